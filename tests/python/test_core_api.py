# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hexcon_native promises at its border: arrays of any kind in, named errors, cancellation."""
import signal
import threading
import time

import numpy as np
import pytest
import surfaces as make

import hexcon_native as hn

POINTS, QUADS = make.box(2, 2, 2)
MESH = hn.mesh(POINTS, QUADS)
Code = hn.ErrorCode


def code_of(function, *arguments, **options):
    """The code of the error that this call raises, which must have words."""
    with pytest.raises(hn.HexconError) as fault:
        function(*arguments, **options)
    assert str(fault.value)
    assert len(fault.value.elements) <= 1000
    assert all(type(e) is int for e in fault.value.elements)
    return fault.value.code


# --------------------------------------------------------------------------------------- shapes

WRONG_ROWS = {"3 columns": np.zeros((4, 3), int), "flat": np.arange(8), "a number": np.array(3),
              "3 dimensions": np.zeros((2, 2, 4), int), "a ragged list": [[0, 1, 2, 3], [0, 1]],
              "an empty list": []}


@pytest.mark.parametrize("quads", WRONG_ROWS.values(), ids=WRONG_ROWS)
def test_wrong_shape_of_quads(quads):
    for call in (hn.check_surface, hn.mesh):
        assert code_of(call, POINTS, quads) == Code.WRONG_SHAPE
    for call in (hn.loops, hn.colouring):
        assert code_of(call, quads) == Code.WRONG_SHAPE
    assert code_of(hn.certify, MESH.points, MESH.hexes, quads) == Code.WRONG_SHAPE


@pytest.mark.parametrize("points", [np.zeros((8, 2)), np.zeros(24), np.zeros((8, 3, 1)),
                                    np.array(1.0), np.zeros((3, 8)), []])
def test_wrong_shape_of_points(points):
    for call in (hn.check_surface, hn.mesh):
        assert code_of(call, points, QUADS) == Code.WRONG_SHAPE
    assert code_of(hn.quality, points, MESH.hexes) == Code.WRONG_SHAPE


@pytest.mark.parametrize("hexes", [np.zeros((2, 4), int), np.zeros((2, 27), int), np.arange(8),
                                   [[0, 1, 2, 3, 4, 5, 6, 7], [0]]])
def test_wrong_shape_of_hexes(hexes):
    assert code_of(hn.quality, MESH.points, hexes) == Code.WRONG_SHAPE
    assert code_of(hn.certify, MESH.points, hexes, QUADS) == Code.WRONG_SHAPE
    assert code_of(hn.optimize, MESH.points, hexes) == Code.WRONG_SHAPE


NO_IDS = {"floats": QUADS.astype(float), "bools": QUADS > 3, "complex": QUADS.astype(complex),
          "objects": QUADS.astype(object), "text": QUADS.astype(str),
          "dates": QUADS.astype("datetime64[s]")}


@pytest.mark.parametrize("quads", NO_IDS.values(), ids=NO_IDS)
def test_wrong_type_of_quads(quads):
    for call in (hn.check_surface, hn.mesh):
        assert code_of(call, POINTS, quads) == Code.WRONG_TYPE
    assert code_of(hn.loops, quads) == Code.WRONG_TYPE
    assert code_of(hn.certify, MESH.points, MESH.hexes, quads) == Code.WRONG_TYPE


NO_POINTS = {"bools": POINTS > 1, "complex": POINTS.astype(complex), "objects": POINTS.astype(object),
             "text": POINTS.astype(str), "None": None, "a word": "points", "a dict": {"x": 1},
             "ragged": [[0, 0, 0], [1, 1]]}


@pytest.mark.parametrize("points", NO_POINTS.values(), ids=NO_POINTS)
def test_wrong_type_of_points(points):
    for call in (hn.check_surface, hn.mesh):
        assert code_of(call, points, QUADS) == Code.WRONG_TYPE
    assert code_of(hn.quality, points, MESH.hexes) == Code.WRONG_TYPE


