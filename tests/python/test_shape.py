# SPDX-License-Identifier: LGPL-2.1-or-later
"""hn.optimize and hn.morph, judged by mesh_checker: what they reach, and what they never do."""
import itertools
import re

import numpy as np
import pytest
from cell_meshes import build_cells
from cell_surfaces import plain_surfaces
from deformed_boxes import deformed_cells
from impossible import SLOPES, impossible_reason
from mesh_checker import CORNERS, faults, nonpositive, scaled_jacobians
from scrambled import boundary_quads, graded_box, scramble, swept_meshes, twisted_prism
from template_files import load_template, names

import hexcon_native as hn

Code = hn.ErrorCode
SURFACES = {name: (points, quads) for name, points, quads in plain_surfaces()}
SWEPT, LARGE = dict(swept_meshes(1000)), dict(swept_meshes(10000))
# Worst scaled Jacobians of the fillings as the search that found them had left them.
FOUND = {"domino_48": 0.02,
         "domino_56": 0.17,
         "domino_58": 0.308858045,
         "domino_62": 0.428965772,
         "geode_26": 0.260029908,
         "halfcell_2x2_46": 0.188926085,
         "halfcell_2x2_46_flat": 0.142734783,
         "halfcell_diced_41": 0.214204635,
         "halfcell_diced_41_flat": 0.158977118,
         "halfcell_diced_black_55": 0.335332306,
         "rotation_38": 0.332,
         "schneiders_pyramid_36": 0.203995389,
         "trapezohedron_40": 0.264487512}
FITTED = ("domino_62", "halfcell_diced_41", "geode_26", "schneiders_pyramid_36")


def worst(points, hexes):
    return scaled_jacobians(points, hexes).min()


def standing(points, hexes):
    """Pairs that grow as meshes get better: positive hexes, worst scaled Jacobian."""
    return len(hexes) - len(nonpositive(points, hexes)), worst(points, hexes)


def assert_certified(points, start, hexes, fixed):
    """By the independent judge; fixed rows as in the start."""
    assert points[fixed].tobytes() == start[fixed].tobytes()
    assert faults(points, hexes, boundary_quads(hexes), start[:0]) == []


def small_meshes(size=60):
    return dict(swept_meshes(size))


# ------------------------------------------------------------------------------- what is reached

@pytest.mark.parametrize("name", names())
def test_templates_from_the_centroid(name):
    """All points inside in one place; what comes out is no worse than what was found by search."""
    t = load_template(name)
    found = hn.optimize(t.collapsed, t.hexes, t.fixed, threads=1)
    assert faults(found, t.hexes, t.quads, t.points[t.fixed]) == []
    assert worst(found, t.hexes) >= FOUND[name]
    assert worst(t.points, t.hexes) >= FOUND[name]  # what we ship


@pytest.mark.parametrize("name", names())
def test_templates_from_themselves(name):
    t = load_template(name)
    found = hn.optimize(t.points, t.hexes, t.fixed, threads=1)
    assert faults(found, t.hexes, t.quads, t.points[t.fixed]) == []
    assert worst(found, t.hexes) >= worst(t.points, t.hexes)


def assert_unscrambled(points, hexes, fixed, seed):
    start = scramble(points, hexes, fixed, 5, seed)
    assert len(nonpositive(start, hexes)) > 0.9 * len(hexes)
    found = hn.optimize(start, hexes, fixed)
    assert_certified(found, points, hexes, fixed)
    assert worst(found, hexes) >= 0.9 * worst(points, hexes)


@pytest.mark.parametrize("name", SWEPT)
def test_scrambled(name):
    """Every point inside thrown five edge lengths away: nothing is left of the shape."""
    for seed in (1, 2):
        assert_unscrambled(*SWEPT[name], seed)


@pytest.mark.parametrize("name", ["bent_bar", "cylinder"])
def test_scrambled_and_large(name):
    assert_unscrambled(*LARGE[name], seed=3)


