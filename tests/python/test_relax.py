# SPDX-License-Identifier: LGPL-2.1-or-later
"""Relaxation: points slide on what they lie on, exactly, and no mesh comes out worse."""
import numpy as np
import pytest
from sliding_bodies import BODIES, body

import hexcon_native as hn

Code = hn.ErrorCode


def code_of(call, *arguments, **options):
    with pytest.raises(hn.HexconError) as caught:
        call(*arguments, **options)
    return caught.value.code


def distances(points, carrier):
    """How far points are from a carrier, by its equation."""
    axis = np.array(carrier.axis, float) / np.linalg.norm(carrier.axis)
    apart = points - carrier.origin
    along = apart @ axis
    out, whole = np.linalg.norm(np.cross(apart, axis), axis=1), np.linalg.norm(apart, axis=1)
    size = (*carrier.sizes, 0, 0)
    return abs({"point": whole, "line": out, "plane": along, "cylinder": out - size[0], "sphere": whole - size[0],
                "circle": np.hypot(out - size[0], along), "cone": out * np.cos(size[0]) - along * np.sin(size[0]),
                "torus": np.hypot(out - size[0], along) - size[1]}[carrier.kind])


def farthest(points, carrier_of_point, carriers):
    return max(distances(points[carrier_of_point == k], carrier).max(initial=0) for k, carrier in enumerate(carriers))


def scrambled(points, hexes, part, seed):
    length = np.linalg.norm(points[hexes[:, 1]] - points[hexes[:, 0]], axis=1).mean()
    return points + np.random.default_rng(seed).uniform(-part, part, points.shape) * length


@pytest.mark.parametrize("name", BODIES)
def test_bodies_lie_on_their_carriers(name):
    points, hexes, carrier_of_point, carriers = body(name, 3)
    assert farthest(points, carrier_of_point, carriers) < 1e-14
    assert hn.quality(points, hexes).min > 0.5


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize("part", [0.3, 1.2])
def test_scrambled_bodies_come_right(name, part):
    points, hexes, carrier_of_point, carriers = body(name, 5)
    relaxed = hn.relax(scrambled(points, hexes, part, 1), hexes, carrier_of_point, carriers)
    assert farthest(relaxed, carrier_of_point, carriers) < 1e-13
    assert hn.quality(relaxed, hexes).min > hn.quality(points, hexes).min - 0.05


@pytest.mark.parametrize("name", BODIES)
def test_never_worse(name):
    points, hexes, carrier_of_point, carriers = body(name, 3)
    rng = np.random.default_rng(2)
    for seed in range(12):
        some = carrier_of_point.copy()
        some[rng.random(len(some)) < rng.random() / 2] = -2
        start = hn.project_points(scrambled(points, hexes, rng.random() * 2, seed), some, carriers)[0]
        relaxed = hn.relax(start, hexes, some, carriers, rounds=int(rng.integers(4)))
        before, after = hn.quality(start, hexes), hn.quality(relaxed, hexes)
        folded = [int((one.scaled_jacobian <= 0).sum()) for one in (before, after)]
        assert folded[1] < folded[0] or folded[1] == folded[0] and after.min >= before.min - 1e-12
        assert (relaxed[some == -2] == start[some == -2]).all()
        assert farthest(relaxed, some, carriers) < 1e-13


def test_a_smooth_patch_of_several_faces():
    """A beam whose top is a plane and, tangent to it, a cylinder: points pass from one to the other."""
    points, hexes, carrier_of_point, carriers = body("cube", 4)
    plane = hn.Carrier("plane", (0, 0, 1), (0, 0, 1))
    cylinder = hn.Carrier("cylinder", (0.5, 0, -1), (0, 1, 0), sizes=(2,))
    top = next(k for k, one in enumerate(carriers) if one.kind == "plane" and tuple(one.origin) == (0.5, 0.5, 1))
    carriers[top] = [plane, cylinder]
    relaxed = hn.relax(points, hexes, carrier_of_point, carriers)
    rows = relaxed[carrier_of_point == top]
    assert np.minimum(distances(rows, plane), distances(rows, cylinder)).max() < 1e-14