@pytest.mark.parametrize("ids", [None, "quads", {"a": 1}, object(), 3.5], ids=lambda ids: type(ids).__name__)
def test_no_array_at_all(ids):
    wrong = (Code.WRONG_TYPE, Code.WRONG_SHAPE)
    assert code_of(hn.mesh, POINTS, ids) in wrong
    assert code_of(hn.loops, ids) in wrong
    assert code_of(hn.quality, MESH.points, ids) in wrong
    assert code_of(hn.certify, MESH.points, MESH.hexes, ids) in wrong
    assert code_of(hn.optimize, MESH.points, ids) in wrong
    assert code_of(hn.raise_order, MESH.points, ids) in wrong


# ----------------------------------------------------------------------------------- good arrays

def read_only(array):
    copy = array.copy()
    copy.setflags(write=False)
    return copy


def every_other_row(array):
    wide = np.zeros((2 * len(array), array.shape[1] + 3), array.dtype)
    wide[::2, 1:-2] = array
    return wide[::2, 1:-2]


SAME_VALUES = {"int8": (POINTS, QUADS.astype(np.int8)), "uint8": (POINTS, QUADS.astype(np.uint8)),
               "int16": (POINTS, QUADS.astype(np.int16)), "int32": (POINTS, QUADS.astype(np.int32)),
               "uint32": (POINTS, QUADS.astype(np.uint32)), "int64": (POINTS, QUADS.astype(np.int64)),
               "uint64": (POINTS, QUADS.astype(np.uint64)),
               "big-endian": (POINTS.astype(">f8"), QUADS.astype(">i4")),
               "float32": (POINTS.astype(np.float32), QUADS),
               "integer points": (POINTS.astype(int), QUADS),
               "Fortran order": (np.asfortranarray(POINTS), np.asfortranarray(QUADS)),
               "gaps": (every_other_row(POINTS), every_other_row(QUADS)),
               "backwards": (POINTS[::-1][::-1], np.flip(np.flip(QUADS, 0).copy(), 0)),
               "read-only": (read_only(POINTS), read_only(QUADS)),
               "lists": (POINTS.tolist(), QUADS.tolist()),
               "matrices": (np.asmatrix(POINTS), np.asmatrix(QUADS))}


@pytest.mark.parametrize("points, quads", SAME_VALUES.values(), ids=SAME_VALUES)
def test_any_kind_of_array(points, quads):
    mesh = hn.mesh(points, quads)
    assert (mesh.hexes == MESH.hexes).all()
    assert mesh.points.tobytes() == MESH.points.tobytes()
    assert mesh.points.flags.c_contiguous and mesh.points.dtype == np.float64
    assert mesh.hexes.dtype in (np.int32, np.int64)
    assert (mesh.quads == QUADS).all()


def test_input_stays_as_it_is():
    points, quads = POINTS.copy(), np.ascontiguousarray(QUADS[:, ::-1], dtype=np.int32)
    before = points.tobytes(), quads.tobytes()
    hn.mesh(points, quads)
    hn.check_surface(points, quads)
    scrambled = MESH.points + 0.2
    kept = scrambled.tobytes()
    moved = hn.optimize(scrambled, MESH.hexes)
    assert (points.tobytes(), quads.tobytes()) == before
    assert scrambled.tobytes() == kept and not np.shares_memory(moved, scrambled)


def test_surface_points_bit_for_bit():
    points = POINTS * 0.1 + 1 / 3
    points[0, 0] = -0.0
    points[1, 1] = np.nextafter(points[1, 1], 2)
    mesh = hn.mesh(points, QUADS)
    assert mesh.points[:len(points)].tobytes() == points.tobytes()


def test_results_may_be_changed():
    mesh = hn.mesh(POINTS, QUADS)
    mesh.points[0] = 5
    mesh.hexes[0] = 0
    mesh.quality.scaled_jacobian[0] = 0
    assert hn.mesh(POINTS, QUADS).points.tobytes() == MESH.points.tobytes()


# ------------------------------------------------------------------------------------------- ids

@pytest.mark.parametrize("wrong", [-1, len(POINTS), 2 ** 31 - 1, 2 ** 31, 2 ** 32, 2 ** 62, -2 ** 63])
def test_ids_out_of_range(wrong):
    quads = QUADS.astype(np.int64)
    quads[7, 2] = wrong
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(POINTS, quads)
    assert fault.value.code == Code.INDEX_OUT_OF_RANGE
    assert fault.value.elements == [7]
    hexes = MESH.hexes.astype(np.int64)
    hexes[3, 3] = wrong + 1 if wrong == len(POINTS) else wrong
    for call in (hn.quality, hn.optimize, hn.raise_order):
        assert code_of(call, MESH.points, hexes) == Code.INDEX_OUT_OF_RANGE
    assert code_of(hn.certify, MESH.points, hexes, QUADS) == Code.INDEX_OUT_OF_RANGE


