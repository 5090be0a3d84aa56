# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls with what nobody should hand in: the right answer or an error with a code, and nothing else.

`make hostile-test` runs this file once more, against an extension module built with the sanitizers.
"""
import decimal
import fractions
import itertools
import os
import threading

import numpy as np
import pytest
import surfaces as make

import hexcon_native as hn

CALLS_IN_ALL, CALLS_AT_ONCE, SLOW = 2000, 100, 2
Code = hn.ErrorCode

# ------------------------------------------------------------------------------------- good calls


class Given:
    """Good arguments of one call, by name; `arrays` tells which of them are arrays, of what width."""

    def __init__(self, call, arrays, **options):
        self.call, self.arrays, self.options = call, list(arrays), options

    def copy(self):
        options = {name: value.copy() if isinstance(value, np.ndarray) else value
                   for name, value in self.options.items()}
        return Given(self.call, self.arrays, **options)

    def result(self):
        return self.call(**self.options)


def good_calls():
    """The last SLOW of them take some tenths of a second."""
    points, quads = make.box(2, 2, 2)
    mesh = hn.mesh(points, quads)
    moved = mesh.points.copy()
    moved[len(points):] += 0.7
    goal = mesh.points * [1, 1, 2.0]
    fixed = np.arange(len(points))
    surface = {"points": points, "quads": quads.astype(np.int32)}
    hexes = {"points": mesh.points, "hexes": mesh.hexes}
    pairs = hn.pairing(quads, points)
    cube_points, cube_quads = make.box(1, 1, 1)
    cube = {"points": cube_points, "quads": cube_quads.astype(np.int32)}
    odd_points, odd_quads = make.schneiders_pyramid()
    odd = {"points": odd_points, "quads": odd_quads.astype(np.int32)}
    counted = {"threads": 1, "progress": None}
    return [
        Given(hn.check_surface, surface, **surface),
        Given(hn.orient, surface, **surface),
        Given(hn.loops, ["quads"], quads=surface["quads"]),
        Given(hn.colouring, ["quads"], quads=surface["quads"]),
        Given(hn.pairing, surface, **surface, progress=None, fewest=False),
        Given(hn.quality, hexes, **hexes),
        Given(hn.certify, ["points", "hexes", "quads"], **hexes, quads=surface["quads"], progress=None),
        Given(hn.raise_order, hexes, **hexes),
        Given(hn.optimize, ["points", "hexes", "fixed"], points=moved, hexes=mesh.hexes, fixed=fixed, rounds=0,
              target=1.0, mean_passes=0, **counted),
        Given(hn.repair, ["points", "hexes", "fixed"], points=moved, hexes=mesh.hexes, fixed=fixed, pillow="auto",
              **counted),
        Given(hn.morph, ["points", "hexes", "goal", "fixed"], **hexes, goal=goal, fixed=fixed, target=1.0,
              progress=None),
        Given(hn.mesh, surface, **surface, method="auto", order=1, layers=0, pairing="all", core=True, pillow="auto",
              budget=0.0, allow_uncertified=False, certify=True, tetrahedralise=None, **counted),
        Given(hn.mesh, [*surface, "pairing"], **surface, method="pyramid", pairing=pairs, order=2, certify=False,
              **counted),
        Given(hn.mesh, surface, **cube, method="cells", order=1, layers=1, tetrahedralise=None,
              allow_uncertified=True, **counted),
        Given(hn.pairing, surface, **odd, progress=None, fewest=True),
    ]


GOOD = good_calls()


def summary(result):
    """Every number of a result, as bytes; times are left out."""
    if isinstance(result, np.ndarray):
        return result.tobytes()
    if isinstance(result, (list, tuple)):
        return tuple(summary(part) for part in result)
    if isinstance(result, hn.Mesh):
        return summary([result.points, result.hexes, result.quads, result.method])
    return tuple(summary(value) for value in vars(result).values()) if hasattr(result, "__dict__") else result


ANSWERS = [summary(given.result()) for given in GOOD]

# --------------------------------------------------------------------------- arrays of other kinds


class Reader:
    """As a table of another library: an array to whom asks."""

    def __init__(self, array):
        self.array = array

    def __array__(self, dtype=None, copy=None):
        return self.array if dtype is None else self.array.astype(dtype)


class Own(np.ndarray):
    """A subclass that answers comparisons in its own way."""

    def __lt__(self, other):
        raise RuntimeError("no comparison")
    __gt__ = __lt__


def misaligned(array):
    raw = np.zeros(array.nbytes + 1, np.uint8)[1:]
    raw[:] = np.frombuffer(array.tobytes(), np.uint8)
    return raw.view(array.dtype).reshape(array.shape)


def read_only(array):
    array.setflags(write=False)
    return array


def gaps(array):
    wide = np.zeros(tuple(2 * n for n in array.shape), array.dtype)
    wide[tuple(slice(None, None, 2) for _ in array.shape)] = array
    return wide[tuple(slice(None, None, 2) for _ in array.shape)]


SAME = {
    "misaligned": misaligned, "byte-swapped": lambda a: a.astype(a.dtype.newbyteorder()), "read-only": read_only,
    "backwards": lambda a: a[::-1].copy()[::-1], "Fortran order": np.asfortranarray, "gaps": gaps,
    "a list": lambda a: a.tolist(), "a tuple": lambda a: tuple(map(tuple, a.tolist())) if a.ndim > 1 else tuple(a),
    "rows in a list": list, "a subclass": lambda a: a.view(Own), "masked nowhere": np.ma.array,
    "its __array__": Reader, "a memoryview": lambda a: memoryview(np.ascontiguousarray(a)),
    "wider": lambda a: a.astype(np.longdouble if a.dtype.kind == "f" else np.int64),
    "unsigned": lambda a: a if a.dtype.kind == "f" else a.astype(np.uint64),
    "a broadcast row more and less": lambda a: np.concatenate([a, a[:1]])[:-1],
}


class Broken:
    """Whatever is asked of it, it raises."""

    def _complain(self, *_):
        raise ArithmeticError("broken")
    __array__ = __index__ = __float__ = __int__ = __bool__ = __repr__ = __eq__ = __len__ = __getitem__ = _complain
    __hash__ = object.__hash__


def changed(array, rng, value):
    """One entry replaced, in an array that can hold it."""
    if array.size == 0:
        return array
    kind = object if isinstance(value, (str, type(None))) or abs(value) >= 2 ** 64 and isinstance(value, int) else \
        np.float64 if isinstance(value, float) else np.uint64 if value >= 2 ** 63 else np.int64
    copy = array.astype(kind if array.dtype.kind in "iu" or kind is object else np.float64)
    copy.flat[rng.integers(copy.size)] = value
    return copy


def endless(array):
    """Its first row, ten million million times."""
    return np.lib.stride_tricks.as_strided(array, (10 ** 13, *array.shape[1:]), (0, *array.strides[1:]))


def inside_itself():
    ring = []
    ring.append(ring)
    return ring


NUMBERS = (-1, 10 ** 6, 2 ** 31 - 1, 2 ** 31, 2 ** 63, 2 ** 64 - 1, 2 ** 70, -2 ** 63, float("nan"), float("inf"),
           1e100, 1.7e308, -1e200, 1e-300, 5e-324, 0, 0.5, "1", None)

OTHER = {
    "one number": lambda a, rng: np.array(a.flat[0]) if a.size else a, "a number": lambda a, rng: 3,
    "objects": lambda a, rng: a.astype(object), "text": lambda a, rng: a.astype(str),
    "complex": lambda a, rng: a.astype(complex), "booleans": lambda a, rng: a > 0,
    "dates": lambda a, rng: a.astype("datetime64[s]"), "bytes": lambda a, rng: a.tobytes(),
    "records": lambda a, rng: np.zeros(len(a), [("x", float), ("y", float)]),
    "masked": lambda a, rng: np.ma.array(a, mask=rng.random(a.shape) < 0.3), "None": lambda a, rng: None,
    "a word": lambda a, rng: "quads", "a dictionary": lambda a, rng: {0: a}, "a set": lambda a, rng: {1, 2},
    "a generator": lambda a, rng: (row for row in a), "broken": lambda a, rng: Broken(),
    "its __array__ is none": lambda a, rng: Reader("none"), "itself inside": lambda a, rng: inside_itself(),
    "uneven rows": lambda a, rng: [[0, 1, 2, 3], [0]], "empty": lambda a, rng: a[:0], "nothing": lambda a, rng: [],
    "a matrix": lambda a, rng: np.asmatrix(a), "flat": lambda a, rng: a.ravel(),
    "a column less": lambda a, rng: a[..., :-1], "a dimension more": lambda a, rng: a[..., None],
    "no columns": lambda a, rng: np.zeros((len(a), 0)), "rows left out": lambda a, rng: a[rng.random(len(a)) < 0.8],
    "rows twice": lambda a, rng: a[rng.integers(len(a), size=len(a) + 2)] if len(a) else a,
    "rows more": lambda a, rng: np.concatenate([a, a[:1]]), "mixed rows": lambda a, rng: rng.permutation(a),
    "mixed entries": lambda a, rng: rng.permutation(a.ravel()).reshape(a.shape),
    "random ids": lambda a, rng: rng.integers(-1, 14, a.shape), "halves": lambda a, rng: a.astype(np.float16),
    "scaled": lambda a, rng: a * 10.0 ** rng.integers(-300, 300) if a.dtype.kind == "f" else a,
    "more than memory": lambda a, rng: endless(a),
    "a bad number": lambda a, rng: changed(a, rng, NUMBERS[rng.integers(len(NUMBERS))]),
}

# ------------------------------------------------------------------------------- options and calls


class OwnFault(Exception):
    """What a callback of these tests raises."""


def raises(*_):
    raise OwnFault("no")


OPTIONS = (-1, 0, 1, 2, 3, 2 ** 31 - 1, 2 ** 31, 2 ** 63, 10 ** 400, -10 ** 400, 10 ** 5000, 0.5, 1.5, 2.0, -0.0,
           float("nan"), float("inf"), -1e300, 1e300, np.int64(1), np.uint8(2), np.uint64(2 ** 64 - 1),
           np.float32(0.5), np.float16("nan"), np.longdouble(1), np.bool_(True), np.bool_(False), True, False, None,
           "", "1", "auto", "pyramid", "cells", "sheets", "fewest", "none", np.str_("swept"), b"auto", [], ["auto"],
           [1], {}, {1}, (), np.array(1), np.array([1, 2]), np.array([]), object(), Broken(), decimal.Decimal(1),
           fractions.Fraction(1, 2), 1j, raises, ...)

PROGRESS_ANSWERS = (None, True, np.True_, 0, "", [], np.array([True, False]), np.array(False), Broken(), float("nan"),
                    np.False_, False)


def star(points, triangles):
    """A closure about the mean of the points: right for what is convex."""
    corners = np.column_stack([triangles[:, [0, 2, 1]], np.full(len(triangles), len(points))])
    return points.mean(axis=0)[None], corners


def hostile_meshers(rng):
    def torn(points, triangles):
        new, corners = star(points, triangles)
        points[:], triangles[:] = np.nan, -7
        return new, corners

    def damaged(points, triangles):
        damages = list(OTHER.values())
        made = [np.asarray(rows) for rows in star(points, triangles)]
        i = rng.integers(2)
        made[i] = damages[rng.integers(len(damages))](made[i], rng)
        return made
    answer = OPTIONS[rng.integers(len(OPTIONS))]
    choices = (star, torn, damaged, lambda *_: answer, lambda *_: (answer, answer), raises)
    return choices[rng.integers(len(choices))]


def patient(limit=200):
    """No call is unbounded: it is cancelled in the end."""
    steps = itertools.count()
    return lambda *_: next(steps) < limit


def make_hostile(given, rng):
    """Change one to three arguments. Returns whether the answer must stay what it is."""
    same = True
    for name in rng.choice(list(given.options), size=min(rng.integers(1, 4), len(given.options)), replace=False):
        value = given.options[name]
        if name in given.arrays and rng.random() < 0.4:
            given.options[name] = SAME[rng.choice(list(SAME))](value)
            continue
        same = False
        if name in given.arrays and rng.random() < 0.9:
            given.options[name] = OTHER[rng.choice(list(OTHER))](value, rng)
        elif name == "progress" and rng.random() < 0.8:
            answer = PROGRESS_ANSWERS[rng.integers(len(PROGRESS_ANSWERS))]
            given.options[name] = (lambda *_: answer) if rng.random() < 0.8 else raises
        elif name == "tetrahedralise":
            given.options[name] = hostile_meshers(rng)
        elif name == "method" and rng.random() < 0.5:
            given.options[name] = list(hn.METHODS)[rng.integers(len(hn.METHODS))]
        else:
            given.options[name] = OPTIONS[rng.integers(len(OPTIONS))]
    if given.options.get("progress", 1) is None:
        given.options["progress"] = patient()
    return same


def outcome(given):
    """The result, or the error with a code or of the callback's own that is allowed."""
    try:
        return given.result()
    except hn.HexconError as fault:
        assert isinstance(fault.code, Code) and str(fault)
        assert all(type(e) is int for e in fault.elements) and len(fault.elements) <= 1000
        return fault
    except OwnFault as fault:
        return fault


