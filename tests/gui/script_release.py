# SPDX-License-Identifier: LGPL-2.1-or-later
"""A release in the Mod folder of a user who has nothing else (scripts/try_release.sh): the core is the one it brings,
and the path from an empty document to displacements is walked by clicks."""
import os

import FreeCAD
import FreeCADGui
from session import displacements_by_clicks, run, say


def the_core_is_the_releases():
    FreeCADGui.activateWorkbench("HexConWorkbench")
    import hexcon_native
    from hexcon_native import core_builds
    say("FreeCAD", *FreeCAD.Version()[:3], "core", hexcon_native._core.__file__)
    assert os.path.dirname(hexcon_native._core.__file__) == core_builds.folder()
    assert core_builds.folder().startswith(FreeCAD.getUserAppDataDir()), core_builds.folder()


run(the_core_is_the_releases, displacements_by_clicks)