def test_unsigned_ids_out_of_range():
    quads = QUADS.astype(np.uint64)
    quads[2, 1] = 2 ** 64 - 1
    assert code_of(hn.mesh, POINTS, quads) == Code.INDEX_OUT_OF_RANGE


def test_at_most_1000_elements():
    points, quads = make.box(20, 20, 20)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads + len(points))
    assert fault.value.code == Code.INDEX_OUT_OF_RANGE
    assert fault.value.elements == list(range(1000))
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads.astype(np.int64) + 2 ** 40)
    assert fault.value.elements == list(range(1000))


def test_every_fault_has_a_code():
    assert len(Code) == len(hn.ErrorCode.__members__) >= 21
    assert len(set(Code)) == len(Code)
    assert issubclass(hn.HexconError, Exception)


def surface_fault(change):
    points, quads = POINTS.copy(), QUADS.copy()
    points, quads = change(points, quads) or (points, quads)
    return code_of(hn.check_surface, points, quads), code_of(hn.mesh, points, quads)


def no_number(points, quads):
    points[3, 1] = np.nan


def infinite(points, quads):
    points[3, 1] = -np.inf


def twice(points, quads):
    quads[5, 1] = quads[5, 0]


def unused(points, quads):
    return np.vstack([points, [[9, 9, 9]]]), quads


def opened(points, quads):
    return points, quads[:-1]


def doubled(points, quads):
    return points, np.vstack([quads, quads[:1]])


def flipped(points, quads):
    quads[4] = quads[4, ::-1].copy()


def emptied(points, quads):
    return points, quads[:0]


@pytest.mark.parametrize("change, code", [
    (no_number, Code.NOT_FINITE), (infinite, Code.NOT_FINITE), (twice, Code.REPEATED_VERTEX),
    (unused, Code.UNUSED_POINT), (opened, Code.NOT_CLOSED), (doubled, Code.NON_MANIFOLD_EDGE),
    (flipped, Code.INCONSISTENT_ORIENTATION), (emptied, Code.EMPTY)], ids=lambda x: getattr(
        x, "__name__", ""))
def test_surface_faults(change, code):
    assert surface_fault(change) == (code, code)


def test_two_parts():
    points = np.vstack([POINTS, POINTS + 5])
    quads = np.vstack([QUADS, QUADS + len(POINTS)])
    assert hn.check_surface(points, quads).components == 2
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads)
    assert fault.value.code == Code.SEVERAL_COMPONENTS
    assert fault.value.elements == [0, len(QUADS)]


# --------------------------------------------------------------------------------------- options

@pytest.mark.parametrize("options", [{"method": "magic"}, {"method": None}, {"method": 1},
                                     {"order": 3}, {"order": 0}, {"order": "2"}, {"order": True},
                                     {"threads": -1}, {"threads": 1.5}, {"threads": None}])
def test_bad_options(options):
    assert code_of(hn.mesh, POINTS, QUADS, **options) == Code.BAD_ARGUMENT


@pytest.mark.parametrize("options", [{"rounds": -1}, {"threads": -2}, {"target": 2},
                                     {"target": -0.1}, {"target": float("nan")}])
def test_bad_options_of_optimize(options):
    assert code_of(hn.optimize, MESH.points, MESH.hexes, **options) == Code.BAD_ARGUMENT


@pytest.mark.parametrize("call", [
    lambda: hn.mesh(POINTS, QUADS, progress=3),
    lambda: hn.certify(MESH.points, MESH.hexes, QUADS, progress="often"),
    lambda: hn.optimize(MESH.points, MESH.hexes, progress=[])])
def test_progress_must_be_callable(call):
    with pytest.raises((TypeError, hn.HexconError), match="progress"):
        call()


