# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why a solid is not layered along a direction, in words."""


class NotLayered(Exception):
    """faces: CAD faces at fault."""

    def __init__(self, message, faces=()):
        super().__init__(message)
        self.faces = list(faces)