@pytest.mark.parametrize("first", range(0, CALLS_IN_ALL, CALLS_AT_ONCE))
def test_hostile_calls(first):
    failed = []
    for seed in range(first, first + CALLS_AT_ONCE):
        rng = np.random.default_rng([15, seed])
        number = seed % (len(GOOD) - (0 if rng.random() < 0.1 else SLOW))
        given = GOOD[number].copy()
        try:
            same = make_hostile(given, rng)
            found = outcome(given)
            if same:
                assert not isinstance(found, Exception), f"refused: {found}"
                assert summary(found) == ANSWERS[number], "another answer"
        except Exception as fault:
            failed.append(f"seed {seed}, {given.call.__name__}: {type(fault).__name__}: {str(fault)[:200]}")
    assert not failed, "\n".join(failed)


# ---------------------------------------------------------------------------------- named outcomes

@pytest.mark.parametrize("name", SAME)
@pytest.mark.parametrize("number", range(len(GOOD) - SLOW), ids=[given.call.__name__ for given in GOOD[:-SLOW]])
def test_other_kinds_of_arrays(number, name):
    given = GOOD[number].copy()
    for array in given.arrays:
        given.options[array] = SAME[name](given.options[array])
    assert summary(given.result()) == ANSWERS[number]


NAMED = [
    ({"threads": 2 ** 40}, Code.BAD_ARGUMENT), ({"threads": True}, Code.BAD_ARGUMENT),
    ({"layers": 2 ** 31}, Code.BAD_ARGUMENT), ({"order": 10 ** 30}, Code.BAD_ARGUMENT),
    ({"order": np.array([1, 2])}, Code.BAD_ARGUMENT), ({"budget": 10 ** 400}, Code.BAD_ARGUMENT),
    ({"budget": float("nan")}, Code.BAD_ARGUMENT), ({"method": ["auto"]}, Code.BAD_ARGUMENT),
    ({"method": np.array(["auto"])}, Code.BAD_ARGUMENT), ({"core": "no"}, Code.BAD_ARGUMENT),
    ({"allow_uncertified": np.array([True, False])}, Code.BAD_ARGUMENT), ({"certify": None}, Code.BAD_ARGUMENT),
    ({"progress": 3}, Code.BAD_ARGUMENT), ({"tetrahedralise": 3}, Code.BAD_ARGUMENT),
    ({"pairing": None}, Code.BAD_ARGUMENT), ({"threads": Broken()}, Code.BAD_ARGUMENT),
]


