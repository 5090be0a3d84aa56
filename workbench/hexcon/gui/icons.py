# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where HexCon's icons are."""
import os

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))),
                      "resources", "icons")


def icon_path(name):
    """Path of an icon by its name, HexCon_Inspect say."""
    return os.path.join(FOLDER, f"{name}.svg")
