# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a solid is not layered along a direction, in words."""


class NotLayered(Exception):
    """faces: CAD faces at fault, which the words name."""

    def __init__(self, message, faces=()):
        self.faces = sorted(faces)
        named = "Face" in message or not self.faces
        super().__init__(message if named else f"{message}, at " + ", ".join(f"Face{f}" for f in self.faces[:8]))
