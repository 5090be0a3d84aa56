# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of named parts from solid to solved model, in FreeCADCmd (see parts_figures.py):

    freecadcmd tests/freecad/parts_table.py -- [--surface-method auto blossom] [--part torus] [--factor 1 0.6]
                                               [--result output/parts.txt]
"""
import os
import sys
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

if __name__ in ("__main__", "parts_table"):
    status = 0
    try:
        from parts_figures import main
        main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    except SystemExit as stop:
        status = stop.code or 0
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)    # FreeCAD would run a script that raises a second time and exit with 0