def test_others_project():
    """A paraboloid is no closed form: it is asked for."""
    points, hexes, carrier_of_point, carriers = body("cube", 4)
    top = next(k for k, one in enumerate(carriers) if one.kind == "plane" and tuple(one.origin) == (0.5, 0.5, 1))
    carriers[top] = hn.Carrier("surface", tag=7)
    asked = []

    def project(places, tags):
        asked.append(set(tags))
        x, y, z = places.T.copy()
        for _ in range(100):  # where z - (1 + (x^2 + y^2) / 8) and the gap's slant are 0
            height = 1 + (x * x + y * y) / 8
            x, y = places[:, 0] - x / 4 * (height - z), places[:, 1] - y / 4 * (height - z)
        return np.stack([x, y, 1 + (x * x + y * y) / 8], axis=1), np.stack([x / 4, y / 4, -np.ones_like(x)], axis=1)

    relaxed = hn.relax(points, hexes, carrier_of_point, carriers, project=project)
    x, y, z = relaxed[carrier_of_point == top].T
    assert abs(z - 1 - (x * x + y * y) / 8).max() < 1e-14
    assert hn.quality(relaxed, hexes).min > 0.75
    assert set.union(*asked) == {7}


def test_numbering_and_threads_do_not_matter():
    points, hexes, carrier_of_point, carriers = body("shell", 4)
    start = scrambled(points, hexes, 0.4, 3)
    relaxed = hn.relax(start, hexes, carrier_of_point, carriers, threads=1)
    rng = np.random.default_rng(4)
    new = rng.permutation(len(points))
    old = np.argsort(new)
    turned = new[hexes[rng.permutation(len(hexes))]][:, [1, 2, 3, 0, 5, 6, 7, 4]]
    again = hn.relax(start[old], turned, carrier_of_point[old], carriers, threads=2)
    assert (again[new] == relaxed).all()


def test_passes_that_slide_raise_the_worst():
    """A column with a cap that bulges: the sides, and with them the corners' hexes, are better where they may slide."""
    points, hexes, carrier_of_point, carriers = body("cube", 4)
    top = next(k for k, one in enumerate(carriers) if one.kind == "plane" and tuple(one.origin) == (0.5, 0.5, 1))
    carriers[top] = hn.Carrier("sphere", (0.5, 0.5, 0.5), sizes=(np.sqrt(0.75),))
    edges = [k for k, one in enumerate(carriers) if one.kind == "line" and one.origin[2] == 1]
    for k in edges:  # where the ball meets the sides
        middle, along = np.array(carriers[k].origin), np.array(carriers[k].axis, bool)
        carriers[k] = hn.Carrier("circle", (*middle[:2], 0.5), tuple(~along * [1.0, 1.0, 0.0]), sizes=(np.sqrt(0.5),))
    relaxed = hn.relax(points, hexes, carrier_of_point, carriers)
    held = hn.optimize(relaxed, hexes)
    slid = hn.relax(points, hexes, carrier_of_point, carriers, passes=9)
    assert farthest(slid, carrier_of_point, carriers) < 1e-13
    assert hn.quality(slid, hexes).min > hn.quality(held, hexes).min + 0.01


def test_cancelled_keeps_the_best():
    points, hexes, carrier_of_point, carriers = body("bend", 4)
    start = scrambled(points, hexes, 0.8, 5)
    with pytest.raises(hn.HexconError) as caught:
        hn.relax(start, hexes, carrier_of_point, carriers, progress=lambda stage, part: stage.startswith("measuring"))
    assert caught.value.code == Code.CANCELLED
    assert farthest(caught.value.points, carrier_of_point, carriers) < 1e-13


def test_faults():
    points, hexes, carrier_of_point, carriers = body("cube", 2)

    def fault(*, of_point=carrier_of_point, on=carriers, **options):
        with pytest.raises(hn.HexconError) as caught:
            hn.relax(points, hexes, of_point, on, **options)
        return caught.value.code, list(caught.value.elements)

    assert fault(of_point=carrier_of_point[1:]) == (Code.WRONG_SHAPE, [])
    assert fault(of_point=carrier_of_point * 1.0) == (Code.WRONG_TYPE, [])
    assert fault(of_point=np.where(np.arange(len(points)) == 4, -3, carrier_of_point)) == (Code.INDEX_OUT_OF_RANGE, [4])
    assert fault(of_point=np.where(np.arange(len(points)) == 4, 99, carrier_of_point)) == (Code.INDEX_OUT_OF_RANGE, [4])
    for wrong in (None, "plane", hn.Carrier("plain"), hn.Carrier("plane", (0, 0)), hn.Carrier("plane", axis=(0, 0, 0)),
                  hn.Carrier("sphere", sizes=(-1,)), hn.Carrier("surface"), [],
                  [hn.Carrier("plane"), hn.Carrier("line")],
                  hn.Carrier("plane", tag=0.5), hn.Carrier("sphere"), hn.Carrier("sphere", sizes=3.0)):
        assert fault(on=[*carriers[:3], wrong, *carriers[4:]])[0] == Code.BAD_ARGUMENT, wrong
    asked, lying = [*carriers, hn.Carrier("curve")], carrier_of_point.copy()
    lying[0] = len(carriers)
    for name, value in {"rounds": -1, "passes": -1, "mean_passes": 0.5, "threads": 0.5, "budget": -1,
                        "project": 3}.items():
        assert fault(**{name: value})[0] == Code.BAD_ARGUMENT
    assert fault(of_point=lying, on=asked, project=lambda p, t: None)[0] == Code.BAD_ARGUMENT
    assert fault(of_point=lying, on=asked, project=lambda p, t: (p, 0 * p))[0] == Code.BAD_ARGUMENT
    assert fault(of_point=lying, on=asked, project=lambda p, t: (p[1:], p))[0] == Code.WRONG_SHAPE
    with pytest.raises(ZeroDivisionError):
        hn.relax(points, hexes, lying, asked, project=lambda p, t: 1 / 0)
    assert code_of(hn.project_points, points[:, :2], carrier_of_point, carriers) == Code.WRONG_SHAPE


