# SPDX-License-Identifier: LGPL-2.1-or-later
"""Is a .FCStd file a whole zip archive of bearable size, and its XML harmless? Looked at before FreeCAD reads it.

FreeCAD believes the archive: it reads entry after entry from the file's start, by the headers in front of each, while
others go by the directory at the end. So both must say the same, every byte must belong to one entry, and each entry
must unpack to exactly the length that was added up before anything was unpacked. Format: PKWARE's APPNOTE 6.3, 4.3.
"""
import os
import re
import stat
import struct
import zipfile
import zlib

from hexcon.errors import FaultCode, ToolError

UNPACKED_MOST = 1 << 30     # bytes of all entries together
RATIO_MOST = 200            # unpacked to packed, beyond RATIO_FREE; XML and BREP come to 5 ... 60
RATIO_FREE = 64 << 20
ENTRIES_MOST = 100_000

_LOCAL = struct.Struct("<4s5H3L2H")     # signature, version, flags, method, time, date, CRC, packed, unpacked, name, extra
_ENCRYPTED, _DESCRIPTOR, _UTF8 = 1, 8, 0x800    # bits of the flags
_DECLARATION = re.compile(rb"<!(?!--|\[CDATA\[)(?=.)", re.DOTALL)
_PIECE = 1 << 20
_HEAD = 1000            # bytes in which an XML declaration must end
_ENCODINGS = (b"utf-8", b"us-ascii", b"ascii", b"iso-8859-1", b"windows-1252")   # a "<" is one byte, and means it


def check_document(path):
    """Bytes that the entries of a .FCStd file have together. Raises ToolError FILE_FORMAT saying why it is not read.

    Cost: every entry is unpacked once, in pieces."""
    try:
        with zipfile.ZipFile(path) as archive, open(path, "rb") as stream:
            entries = sorted(archive.infolist(), key=lambda entry: entry.header_offset)
            total = _check_sizes(entries, os.path.getsize(path))
            _check_names(entries)
            _check_places(entries, archive.start_dir, stream)
            for entry in entries:
                _check_content(entry, stream)
            return total
    except ToolError as fault:
        raise ToolError(f"{path} is not opened: {fault}", fault.code) from fault
    except (zipfile.BadZipFile, zlib.error, struct.error, NotImplementedError, EOFError, ValueError,
            OverflowError) as error:
        raise ToolError(f"{path} is no FreeCAD document, or damaged: {error}", FaultCode.FILE_FORMAT) from error


def _refused(words):
    return ToolError(words + "; save it again in FreeCAD, or export its solid as STEP", FaultCode.FILE_FORMAT)


def _check_sizes(entries, packed):
    """Sum of the unpacked lengths, from the directory alone."""
    if not entries or len(entries) > ENTRIES_MOST:
        raise _refused(f"it has {len(entries)} entries; 1 to {ENTRIES_MOST} are possible")
    total = sum(entry.file_size for entry in entries)
    if total > UNPACKED_MOST or (total > RATIO_FREE and total > RATIO_MOST * packed):
        raise _refused(f"its {packed} bytes would unpack to {total}; at most {UNPACKED_MOST} are unpacked, and "
                       f"{RATIO_MOST} times the file's length")
    for entry in entries:
        if entry.flag_bits & _ENCRYPTED:
            raise _refused(f"{entry.filename!r} in it is encrypted")
        if entry.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise _refused(f"{entry.filename!r} in it is packed by a method ({entry.compress_type}) that FreeCAD has not")
    return total


def _check_names(entries):
    """Each name once, and of a file below where it is unpacked."""
    seen = set()
    for entry in entries:
        name = entry.orig_filename
        parts = re.split(r"[/\\]", name)
        if not name or "\0" in name or ":" in name or not parts[0] or ".." in parts:
            raise _refused(f"{name[:200]!r} is no name for a file in it")
        if stat.S_ISLNK(entry.external_attr >> 16):
            raise _refused(f"{name!r} in it is a link")
        if name in seen:
            raise _refused(f"{name!r} is in it twice")
        seen.add(name)


