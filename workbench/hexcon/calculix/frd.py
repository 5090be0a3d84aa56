# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading CalculiX's results: of .frd (ASCII) nodal displacements and stresses, of .dat stresses inside elements."""
import re

import numpy as np

END = b"9999"  # the last line
_VALUE = re.compile(rb"[-+]?\d\.\d{5}E[-+]\d{2,3}|[-+]?NaN|[-+]?Infinity", re.IGNORECASE)
_COUNT = slice(24, 36)  # of a line 100C: how many nodes the result has


def _last_block(data, name, components):
    """(ids (n,) rising, values (n,components)) of the last nodal result called name, or None.

    Raises ValueError where it is not all there."""
    start = data.rfind(b"\n -4  " + name.ljust(8))
    if start < 0:
        return None
    first, end = data.find(b"\n -1", start), data.find(b"\n -3", start)
    block = data[first + 1:end + 1] if 0 <= first < end else b""
    ids, values = _table(block, components)
    head = data.rfind(b"\n  100C", 0, start)
    count = int(data[head + 1:start].split(b"\n")[0][_COUNT]) if head >= 0 else len(ids)
    if len(ids) != count or values.shape != (count, components):
        raise ValueError(f"{name.decode()} has {values.shape} numbers, {count} nodes are announced")
    if (np.diff(ids) <= 0).any():
        raise ValueError(f"{name.decode()} lists a node twice, or out of turn")
    return ids, values


def _table(block, components):
    """(ids (n,), values (n,components)) of fixed-width lines: I10 after " -1", then E12.5."""
    width = 13 + 12 * components + 1
    if len(block) % width == 0:
        grid = np.frombuffer(block, "S1").reshape(-1, width)
        if (grid[:, -1] == b"\n").all():
            ids = np.ascontiguousarray(grid[:, 3:13]).view("S10").astype(np.int64)
            values = np.ascontiguousarray(grid[:, 13:-1]).view("S12").astype(float)
            return ids.reshape(-1), values.reshape(-1, components)
    # three-digit exponents make some lines longer
    lines = block.splitlines()
    ids = np.array([int(line[3:13]) for line in lines], np.int64)
    values = [_VALUE.findall(line[13:])[:components] for line in lines]
    if any(len(row) != components for row in values):
        raise ValueError("a line lacks numbers")
    return ids, np.array(values).astype(float).reshape(-1, components)


def read(path):
    """{"node_ids" (n,) rising, "displacements" (n,3), "stress" (n,6)|None} of the last step.

    Stress components xx yy zz xy yz zx, in the deck's units, extrapolated to the nodes; of the nodes that have
    displacements.
    Returns None where the file holds no displacements, or lacks its last line: ccx did not get
    that far, or the disk was full, which it does not notice. Raises ValueError where it is damaged.
    """
    with open(path, "rb") as stream:
        data = stream.read()
    if data.rstrip()[-4:] != END:
        return None
    found = _last_block(data, b"DISP", 3)
    if found is None or not len(found[0]):
        return None
    ids, displacements = found
    found, stress = _last_block(data, b"STRESS", 6), None
    if found is not None:
        place = np.searchsorted(found[0], ids).clip(max=len(found[0]) - 1)
        if not len(found[0]) or (found[0][place] != ids).any():
            raise ValueError("nodes have displacements and no stresses")
        stress = found[1][place]
    return {"node_ids": ids, "displacements": displacements, "stress": stress}


def read_dat_stress(path):
    """(m,8) element number, point, xx yy zz xy yz zx of the last *EL PRINT S, or None. Raises ValueError."""
    with open(path, encoding="ascii", errors="replace") as stream:
        blocks = re.split(r"\n\s*stresses \(", stream.read())
    if len(blocks) < 2:
        return None
    rows = [line.split()[:8] for line in blocks[-1].splitlines()[1:] if line.strip()]
    return np.array([row for row in rows if len(row) == 8 and row[0].isdigit()]).astype(float)


def von_mises(stress):
    """(n,) of (n,6) stresses xx yy zz xy yz zx."""
    x, y, z, xy, yz, zx = np.asarray(stress, float).T
    return np.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2)
                   + 3 * (xy * xy + yz * yz + zx * zx))
