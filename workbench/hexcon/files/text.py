# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fast text output and input of arrays: one operation per block of rows."""
import warnings

import numpy as np

ROWS_PER_BLOCK = 20000


def write_rows(stream, row_format, rows):
    """Write each row of a 2-D array through a %-format such as "%d, %r, %r\\n".

    About 0.3 us per number; %r gives the shortest text that reads back bit for bit.
    """
    for start in range(0, len(rows), ROWS_PER_BLOCK):
        block = rows[start:start + ROWS_PER_BLOCK]
        stream.write((row_format * len(block)) % tuple(block.ravel().tolist()))


def write_numbered(stream, row_format, rows, first=1):
    """As write_rows, with a running number (1-based by default) before each row."""
    width = rows.shape[1]
    for start in range(0, len(rows), ROWS_PER_BLOCK):
        block = rows[start:start + ROWS_PER_BLOCK]
        values = [None] * (len(block) * (width + 1))
        numbers = range(first + start, first + start + len(block))
        values[::width + 1] = numbers
        for column in range(width):
            values[column + 1::width + 1] = block[:, column].tolist()
        stream.write((row_format * len(block)) % tuple(values))


def write_list(stream, ids, per_line=10, separator=", "):
    """Integers, per_line in a line."""
    ids = ids.tolist()
    for start in range(0, len(ids), per_line * 1000):
        block = ids[start:start + per_line * 1000]
        lines = [separator.join(map(str, block[k:k + per_line]))
                 for k in range(0, len(block), per_line)]
        # Abaqus and CalculiX take a line's last comma as "more follows", which is harmless
        stream.write((separator.rstrip() + "\n").join(lines) + separator.rstrip() + "\n")


def real(text):
    """A float, as Fortran writes it too (1.5D3); 0 where a field is left empty. Raises ValueError."""
    return float(text.upper().replace("D", "E")) if text else 0.0


def parse_numbers(text, kind):
    """(n,) array of kind from numbers set apart by blanks, commas and line ends.

    D exponents are taken for float. Raises ValueError for anything else. About 50 ns a
    number."""
    text = text.replace(",", " ")
    if kind is float:
        text = text.replace("D", "E").replace("d", "e")
    with warnings.catch_warnings():
        # numpy reports text that is no number as a DeprecationWarning, and stops there
        warnings.simplefilter("error")
        try:
            return np.fromstring(text, kind, sep=" ") if text.strip() else np.zeros(0, kind)
        except DeprecationWarning as error:
            raise ValueError("text that is no number among numbers") from error
