# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that a library reads, in a process of its own with limits of time and memory.

VTK, OpenCASCADE, FreeCAD and MED end the process, or never come back, on some damaged files, and every library
believes the counts in a file. What happens there ends as a ToolError here, and the caller lives.
"""
import contextlib
import json
import os
import shutil
import signal
import sys

from hexcon import answers, child, disk
from hexcon.errors import FaultCode, ToolError
from hexcon.interpreter import python

from .regular import naming_faults

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
START = os.path.join(os.path.dirname(os.path.abspath(__file__)), "workers", "file_worker", "start.py")

# The limits of a small file, and what every byte of a file adds: readers in Python are slow, and keep lists.
SECONDS, SECONDS_PER_BYTE = 30.0, 5e-6
MEMORY, MEMORY_PER_BYTE = 3 << 30, 100      # bytes of address space, of which libraries reserve 1 GiB unused


def read(reader, path, table, *, program, progress=None, **wanted):
    """Let a reader of the file worker read a regular file; returns arrays, checked against a table of answers.Array.

    reader    "mesh" (gmsh, VTK, meshio), "med", "document", "solid" (FreeCAD): see file_worker/start.py
    program   who reads, for words
    progress  callable(stage, fraction), for cancelling: whatever it raises ends the process and comes out here
    wanted    what else the reader wants to know
    Raises ToolError: FILE_FORMAT (the reader's words, or how it died), TOOL_TIMEOUT, FILE_IO, FREECAD_MISSING,
    TOOL_MISSING, TOOL_FAILED, and what the reader found. Cost: 0.3 s, and what is read is copied once.
    """
    with naming_faults(path):
        size = os.path.getsize(path)
    with disk.working_folder("hexcon-read-") as folder:
        with disk.naming(folder, f"work in {folder}"):
            job = {"reader": reader, "file": os.path.abspath(path), "seconds": SECONDS + SECONDS_PER_BYTE * size,
                   "memory": MEMORY + MEMORY_PER_BYTE * size, "path": _module_path(), **wanted}
            with open(os.path.join(folder, "job.json"), "w", encoding="utf-8") as stream:
                json.dump(job, stream)
        try:
            _run([python(), START], folder, job, program, progress)
        except ToolError as fault:
            freecadcmd = shutil.which(os.environ.get("FREECADCMD") or "freecadcmd")
            if fault.code is not FaultCode.FREECAD_MISSING or freecadcmd is None:
                raise
            os.remove(os.path.join(folder, "fault.json"))
            _run([freecadcmd, START, "--"], folder, job, program, progress)
        with disk.naming(folder, f"work in {folder}"):
            return answers.read_arrays(os.path.join(folder, "result.npz"), program, table)


def _module_path():
    """Where the child looks for modules last: ours, and what this process has found its own in (FreeCAD's, say)."""
    try:
        here = os.getcwd()
    except OSError:     # it was removed
        here = None
    return [ROOT, os.path.join(ROOT, "workbench"),
            *(p for p in sys.path if os.path.isabs(p) and p != here and os.path.isdir(p))]


def _run(command, folder, job, program, progress):
    """Run the reader to its end. Raises ToolError unless it left a result."""
    environment = child.python_environment(command[0], PYTHONDONTWRITEBYTECODE="1", OMP_NUM_THREADS="1",
                                           OPENBLAS_NUM_THREADS="1")
    app = sys.modules.get("FreeCAD")
    if app is not None and getattr(app, "__file__", None):
        environment.setdefault("FREECAD_LIB", os.path.dirname(app.__file__))
    try:
        ended = child.run([*command, os.path.join(folder, "job.json")], f"reading {job['file']} with {program}",
                          folder=folder, environment=environment, timeout=job["seconds"],
                          look=progress and (lambda: progress("read", 0.0)))
    except ToolError as fault:
        if fault.code is FaultCode.TOOL_TIMEOUT:
            raise _too_slow(job, program) from fault
        raise
    _check_end(ended, folder, job, program)


def _too_slow(job, program):
    return ToolError(f"cannot read {job['file']}: {program} did not finish within {job['seconds']:g} seconds; the file is "
                     "damaged, or too much for this machine", FaultCode.TOOL_TIMEOUT)


def _check_end(ended, folder, job, program):
    """Raise what the process found, or how it ended."""
    fault_path = os.path.join(folder, "fault.json")
    if ended.status == 0 and os.path.exists(fault_path):
        found = answers.read_fault(fault_path, program)
        words = str(found) if job["file"] in str(found) else f"cannot read {job['file']}: {found}"
        raise ToolError(words, found.code, found.elements)
    if ended.status == 0 and os.path.exists(os.path.join(folder, "result.npz")):
        return
    if ended.status == -getattr(signal, "SIGXCPU", 0) and ended.status:
        raise _too_slow(job, program)
    if ended.status < 0 or os.path.exists(os.path.join(folder, "progress.txt")):
        how = _signal_name(-ended.status) if ended.status < 0 else f"status {ended.status}"    # OpenCASCADE calls exit(1)
        raise ToolError(f"cannot read {job['file']}: {program} ended the process ({how}) while it read the file, which is "
                        "damaged, or of a kind it cannot take", FaultCode.FILE_FORMAT)
    raise ToolError(f"cannot read {job['file']}: the process for {program} did not start (it {ended.how()}): "
                    f"{ended.last_words()}", FaultCode.TOOL_FAILED)


def _signal_name(number):
    with contextlib.suppress(ValueError):
        return f"signal {number} ({signal.Signals(number).name})"
    return f"signal {number}"
