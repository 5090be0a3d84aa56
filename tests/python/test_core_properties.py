# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept surfaces of many kinds and numberings: exact counts, certified by an independent judge."""
from fractions import Fraction

import mesh_checker
import numpy as np
import pytest
import surfaces as make
from scipy.optimize import linprog
from scipy.spatial import cKDTree

import hexcon_native as hn

# ------------------------------------------------------------------------------- caps and shapes

CAPS = {
    "square": lambda rng: make.grid(1, 1),
    "strip": lambda rng: make.grid(int(rng.integers(5, 30)), 1),
    "rectangle": lambda rng: make.grid(int(rng.integers(2, 7)), int(rng.integers(2, 7))),
    "L": lambda rng: make.picture("#...", "#...", "####"),
    "U": lambda rng: make.picture("#.#", "#.#", "###"),
    "frame": lambda rng: make.picture("####", "#..#", "####"),
    "two holes": lambda rng: make.picture("#####", "#.#.#", "#####"),
    "three holes": lambda rng: make.picture("#######", "#.#.#.#", "#######", "##.####", "#######"),
    "comb": lambda rng: make.picture("#.#.#.#", "#.#.#.#", "#######"),
    "triangle": lambda rng: make.diced([[0, 0], [2, 0], [1, 1.7]], [[0, 1, 2]]),
    "tube": lambda rng: make.annulus(int(rng.integers(3, 16))),
    "odd tube": lambda rng: make.annulus(3),
    "thick tube": lambda rng: make.annulus(int(rng.integers(3, 12)), int(rng.integers(2, 5))),
    "disc": lambda rng: make.o_grid(int(rng.integers(1, 5)), int(rng.integers(1, 4))),
    "random": lambda rng: make.relaxed(make.random_cap(rng, int(rng.integers(2, 7)))),
    "random, holes": lambda rng: make.relaxed(make.random_cap(rng, 9, 3)),
}


def straight(rng):
    return make.upright


def sheared(rng):
    a, b = rng.uniform(-0.6, 0.6, 2)
    return lambda t, xy: np.column_stack([xy[:, 0] + a * t, xy[:, 1] + b * t, np.full(len(xy), t)])


def tapered(rng):
    rate = rng.uniform(-0.05, 0.05)
    return lambda t, xy: np.column_stack([xy * (1 + rate * t), np.full(len(xy), t)])


def twisted(rng):
    rate = np.radians(rng.uniform(-60, 60)) / 8

    def place(t, xy):
        c, s = np.cos(rate * t), np.sin(rate * t)
        flat = xy - xy.mean(axis=0)
        return np.column_stack([flat @ [[c, s], [-s, c]], np.full(len(xy), 2 * t)])
    return place


def swung(rng):
    """Swept about an axis beside the cap."""
    rate = rng.uniform(0.05, 0.15)

    def place(t, xy):
        radius = xy[:, 0] - xy[:, 0].min() + 8
        return np.column_stack([radius * np.cos(rate * t), xy[:, 1], radius * np.sin(rate * t)])
    return place


def bulging(rng):
    """Caps of different shape: flat below, a dome above."""
    rise = rng.uniform(-0.04, 0.04)

    def place(t, xy):
        square = ((xy - xy.mean(axis=0)) ** 2).sum(axis=1)
        return np.column_stack([xy * (1 + 0.02 * t), t + rise * t * np.minimum(square, 4) / 4])
    return place


SHAPES = {f.__name__: f for f in (straight, sheared, tapered, twisted, swung, bulging)}


def levels(rng, rings):
    """Rings of different heights, each within three times of its neighbours', 1 in the mean."""
    return np.concatenate([[0], np.cumsum(np.exp(rng.uniform(-0.5, 0.5, rings)))])


def swept_surface(cap, shape, seed=0):
    """A surface and the number of hexes that fill it."""
    rng = np.random.default_rng([seed, list(CAPS).index(cap), list(SHAPES).index(shape)])
    flat, quads = CAPS[cap](rng)
    rings = int(rng.integers(1, 13))
    surface = make.prism((flat, quads), levels(rng, rings), SHAPES[shape](rng))
    return surface, len(quads) * rings, rng


def centers(mesh):
    return mesh.points[mesh.hexes[:, :8]].mean(axis=1)


