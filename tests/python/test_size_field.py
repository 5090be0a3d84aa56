# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes by place: the field itself, how people write local sizes, and surfaces that follow them."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker.detail_sizes import detail_sizes
from hexcon.quads.gmsh_worker.size_field import GROWTH, Place, SizeField
from hexcon.quads.local_sizes import of_the_solid, parsed

PLATE = "occ.cut([(3, occ.addBox(0, 0, 0, 40, 16, 4))], [(3, occ.addCylinder(20, 8, -1, 0, 0, 6, 4))])"


def test_field():
    place = Place(np.array([0, 0, 4.0]), np.array([9, 9, 9.0]), 0.0, 0.25)
    field = SizeField(2.0, [[0, 0, 0], [5, 0, 0]], [0.5, 3.0], [place])
    sizes = field([[0, 0, 0], [1, 0, 0], [5, 0, 0], [0, 0, 5], [0, 0, 3]])
    assert sizes[2] == 2.0 and sizes[3] == 0.25 and sizes[4] == pytest.approx(0.25 + GROWTH)
    assert 0.4 < sizes[0] <= 0.5 and sizes[1] - sizes[0] == pytest.approx(GROWTH)
    assert field.least == 0.25 and not field.even and SizeField(1.0, [[0, 0, 0]], [1.5]).even
    with pytest.raises(ValueError, match="positive"):
        SizeField(1.0, [[0, 0, 0]], [-1.0])
    with pytest.raises(ValueError, match="one each"):
        SizeField(1.0, [[0, 0, 0]], [1.0, 2.0])


@pytest.mark.parametrize("seed", range(3))
def test_field_of_random_sources(seed):
    """Against the least of all cones: never above it, and at most a class of sizes below."""
    rng = np.random.default_rng(seed)
    points, sizes, at = rng.uniform(0, 10, (60, 3)), rng.uniform(0.1, 3, 60), rng.uniform(0, 10, (200, 3))
    field = SizeField(2.5, points, sizes)
    exact = np.minimum(2.5, (sizes + GROWTH * np.linalg.norm(at[:, None] - points, axis=2)).min(axis=1))
    assert (field(at) <= exact + 1e-12).all() and (field(at) >= 2 ** -0.25 * exact - 1e-12).all()
    twice = field.scaled(2.0)
    assert twice.size == 5.0 and twice.least == 2 * field.least
    both = SizeField(2.5, points[:30], sizes[:30]).joined(SizeField(2.5, points[30:], sizes[30:]))
    assert (both(at) == field(at)).all()
    dense = SizeField(2.5, np.column_stack([np.linspace(0, 10, 400), np.zeros(400), np.zeros(400)]),
                      0.2 + 0.1 * np.sin(np.linspace(0, 9, 400)))
    one = [dense.for_gmsh(0, 0, *p) for p in at]
    assert np.abs(one / dense(at) - 1).max() < 0.25


def test_details_want_smaller_elements(features):
    """A plain box has none. A tube's thin wall behind its round faces allows the root of thickness times radius."""
    field, wall = detail_sizes(features(lambda occ: occ.addBox(0, 0, 0, 6, 5, 4), 1.0).cad.solid, 1.0)
    assert field.even and wall == np.inf

    def tube(occ):
        occ.cut([(3, occ.addCylinder(0, 0, 0, 0, 0, 9, 4))], [(3, occ.addCylinder(0, 0, 0, 0, 0, 9, 3.5))])
    field, wall = detail_sizes(features(tube, 2.0).cad.solid, 2.0)
    assert wall == pytest.approx(np.sqrt(0.5 * 3.5)) and 0.84 * wall < field([[-3.5, 0, 4.5]])[0] <= 1.01 * wall
    assert field.least == pytest.approx(0.5) and field([[0, 0, 30]])[0] == 2.0     # across the rings at its ends


def test_what_wants_them_is_named():
    field = SizeField(2.0, np.zeros((3, 3)), [1.0, 0.5, 1.5], names=("Face1", "Edge3"), name_of=[0, 1, 1])
    assert field.smallest_names(5) == ["Edge3", "Face1"] and field.smallest_names(1) == ["Edge3"]


def test_how_they_are_written():
    found = parsed({"Face3": 1.5, "box: 4,0,0, 1,2,3": 0.5})
    assert found == parsed(["Face3=1.5", "box: 4,0,0, 1,2,3=0.5"])
    assert found[0] == {"where": "Face3", "kind": "face", "tag": 3, "size": 1.5}
    assert found[1]["at"] == [1, 0, 0, 4, 2, 3]
    assert [one["kind"] for one in parsed(["Edge1=1", "Vertex2=1", "point:0,0,0=1", "ball:0,0,0,2=1"])] == \
        ["edge", "vertex", "point", "ball"]
    assert of_the_solid(parsed(["Face7=1"]), [3, 7])[0]["tag"] == 2
    assert of_the_solid(parsed(["Face7=1"]), None)[0]["tag"] == 7


@pytest.mark.parametrize("text", ["Face0=1", "face3=1", "Face3", "Face3=0", "Face3=nan", "Face3=x", "=1", "point:1,2=1",
                                  "ball:0,0,0,-1=1", "box:0,0,0,1,1=1", "point:1,2,inf=1", "Solid1=2"])
def test_what_is_none_is_refused(text):
    with pytest.raises(ToolError) as caught:
        parsed([text])
    assert caught.value.code is FaultCode.BAD_OPTION


