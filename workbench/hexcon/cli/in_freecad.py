# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line inside freecadcmd, for files that need FreeCAD where its Python modules
cannot be imported from outside (an AppImage, say).

Run as a script by freecadcmd: `freecadcmd in_freecad.py -- ANSWER mesh part.FCStd -o part.med`,
where the file ANSWER receives what the command prints.
"""
import contextlib
import os
import shutil
import subprocess
import sys
import traceback

FREECAD_ENDINGS = (".fcstd", ".med")


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


def rerun(arguments):
    """Run the command in freecadcmd; returns its exit status, None if there is no freecadcmd."""
    program = shutil.which(os.environ.get("FREECADCMD") or "freecadcmd")
    if program is None:
        return None
    from hexcon.disk import working_folder
    with working_folder("hexcon-cli-") as folder:
        answer = os.path.join(folder, "answer")
        status = subprocess.run([program, os.path.abspath(__file__), "--", answer, *arguments],
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                check=False).returncode
        if os.path.exists(answer):
            with open(answer, encoding="utf-8") as stream:
                sys.stdout.write(stream.read())
    return status


def _run():
    workbench = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    sys.path[:0] = [os.path.dirname(workbench), workbench]
    answer, *arguments = sys.argv[sys.argv.index("--") + 1:]
    try:
        from hexcon.cli import main
        # FreeCAD prints a banner and more on standard output: the answer goes to a file
        with open(answer, "w", encoding="utf-8") as stream, contextlib.redirect_stdout(stream):
            return main(arguments)
    except SystemExit as stop:  # argparse
        return stop.code if isinstance(stop.code, int) else 2
    except BaseException:
        traceback.print_exc()
        return 1


if __name__ == "in_freecad":  # the name freecadcmd gives a script
    status = _run()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # FreeCAD would run a script that raises a second time and exit with 0