@pytest.mark.parametrize("name, kind", [
    ("sphere_2", "domino"), ("tetrahedron", "domino"), ("parallelepiped", "domino"),
    ("zonohedron_4", "domino"), ("round_hull_8", "domino"), ("projected_2", "halfcell"),
    ("shaken_2", "halfcell")])
def test_cells(name, kind):
    """Placed without care: every hex is made positive, and the surface stays."""
    points, quads = SURFACES[name]
    start, hexes, fixed = build_cells(points, quads, kind)
    before = standing(start, hexes)
    found = hn.optimize(start, hexes, fixed)
    assert faults(found, hexes, quads, points) == []
    assert worst(found, hexes) > max(before[1], 0.01)


def rings_of_points(hexes, seeds, layers):
    """(P,) bool: points of the seeds and of so many layers of hexes around."""
    near = np.zeros(hexes.max() + 1, bool)
    near[hexes[seeds]] = True
    for _ in range(layers):
        near[hexes[near[hexes].any(axis=1)]] = True
    return near


def test_repair_is_local():
    """With a low target only what is near a bad hex moves; all else stays bit for bit."""
    points, hexes, fixed = LARGE["cylinder"]
    rng = np.random.default_rng(4)
    start = points.copy()
    moved = rng.choice(np.flatnonzero(~fixed), 3, replace=False)
    start[moved] += 0.2
    bad = nonpositive(start, hexes)
    assert 0 < len(bad) < 100
    found = hn.optimize(start, hexes, fixed, target=1e-3)
    assert_certified(found, points, hexes, fixed)
    near = rings_of_points(hexes, bad, 2)
    assert near.mean() < 0.5
    assert found[~near].tobytes() == start[~near].tobytes()


@pytest.mark.parametrize("target", [1e-3, 0.5])
def test_what_reaches_the_target_is_left_alone(target):
    points, hexes, fixed = SWEPT["cylinder"]
    assert worst(points, hexes) > target
    assert hn.optimize(points, hexes, fixed, target=target).tobytes() == points.tobytes()


# -------------------------------------------------------------------------------------- never worse