def test_numbers_of_another_shape():
    for text in ("Face4=1", "Edge1=1"):
        with pytest.raises(ToolError, match="more than its solid"):
            of_the_solid(parsed([text]), [3, 7])


def edges_near(surface, at, reach):
    """Lengths of the surface's edges whose middles are within reach of a place (3,), NaN: anywhere along that axis."""
    a, b = surface.points[surface.quads], surface.points[np.roll(surface.quads, -1, axis=1)]
    away = np.nan_to_num(((a + b) / 2 - at).reshape(-1, 3))
    return np.linalg.norm(a - b, axis=2).ravel()[np.linalg.norm(away, axis=1) < reach]


# where: (a place there, one far away)
WHERE = {"Face1": ([0, np.nan, np.nan], [38, 8, np.nan]), "point:40,16,4": ([40, 16, 4], [3, 3, np.nan]),
         "box:38,0,0,40,16,4": ([40, np.nan, np.nan], [3, 8, np.nan])}


@pytest.mark.parametrize("where", WHERE)
def test_the_grid_follows(tmp_path, where):
    """Small where it is asked for, large elsewhere; certified; no more quads than the sizes want, twice."""
    path = cad_file(PLATE, tmp_path / "solid.brep")
    mesh = hexcon.mesh_solid(path, 4.0, surface_method="grid", local_sizes={where: 1.0})
    surface = mesh.surface
    assert mesh.certificate.certified and mesh.quality.min > 0.2
    assert not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    here, there = WHERE[where]
    assert edges_near(surface, here, 0.8).max() < 1.6
    assert np.median(edges_near(surface, there, 6.0)) > 2.5
    plain = surface_from_solid(path, 4.0, "grid")
    assert len(plain.quads) < len(surface.quads) < 12 * len(plain.quads)


@pytest.mark.parametrize("method", ["layered", "sweep"])
@pytest.mark.parametrize("where", WHERE)
def test_edges_are_divided_as_sizes_want(tmp_path, where, method):
    """Edges of the CAD near the place finely, those far away less."""
    path = cad_file(PLATE, tmp_path / "solid.brep")
    mesh = hexcon.mesh_solid(path, 4.0, surface_method=method, local_sizes={where: 1.0})
    surface = mesh.surface
    assert mesh.certificate.certified and mesh.quality.min > 0.4
    assert not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    here, there = WHERE[where]
    assert np.median(edges_near(surface, here, 0.8)) < 1.6
    assert np.median(edges_near(surface, there, 6.0)) > 1.8
    assert len(surface.quads) < 12 * len(surface_from_solid(path, 4.0, method).quads)


def test_a_turned_part_follows(tmp_path):
    """A shaft's thin end: shorter along and round there; quads round a turn as many as are asked for."""
    shaft = "occ.fuse([(3, occ.addCylinder(0, 0, 0, 0, 0, 10, 4))], [(3, occ.addCylinder(0, 0, 10, 0, 0, 10, 2.5))])"
    path = cad_file(shaft, tmp_path / "solid.brep")
    mesh = hexcon.mesh_solid(path, 3.0, surface_method="revolved", local_sizes={"point:2.5,0,20": 0.4})
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, mesh.surface.quads, mesh.surface.points)
    assert edges_near(mesh.surface, [2.5, 0, 20], 0.4).max() < 0.8 < edges_near(mesh.surface, [4, 0, 4], 3.0).max() / 2
    turned = surface_from_solid(path, 3.0, "revolved", per_turn=48)
    assert any("x 48 round" in note for note in turned.notes)


def test_auto_takes_a_method_that_follows(tmp_path):
    """A cone would be of blocks, which know one size only."""
    path = cad_file("(3, occ.addCone(0, 0, 0, 0, 0, 8, 5, 2))", tmp_path / "cone.brep")
    assert surface_from_solid(path, 2.0).method == "sweep"
    surface = surface_from_solid(path, 2.0, local_sizes={"Edge1": 0.8})
    assert surface.method == "sweep"
    path = cad_file("(3, occ.addSphere(0, 0, 0, 5))", tmp_path / "ball.brep")
    surface = surface_from_solid(path, 2.0, local_sizes={"point:5,0,0": 1.0})
    assert surface.method == "revolved" and any("follows no local sizes" in note for note in surface.notes)
    for options in ({"local_sizes": {"point:5,0,0": 1.5}}, {"per_turn": 40}):
        with pytest.raises(ToolError, match="follows no local sizes") as caught:
            surface_from_solid(path, 2.0, "blocks", **options)
        assert caught.value.code is FaultCode.BAD_OPTION
    with pytest.raises(ToolError, match="does not have") as caught:
        surface_from_solid(path, 2.0, "grid", local_sizes={"Face99": 1.5})
    assert caught.value.code is FaultCode.BAD_OPTION
    assert surface_from_solid(path, 2.0, local_sizes={"Face1": 5.0}).method == "blocks"


def test_triangles_follow(tmp_path):
    path = cad_file(PLATE, tmp_path / "solid.brep")
    surface = surface_from_solid(path, 3.0, "subdivided-triangles", local_sizes={"point:40,16,4": 0.5})
    assert edges_near(surface, [40, 16, 4], 1.0).max() < 1.0 < np.median(edges_near(surface, [4, 4, 4], 6.0))