def _check_places(entries, end, stream):
    """Entries follow each other from the file's start to its directory, each with the header that the directory has."""
    place = 0
    for entry in entries:
        if entry.header_offset != place:
            raise _refused(f"{entry.filename!r} in it begins at byte {entry.header_offset}, not at {place}: they overlap, "
                           "or something lies between them")
        place = _end_of(entry, stream)
    if place != end:
        raise _refused(f"its last entry ends at byte {place}, and its directory begins at {end}")


def _end_of(entry, stream):
    """Where an entry ends; its header is compared with the directory's."""
    stream.seek(entry.header_offset)
    signature, _, flags, method, _, _, crc, packed, unpacked, name_length, extra_length = _LOCAL.unpack(
        stream.read(_LOCAL.size))
    name = stream.read(name_length)
    later = bool(flags & _DESCRIPTOR)   # lengths and checksum stand behind the entry
    same = (signature == b"PK\3\4" and flags == entry.flag_bits and method == entry.compress_type
            and name == entry.orig_filename.encode("utf-8" if flags & _UTF8 else "cp437")
            and (later or (crc, packed, unpacked) == (entry.CRC, entry.compress_size, entry.file_size)))
    if not same:
        raise _refused(f"the two headers of {entry.filename!r} in it disagree")
    end = entry.header_offset + _LOCAL.size + name_length + extra_length + entry.compress_size
    if later:
        stream.seek(end)
        behind = stream.read(16)
        facts = struct.pack("<3L", entry.CRC, entry.compress_size, entry.file_size)
        if behind != b"PK\7\x08" + facts and behind[:12] != facts:
            raise _refused(f"the two headers of {entry.filename!r} in it disagree")
        end += 16 if behind[:4] == b"PK\7\x08" else 12
    return end


def _check_content(entry, stream):
    """The entry unpacks to its length and checksum; XML is looked through."""
    stream.seek(entry.header_offset + 26)
    stream.seek(sum(struct.unpack("<2H", stream.read(4))), os.SEEK_CUR)
    watch = _XmlWatch(entry.filename) if entry.filename.lower().endswith(".xml") else None
    length = crc = 0
    for piece in _unpacked(entry, stream):
        length, crc = length + len(piece), zlib.crc32(piece, crc)
        if length > entry.file_size:
            break
        if watch:
            watch.look(piece)
    if (length, crc) != (entry.file_size, entry.CRC):
        raise _refused(f"it is damaged: {entry.filename!r} in it has not the length or the checksum that it should have")


def _unpacked(entry, stream):
    """Pieces of an entry, at most _PIECE long each; ends where the packed data do."""
    left = entry.compress_size
    unpacker = zlib.decompressobj(-zlib.MAX_WBITS) if entry.compress_type == zipfile.ZIP_DEFLATED else None
    while left:
        packed = stream.read(min(left, _PIECE))
        if not packed:
            return
        left -= len(packed)
        while unpacker and packed:
            yield unpacker.decompress(packed, _PIECE)
            packed = unpacker.unconsumed_tail
        if not unpacker:
            yield packed
    if unpacker:
        yield unpacker.flush()
        if not unpacker.eof or unpacker.unused_data:
            raise zlib.error(f"{entry.filename} does not end where it should")


class _XmlWatch:
    """Looks for declarations in XML that comes piece by piece: FreeCAD writes none, and entities can grow without end."""

    def __init__(self, name):
        self._name, self._head, self._last = name, b"", b""

    def look(self, piece):
        """Raise ToolError for a document type or entities, and for an encoding that could hide them."""
        if len(self._head) < _HEAD:
            self._head += piece[:_HEAD - len(self._head)]
            self._check_encoding()
        if _DECLARATION.search(self._last[-16:] + piece):
            raise _refused(f"{self._name} in it declares a document type or entities, which FreeCAD does not")
        self._last = (self._last + piece)[-16:]

    def _check_encoding(self):
        head = self._head.removeprefix(b"\xef\xbb\xbf")
        named = re.match(rb"""<\?xml[^>]*?encoding\s*=\s*["']([^"']*)["']""", head)
        endless = head.startswith(b"<?xml") and len(self._head) == _HEAD and b"?>" not in head
        if (head[:1] not in (b"<", b"") or b"\0" in head or endless) or (named and named.group(1).lower() not in _ENCODINGS):
            raise _refused(f"{self._name} in it is no XML in UTF-8")