def damaged_points(points, hexes, kind, rng):
    """Points thrown about, or brought together, or mirrored, or a whole hex folded up."""
    points = points.copy()
    edge = np.linalg.norm(points[hexes[:, 0]] - points[hexes[:, 1]], axis=1).mean()
    some = rng.choice(len(points), max(2, len(points) // 10), replace=False)
    if kind == "noise":
        points += rng.normal(size=points.shape) * edge * rng.choice([0.05, 0.2, 1])
    elif kind == "joined":
        points[some] = points[some[0]]
    elif kind == "mirrored":
        points[some] = 2 * points.mean(axis=0) - points[some]
    elif kind == "folded":
        points[hexes[rng.integers(len(hexes))]] = points[hexes[0, 0]]
    else:
        points *= [1, 1, 10.0 ** -rng.integers(0, 16)]
    return points


@pytest.mark.parametrize("kind", ["noise", "joined", "mirrored", "folded", "flat"])
def test_never_worse(kind):
    """Whatever is fixed, whatever the start: no fewer positive hexes, then no lower worst."""
    rng = np.random.default_rng([1, *kind.encode()])
    geode = load_template("geode_26")
    meshes = [graded_box(2), twisted_prism(2), (geode.points, geode.hexes, geode.fixed)]
    for (points, hexes, boundary), _ in itertools.product(meshes, range(5)):
        start = damaged_points(points, hexes, kind, rng)
        fixed = [boundary, rng.random(len(points)) < 0.3, np.zeros(len(points), bool)][
            rng.integers(3)]
        options = {"rounds": int(rng.integers(1, 4)), "target": float(rng.choice([0.1, 1]))}
        found = hn.optimize(start, hexes, fixed, threads=1, **options)
        assert found[fixed].tobytes() == start[fixed].tobytes()
        assert np.isfinite(found).all()
        after, before = standing(found, hexes), standing(start, hexes)
        assert after[0] >= before[0]
        assert after[0] > before[0] or after[1] >= before[1] - 1e-14


def test_certified_stays_certified():
    """Also where some hexes are positive by a hair."""
    rng = np.random.default_rng(3)
    for points, hexes, fixed in small_meshes(200).values():
        thin = points.copy()
        some = rng.choice(np.flatnonzero(~fixed), 5, replace=False)
        for v in some:    # to within a thousandth of the first hex to turn
            move, step = rng.normal(size=3), 1.0
            while step > 1e-4:
                trial = thin.copy()
                trial[v] += step * move
                if len(nonpositive(trial, hexes)):
                    step /= 2
                else:
                    thin = trial
        assert not len(nonpositive(thin, hexes))
        found = hn.optimize(thin, hexes, fixed, threads=1)
        assert_certified(found, points, hexes, fixed)
        assert worst(found, hexes) > worst(thin, hexes)


def test_input_is_not_touched():
    points, hexes, fixed = small_meshes()["cylinder"]
    start = scramble(points, hexes, fixed, 1, 1)
    copy = start.copy()
    hn.optimize(start, hexes, fixed)
    assert start.tobytes() == copy.tobytes()


# -------------------------------------------------------------------------------------- same result

def turned_hexes(hexes, rng):
    """The same hexes, each begun at another of its corners: one of the 24 turns of the cube."""
    turns = []
    for axes, signs in itertools.product(itertools.permutations(range(3)),
                                         itertools.product([1, -1], repeat=3)):
        turn = np.eye(3, dtype=int)[list(axes)] * signs
        if np.linalg.det(turn) > 0:
            turned = ((2 * CORNERS - 1) @ turn + 1) // 2
            turns.append([int(np.flatnonzero((CORNERS == row).all(axis=1))[0]) for row in turned])
    assert len(turns) == 24
    chosen = np.array(turns)[rng.integers(24, size=len(hexes))]
    return np.take_along_axis(hexes, chosen, axis=1)


def problems():
    """(points, hexes, fixed) with much to repair, much to sharpen, or both."""
    points, hexes, fixed = SWEPT["cylinder"]
    yield scramble(points, hexes, fixed, 0.4, 1), hexes, fixed
    yield scramble(points, hexes, fixed, 5, 1), hexes, fixed
    yield build_cells(*SURFACES["shaken_2"])


@pytest.mark.parametrize("problem", problems(), ids=["shaken", "scrambled", "cells"])
def test_threads_change_nothing(problem):
    one, *others = (hn.optimize(*problem, threads=threads).tobytes() for threads in (1, 2, 5))
    assert others == [one] * 2


@pytest.mark.parametrize("problem", problems(), ids=["shaken", "scrambled", "cells"])
def test_numbering_changes_nothing(problem):
    points, hexes, fixed = problem
    rng = np.random.default_rng(5)
    order = rng.permutation(len(points))
    new_id = np.argsort(order)
    renamed = turned_hexes(new_id[hexes[rng.permutation(len(hexes))]], rng)
    found = hn.optimize(points, hexes, fixed, threads=1)
    again = hn.optimize(points[order], renamed, fixed[order], threads=2)
    assert again.tobytes() == found[order].tobytes()


# ----------------------------------------------------------------------------- progress and cancel

class Patience:
    """Counts calls of progress, and cancels at one of them."""

    def __init__(self, cancel_at=0):
        self.calls, self.cancel_at, self.seen = 0, cancel_at, []

    def __call__(self, stage, fraction):
        self.calls += 1
        self.seen.append((stage, fraction))
        return self.calls != self.cancel_at


def cancelled(call, samples=12):
    """Runs call(progress) and cancels it at some of its calls, the first and the last among them:
    yields the points that the error carries."""
    patience = Patience()
    call(patience)
    assert patience.calls > 1
    assert all(isinstance(stage, str) and stage and 0 <= fraction <= 1
               for stage, fraction in patience.seen)
    for k in np.unique(np.linspace(1, patience.calls, samples).round().astype(int)).tolist():
        with pytest.raises(hn.HexconError) as fault:
            call(Patience(cancel_at=k))
        assert fault.value.code == Code.CANCELLED
        yield fault.value.points


def test_progress_of_optimize_tells_the_worst():
    """In words, and truly: of the mesh as it is when told."""
    points, hexes, fixed = SWEPT["cylinder"]
    patience = Patience()
    start = scramble(points, hexes, fixed, 0.3, 6)
    found = hn.optimize(start, hexes, fixed, threads=1, progress=patience)
    bad = [int(match[1]) for stage, _ in patience.seen
           if (match := re.search(r"(\d+) of \d+ hexes inverted", stage))]
    worsts = [float(match[1]) for stage, _ in patience.seen
              if (match := re.search(r"worst scaled Jacobian (\S+)", stage))]
    assert bad[0] == len(nonpositive(start, hexes))
    assert worsts and np.all(np.diff(worsts) >= 0) and worsts[-1] <= worst(found, hexes) + 1e-3


def test_cancelled_optimisation_is_not_worse():
    points, hexes, fixed = small_meshes(200)["twisted_prism"]
    start = scramble(points, hexes, fixed, 1, 6)
    before = standing(start, hexes)
    for found in cancelled(lambda progress: hn.optimize(start, hexes, fixed, threads=1,
                                                       progress=progress)):
        assert found[fixed].tobytes() == start[fixed].tobytes()
        assert standing(found, hexes) >= before


def test_cancelled_morph_is_valid():
    t = load_template("halfcell_diced_41")
    *_, (start, target, _) = deformed_cells(t.name, 9, seed=1)
    for found in cancelled(lambda progress: hn.morph(start, t.hexes, target, t.fixed,
                                                     progress=progress)):
        assert not len(nonpositive(found, t.hexes))


# -------------------------------------------------------------------------------------------- morph

@pytest.mark.parametrize("name", FITTED)
def test_morph_into_deformed_cells(name):
    """Every cell is fitted, or proved to allow no valid mesh."""
    t = load_template(name)
    for k, (start, target, _) in enumerate(deformed_cells(name, 24, seed=11)):
        points, reached = hn.morph(start, t.hexes, target, t.fixed)
        assert not len(nonpositive(points, t.hexes)), k
        if reached < 1:
            assert impossible_reason(target, t.hexes, t.fixed), f"{k}: reached {reached}"
        else:
            assert points[t.fixed].tobytes() == target[t.fixed].tobytes(), k
            assert impossible_reason(target, t.hexes, t.fixed) is None, k


@pytest.mark.parametrize("name", FITTED)
def test_morph_of_the_boundary_alone(name):
    """Free points go along; rows of the goal that are not given are not used."""
    t = load_template(name)
    for start, target, _ in itertools.islice(deformed_cells(name, 8, seed=12), 3, 8):
        points, reached = hn.morph(start, t.hexes, target[t.fixed], t.fixed)
        assert reached == 1
        assert points[t.fixed].tobytes() == target[t.fixed].tobytes()
        assert not len(nonpositive(points, t.hexes))


def folding_goal(points, fixed):
    """The boundary with one of its points drawn through the whole body: no valid mesh."""
    v = int(np.flatnonzero(fixed)[0])
    goal = points.copy()
    goal[v] += 1.5 * (points.mean(axis=0) - points[v])
    return goal


@pytest.mark.parametrize("boundary_only", [False, True])
@pytest.mark.parametrize("name", ["graded_box", "twisted_prism", "bent_bar"])
def test_morph_stops_where_it_must(name, boundary_only):
    points, hexes, fixed = small_meshes()[name]
    goal = folding_goal(points, fixed)
    assert impossible_reason(goal, hexes, fixed)
    found, reached = hn.morph(points, hexes, goal[fixed] if boundary_only else goal, fixed)
    assert 0 <= reached < 1
    assert not len(nonpositive(found, hexes))
    on_the_way = (1 - reached) * points[fixed] + reached * goal[fixed]
    assert np.abs(found[fixed] - on_the_way).max() < 1e-13 * np.abs(points).max()
    assert reached > 0


def test_morph_to_the_start():
    points, hexes, fixed = small_meshes()["cylinder"]
    found, reached = hn.morph(points, hexes, points, fixed)
    assert reached == 1 and found[fixed].tobytes() == points[fixed].tobytes()
    assert worst(found, hexes) >= worst(points, hexes)
    found, reached = hn.morph(points, hexes, points, fixed, target=0.1)
    assert reached == 1 and found.tobytes() == points.tobytes()


def test_morph_of_fixed_points_only():
    """A goal that a straight way leads to, and one that it does not."""
    points, hexes, _ = small_meshes()["graded_box"]
    everything = np.ones(len(points), bool)
    found, reached = hn.morph(points, hexes, 2 * points + 1, everything)
    assert reached == 1 and found.tobytes() == (2 * points + 1).tobytes()
    found, reached = hn.morph(points, hexes, points * [1, 1, -1], everything)
    assert reached < 0.5 and not len(nonpositive(found, hexes))
    assert impossible_reason(points * [1, 1, -1], hexes, everything)


def code_of(call, *arguments, **options):
    with pytest.raises(hn.HexconError) as fault:
        call(*arguments, **options)
    assert str(fault.value)
    return fault.value.code


def test_faults_of_morph():
    points, hexes, fixed = small_meshes()["twisted_prism"]
    assert code_of(hn.morph, points, hexes, points[:-1], fixed) == Code.WRONG_SHAPE
    assert code_of(hn.morph, points, hexes, points[:, :2], fixed) == Code.WRONG_SHAPE
    assert code_of(hn.morph, points, hexes, points[fixed][1:], fixed) == Code.WRONG_SHAPE
    assert code_of(hn.morph, points, hexes[:, :7], points, fixed) == Code.WRONG_SHAPE
    assert code_of(hn.morph, points, hexes, points, fixed[1:]) == Code.WRONG_SHAPE
    assert code_of(hn.morph, points, hexes[:0], points, fixed) == Code.EMPTY
    for target in (-0.1, 1.1, np.nan):
        assert code_of(hn.morph, points, hexes, points, fixed, target=target) == Code.BAD_ARGUMENT
    for value in (np.nan, np.inf):
        goal = points.copy()
        goal[np.flatnonzero(fixed)[2], 1] = value
        assert code_of(hn.morph, points, hexes, goal, fixed) == Code.NOT_FINITE
        assert code_of(hn.morph, points, hexes, goal[fixed], fixed) == Code.NOT_FINITE
    repeated = hexes.copy()
    repeated[3, 1] = repeated[3, 2]
    assert code_of(hn.morph, points, repeated, points, fixed) == Code.REPEATED_VERTEX
    assert code_of(hn.morph, points, np.where(hexes == 0, len(points), hexes), points,
                   fixed) == Code.INDEX_OUT_OF_RANGE


def test_morph_wants_a_valid_start():
    points, hexes, fixed = small_meshes(200)["twisted_prism"]
    start = scramble(points, hexes, fixed, 1, 2)
    assert code_of(hn.morph, start, hexes, points, fixed) == Code.NOT_CERTIFIED
    assert code_of(hn.morph, points * [1, 1, -1], hexes, points, fixed) == Code.NOT_CERTIFIED


@pytest.mark.parametrize("name", FITTED)
def test_fitted_cells_are_not_thin_inside(name):
    """Corners are raised at no price inside: a Jacobian of 1e-10 there would be proved positive,
    and lost in the next file."""
    t = load_template(name)
    for start, target, _ in deformed_cells(name, 16, 5):
        points, reached = hn.morph(start, t.hexes, target, t.fixed)
        if reached == 1:
            jacobians = np.linalg.det(SLOPES @ points[t.hexes][:, None])
            assert (jacobians > 1e-6 * jacobians.mean(axis=1, keepdims=True)).all()
