# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the addon lies; the package hexcon cannot be asked, as it needs the native core."""
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__))))))


def icon_path(name):
    """Path of an icon of the addon, by its file's name."""
    return os.path.join(ROOT, "resources", "icons", name)
