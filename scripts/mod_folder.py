# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by freecadcmd: tell the folder from which this FreeCAD, and no other version, reads a user's addons."""
import os
import sys

import FreeCAD

print("FREECAD_MOD=" + os.path.join(FreeCAD.getUserAppDataDir(), "Mod"))
sys.stdout.flush()
os._exit(0)
