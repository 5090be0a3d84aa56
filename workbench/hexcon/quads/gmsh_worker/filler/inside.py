# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes inside closed quads, by the methods for solvers that keep them."""
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import hexcon_native as hn

from ..layered.fault import NotLayered

METHODS = ("diced", "cells")
COARSENING = 0.5                        # of tetrahedra away from the quads
ALGORITHMS = ("Delaunay", "HXT")        # of the worker of tetrahedra, the better one first
PATIENCE = 30.0                         # seconds for it
SECONDS = 5.0                           # that a method has at least


def filled(points, quads, name, end):
    """The hexcon_native.Mesh of closed quads, outward, by the first of METHODS that comes to one.

    name: of the room; end: of processor time. Raises NotLayered.
    """
    told = []
    for method in METHODS:
        try:
            return hn.mesh(points, quads, method, threads=1, tetrahedralise=_tetrahedra,
                           budget=max(end - time.process_time(), SECONDS))
        except hn.HexconError as fault:
            told.append(f"{method}: {fault}")
    raise NotLayered(f"{name}: {len(quads)} quads are not filled: " + "; ".join(told))


def _tetrahedra(points, triangles):
    """As hexcon_native.mesh takes them, by gmsh in a process of its own, for it is of no more use once it has failed;
    None where it finds none."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "surface.npz")
        np.savez(path, points=points, triangles=triangles)
        job = os.path.join(folder, "job.json")
        with open(job, "w", encoding="utf-8") as stream:
            json.dump({"file": path, "timeout": PATIENCE, "avoid": [], "coarsening": COARSENING}, stream)
        try:
            ended = subprocess.run([sys.executable, "-m", "tetrahedra_worker", job], cwd=folder, timeout=PATIENCE,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        except subprocess.TimeoutExpired:
            return None
        result = os.path.join(folder, "result.npz")
        if ended.returncode or not os.path.exists(result):
            return None
        with np.load(result) as found:
            for one in ALGORITHMS:
                if one + "_tetrahedra" in found:
                    return found[one + "_points"][len(points):], found[one + "_tetrahedra"]
    return None