def test_fixed_points_of_optimize():
    count = len(MESH.points)
    moved = MESH.points + np.random.default_rng(1).uniform(-0.2, 0.2, (count, 3))
    fixed = np.arange(count) % 2 == 0
    by_mask = hn.optimize(moved, MESH.hexes, fixed)
    assert by_mask[fixed].tobytes() == moved[fixed].tobytes()
    assert (hn.optimize(moved, MESH.hexes, np.flatnonzero(fixed)) == by_mask).all()
    assert code_of(hn.optimize, moved, MESH.hexes, fixed[:-1]) == Code.WRONG_SHAPE
    assert code_of(hn.optimize, moved, MESH.hexes, [0, count]) == Code.INDEX_OUT_OF_RANGE
    assert code_of(hn.optimize, moved, MESH.hexes, [-1]) == Code.INDEX_OUT_OF_RANGE
    assert code_of(hn.optimize, moved, MESH.hexes, [0.5]) == Code.WRONG_TYPE
    assert (hn.optimize(moved, MESH.hexes, []) != moved).any()  # nothing is fixed


# ----------------------------------------------------------------------------- progress and cancel

def calls_with_progress():
    scrambled = MESH.points.copy()
    scrambled[26:] += 0.8
    return {"mesh": lambda p: hn.mesh(POINTS, QUADS, progress=p),
            "certify": lambda p: hn.certify(MESH.points, MESH.hexes, QUADS, progress=p),
            "optimize": lambda p: hn.optimize(scrambled, MESH.hexes, progress=p),
            "morph": lambda p: hn.morph(MESH.points, MESH.hexes, 2 * POINTS, progress=p)}


CALLS = calls_with_progress()


@pytest.mark.parametrize("name", CALLS)
def test_progress_is_told(name):
    seen = []
    CALLS[name](lambda stage, fraction: seen.append((stage, fraction)))
    assert seen
    assert all(type(stage) is str and stage and type(fraction) is float and 0 <= fraction <= 1
               for stage, fraction in seen)


@pytest.mark.parametrize("name", CALLS)
def test_progress_cancels_at_every_call(name):
    total = []
    CALLS[name](lambda *_: total.append(1))
    for stop in range(1, len(total) + 1):
        seen = []
        with pytest.raises(hn.HexconError) as fault:
            CALLS[name](lambda *_: seen.append(1) or len(seen) != stop)
        assert fault.value.code == Code.CANCELLED
        assert "cancelled" in str(fault.value)
        assert len(seen) == stop


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("answer", [None, True, 0, "", np.True_])
def test_only_false_cancels(name, answer):
    CALLS[name](lambda *_: answer)


@pytest.mark.parametrize("name", CALLS)
def test_exception_in_progress(name):
    class Unexpected(Exception):
        pass

    def complain(*_):
        raise Unexpected("no")
    with pytest.raises(Unexpected, match="no"):
        CALLS[name](complain)
    with pytest.raises(TypeError):
        CALLS[name](lambda: None)  # takes too few arguments
    CALLS[name](None)  # nothing remains of it


def test_mesh_inside_progress():
    """The core has no global state: a callback may call it."""
    inner = []
    hn.mesh(POINTS, QUADS, progress=lambda *_: inner.append(hn.mesh(POINTS, QUADS)) or True)
    assert all(m.points.tobytes() == MESH.points.tobytes() for m in inner) and inner


def test_interrupt():
    """Ctrl-C ends the call, whatever it does: tried on larger surfaces until it comes in time."""
    def interrupt(*_):
        raise KeyboardInterrupt
    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        for n in (40, 80, 120, 160):
            points, quads = make.box(n, n, n)
            try:
                signal.setitimer(signal.ITIMER_REAL, 0.03)
                hn.mesh(points, quads)
            except KeyboardInterrupt:
                return
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        pytest.fail("no call was interrupted")
    finally:
        signal.signal(signal.SIGALRM, before)


def test_other_threads_run():
    """A thread that takes the GIL for every step makes many of them between two callbacks; were the
    GIL held, one or two."""
    steps, stop = [0], threading.Event()

    def walk():
        while not stop.is_set():
            steps[0] += 1
            time.sleep(0)
    walker = threading.Thread(target=walk)
    points, quads = make.box(50, 50, 50)
    inside = []

    def note(stage, fraction):
        inside.append(steps[0])
    walker.start()
    try:
        hn.mesh(points, quads, progress=note)
    finally:
        stop.set()
        walker.join()
    assert np.diff(inside).max() > 50