def rounded_edge():
    """Facets of a floor, a quarter of a cylinder and a wall, one patch; the middle of each part."""
    profile = [(-2, 0), (0, 0), *[(np.sin(a), 1 - np.cos(a)) for a in np.pi / 2 * np.arange(1, 4) / 4], (1, 1), (1, 3)]
    points = np.array([(x, y, z) for x, z in profile for y in (0, 4)], float)
    triangles = np.array([t for k in range(0, 12, 2) for t in ((k, k + 1, k + 2), (k + 1, k + 2, k + 3))])
    pieces = np.repeat([0, 1, 1, 1, 1, 2], 2)
    return hn.Facets(points, triangles, np.zeros(12, int), pieces), [
        [hn.Carrier("plane", axis=(0, 0, 1)), hn.Carrier("cylinder", (0, 0, 1), (0, 1, 0), sizes=(1.0,)),
         hn.Carrier("plane", (1, 0, 0), (1, 0, 0))]]


def test_facets_tell_which_face_counts():
    """Without them the floor's plane, which goes on beyond the edge, is nearer."""
    facets, carriers = rounded_edge()
    given = np.array([[0.9, 2, 0.05], [-1, 2, 0.3], [1.2, 2, 2]])
    places, normals = hn.project_points(given, [0, 0, 0], carriers, facets=facets)
    far = np.hypot(0.9, 0.95)
    assert np.allclose(places, [[0.9 / far, 2, 1 - 0.95 / far], [-1, 2, 0], [1, 2, 2]]) and \
        np.allclose(np.abs(normals[1:]), [[0, 0, 1], [1, 0, 0]])
    assert np.allclose(hn.project_points(given, [0, 0, 0], carriers)[0][0], [0.9, 2, 0])
    curved = facets._replace(normals=np.tile([0.0, 0.0, 1.0], (12, 3, 1)), pieces=np.zeros(12, int))
    places, _ = hn.project_points(given[1:2], [0], [hn.Carrier("facets")], facets=curved)
    assert np.allclose(places, [[-1, 2, 0]])


@pytest.mark.parametrize("change,code", [
    ({"triangles": np.full((12, 3), 14)}, Code.INDEX_OUT_OF_RANGE),
    ({"pieces": np.full(12, 3)}, Code.INDEX_OUT_OF_RANGE), ({"carriers": np.ones(12, int)}, Code.INDEX_OUT_OF_RANGE),
    ({"pieces": np.zeros(11, int)}, Code.WRONG_SHAPE), ({"points": np.zeros((14, 2))}, Code.WRONG_SHAPE),
    ({"normals": np.zeros((12, 3))}, Code.WRONG_SHAPE), ({"triangles": np.ones((12, 3))}, Code.WRONG_SHAPE),
    ({"normals": np.zeros((12, 3, 3))}, Code.INDEX_OUT_OF_RANGE), ({"pieces": np.zeros(12, int)}, Code.BAD_ARGUMENT),
    ({"points": np.full((14, 3), np.nan)}, Code.INDEX_OUT_OF_RANGE)])
def test_facets_that_do_not_fit(change, code):
    facets, carriers = rounded_edge()
    at = np.zeros((1, 3)), [0], carriers
    assert code_of(hn.project_points, *at, facets=facets._replace(**change)) is code
    assert code_of(hn.project_points, *at, facets="none") is Code.BAD_ARGUMENT