# --------------------------------------------------------------------------------------- sweeps

@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("cap", CAPS)
def test_swept(cap, shape):
    (points, quads), count, rng = swept_surface(cap, shape)
    mesh = hn.mesh(points, quads)
    assert len(mesh.hexes) == count
    assert mesh.method == "swept"
    assert mesh.certificate.certified
    assert mesh_checker.faults(mesh.points, mesh.hexes, quads, points) == []
    assert hn.certify(mesh.points, mesh.hexes, quads).certified
    assert mesh.certificate.euler == mesh_checker.euler(mesh.hexes)
    assert len(mesh.certificate.doublets) == 0

    other_points, other_quads = make.permuted((points, quads), rng)
    other = hn.mesh(other_points, other_quads)
    assert len(other.hexes) == count
    assert mesh_checker.faults(other.points, other.hexes, other_quads, other_points) == []
    distance, nearest = cKDTree(centers(mesh)).query(centers(other))
    assert len(np.unique(nearest)) == count
    assert distance.max() <= 1e-9 * np.ptp(points, axis=0).max()


@pytest.mark.parametrize("n", [(1, 1, 1), (1, 1, 2), (2, 2, 2), (4, 4, 4), (2, 3, 5), (1, 7, 4)])
def test_boxes(n):
    points, quads = make.box(*n)
    mesh = hn.mesh(points, quads)
    assert len(mesh.hexes) == np.prod(n)
    assert mesh.quality.min == pytest.approx(1, abs=1e-12)
    assert mesh_checker.faults(mesh.points, mesh.hexes, quads, points) == []
    lattice = {tuple(p) for p in np.round(mesh.points, 9).tolist()}
    assert len(lattice) == np.prod(np.add(n, 1))


def test_inward_surface():
    points, quads = make.box(2, 3, 2)
    inward = quads[:, ::-1]
    assert not hn.check_surface(points, inward).oriented
    mesh = hn.mesh(points, inward)
    assert mesh.report["turned outward"] == 1
    assert mesh_checker.faults(mesh.points, mesh.hexes, mesh.quads, points) == []
    assert mesh_checker.boundary_faults(mesh.hexes, quads) == []


def test_second_order():
    (points, quads), count, _ = swept_surface("disc", "twisted")
    mesh = hn.mesh(points, quads, order=2)
    assert mesh.hexes.shape == (count, 20)
    ends = mesh.hexes[:, [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4],
                          [0, 4], [1, 5], [2, 6], [3, 7]]]
    middles = mesh.points[ends].mean(axis=2)
    assert np.abs(mesh.points[mesh.hexes[:, 8:]] - middles).max() < 1e-12
    assert len(np.unique(mesh.hexes)) == len(mesh.points)
    first = hn.mesh(points, quads)
    raised, hexes = hn.raise_order(first.points, first.hexes)
    assert raised.tobytes() == mesh.points.tobytes()
    assert (hexes == mesh.hexes).all()


# ------------------------------------------------------------------------------------ not sweeps

def random_hull():
    return make.diced_hull(np.random.default_rng(3).normal(size=(12, 3)))


@pytest.mark.parametrize("surface", [make.tetrahedron, random_hull, make.schneiders_pyramid],
                         ids=lambda f: f.__name__)
def test_not_swept(surface):
    points, quads = surface()
    report = hn.check_surface(points, quads)
    assert report.genus == 0 and report.even and report.oriented and report.convex
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "swept")
    assert fault.value.code == hn.ErrorCode.NOT_SWEPT
    assert str(fault.value).startswith("not swept: ")
    assert all(0 <= e < len(quads) for e in fault.value.elements)


@pytest.mark.parametrize("n, quad", [(4, 0), (6, 17), (10, 3)])
def test_one_edge_turned(n, quad):
    """As many quads as a box has, and no sweep."""
    points, quads = make.turn_edge(make.box(n, n, n), quad)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "swept")
    assert fault.value.code in (hn.ErrorCode.NOT_SWEPT, hn.ErrorCode.NOT_CERTIFIED)


