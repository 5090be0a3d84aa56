# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line inside freecadcmd, for files that need FreeCAD where its Python modules
cannot be imported from outside (an AppImage, say).

Run as a script by freecadcmd: `freecadcmd in_freecad.py -- FOLDER mesh part.FCStd -o part.med`. It leaves in FOLDER
the file `started` when it starts, and answer.json when all is done: exit status, and what the command printed.
"""
import contextlib
import io
import json
import os
import shutil
import sys
import time

FREECAD_ENDINGS = (".fcstd", ".med")
STARTING = 120.0    # seconds in which freecadcmd must have come to the script; what the command takes is its own affair


def can_import_freecad():
    """True where FreeCAD's modules load into this interpreter."""
    from hexcon.errors import ToolError
    from hexcon.freecad_compat import freecad
    try:
        freecad()
    except ToolError:
        return False
    return True


def needs_freecad(paths):
    """True if one of the files can only be read or written by FreeCAD."""
    return any(path.lower().endswith(FREECAD_ENDINGS) for path in paths)


def rerun(arguments=None):
    """Run the command in freecadcmd and say what it says; returns its exit status, None if there is no freecadcmd.

    arguments  of the command, None: this program's
    Raises ToolError: TOOL_MISSING, TOOL_FAILED (it came to no answer), TOOL_TIMEOUT (it did not start).
    """
    from hexcon import answers, child, disk
    from hexcon.errors import FaultCode, ToolError

    from .terminal import complain, say
    program = shutil.which(os.environ.get("FREECADCMD") or "freecadcmd")
    if program is None:
        return None
    arguments = sys.argv[1:] if arguments is None else arguments
    with disk.working_folder("hexcon-cli-") as folder, disk.naming(folder, f"work in {folder}"):
        limit, started = time.monotonic() + STARTING, os.path.join(folder, "started")

        def look():
            if time.monotonic() > limit and not os.path.exists(started):
                raise ToolError(f"{program} did not start within {STARTING:g} seconds; FREECADCMD can name another",
                                FaultCode.TOOL_TIMEOUT)
        ended = child.run([program, os.path.abspath(__file__), "--", folder, *arguments], "FreeCAD",
                          environment=child.python_environment(program, TMPDIR=folder), look=look)
        path = os.path.join(folder, "answer.json")
        if ended.status < 0 or not os.path.exists(path):
            raise ToolError(f"FreeCAD ({program}) {ended.how()} and did not come to an answer: {ended.last_words()}",
                            FaultCode.TOOL_FAILED)
        answer = answers.read_json(path, "FreeCAD", {"status": int, "output": str, "errors": str})
    if answer["output"]:
        say(answer["output"].rstrip("\n"))
    if answer["errors"]:
        complain(answer["errors"].rstrip("\n"))
    return answer["status"]


def _run():
    """What happens in freecadcmd; the exit status."""
    workbench = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    sys.path[:] = [os.path.dirname(workbench), workbench, *filter(os.path.isabs, sys.path)]
    folder, *arguments = sys.argv[sys.argv.index("--") + 1:]
    with open(os.path.join(folder, "started"), "wb"):
        pass
    # FreeCAD prints a banner and more: what the command says goes another way
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        from hexcon.cli import program
        status = program(arguments)
    path = os.path.join(folder, "answer.json")
    with open(path + ".part", "w", encoding="utf-8") as stream:
        json.dump({"status": status, "output": output.getvalue(), "errors": errors.getvalue()}, stream)
    os.replace(path + ".part", path)
    return status


if __name__ == "in_freecad":  # the name freecadcmd gives a script
    status = 1
    try:
        status = _run()
    except BaseException:  # FreeCAD would run a script that raises a second time and exit with 0
        import traceback
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
