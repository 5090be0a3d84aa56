# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which solid of a file is meant, where it may hold several."""
import os
from dataclasses import dataclass


@dataclass(frozen=True)
class SolidChoice(os.PathLike):
    """The path of a file, and the choice of one solid in it: taken wherever the path of a solid's file is.

    path         a .FCStd, .step, .brep ... file
    object_name  name or label of the object of a document that holds it; None: any
    number       which of the solids left, 1, 2, ... as the refusal of several lists them; None: the only one
    scale        what all lengths are multiplied by
    """

    path: str
    object_name: str | None = None
    number: int | None = None
    scale: float = 1.0

    def __fspath__(self):
        return os.fsdecode(self.path)

    @property
    def plain(self):
        """Whether the file is taken as it is."""
        return self.object_name is None and self.number is None and self.scale == 1.0

    def as_dict(self):
        """For a reader in another process."""
        return {"object_name": self.object_name, "number": self.number, "scale": self.scale}


def choice_of(path):
    """The SolidChoice that a path is, or stands for."""
    return path if isinstance(path, SolidChoice) else SolidChoice(os.fsdecode(path))