@pytest.mark.parametrize("quad", [0, 3000, 16000])
def test_large_and_not_swept(quad):
    """Hundreds of strips of which each fails late: the work stays in proportion to the quads."""
    points, quads = make.turn_edge(make.box(180, 181, 182), quad)
    assert len(quads) > 190_000
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "swept")
    assert fault.value.code == hn.ErrorCode.NOT_SWEPT


# --------------------------------------------------------------------------------- the judges

def vtk_scaled_jacobians(points, hexes):
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    grid, cells, nodes = vtk.vtkUnstructuredGrid(), vtk.vtkCellArray(), vtk.vtkPoints()
    nodes.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    rows = np.column_stack([np.full(len(hexes), 8), hexes]).astype(np.int64).ravel()
    cells.SetCells(len(hexes), numpy_to_vtkIdTypeArray(rows, deep=True))
    grid.SetPoints(nodes)
    grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
    quality = vtk.vtkMeshQuality()
    quality.SetInputData(grid)
    quality.SetHexQualityMeasureToScaledJacobian()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))


@pytest.mark.parametrize("cap, shape", [("disc", "twisted"), ("random", "swung"),
                                        ("triangle", "sheared"), ("frame", "bulging")])
def test_quality_is_verdicts(cap, shape):
    (points, quads), _, rng = swept_surface(cap, shape)
    mesh = hn.mesh(points, quads)
    moved = mesh.points + rng.normal(scale=0.1, size=mesh.points.shape)
    # Verdict takes the middle frame into account as well as the corners'
    corners = moved[mesh.hexes]
    axes = [(corners[:, hi] - corners[:, lo]).sum(axis=1) for lo, hi in
            (([0, 3, 4, 7], [1, 2, 5, 6]), ([0, 1, 4, 5], [3, 2, 7, 6]), ([0, 1, 2, 3], [4, 5, 6, 7]))]
    middle = np.linalg.det(np.stack(axes, axis=1)) / np.prod(np.linalg.norm(axes, axis=2), axis=0)
    ours = np.minimum(hn.quality(moved, mesh.hexes).scaled_jacobian, middle)
    assert np.abs(ours - vtk_scaled_jacobians(moved, mesh.hexes)).max() < 1e-9


def random_hexes(rng, count, spread):
    corners = mesh_checker.CORNERS + rng.uniform(-spread, spread, (count, 8, 3))
    return corners.reshape(-1, 3), np.arange(8 * count).reshape(-1, 8)


@pytest.mark.parametrize("spread", [0.1, 0.25, 0.35, 0.5])
def test_jacobian_judges_agree(spread):
    points, hexes = random_hexes(np.random.default_rng(int(100 * spread)), 2000, spread)
    ours = hn.certify(points, hexes, hexes[:, mesh_checker.FACES].reshape(-1, 4)).nonpositive
    theirs = mesh_checker.nonpositive(points, hexes)
    assert len(np.setxor1d(ours, theirs)) == 0
    samples = mesh_checker.jacobians(points[hexes], np.random.default_rng(1).random((200, 3)))
    positive = np.setdiff1d(np.arange(len(hexes)), ours)
    assert (samples[positive] > 0).all()


def exact_jacobian(corners, at):
    """The Jacobian at a point in rational numbers; float64 values are rationals."""
    at = [Fraction(u) for u in at]
    rows = [[Fraction(0)] * 3 for _ in range(3)]
    for corner, place in zip(corners, mesh_checker.CORNERS.tolist()):
        factors = [u if on else 1 - u for u, on in zip(at, place)]
        for axis in range(3):
            weight = factors[axis - 1] * factors[axis - 2] * (1 if place[axis] else -1)
            rows[axis] = [sum_ + weight * Fraction(float(x)) for sum_, x in zip(rows[axis], corner)]
    a, b, c = rows
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def test_corners_within_rounding_of_flat():
    """A corner in one plane with its neighbours up to rounding: the last bit decides."""
    rng = np.random.default_rng(6)
    hexes = np.arange(8)[None]
    quads = hexes[:, mesh_checker.FACES].reshape(-1, 4)
    signs = set()
    for _ in range(400):
        corners = mesh_checker.CORNERS + rng.uniform(-0.12, 0.12, (8, 3))
        i = int(rng.integers(8))
        near = np.abs(mesh_checker.CORNERS - mesh_checker.CORNERS[i]).sum(axis=1) == 1
        corners[i] = rng.dirichlet([3, 3, 3]) @ corners[near]
        corners *= 10.0 ** rng.integers(-30, 30)
        exact = exact_jacobian(corners, mesh_checker.CORNERS[i].tolist())
        signs.add(exact > 0)
        certificate = hn.certify(corners, hexes, quads)
        assert certificate.undecided == 0
        if exact <= 0:
            assert certificate.nonpositive.tolist() == [0]
    assert signs == {True, False}


