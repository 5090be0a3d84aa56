# SPDX-License-Identifier: LGPL-2.1-or-later
"""Running ccx on a deck in a folder, and saying in its own words why it failed."""
import os
import re
import shutil
import subprocess
import time

from hexcon.errors import FaultCode, ToolError
from hexcon_native import ErrorCode, HexconError

from . import frd

_NAMES = ("ccx", "ccx_static", "ccx_dynamic")
_MAX_LINES = 20
POLL = 0.1  # seconds between looks at ccx
_ELEMENT = re.compile(r"(?:in|to) element\s+(\d+)")


def find_ccx(preferred=None):
    """Path of ccx: preferred, else $HEXCON_CCX, else on PATH. ToolError(TOOL_MISSING)."""
    for candidate in (preferred, os.environ.get("HEXCON_CCX")):
        if candidate:
            found = shutil.which(candidate)
            if found:
                return found
            raise ToolError(f"CalculiX is not at {candidate}; correct FreeCAD's FEM "
                            "preference or HEXCON_CCX", FaultCode.TOOL_MISSING)
    for name in _NAMES:
        found = shutil.which(name)
        if found:
            return found
    raise ToolError("CalculiX (ccx) is not on PATH. Install it (Debian, Ubuntu: apt install "
                    "calculix-ccx; others: https://www.calculix.de) or set HEXCON_CCX to "
                    "the program", FaultCode.TOOL_MISSING)


def error_lines(log):
    """CalculiX's own *ERROR messages, each with the lines that continue it."""
    lines, taken, inside = log.splitlines(), [], False
    for line in lines:
        text = line.strip()
        if "*ERROR" in text:
            inside = True
        elif not text or text.startswith("*"):
            inside = False
        if inside and text not in taken:
            taken.append(text)
    return taken


def failure(log, returncode):
    """ToolError(TOOL_FAILED) that quotes ccx; .elements are the elements it names, rows
    (element number - 1)."""
    words = error_lines(log)
    if not words:  # killed, or an end without a message: show where it stopped
        words = [line.strip() for line in log.splitlines() if line.strip()][-5:]
    more = len(words) - _MAX_LINES
    shown = words[:_MAX_LINES] + ([f"... and {more} more lines"] if more > 0 else [])
    ids = sorted({int(n) - 1 for n in _ELEMENT.findall("\n".join(words))})
    return ToolError(f"CalculiX failed (exit status {returncode}):\n" + "\n".join(shown),
                     FaultCode.TOOL_FAILED, ids)


def run_ccx(deck_path, *, timeout=3600, threads=None, ccx=None, progress=None):
    """Run ccx on deck_path (ending .inp); its results come to lie beside it.

    timeout  seconds;  threads  0 or None: all processors
    progress  callable (stage, fraction), asked ten times a second; returning False cancels
    Returns (results of frd.read, log). ccx may report an error and still end with status
    0, so status, messages and results are all looked at.
    Raises ToolError: TOOL_MISSING, TOOL_FAILED (ccx's words), TOOL_TIMEOUT.
    """
    program = find_ccx(ccx)
    folder, base = os.path.split(os.path.abspath(deck_path))
    job = os.path.splitext(base)[0]
    count = str(threads or os.cpu_count() or 1)
    environment = dict(os.environ, OMP_NUM_THREADS=count, CCX_NPROC_RESULTS=count)
    result_path = os.path.join(folder, job + ".frd")
    if os.path.exists(result_path):
        os.remove(result_path)  # an old result must not pass for this one's
    returncode, log = _watched(program, job, folder, environment, timeout, progress)
    results = frd.read(result_path) if os.path.exists(result_path) else None
    if returncode or "*ERROR" in log or results is None:
        raise failure(log, returncode)
    return results, log


def _watched(program, job, folder, environment, timeout, progress):
    """(exit status, output) of ccx; it never outlives this call."""
    limit = time.monotonic() + timeout
    try:
        process = subprocess.Popen(
            [program, "-i", job], cwd=folder, env=environment,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            encoding="utf-8", errors="replace")
    except OSError as error:
        raise ToolError(f"CalculiX ({program}) cannot be started: {error}",
                        FaultCode.TOOL_MISSING) from error
    try:
        while True:
            try:
                log, _ = process.communicate(timeout=POLL)
                return process.returncode, log
            except subprocess.TimeoutExpired:
                _look_up(limit, timeout, progress)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()


def _look_up(limit, timeout, progress):
    """Raise if the time is over, or the user has had enough."""
    if time.monotonic() > limit:
        raise ToolError(f"CalculiX did not finish within {timeout} s; give it more time, or "
                        "mesh coarser", FaultCode.TOOL_TIMEOUT)
    if progress is not None and progress("CalculiX", 0.5) is False:
        raise HexconError("cancelled while CalculiX ran", ErrorCode.CANCELLED)
