# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by freecadcmd: tell which interpreter matches the Python inside FreeCAD."""
import os
import sys

name = f"python{sys.version_info.major}.{sys.version_info.minor}"
print("FREECAD_PYTHON=" + os.path.join(sys.base_prefix, "bin", name))
sys.stdout.flush()
os._exit(0)
