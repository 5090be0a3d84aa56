# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other programs as children of this process: started, watched, and in any case ended with all that they started.

Each child leads a session of its own, so that one call ends its whole group; keeper.py does that if this process is
killed. What it prints is read through a pipe and kept within bounds.
"""
import contextlib
import os
import shutil
import subprocess
import sys
import threading
import time
from dataclasses import dataclass

from . import freecad_compat, interpreter, keeper
from .errors import FaultCode, ToolError

POLL = 0.03             # seconds between looks at a child
KEPT = 8 << 20          # bytes of its output kept from the beginning, and as many from the end
MOST_OUTPUT = 256 << 20     # bytes; no program of ours says a hundredth of it
_TRACEBACK = "Traceback (most recent call last)"


@dataclass
class Ended:
    """How a child ended: its status (-n: by signal n), and what it printed, which may lack the middle."""

    status: int
    output: str

    def how(self):
        return f"was ended by signal {-self.status}" if self.status < 0 else f"ended with status {self.status}"

    def last_words(self, most=12):
        """The lines that begin with Error, or the last ones; of a Python traceback what it ends with."""
        lines = [line.rstrip()[:500] for line in self.output.splitlines() if line.strip()]
        if any(line.startswith(_TRACEBACK) for line in lines):
            lines = [line for line in lines if not line.startswith((_TRACEBACK, " ", "During handling"))]
        errors = [line for line in lines if line.startswith("Error")] or lines
        return "\n".join(errors[-most:]) or "it said nothing"


def run(command, program, *, folder=None, environment=None, timeout=None, limit=None, look=None,
        most_files=None):
    """Run a command to its end; returns Ended, whatever its status.

    command      list of str; the first is found as Popen does
    program      its name, for words
    folder       working folder;  environment: dict, None: program_environment
    timeout      seconds, None: no limit;  limit: when they are over by the monotonic clock, None: counted from now
    look         callable () asked every POLL seconds; whatever it raises ends the child and comes out here
    most_files   bytes that the files right in the working folder may take, None: as many as there is room for
    When this returns or raises, the child and all of its session are gone.
    Raises ToolError: TOOL_MISSING (it cannot be started), TOOL_TIMEOUT, TOOL_FAILED (it prints, or writes, without end).
    """
    if limit is None and timeout is not None:
        limit = time.monotonic() + timeout
    child = _Child(command, folder, program_environment(command[0]) if environment is None else environment)
    try:
        child.begin(program)
        child.watch(program, limit, timeout, look, most_files)
    finally:
        child.end()
    return Ended(child.process.returncode, child.output())


class _Child(threading.Thread):
    """One child, started and read by a thread: no signal's exception can come between its start and what knows of it."""

    def __init__(self, command, folder, environment):
        super().__init__(name="HexCon child", daemon=True)
        self._command, self._folder, self._environment = command, folder, environment
        self._known = threading.Event()
        self.process = self._fault = None
        self._head, self._tail, self._count = bytearray(), bytearray(), 0

    def run(self):
        try:
            self.process = subprocess.Popen(
                self._command, cwd=self._folder, env=self._environment, stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, bufsize=0, start_new_session=True)
            keeper.hold_group(self.process.pid)
        except (OSError, ValueError) as fault:
            self._fault = fault
            return
        finally:
            self._known.set()
        with self.process.stdout as pipe:
            while chunk := pipe.read(65536):
                self._take(chunk)

    def _take(self, chunk):
        self._count += len(chunk)
        if len(self._head) < KEPT:
            self._head += chunk
        else:
            self._tail += chunk
            if len(self._tail) > 2 * KEPT:
                del self._tail[:-KEPT]

    def begin(self, program):
        try:
            self.start()
        except RuntimeError as fault:       # no more threads
            self._fault = fault
            self._known.set()
        self._known.wait()
        if self._fault is not None:
            raise ToolError(f"cannot start {program} ({self._command[0]}): {self._fault}", FaultCode.TOOL_MISSING)

    def watch(self, program, limit, timeout, look, most_files):
        """Wait for the end; raises as run."""
        pause = 0.0005
        while self.process.poll() is None:
            if limit is not None and time.monotonic() > limit:
                raise ToolError(f"{program} did not finish within {timeout:g} seconds; give it more time",
                                FaultCode.TOOL_TIMEOUT)
            if self._count > MOST_OUTPUT:
                raise ToolError(f"{program} printed more than {MOST_OUTPUT >> 20} MB and was ended; its first words: "
                                + self._head[:200].decode("utf-8", "replace"), FaultCode.TOOL_FAILED)
            time.sleep(pause)
            pause = min(2 * pause, POLL)
            if pause < POLL:
                continue
            if look is not None:
                look()
            if most_files is not None and _size_of(self._folder) > most_files:
                raise ToolError(f"{program} wrote more than {most_files >> 20} MB and was ended", FaultCode.TOOL_FAILED)

    def end(self):
        """End what is left of the group; afterwards nothing of it is there."""
        if self.ident is not None:
            self._known.wait()
        if self.process is None:
            return
        keeper.end_group(self.process.pid, self.process.poll)
        self.process.wait()
        keeper.let_group_go(self.process.pid)
        self.join(1.0)              # one that left the session may hold the pipe

    def output(self):
        gap = b"\n[...]\n" if self._count > len(self._head) + len(self._tail) else b""
        return (bytes(self._head) + gap + bytes(self._tail)).decode("utf-8", "replace")


