# SPDX-License-Identifier: LGPL-2.1-or-later
"""Is there a file to read, and is it a file? A pipe or a device would be waited for without end. And faults while it is
read, in words."""
import contextlib
import os
import stat

from hexcon.errors import FaultCode, HexconError, ToolError

_WHAT = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"),
         (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"))


def regular_file(path):
    """The path of a regular file, as text, that can be opened for reading; links are followed.

    Raises ToolError FILE_IO (not there, no permission, links without end, a folder, pipe or device), BAD_OPTION (no path).
    """
    try:
        path = os.fsdecode(path)
    except TypeError as error:
        raise ToolError(f"a path is needed, not {type(path).__name__}", FaultCode.BAD_OPTION) from error
    try:
        mode = os.stat(path).st_mode
        if stat.S_ISREG(mode):
            # without waiting, should it have become a pipe since
            os.close(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)))
    except FileNotFoundError as error:
        raise ToolError(f"cannot read {path!r}: there is no such file", FaultCode.FILE_IO) from error
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        raise ToolError(f"cannot read {path!r}: {getattr(error, 'strerror', None) or error}", FaultCode.FILE_IO) from error
    if not stat.S_ISREG(mode):
        what = next((words for is_one, words in _WHAT if is_one(mode)), "no regular file")
        raise ToolError(f"cannot read {path!r}: it is {what}; give the name of a file", FaultCode.FILE_IO)
    return path


@contextlib.contextmanager
def naming_faults(path):
    """Inside, whatever a reader stumbles over becomes a fault that names the file: FILE_IO, FILE_FORMAT, its own."""
    try:
        yield
    except HexconError as fault:
        if path in str(fault):
            raise
        raise type(fault)(f"{path}: {fault}", fault.code, fault.elements) from fault
    except OSError as error:    # it went away, or its disk did
        raise ToolError(f"cannot read {path}: {error.strerror or error}", FaultCode.FILE_IO) from error
    except (ValueError, ArithmeticError, LookupError, TypeError, RecursionError) as error:
        raise ToolError(f"cannot read {path}: it is damaged, or of another format than its ending says "
                        f"({type(error).__name__}: {error})", FaultCode.FILE_FORMAT) from error
    except MemoryError as error:
        raise ToolError(f"cannot read {path}: there is too little memory for it", FaultCode.FILE_FORMAT) from error
