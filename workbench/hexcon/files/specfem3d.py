# SPDX-License-Identifier: LGPL-2.1-or-later
""".specfem3d: a folder of the text files that SPECFEM3D Cartesian's xdecompose_mesh reads.

The formats are what its src/decompose_mesh/read_mesh_files.F90 reads. Hexes have 8 nodes or 27 (NGNOD in its Par_file),
never 20: at order 2 the middles of faces and hexes are added, where the 20 nodes put them. The order is VTK's but for
the edges of the top, which follow the upright ones.
"""
import os
import re

import numpy as np

from hexcon.femmesh.second_order import with_centres

from .abaqus import STEEL_DENSITY, STEEL_POISSON, STEEL_YOUNG
from .text import write_numbered, write_rows

FREE = "free_or_absorbing_surface_file_zmax"
ABSORBING = {(0, 0): "absorbing_surface_file_xmin", (0, 1): "absorbing_surface_file_xmax",
             (1, 0): "absorbing_surface_file_ymin", (1, 1): "absorbing_surface_file_ymax",
             (2, 0): "absorbing_surface_file_bottom"}
"""(axis, 1 at its upper end): the file of what lies in that side of the bounding box."""
FLAT = 1e-9     # of the box's diagonal: how far from a side of the box a point may be that lies in it
_OTHERS = ("nodes_coords_file", "mesh_file", "materials_file", "nummaterial_velocity_file")
NODES = {1: np.arange(8), 2: np.r_[0:12, 16:20, 12:16, 20:27]}


def is_own(name):
    """Whether write makes files of that name."""
    return name in (*_OTHERS, FREE, *ABSORBING.values()) or bool(name.endswith("_surface_file"))


def write(folder, elements):
    """A new folder: nodes_coords_file, mesh_file, materials_file, nummaterial_velocity_file, files of boundary faces.

    Boundary faces in a side of the bounding box go into its absorbing_surface_file, all others, and the upper side's,
    into free_or_absorbing_surface_file_zmax. Besides, each group of faces has a file of its own, Face3_surface_file,
    which SPECFEM3D leaves alone: to put together other files from. The material is .inp's, in its units (mm, t, s)."""
    os.mkdir(folder)
    points, hexes, quads = elements.points, elements.hexes, elements.quads
    if elements.order == 2:
        points, hexes, quads = with_centres(points, hexes, elements.hex_of_quad, elements.side_of_quad)

    def put(name, format_of_row, rows, head=None):
        with open(os.path.join(folder, name), "w", encoding="ascii") as stream:
            stream.write("" if head is None else f"{head}\n")
            write_rows(stream, format_of_row, rows)
    with open(os.path.join(folder, "nodes_coords_file"), "w", encoding="ascii") as stream:
        stream.write(f"{len(points)}\n")
        write_numbered(stream, "%d %r %r %r\n", points)
    numbers = np.arange(1, len(hexes) + 1)
    put("mesh_file", _whole(1 + hexes.shape[1]),
        np.column_stack([numbers, hexes[:, NODES[elements.order]] + 1]), len(hexes))
    put("materials_file", _whole(2), np.column_stack([numbers, np.ones_like(numbers)]))
    _write_material(os.path.join(folder, "nummaterial_velocity_file"))
    faces = np.column_stack([elements.hex_of_quad, quads]) + 1
    for name, rows in _files_of_faces(points, elements):
        put(name, _whole(faces.shape[1]), faces[rows], len(rows))


def _whole(count):
    """Format of a row of whole numbers."""
    return " ".join(["%d"] * count) + "\n"


def _files_of_faces(points, elements):
    """(name, rows of quads): each quad in one file of the box's sides, and in its group's."""
    corners = points[elements.quads[:, :4]]
    least, most = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    left = np.ones(len(corners), bool)
    tolerance = FLAT * np.linalg.norm(most - least)
    for (axis, upper), name in ABSORBING.items():
        side = (most if upper else least)[axis]
        inside = left & (np.abs(corners[:, :, axis] - side) <= tolerance).all(axis=1)
        left &= ~inside
        yield name, np.flatnonzero(inside)
    yield FREE, np.flatnonzero(left)
    for _, name, rows in elements.all_groups():
        yield f"{re.sub(r'[^A-Za-z0-9_.-]', '_', name)}_surface_file", rows


def _write_material(path):
    """One elastic material: its number 1, density, speeds of both waves, no attenuation (9999), isotropic."""
    stretching = STEEL_YOUNG * (1 - STEEL_POISSON) / ((1 + STEEL_POISSON) * (1 - 2 * STEEL_POISSON))
    shearing = STEEL_YOUNG / (2 * (1 + STEEL_POISSON))
    speeds = (float(np.sqrt(modulus / STEEL_DENSITY)) for modulus in (stretching, shearing))
    with open(path, "w", encoding="ascii") as stream:
        stream.write("2 1 {!r} {:.6e} {:.6e} 9999 9999 0\n".format(STEEL_DENSITY, *speeds))
