# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python for processes of our own: inside FreeCAD sys.executable is FreeCAD itself."""
import os
import shutil
import sys


def python():
    """$HEXCON_PYTHON, or this interpreter, or inside FreeCAD the one it was built for."""
    if os.environ.get("HEXCON_PYTHON"):
        return os.environ["HEXCON_PYTHON"]
    if os.path.basename(sys.executable or "").lower().startswith("python"):
        return sys.executable
    name = f"python{sys.version_info.major}.{sys.version_info.minor}"
    beside = os.path.join(sys.base_prefix, "bin", name)
    return beside if os.path.exists(beside) else (shutil.which(name) or "python3")