def test_threads_mesh_at_once():
    results = {}

    def work(n):
        points, quads = make.box(n, n, n)
        results[n] = hn.mesh(points, quads)
    threads = [threading.Thread(target=work, args=(n,)) for n in range(2, 12)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert [len(results[n].hexes) for n in range(2, 12)] == [n ** 3 for n in range(2, 12)]


# ----------------------------------------------------------------------------------------- facts

def test_report():
    report = hn.check_surface(POINTS, QUADS)
    assert (report.n, report.points, report.edges) == (24, 26, 48)
    assert (report.genus, report.components, report.euler) == (0, 1, 2)
    assert report.even and report.bipartite and report.oriented and report.convex
    assert report.star_center == pytest.approx([1, 1, 1])
    assert report.star_margin == pytest.approx(1)
    assert report.volume == pytest.approx(8)
    assert report.loops.lengths.tolist() == [8] * 6
    assert report.loops.self_crossings.tolist() == [0] * 6
    plain = report.as_dict()
    assert plain["loops"]["count"] == 6


def test_loops_and_colouring():
    loops = hn.loops(QUADS)
    assert len(loops) == 6 and all(len(loop) == 8 for loop in loops)
    assert (np.bincount(np.concatenate(loops)) == 2).all()
    pyramid = hn.loops(make.schneiders_pyramid()[1])
    assert sorted(len(loop) for loop in pyramid) == [8, 24]
    colours = hn.colouring(QUADS)
    ends = np.stack([QUADS, np.roll(QUADS, -1, axis=1)], axis=2).reshape(-1, 2)
    assert (colours[ends].sum(axis=1) == 1).all() and colours[0] == 0
    points, quads = make.prism(make.annulus(3), [0.0, 1.0, 2.0], make.upright)
    assert not hn.check_surface(points, quads).bipartite
    with pytest.raises(hn.HexconError) as fault:
        hn.colouring(quads)
    assert fault.value.code == Code.NOT_BIPARTITE
    assert len(fault.value.elements) % 2 == 1


def test_certificate_of_a_bad_mesh():
    bad = MESH.points.copy()
    bad[26] = [2.5, 2.5, 2.5]
    certificate = hn.certify(bad, MESH.hexes, QUADS)
    assert not certificate.certified and certificate.boundary_exact and certificate.proper
    assert len(certificate.nonpositive) > 0
    assert hn.certify(MESH.points, MESH.hexes, QUADS[:-1]).boundary_exact is False
    assert certificate.witnesses.shape == (len(certificate.nonpositive), 3)
    for array in (certificate.nonpositive, certificate.witnesses, certificate.doublets,
                  certificate.improper):
        assert not array.flags.writeable
    plain = certificate.as_dict()
    assert plain["nonpositive_count"] == len(certificate.nonpositive)
    assert plain["witnesses"] == certificate.witnesses.tolist()


def test_certify_order_2():
    mesh = hn.mesh(POINTS, QUADS, order=2)
    assert hn.certify(mesh.points, mesh.hexes, QUADS).certified
    assert hn.quality(mesh.points, mesh.hexes).min == pytest.approx(1)


def test_nothing_is_begun_after_the_budget():
    points, quads = make.box(3, 3, 3)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "cells", budget=1e-9)
    assert fault.value.code == Code.OUT_OF_TIME and "time budget" in str(fault.value)


@pytest.mark.parametrize("budget", [-1, float("nan"), float("inf"), "10", True])
def test_budgets_that_are_none(budget):
    points, quads = make.box(1, 1, 1)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, budget=budget)
    assert fault.value.code == Code.BAD_ARGUMENT


def test_auto_tells_of_every_method_it_tried():
    points, quads = make.schneiders_pyramid()
    mesh = hn.mesh(points, quads)
    told = mesh.report["log"]
    assert told[0].startswith("swept: not swept")
    assert any(line.startswith(f"{mesh.method}: {len(mesh.hexes)} hexes") for line in told)
    assert any(line.startswith(f"chosen: {mesh.method}") for line in told)
