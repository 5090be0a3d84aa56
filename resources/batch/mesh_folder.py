# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex meshes for a folder of parts, in FreeCADCmd:

    freecadcmd mesh_folder.py -- FOLDER --size 4 [--out DIR] [--write .inp] [--write .FCStd]
                                 [--order 2] [--surface-method sweep] [--method cells]
                                 [--allow-topological]

One line a part, a summary; exit status 0 if every part was meshed, 1 if one failed, 2 for wrong
usage. What follows `--` is for this script (FreeCAD refuses dashes before it).
"""
import os
import sys
import traceback

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:] = [ROOT, os.path.join(ROOT, "workbench"), *filter(os.path.isabs, sys.path)]


def run():
    """Exit status of the batch."""
    try:
        from hexcon.batch import program
        given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else sys.argv[2:]
        return program(given)
    except BaseException:
        traceback.print_exc()
        return 1


if __name__ in ("__main__", "mesh_folder"):
    status = run()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # FreeCAD would run a script that raises a second time and exit with 0
