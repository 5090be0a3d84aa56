# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the subprocess tells its parent while it works: how far it is, and what may kill it."""
import os


class Link:
    """folder: where the parent reads; avoid: names of risks that killed an earlier run."""

    def __init__(self, folder=None, avoid=()):
        self.avoid = set(avoid)
        self._risk_path = folder and os.path.join(folder, "risk.txt")
        self._stream = folder and open(os.path.join(folder, "progress.txt"), "w", encoding="utf-8")

    def progress(self, stage, fraction):
        """Write a line; stage is one word."""
        if self._stream:
            self._stream.write(f"{stage} {fraction:.3f}\n")
            self._stream.flush()

    def risk(self, name):
        """Announce a gmsh call that may crash; False if it has done so before and must be left out."""
        if name in self.avoid:
            return False
        if self._risk_path:
            with open(self._risk_path, "w", encoding="utf-8") as stream:
                stream.write(name)
        return True
