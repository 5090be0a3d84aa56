# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's start in every FreeCAD, with a window or without: it makes `import hexcon` work.

Nothing is registered and nothing of HexCon imported here, so a core that is not built yet costs
nothing until it is used.
"""


def _make_importable():
    import importlib.util
    import os
    import sys

    # FreeCAD executes this text without __file__, but has put this folder on sys.path
    spec = importlib.util.find_spec("hexcon_native")
    if spec is None or not spec.origin:
        return
    root = os.path.dirname(os.path.dirname(os.path.abspath(spec.origin)))
    packages = os.path.join(root, "workbench")
    if os.path.isdir(packages) and packages not in sys.path:
        sys.path.insert(0, packages)


_make_importable()
del _make_importable
