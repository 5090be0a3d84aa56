# SPDX-License-Identifier: LGPL-2.1-or-later
"""Running ccx on a deck in a folder."""
import os
import shutil

from hexcon import child, interpreter
from hexcon.errors import FaultCode, ToolError
from hexcon_native import ErrorCode, HexconError

from .deck_loads import check_deck
from .judging import judged

_NAMES = ("ccx", "ccx_static", "ccx_dynamic")


def find_ccx(preferred=None):
    """Path of ccx: preferred, else $HEXCON_CCX, else on PATH, else FreeCAD's own. ToolError(TOOL_MISSING)."""
    for candidate in (preferred, os.environ.get("HEXCON_CCX")):
        if candidate:
            found = shutil.which(candidate)
            if found:
                return os.path.abspath(found)   # work is done in another folder
            raise ToolError(f"CalculiX is not at {candidate}; correct FreeCAD's FEM "
                            "preference or HEXCON_CCX", FaultCode.TOOL_MISSING)
    for name in _NAMES:
        found = shutil.which(name)
        if found:
            return os.path.abspath(found)
    found = interpreter.beside(*_NAMES)
    if found and interpreter.is_bundled(found):
        return found
    raise ToolError("CalculiX (ccx) is not on PATH, nor did it come with this FreeCAD. Install it (Debian, Ubuntu: apt "
                    "install calculix-ccx; others: https://www.calculix.de) or set HEXCON_CCX to the program",
                    FaultCode.TOOL_MISSING)


def run_ccx(deck_path, *, timeout=3600, threads=None, ccx=None, progress=None, nodes=None):
    """Run ccx on deck_path (ending .inp); its results come to lie beside it.

    timeout  seconds;  threads  0 or None: all processors
    progress  callable (stage, fraction), asked some thirty times a second; returning False cancels
    nodes    node numbers that the results must cover, see judging.judged
    Returns (results of frd.read, log).
    Raises ToolError: BAD_OPTION (a deck that loads nothing),
    TOOL_MISSING, TOOL_FAILED (ccx's words, or why its results cannot be used), TOOL_TIMEOUT.
    """
    program = find_ccx(ccx)
    folder, base = os.path.split(os.path.abspath(deck_path))
    job = os.path.splitext(base)[0]
    count = str(threads or os.cpu_count() or 1)
    environment = child.program_environment(program, OMP_NUM_THREADS=count, CCX_NPROC_RESULTS=count)
    for ending in (".frd", ".dat"):     # an old result must not pass for this one's
        if os.path.exists(os.path.join(folder, job + ending)):
            os.remove(os.path.join(folder, job + ending))
    with open(deck_path, encoding="utf-8", errors="replace") as stream:
        check_deck(stream.read())
    ended = child.run([program, "-i", job], "CalculiX", folder=folder, environment=environment, timeout=timeout,
                      look=progress and (lambda: _look_up(progress)))
    return judged(os.path.join(folder, base), ended, nodes), ended.output


def _look_up(progress):
    """Raise if the user has had enough."""
    if progress("CalculiX", 0.5) is False:
        raise HexconError("cancelled while CalculiX ran", ErrorCode.CANCELLED)