def _size_of(folder):
    """Bytes on disk of the files right in a folder."""
    total = 0
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            with contextlib.suppress(OSError):      # it may go meanwhile
                found = entry.stat(follow_symlinks=False)
                total += 512 * found.st_blocks if hasattr(found, "st_blocks") else found.st_size
    return total


# ------------------------------------------------------------------------------ what a child finds set

_LIBRARY_PATHS = ("LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH")


def program_environment(program, **more):
    """Environment of a child: the libraries of FreeCAD's bundle are for its own programs, and would break the system's.

    program  which is run;  more: other variables
    """
    kept = dict(os.environ)
    if not interpreter.is_bundled(shutil.which(program) or program):
        for name in _LIBRARY_PATHS:
            folders = [folder for folder in kept.pop(name, "").split(os.pathsep) if folder and not interpreter.is_bundled(folder)]
            if folders:
                kept[name] = os.pathsep.join(folders)
    return {**kept, **more}


def python_environment(python, folders=(), **more):
    """program_environment of a child that is, or holds, a Python: what it imports never comes from the working folder.

    python   the program;  folders: where it finds modules first;  more: other variables
    PYTHONPATH, but for its relative entries (an empty one is the working folder), and PYTHONHOME go along only to the
    interpreter that they were set for: this one, or FreeCAD's own, which also gets what the Addon Manager has installed;
    PYTHONHOME to all programs of FreeCAD's bundle.
    """
    own = _is_own(python)
    given = os.environ.get("PYTHONPATH", "").split(os.pathsep) + added_packages() if own else []
    bundled = interpreter.is_bundled(shutil.which(python) or python)
    left_out = {"PYTHONPATH", "PYTHONINSPECT", "PYTHONSTARTUP"} | (set() if own or bundled else {"PYTHONHOME"})
    kept = {name: value for name, value in program_environment(python).items() if name not in left_out}
    path = os.pathsep.join([*folders, *(entry for entry in given if os.path.isabs(entry))])
    if path:
        kept["PYTHONPATH"] = path
    return {**kept, "PYTHONSAFEPATH": "1", **more}


def _is_own(python):
    try:
        return os.path.samefile(shutil.which(python) or python, shutil.which(interpreter.python()) or interpreter.python())
    except OSError:     # one of them is not there
        return False


def added_packages():
    """Where the Addon Manager and the preferences have put Python packages that FreeCAD's Python lacks.

    Empty outside of FreeCAD; not every FreeCAD has the folder on its own path (as an AppImage it has not)."""
    found = [entry for entry in sys.path if freecad_compat.PACKAGES in entry.replace(os.sep, "/").split("/")]
    if sys.modules.get("FreeCAD") is not None:
        found += [entry for entry in [freecad_compat.packages_folder()] if entry not in found]
    return found