@pytest.mark.parametrize("options, code", NAMED, ids=[str(list(o)[0]) + str(i) for i, (o, _) in enumerate(NAMED)])
def test_bad_options_have_a_name(options, code):
    points, quads = make.box(2, 1, 1)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, **options)
    assert fault.value.code == code and next(iter(options)) in str(fault.value)


def test_numpy_scalars_are_options():
    points, quads = make.box(2, 1, 1)
    mesh = hn.mesh(points, quads, np.str_("auto"), order=np.int64(2), threads=np.uint8(1), layers=np.int16(0),
                   core=np.True_, budget=np.float32(60), certify=np.bool_(True), allow_uncertified=np.False_)
    assert mesh.order == 2 and mesh.certificate.certified


def test_masked_values_are_no_values():
    points, quads = make.box(1, 1, 1)
    mask = np.zeros(points.shape, bool)
    mask[0, 0] = True
    with pytest.raises(hn.HexconError, match="masked") as fault:
        hn.mesh(np.ma.array(points, mask=mask), quads)
    assert fault.value.code == Code.WRONG_TYPE


def test_more_than_there_is_memory_for():
    points, quads = make.box(1, 1, 1)
    with pytest.raises(hn.HexconError) as fault:
        hn.loops(endless(quads))
    assert fault.value.code == Code.TOO_LARGE


