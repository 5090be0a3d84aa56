# SPDX-License-Identifier: LGPL-2.1-or-later
"""What went wrong with a disk, in words; above all that it is full.

Programs that write for us (gmsh, CalculiX, VTK, FreeCAD) report a full disk badly or not at all,
so after a fault of theirs the disk itself is asked.
"""
import contextlib
import errno
import os
import secrets
import shutil
import tempfile
import zipfile

import numpy as np

from . import keeper
from .errors import FaultCode, HexconError, ToolError

FULL = (errno.ENOSPC, errno.EDQUOT)
NO_SPACE = "no space left on the disk of {}; free some and try again"
LEAST = 65536  # bytes: with less left, a fault that says nothing is put down to the disk


def is_full(folder):
    """Whether next to nothing can be written into the folder."""
    try:
        return shutil.disk_usage(folder).free < LEAST
    except OSError:
        return False


def reason(error, folder):
    """Why an OSError was raised while something was written into the folder."""
    if error.errno in FULL or is_full(folder):
        return NO_SPACE.format(folder)
    return error.strerror or str(error)


@contextlib.contextmanager
def naming(folder, what):
    """Inside, OSError, and on a full disk whatever a program led to, become ToolError(FILE_IO):
    "cannot <what>: why"."""
    try:
        yield
    except HexconError as fault:
        if fault.code is not FaultCode.TOOL_FAILED or not is_full(folder):
            raise
        raise ToolError(f"cannot {what}: {NO_SPACE.format(folder)} ({fault})", FaultCode.FILE_IO) from fault
    except OSError as error:
        raise ToolError(f"cannot {what}: {reason(error, folder)}", FaultCode.FILE_IO) from error
    except Exception as error:  # half a file was read, or a program's own class of fault
        if not is_full(folder):
            raise
        raise ToolError(f"cannot {what}: {NO_SPACE.format(folder)}", FaultCode.FILE_IO) from error


def new_folder(prefix, place=None):
    """A temporary folder in `place`, or where temporary files go, for remove_folder. Until then, or until the caller
    tells keeper.let_folder_go of it to keep it, it goes with this process. Raises ToolError(FILE_IO), or OSError where it has a place."""
    if place is None:
        # gettempdir tries to write: on a full disk it finds no folder at all
        with naming(tempfile.tempdir or os.environ.get("TMPDIR") or "/tmp", "make a temporary folder"):
            return new_folder(prefix, tempfile.gettempdir())
    path = os.path.join(os.path.abspath(place), prefix + secrets.token_hex(8))
    keeper.hold_folder(path)
    try:
        os.mkdir(path, 0o700)
    except OSError:
        keeper.let_folder_go(path)
        raise
    return path


@contextlib.contextmanager
def working_folder(prefix, place=None):
    """A temporary folder that is gone afterwards, whatever ends this process; faults while it is made are named."""
    folder = new_folder(prefix, place)
    try:
        yield folder
    finally:
        remove_folder(folder)


def remove_folder(folder):
    """Remove what new_folder has made, with all that is in it."""
    shutil.rmtree(folder, ignore_errors=True)
    keeper.let_folder_go(folder)


def put_in_place(made, path, is_own=None):
    """Move a file, or a folder, that was made beside path to path. What was there goes; where this fails it stays.

    is_own  callable (name): whether a folder that is there may lose a file of that name. It is not touched where it
            holds any other, or a folder. Raises OSError, or ToolError(FILE_IO) for what must not go.
    """
    if not os.path.isdir(made) or not os.path.lexists(path):
        os.replace(made, path)
        return
    if os.path.islink(path) or not os.path.isdir(path):
        raise ToolError(f"cannot write {path}: it is a file, and a folder is to be written; remove it, or give another "
                        "name", FaultCode.FILE_IO)
    with os.scandir(path) as entries:
        strange = sorted(entry.name for entry in entries
                         if not entry.is_file(follow_symlinks=False) or not is_own(entry.name))
    if strange:
        raise ToolError(f"cannot write {path}: the folder holds {strange[0]!r}, which HexCon has not written; give another "
                        "name", FaultCode.FILE_IO)
    old = f"{path}.old-{secrets.token_hex(4)}"      # beside it, so that nothing is lost if this process is killed now
    os.rename(path, old)
    try:
        os.rename(made, path)
    except BaseException:
        os.rename(old, path)
        raise
    shutil.rmtree(old, ignore_errors=True)


def write_arrays(path, arrays):
    """An .npz file of a dict of arrays, as np.savez makes it. Raises OSError, and nothing after it: on a full disk
    np.savez leaves an archive open, which complains once more when it is collected."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        for name, array in arrays.items():
            with archive.open(name + ".npy", "w", force_zip64=True) as stream:
                np.lib.format.write_array(stream, np.asanyarray(array), allow_pickle=False)