def distorted(rng, n, spread):
    return mesh_checker.CORNERS + rng.uniform(-spread, spread, (n, 8, 3))


def flat(rng, n):
    """Within 1e-12 of a plane, far from the origin, each its own."""
    thin = distorted(rng, n, 0.5) * [1, 1, 1e-12]
    return thin @ np.linalg.qr(rng.normal(size=(n, 3, 3)))[0] + 1000


def lattice(rng, n):
    """Small integers: many Jacobians are zero somewhere."""
    return rng.integers(0, 3, (n, 8, 3)).astype(float)


def corner_in_plane(rng, n):
    """The corner at the origin in one plane with its neighbours, in binary fractions: exactly."""
    hexes = distorted(rng, n, 0.1)
    a, b = rng.choice([0.125, 0.25, 0.375], (2, n, 1))
    hexes[:, [1, 3, 4]] = np.round(hexes[:, [1, 3, 4]] * 1024) / 1024
    hexes[:, 0] = a * hexes[:, 1] + b * hexes[:, 3] + (1 - a - b) * hexes[:, 4]
    return hexes


def collapsed(rng, n):
    """A corner on another: edges, diagonals of faces or of space without length."""
    hexes = distorted(rng, n, 0.1)
    for corners in hexes:
        a, b = rng.choice(8, 2, replace=False)
        corners[a] = corners[b]
    return hexes


def folded_edge(rng, n):
    """A whole edge on its opposite, or a face on a point, or everything."""
    hexes = distorted(rng, n, 0.1)
    for corners in hexes:
        axis, other = rng.choice(3, 2, replace=False)
        place = mesh_checker.CORNERS.copy()
        place[:, axis] = 0
        if rng.random() < 0.3:
            place[place[:, other] == 0] = 0
        if rng.random() < 0.1:
            place[:] = 0
        for i, p in enumerate(place):
            corners[i] = corners[np.flatnonzero((mesh_checker.CORNERS == p).all(axis=1))[0]]
    return hexes


def of_any_size(rng, n):
    """Each axis its own power of two, from the smallest numbers to the largest."""
    return np.ldexp(distorted(rng, n, 0.4), rng.integers(-1020, 1022, (n, 1, 3)))


def positive_at_corners(rng, n):
    hexes = distorted(rng, 200 * n, 0.42)
    values = mesh_checker.jacobians(hexes, mesh_checker.CORNERS)
    return hexes[values.min(axis=1) > 0.01]


KINDS = {"distorted": lambda rng, n: distorted(rng, n, 0.5),
         "noise": lambda rng, n: rng.normal(size=(n, 8, 3)),
         **{f.__name__.replace("_", " "): f for f in (
             flat, lattice, corner_in_plane, collapsed, folded_edge, of_any_size,
             positive_at_corners)}}


@pytest.mark.parametrize("kind", KINDS)
def test_witnesses(kind):
    """Where a hex is said not to be positive, it is not: in rational numbers."""
    corners = KINDS[kind](np.random.default_rng(12), 300)
    hexes = np.arange(8 * len(corners)).reshape(-1, 8)
    certificate = hn.certify(corners.reshape(-1, 3), hexes, [[0, 1, 2, 3]])
    assert certificate.undecided == 0
    assert certificate.witnesses.shape == (len(certificate.nonpositive), 3)
    assert len(certificate.nonpositive) > 0
    assert ((certificate.witnesses >= 0) & (certificate.witnesses <= 1)).all()
    for h, at in zip(certificate.nonpositive[:400], certificate.witnesses):
        assert exact_jacobian(corners[h], at) <= 0
    if kind == "positive at corners":
        assert not np.isin(certificate.witnesses, (0, 1)).all(axis=1).any()
    elif kind in ("corner in plane", "folded edge"):
        assert len(certificate.nonpositive) == len(corners)