CANCELLABLE = [number for number, given in enumerate(GOOD) if "progress" in given.options]


@pytest.mark.parametrize("answer", [False, np.False_], ids=["False", "numpy's False"])
@pytest.mark.parametrize("number", CANCELLABLE)
def test_false_of_either_kind_cancels(number, answer):
    given = GOOD[number].copy()
    given.options["progress"] = lambda *_: answer
    found = outcome(given)
    told = []
    GOOD[number].call(**dict(GOOD[number].copy().options, progress=lambda *_: told.append(1)))
    assert not told or found.code == Code.CANCELLED
    if given.call in (hn.optimize, hn.morph) and told:
        assert found.points.shape == given.options["points"].shape


# -------------------------------------------------------------------- arrays that change meanwhile

def scribble(arrays):
    """Over everything that was given, what would lead beyond the arrays if it were read again."""
    for array in arrays:
        if array.dtype.kind == "f":
            array[:] = np.nan
        else:
            array[:] = 2 ** 31 - 1 if array.dtype.itemsize >= 4 else 255


@pytest.mark.parametrize("number", CANCELLABLE)
def test_progress_scribbles_over_the_arrays(number):
    given = GOOD[number].copy()
    arrays = [given.options[name] for name in given.arrays]
    given.options["progress"] = lambda *_: scribble(arrays)
    assert summary(given.result()) == ANSWERS[number]


