# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells in FreeCAD and CalculiX: solids that are no sweeps, and what the elements are worth."""
import pathlib
import sys

import numpy as np
import pytest
from quads_solids import Part
from test_calculix_deck import patch_error
from test_calculix_solve import FORCE, LENGTH, POISSON, SIDE, YOUNG, timoshenko
from tetrahedron_beam import end_deflection

import hexcon
from hexcon import calculix, femmesh
from hexcon.meshing import mesh_surface

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "python"))
from blossom_surfaces import surface_of_size  # noqa: E402

# Body, method and size of surfaces of 45 to 80 quads (the box by gmsh 4.15: 92).
PATCHES = [("box", "blossom", 0.5), ("cylinder", "blossom", 0.55), ("frustum", "blossom", 0.5),
           ("hexagonal_prism", "blossom", 0.5), ("ball", "blossom", 0.5),
           ("half_ball", "blossom", 0.45), ("ball", "subdivided", 0.5),
           ("triangular_prism", "blossom", 0.6), ("hexagonal_prism", "subdivided", 1.2),
           ("chamfered", "subdivided", 1.8)]


@pytest.fixture(scope="module")
def cad_folder(tmp_path_factory):
    return str(tmp_path_factory.mktemp("bodies"))


@pytest.mark.parametrize("body,surface_method,size", PATCHES)
def test_patch(cad_folder, body, surface_method, size):
    """A linear displacement on the boundary alone: the one stress at every integration point."""
    mesh = mesh_surface(*surface_of_size(body, size, surface_method, cad_folder), "cells")
    assert mesh.certificate.certified and 45 <= len(mesh.quads) <= 100
    for order in (1, 2) if body == "triangular_prism" else (1,):
        stress, nodal, displacement = patch_error(mesh, order)
        print(f"patch {body}, {surface_method}, order {order}: {len(mesh.quads)} quads, "
              f"{len(mesh.hexes)} hexes, scaled Jacobian min {mesh.quality.min:.3f}: stress "
              f"{stress:.1e}, at nodes {nodal:.1e}, displacement {displacement:.1e}")
        assert stress < 1e-4 and nodal < 1e-4 and displacement < 1e-4


def chamfered_box():
    """A box with the three edges of one corner chamfered: three caps, no sweep."""
    box = Part.makeBox(12, 10, 8)
    corner = [edge for edge in box.Edges
              if any(vertex.Point.Length < 1e-9 for vertex in edge.Vertexes)]
    return box.makeChamfer(3, corner)


@pytest.mark.parametrize("make,size", [(lambda: Part.makeSphere(5), 2.5), (chamfered_box, 8.0)],
                         ids=["ball", "chamfered box"])
@pytest.mark.parametrize("surface_method,method", [("auto", "auto"), ("subdivided", "cells")])
def test_a_solid_that_is_no_sweep(doc, make, size, surface_method, method):
    shape = make()
    solid = doc.addObject("Part::Feature", "Solid")
    solid.Shape = shape
    mesh = hexcon.mesh_solid(shape, size, surface_method=surface_method, method=method)
    print(f"{mesh} of {len(mesh.quads)} quads")
    assert mesh.certificate.certified
    assert mesh.method == method or (method == "auto" and len(mesh.hexes) < 4 * len(mesh.quads))
    assert np.array_equal(mesh.points[:len(mesh.surface.points)], mesh.surface.points)
    mesh_object = femmesh.add_to_document(doc, mesh, solid)
    assert mesh_object.FemMesh.HexaCount == len(mesh.hexes) == mesh_object.FemMesh.VolumeCount
    assert mesh_object.FemMesh.GroupCount == len(shape.Faces)


# Element types, and the least and the most of Timoshenko's deflection: what is integrated in full
# stays below it, as elements that conform must.
SOLVED = {"C3D8": (0.07, 0.3), "C3D20": (0.6, 1.0), "C3D20R": (0.9, 1.05)}


def beam_deflection(mesh, kind):
    """Mean of the end's nodes, downwards, in parts of Timoshenko's."""
    order = 1 if kind == "C3D8" else 2
    deck = calculix.static_deck(mesh, fixed=["Face1"], force={"Face2": (0, 0, -FORCE)}, order=order,
                                element=kind)
    result = calculix.solve_inp(deck)
    return -result.displacements[femmesh.face_nodes(mesh, 2, order), 2].mean() / timoshenko()


def test_cantilever(tmp_path):
    """A beam of cells beside one of ten-node tetrahedra (C3D10) of the same size. Measured, end
    deflection in parts of Timoshenko's:

        surface         quads  hexes   C3D8   C3D20  C3D20R   C3D10
        blossom, 20        26   1136   0.111  0.722  0.949    0.978
        blossom, 10       112   5456   0.103  0.859  1.009    0.987
        subdivided, 20     72   3324   0.465  0.931  0.977    0.978
        subdivided, 10    104   4872   0.705  0.971  0.987    0.987

    Fully integrated, cells are too stiff in bending, at first order and on crooked quads far too
    stiff: trilinear hexes that are no parallelepipeds are known for it, and another program that
    puts the same elements together gives what ccx does, to six digits. C3D20R, which HexCon does
    not write, is better.
    """
    size = 20.0  # finer ones take longer to mesh than a test should
    mesh = hexcon.mesh_solid(Part.makeBox(LENGTH, SIDE, SIDE), size, surface_method="blossom",
                             method="cells")
    assert mesh.certificate.certified
    ratios = {kind: beam_deflection(mesh, kind) for kind in SOLVED}
    tetrahedra, count, nodes = end_deflection(LENGTH, SIDE, size, FORCE, (YOUNG, POISSON),
                                              str(tmp_path))
    print(f"size {size}: {len(mesh.quads)} quads, {len(mesh.hexes)} hexes: "
          + ", ".join(f"{kind} {ratio:.3f}" for kind, ratio in ratios.items())
          + f" of Timoshenko; {count} C3D10, {nodes} nodes: {tetrahedra / timoshenko():.3f}")
    for kind, (least, most) in SOLVED.items():
        assert least < ratios[kind] < most
    assert abs(tetrahedra / timoshenko() - 1) < 0.05