def test_no_witness():
    """The Jacobian touches zero at two thirds of an edge: not decided, and never called positive."""
    corners = np.array([[-1, -1, -1], [2, 1, 0], [3, 3, 0], [-1, 3, -1],
                        [1, 1, 3], [1, 0, 1], [2, 1, 2], [-1, 3, 3]])
    certificate = hn.certify(corners, [range(8)], [[0, 1, 2, 3]])
    assert exact_jacobian(corners, [Fraction(2, 3), 0, 1]) == 0
    assert certificate.nonpositive.tolist() == [0] and certificate.undecided == 1
    assert np.isnan(certificate.witnesses).all()
    assert certificate.as_dict()["witnesses"] == [None]


def damaged(hexes, point_count, rng):
    """One corner of one hex changed, or two corners exchanged, or a hex taken out or doubled."""
    hexes, h, (a, b) = hexes.copy(), rng.integers(len(hexes)), rng.choice(8, 2, replace=False)
    kind = rng.integers(4)
    if kind == 0:
        hexes[h, a] = rng.integers(point_count)
    elif kind == 1:
        hexes[h, [a, b]] = hexes[h, [b, a]]
    elif kind == 2:
        return np.delete(hexes, h, axis=0)
    else:
        return np.vstack([hexes, hexes[h]])
    return hexes


def test_judges_of_topology_agree():
    """On damaged meshes, fact by fact."""
    rng = np.random.default_rng(8)
    mesh = hn.mesh(*make.prism(make.o_grid(2, 1), np.arange(4.0), make.upright))
    samples = rng.random((200, 3))
    for _ in range(150):
        hexes = damaged(mesh.hexes, len(mesh.points), rng)
        if any(len(set(h)) < 8 for h in hexes.tolist()):
            continue
        ours = hn.certify(mesh.points, hexes, mesh.quads)
        assert ours.proper == (not mesh_checker.improper_pairs(hexes))
        assert ours.conforming == (not mesh_checker.conformity_faults(hexes))
        exact = not mesh_checker.boundary_faults(hexes, mesh.quads)
        assert ours.boundary_exact == exact or (exact and not ours.conforming)
        theirs = mesh_checker.nonpositive(mesh.points, hexes)  # in doubles: what is near 0 is out
        assert np.isin(ours.nonpositive, theirs).all()
        near = mesh.points[hexes[np.setdiff1d(theirs, ours.nonpositive)]]
        assert (mesh_checker.jacobians(near, samples) > 0).all()
        assert ours.euler == mesh_checker.euler(hexes)


def test_star_center_is_deepest():
    """Against scipy's linear programme, on surfaces with a kernel and without."""
    rng = np.random.default_rng(4)
    for _ in range(40):
        points, quads = make.diced_hull(rng.normal(size=(10, 3)))
        points = points * (1 + rng.uniform(-0.08, 0.08, (len(points), 1)))
        here, after, before = points[quads], points[np.roll(quads, -1, 1)], points[np.roll(quads, 1, 1)]
        normal = np.cross(after - here, before - here).reshape(-1, 3)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        offset = (normal * here.reshape(-1, 3)).sum(axis=1)
        best = linprog([0, 0, 0, -1], np.column_stack([normal, np.ones(len(normal))]), offset,
                       bounds=[(None, None)] * 4)
        report = hn.check_surface(points, quads)
        assert report.star_margin == pytest.approx(best.x[3], abs=1e-7)
        assert (report.star_center is not None) == (best.x[3] > 0)


def test_optimize_repairs():
    rng = np.random.default_rng(5)
    mesh = hn.mesh(*make.box(5, 4, 4))
    inner = np.arange(len(make.box(5, 4, 4)[0]), len(mesh.points))
    tangled = mesh.points.copy()
    tangled[inner] += rng.uniform(-0.7, 0.7, (len(inner), 3))
    assert len(mesh_checker.nonpositive(tangled, mesh.hexes)) > 0
    repaired = hn.optimize(tangled, mesh.hexes)
    assert mesh_checker.faults(repaired, mesh.hexes, mesh.quads, make.box(5, 4, 4)[0]) == []