@pytest.mark.parametrize("number", range(len(GOOD)), ids=[given.call.__name__ for given in GOOD])
def test_another_thread_scribbles_over_the_arrays(number):
    """Whatever is copied of them, it leads nowhere: an answer, or an error with a code."""
    given, stop = GOOD[number].copy(), threading.Event()
    arrays = [given.options[name] for name in given.arrays]
    good = [array.copy() for array in arrays]

    def write():
        while not stop.is_set():
            scribble(arrays)
            for array, values in zip(arrays, good):
                array[:] = values
    writer = threading.Thread(target=write)
    writer.start()
    try:
        for _ in range(20 if number < len(GOOD) - SLOW else 1):
            outcome(given)
    finally:
        stop.set()
        writer.join()


def test_tetrahedra_of_a_mesher_that_scribbles():
    points, quads = make.box(1, 1, 1)
    kept = []

    def mesher(points, triangles):
        made = star(points.copy(), triangles.copy())
        kept.extend(made)
        points[:], triangles[:] = np.inf, -1
        return made
    mesh = hn.mesh(points, quads, "cells", tetrahedralise=mesher, allow_uncertified=True,
                   progress=lambda *_: scribble(kept) if kept else None)
    assert kept and np.isfinite(mesh.points).all()


def test_the_module_is_the_one_with_sanitizers():
    """In the run that is meant for it."""
    assert "sanitized" in hn._core.__file__ or "HEXCON_SANITIZED" not in os.environ
