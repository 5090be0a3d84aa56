# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages that put hexes in, as a mesh's report counts them: are the hexes really theirs?"""
from collections import Counter
from types import SimpleNamespace

import numpy as np
import pytest
from cell_surfaces import merged_hull, sphere
from surfaces import box, schneiders_pyramid
from test_shelling import rotated_ball

import hexcon_native as hn
from hexcon.errors import FaultCode, ToolError
from hexcon.inspection.opening import InspectedMesh, Opening
from hexcon.inspection.stages import ALL, counts_of, stage_of_hex, stages_of

SIDES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def bare_faces(hexes):
    """Faces of one hex alone, by a plain loop."""
    found = Counter(frozenset(corners[i] for i in side) for corners in hexes.tolist() for side in SIDES)
    return {face for face, count in found.items() if count == 1}


def peeled(mesh):
    """(names, faces that are bare when the first 0, 1, ... stages are gone)."""
    stages = stages_of(mesh)
    assert stages[0][1].start == 0 and stages[-1][1].stop == len(mesh.hexes)
    return [name for name, _ in stages], [bare_faces(mesh.hexes[rows.start:]) for _, rows in stages]


@pytest.mark.parametrize("layers", [0, 2])
def test_cells(layers):
    """Layers keep the quads; a domino lays two triangles under each, diced into three."""
    surface = sphere(2)
    mesh = hn.mesh(*surface, "cells", layers=layers, pillow="never")
    names, bare = peeled(mesh)
    count = len(surface[1])
    assert names == ["layers", "cells", "star"][-len(names):] and ("layers" in names or not layers)
    assert [len(faces) for faces in bare] == [count, count, 6 * count][-len(names):]
    assert bare[0] == {frozenset(quad) for quad in surface[1].tolist()}


def test_layers_and_a_core():
    mesh = hn.mesh(*schneiders_pyramid(), "sheets", pillow="never")
    names, bare = peeled(mesh)
    assert names == ["layers", "core"] and [len(faces) for faces in bare] == [16, mesh.report["core quads"]]


def test_diced():
    """A coarse quad leaves the four triangles of its pyramid, or two; each shows three quads."""
    surface = merged_hull(np.random.default_rng(3), 14)
    mesh = hn.mesh(*surface, "diced", pillow="never")
    names, bare = peeled(mesh)
    report = mesh.report
    assert report["coarse quads"] > 0 and names[1:] == ["tetrahedra"]
    assert names[0] == ("pyramids" if report["pyramids"] else "geodes")
    triangles = report["coarse triangles"] + (4 * report["pyramids"] or 2 * report["geodes"])
    assert len(bare[1]) == 3 * triangles


def test_shelling():
    surface = rotated_ball(1, 1)
    names, bare = peeled(hn.mesh(*surface, "shelling", pillow="never"))
    assert names == ["shells", "sheets inside"] and [len(faces) for faces in bare] == 2 * [len(surface[1])]


def test_topological_and_plain():
    names, bare = peeled(hn.mesh(*schneiders_pyramid(), "pyramid"))
    assert names == ["paired transition", "split layer 1", "split layer 2", "closure"] and len(bare[-1]) == 8 * 6 * 4  # cells of six
    mesh = hn.mesh(*box(2, 2, 2))
    assert counts_of(mesh.report) == [] and stages_of(mesh) == [(ALL, slice(0, 8))]


def test_counts_of_other_hexes_are_refused():
    mesh = SimpleNamespace(hexes=np.zeros((5, 8), int), report={"hexes of layers": 4.0})
    with pytest.raises(ToolError) as raised:
        stages_of(mesh)
    assert raised.value.code is FaultCode.BAD_MESH
    assert stage_of_hex([("layers", 4)], np.arange(5)) is None and stage_of_hex([], np.arange(5)) is None
    # element numbers need not rise in a FEM mesh of others
    assert stage_of_hex([("layers", 2), ("core", 1)], np.array([30, 10, 20])).tolist() == [1, 0, 0]


def test_stages_are_hidden():
    mesh = hn.mesh(*schneiders_pyramid(), "sheets", pillow="never")
    counts = counts_of(mesh.report)
    inspected = InspectedMesh(mesh, counts)
    (_, layers), (_, core) = inspected.stages
    assert Opening(hidden=("layers",)).keep(inspected).tolist() == layers * [False] + core * [True]
    assert not Opening(hidden=("core", "layers")).keep(inspected).any()
    assert Opening(peel=1, hidden=("core",)).keep(inspected).sum() == (inspected.layer[:layers] > 1).sum()
    with pytest.raises(ToolError, match="it has layers, core") as raised:
        Opening(hidden=("walls",)).keep(inspected)
    assert raised.value.code is FaultCode.BAD_OPTION
    assert InspectedMesh(mesh, [("layers", 3)]).stages == [(ALL, len(mesh.hexes))]
