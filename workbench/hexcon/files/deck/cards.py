# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cards of a deck: keyword, parameters and data lines, with the files that it includes in their place."""
import os
from dataclasses import dataclass, field

import numpy as np

from hexcon.errors import FaultCode, ToolError

from ..regular import regular_file
from ..text import parse_numbers

MOST_FILES = 1000           # that one deck may include
_MOST_DEEP = 50


@dataclass
class Card:
    """A keyword line and what follows it.

    name        in capitals, one blank between words
    parameters  {name in capitals: value as written, without quotes}
    path, line  where it stands;  lines  data lines [(line number, text)], no comments;  data_path  their file
    """

    name: str
    parameters: dict
    path: str
    line: int
    lines: list = field(default_factory=list)
    data_path: str = ""

    def fault(self, words, line=None, code=FaultCode.FILE_FORMAT):
        """A ToolError that names the file, the line (of the data, or the card's own) and the card."""
        where = f"{self.path}, line {self.line}" if line is None else f"{self.data_path or self.path}, line {line}"
        return ToolError(f"{where}: *{self.name}: {words}", code)

    def value(self, name, default=None):
        return self.parameters.get(name, default)

    def fields(self):
        """(line number, [fields without blanks around them]) of each data line; a trailing comma ends no field."""
        for number, text in self.lines:
            parts = [part.strip() for part in text.split(",")] if "," in text else text.split()
            while parts and not parts[-1]:
                parts.pop()
            if parts:
                yield number, parts

    def numbers(self, kind, width):
        """(n, width) numbers of data that may wrap as they like, or None where fields are left out or hold names."""
        text = "\n".join(text for _, text in self.lines)
        try:
            found = parse_numbers(text, kind)
        except ValueError:
            return None
        return found.reshape(-1, width) if len(found) % width == 0 else None


def cards_of(path):
    """The cards of a deck and of all that it includes, in order. Raises ToolError FILE_FORMAT, FILE_IO."""
    return list(_Cards(path).read(path, ()))


class _Cards:
    def __init__(self, path):
        self._folder, self._count = os.path.dirname(os.path.abspath(path)), 0

    def read(self, path, chain):
        card = None
        for source, number, text in self._items(path, chain):
            if isinstance(text, Card):
                if card is not None:
                    yield card
                card = text
            elif card is None:
                raise ToolError(f"{source}, line {number}: a data line without a card before it: {text[:60]!r}",
                                FaultCode.FILE_FORMAT)
            else:
                if source != card.path:
                    card.data_path = source
                card.lines.append((number, text))
        if card is not None:
            yield card

    def _items(self, path, chain):
        """(file, line number, data line or Card); what is included stands in its place, be it cards, or more data of
        the
        card before."""
        inner = chain + (os.path.realpath(path),)
        for number, text in self._lines(path, chain):
            if not isinstance(text, Card):
                yield path, number, text
            elif text.name == "INCLUDE":
                if not text.value("INPUT"):
                    raise text.fault("it names no file: INPUT=... is missing")
                yield from self._items(self._path_of(text, text.value("INPUT"), inner), inner)
            else:
                if "INPUT" in text.parameters:
                    self._take_input(text, inner)
                yield path, number, text

    def _take_input(self, card, chain):
        """Data lines of another file, which come before the card's own."""
        path = self._path_of(card, card.parameters["INPUT"], chain)
        lines = []
        for number, text in self._lines(path, chain):
            if isinstance(text, Card):
                raise card.fault(f"{path}, line {number}, which it takes its data from, has a card *{text.name}")
            lines.append((number, text))
        card.lines, card.data_path = lines, path

    def _path_of(self, card, name, chain):
        name = name.replace("\\", "/") if os.sep == "/" else name
        places = [os.path.join(os.path.dirname(card.path), name), os.path.join(self._folder, name)]
        path = next((p for p in places if os.path.exists(p)), None)
        if path is None:
            raise card.fault(f"the file {name!r} is not there (looked for beside the deck)", code=FaultCode.FILE_IO)
        self._count += 1
        if os.path.realpath(path) in chain or len(chain) > _MOST_DEEP or self._count > MOST_FILES:
            raise card.fault(f"{name!r} includes itself, by one file or more, or there are more than {MOST_FILES} "
                             f"files")
        return regular_file(path)

    def _lines(self, path, chain):
        """(line number, data line or Card), comments and empty lines left out."""
        lines = _text(path).split("\n")
        at = 0
        while at < len(lines):
            number, text = at + 1, lines[at].strip()
            at += 1
            if not text or text.startswith("**"):
                continue
            if not text.startswith("*"):
                if number == 1 and not chain and not _is_printable(text):
                    raise ToolError(f"{path}: this is no text", FaultCode.FILE_FORMAT)
                yield number, text
                continue
            while text.endswith(",") and at < len(lines) and _continues(lines[at].strip()):
                if not lines[at].strip().startswith("**"):
                    text += lines[at].strip()
                at += 1
            yield number, _card(text, path, number)


def _continues(text):
    """Whether a line after a card that ends with a comma is more of the card: parameters begin with a letter, and of
    the data behind a card only names do. Comments may stand between."""
    return text.startswith("**") or (text[:1].isalpha() and ("=" in text or _only_words(text)))


def _only_words(text):
    """Parameters without a value: GENERATE, UNSORTED, INTERNAL."""
    return all(word.strip().upper() in ("GENERATE", "UNSORTED", "INTERNAL", "SHIFT")
               for word in text.rstrip(",").split(","))


def _is_printable(text):
    return all(c.isprintable() or c == "\t" for c in text[:200])


def _text(path):
    with open(path, "rb") as stream:
        data = stream.read()
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise ToolError(f"{path} is UTF-16 text: save it as UTF-8 or ASCII", FaultCode.FILE_FORMAT)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n").replace("\x1a", "")


def _card(text, path, number):
    """A Card of a keyword line, whole."""
    words = _split(text[1:])
    name = " ".join(words[0].upper().split())
    parameters = {}
    for word in words[1:]:
        key, _, value = word.partition("=")
        if key.strip():
            parameters["".join(key.upper().split()) if " " not in key.strip() else " ".join(key.upper().split())] = \
                value.strip().strip("\"'")
    return Card(name, parameters, path, number)


def _split(text):
    """Words between commas that are not in quotes."""
    if '"' not in text and "'" not in text:
        return text.split(",")
    words, quote = [""], None
    for c in text:
        if quote is None and c == ",":
            words.append("")
            continue
        if c in "\"'" and quote in (None, c):
            quote = c if quote is None else None
        words[-1] += c
    return words


def whole_numbers(values):
    """int64 of numbers read as floats. Raises ValueError."""
    values = np.asarray(values, float)
    if not (np.abs(values) < 2.0 ** 53).all() or (values != np.rint(values)).any():
        raise ValueError("a number of a node or an element that is no whole number")
    return values.astype(np.int64)
