# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the subprocess tells its parent while it works: how far it is, what may kill it, and what it has so far."""
import os
import signal

import numpy as np


class Link:
    """folder: where the parent reads; avoid: names of risks that killed an earlier run.

    patience  seconds of processor time that one risk may take before it ends this process; None: any number
    """

    def __init__(self, folder=None, avoid=()):
        self.avoid, self.patience = set(avoid), None
        self._folder = folder
        self._round = ""
        self._stream = folder and open(os.path.join(folder, "progress.txt"), "w", encoding="utf-8")
        self._arrays, self._is_settled = None, False

    def progress(self, stage, fraction):
        """Write a line; stage is one word."""
        if self._stream:
            self._stream.write(f"{stage} {fraction:.3f}\n")
            self._stream.flush()

    def risk(self, name):
        """Announce a gmsh call that may crash, or not end; False if it has done so before and must be left out."""
        name += self._round
        if name in self.avoid:
            return False
        if self._folder:
            with open(os.path.join(self._folder, "risk.txt"), "w", encoding="utf-8") as stream:
                stream.write(name)
            self._end_after(self.patience or 0.0)
        return True

    def over(self):
        """No call that was announced is at work any more."""
        self._end_after(0.0)
        if self._folder and os.path.exists(os.path.join(self._folder, "risk.txt")):
            os.remove(os.path.join(self._folder, "risk.txt"))

    def _end_after(self, seconds):
        if self._folder and hasattr(signal, "setitimer"):       # not on Windows
            signal.setitimer(signal.ITIMER_PROF, seconds)

    def second(self, mesh):
        """Another mesh is to be made of the solid, for which this one is kept; its risks are others."""
        self.over()
        self.keep(mesh)
        self._round = ", more quads on round faces"

    def kept_as(self, arrays):
        """arrays: callable(mesh) -> arrays of result.npz for a mesh that keep is called with."""
        self._arrays = arrays

    def keep(self, mesh):
        """Leave the best mesh so far in best.npz: the parent takes it where time runs out."""
        if self._folder and self._arrays and not self._is_settled:
            self._leave(self._arrays(mesh))

    def settled(self, arrays):
        """A whole mesh is there: keep leaves no other, and only a better whole one comes in its place."""
        self._is_settled = True
        if self._folder:
            self._leave(arrays)

    def _leave(self, arrays):
        path = os.path.join(self._folder, "best.npz")
        with open(path + ".part", "wb") as stream:
            np.savez(stream, **arrays)
        os.replace(path + ".part", path)
