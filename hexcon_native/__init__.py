# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's core: hexahedral meshes whose boundary is exactly a given quad surface.

Arrays in, arrays out, no other program. All ids are 0-based; quads are counter-clockwise seen
from outside; hexes are in VTK order. The GIL is released while the core works; Ctrl-C and a
`progress` callback cancel. Every fault is a HexconError with a code and the offending ids.
"""
import contextlib
import enum

import numpy as np

from .errors import HexconError

try:
    from . import _core
except ImportError as fault:
    raise ImportError(
        "HexCon's native core is missing or does not load "
        f"({fault}). Build it with `make build` in HexCon's folder."
    ) from fault

ErrorCode = enum.IntEnum("ErrorCode", _core.status_codes())
ErrorCode.__doc__ = "One member per fault of the core; include/hexcon.h says what each means."

METHODS = {"auto": 0, "swept": 1, "sheets": 4, "diced": 3, "smallest": 5, "shelling": 12, "cells": 2, "four-split": 6,
           "pyramid": 7, "pyramid-alt": 8, "geode": 9, "geode-alt": 10, "pillowed": 11}

TOPOLOGICAL_METHODS = frozenset(METHODS) - {"auto", "swept", "sheets", "diced", "smallest", "shelling", "cells"}
"""Methods whose meshes are conforming, but have Jacobians of zero or below: for no solver."""

PAIRINGS = {"all": 0, "fewest": 1, "none": 2}
_GIVEN_PAIRS = 3

__all__ = [
    "Certificate", "ErrorCode", "HexconError", "Loops", "METHODS", "Mesh", "PAIRINGS",
    "Quality", "SurfaceReport", "TOPOLOGICAL_METHODS", "certify", "check_options", "check_surface", "colouring", "loops", "mesh", "morph", "optimize",
    "pairing", "quality", "raise_order",
]


def _raise(message, status, elements):
    """Called by the extension module for every status that is not OK."""
    raise HexconError(message, ErrorCode(status), elements)


# ---------------------------------------------------------------------------- arrays at the border

def _points(points):
    try:
        array = np.asarray(points)
        if array.dtype.kind not in "fiu":
            raise TypeError
        array = np.ascontiguousarray(array, dtype=np.float64)
    except (TypeError, ValueError) as fault:
        raise HexconError("points must be real numbers, convertible to float64",
                          ErrorCode.WRONG_TYPE) from fault
    if array.ndim != 2 or array.shape[1] != 3:
        raise HexconError(f"points must have shape (P, 3), not {array.shape}",
                          ErrorCode.WRONG_SHAPE)
    return array


def _rectangular(ids, name):
    try:
        return np.asarray(ids)
    except ValueError as fault:
        raise HexconError(f"{name} must be a rectangular array of ids",
                          ErrorCode.WRONG_SHAPE) from fault


def _ids(ids, width, name):
    """Rows of 0-based ids as contiguous int32; ids that int32 cannot hold are out of range."""
    array = _rectangular(ids, name)
    if array.ndim != 2 or array.shape[1] != width:
        raise HexconError(f"{name} must have shape (., {width}), not {array.shape}",
                          ErrorCode.WRONG_SHAPE)
    if array.dtype.kind not in "iu" and array.size:  # an empty list is float64 to numpy
        raise HexconError(f"{name} must be integers, not {array.dtype}", ErrorCode.WRONG_TYPE)
    wide = (array < 0) | (array > np.iinfo(np.int32).max)
    if wide.any():
        rows = np.flatnonzero(wide.any(axis=1))
        raise HexconError(f"{len(rows)} rows of {name} (listed) hold ids outside 0 .. 2^31 - 1",
                          ErrorCode.INDEX_OUT_OF_RANGE, rows)
    return np.ascontiguousarray(array, dtype=np.int32)


def _hexes(hexes):
    """Rows of 8 ids; of second-order hexes (20 ids) the corners, as their edges are straight."""
    array = _rectangular(hexes, "hexes")
    if array.ndim == 2 and array.shape[1] == 20:
        array = array[:, :8]
    return _ids(array, 8, "hexes")


def _array(buffer, dtype, width=None):
    array = np.frombuffer(buffer, dtype=dtype)
    return array.reshape(-1, width) if width else array


# --------------------------------------------------------------------------------------- surface

class Loops:
    """Dual loops in figures.

    lengths          (L,) int64, quads passed by each loop
    self_crossings   (L,) int64, quads that each loop passes twice
    """

    def __init__(self, lengths, self_crossings):
        self.lengths = lengths
        self.self_crossings = self_crossings

    def __len__(self):
        return len(self.lengths)

    def __repr__(self):
        crossing = int(np.count_nonzero(self.self_crossings))
        return f"<{len(self)} loops, {crossing} cross themselves>"


class SurfaceReport:
    """Facts of a closed quad surface.

    n, points, edges      counts
    genus, components     of the whole, the genus summed over the components; euler = points - edges + quads
    cavities              components inside an odd number of others; components - cavities are bodies
    even                  every component has an even number of quads
    bipartite             the points can be coloured black and white along edges
    fillable              a hex mesh with this boundary exists, as a complex (Erickson 2014): the quads are
                          even in number, and no odd closed path of edges bounds inside. None: not
                          known (too many holes, or several bodies with an odd part); meaningless if the surface
                          crosses itself
    oriented              quads face out of the solid as given; False: all shells, or some, face into
                          it, and `mesh` turns those
    convex                no edge is concave by more than the warp of its quads
    star_center           (3,) the deepest point that sees every corner triangle, or None
    star_margin           its distance to the nearest corner plane, in the unit of the points
    volume                enclosed, without cavities; positive
    loops                 Loops
    """

    def __init__(self, facts, loop_figures):
        self.n = facts["quads"]
        for name in ("points", "edges", "genus", "components", "cavities", "euler", "even", "bipartite",
                     "oriented", "convex", "star_margin"):
            setattr(self, name, facts[name])
        self.fillable = (None, True, False)[facts["fillable"]]
        self.star_center = np.array(facts["star_center"]) if facts["star_shaped"] else None
        self.volume = abs(facts["volume"])
        self.loops = loop_figures

    def as_dict(self):
        """Plain numbers, for JSON."""
        facts = {k: v for k, v in vars(self).items() if k not in ("loops", "star_center")}
        facts["star_center"] = None if self.star_center is None else self.star_center.tolist()
        facts["loops"] = {"count": len(self.loops),
                          "lengths": self.loops.lengths.tolist(),
                          "self_crossings": self.loops.self_crossings.tolist()}
        return facts

    def __repr__(self):
        return (f"<surface of {self.n} quads, {self.points} points, genus {self.genus}, "
                f"{self.components} component(s), {'even' if self.even else 'odd'}, {self.loops}>")


@contextlib.contextmanager
def _packed_ids(quads):
    """(quads with ids 0, 1, 2 ..., their old names or None): a stray large id costs no memory.

    Points listed by an error inside get their names back.
    """
    if quads.size == 0 or quads.max() < 8 * quads.size:
        yield quads, None
        return
    names, packed = np.unique(quads, return_inverse=True)
    try:
        yield np.ascontiguousarray(packed.reshape(quads.shape), dtype=np.int32), names
    except HexconError as fault:
        if fault.code in (ErrorCode.NON_MANIFOLD_VERTEX, ErrorCode.NOT_BIPARTITE):
            fault.elements = names[fault.elements].tolist()
        raise


def check_surface(points, quads):
    """Check a surface and tell its facts.

    points  (P, 3) float; quads (n, 4) int, 0-based.
    Returns a SurfaceReport. Raises HexconError with codes WRONG_SHAPE, WRONG_TYPE, EMPTY,
    TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE, REPEATED_VERTEX, UNUSED_POINT, NON_MANIFOLD_EDGE,
    NOT_CLOSED, NOT_ORIENTABLE, INCONSISTENT_ORIENTATION, NON_MANIFOLD_VERTEX, OUT_OF_MEMORY.
    An odd, a non-bipartite or an inward surface, or one of several components, is reported, not
    raised. Cost: linear in n; of a surface that is not bipartite near-linear, times the genus squared.
    """
    quads = _ids(quads, 4, "quads")
    facts = _core.check_surface(_points(points), quads)
    offsets, _, crossings = _core.loops(quads)
    figures = Loops(np.diff(_array(offsets, np.uintp)).astype(np.int64),
                    _array(crossings, np.uintp).astype(np.int64))
    return SurfaceReport(facts, figures)


def loops(quads):
    """Dual loops: a list of int32 arrays, the quads each loop passes, in order.

    Every quad occurs twice in all. Raises as check_surface. Cost: linear in n.
    """
    with _packed_ids(_ids(quads, 4, "quads")) as (packed, _):
        offsets, passed, _ = _core.loops(packed)
    return np.split(_array(passed, np.int32), _array(offsets, np.uintp)[1:-1].astype(np.int64))


def colouring(quads):
    """2-colouring of the points along edges: (P,) uint8, 0 black, 1 white, P the largest id + 1.

    The lowest id of each component is black. Raises as check_surface, and NOT_BIPARTITE with the
    points of an odd cycle in order. Cost: linear in n and P.
    """
    with _packed_ids(_ids(quads, 4, "quads")) as (packed, names):
        colours = _array(_core.colouring(packed, int(packed.max(initial=-1)) + 1), np.uint8)
    if names is None:
        return colours
    spread = np.zeros(int(names[-1]) + 1, np.uint8)
    spread[names] = colours
    return spread


def pairing(quads, points=None, *, fewest=False, progress=None):
    """Pair every quad with a neighbour across an edge: a perfect matching of the dual graph.

    points    (P, 3), or None. With points, pairs are flat, of two like quads and not elongated, as
              far as can be: a total weight close to the greatest, not always the greatest
    fewest    pair only what removes the self-crossings: once two hexes stand on each of these
              pairs, no loop crosses itself. As few as a search finds; points are ignored
    progress  as mesh
    Returns (n / 2, 2) int32, with fewest (k, 2), k <= n / 2: the quads of each pair ascending, pairs
    by their first quad. The same for the same input. Raises as check_surface (without points never
    UNUSED_POINT), ODD, CANCELLED, and NO_PAIRING with the quads left over: a component with an odd
    number of quads; with fewest these two only where a loop crosses itself.
    Cost: near-linear in n in practice; with fewest seconds from some hundred quads on.
    """
    quads = _ids(quads, 4, "quads")
    if fewest:
        with _packed_ids(quads) as (packed, _):
            count = int(packed.max(initial=-1)) + 1
            return _array(_core.pairing_of_crossings(count, packed, progress), np.int32, 2)
    if points is not None:
        points = _points(points)
        return _array(_core.pairing(points, len(points), quads, progress), np.int32, 2)
    with _packed_ids(quads) as (packed, _):
        count = int(packed.max(initial=-1)) + 1
        return _array(_core.pairing(None, count, packed, progress), np.int32, 2)


# ------------------------------------------------------------------------------------------ meshes

class Certificate:
    """What is proved of a hex mesh.

    certified        all of the below hold, and the Jacobian of every hex is positive everywhere
    conforming       a 3-manifold: faces in at most two hexes, links are spheres or discs
    proper           two hexes meet in nothing, one vertex, one edge or one face
    boundary_exact   the faces in one hex only are the given quads, outward
    nonpositive      (K,) int32, hexes whose Jacobian is not proved positive
    witnesses        (K, 3) float64, of each of them local coordinates in [0, 1]^3 where the Jacobian
                     is proved zero or negative: corner 0 of the hex lies at (0, 0, 0), 1 at
                     (1, 0, 0), 3 at (0, 1, 0), 4 at (0, 0, 1); NaN for the undecided
    undecided        how many of them are not proved non-positive either
    doublets         (D, 2) int32, pairs of hexes that share two or more faces
    improper         (I,) int32, hexes that meet another improperly
    euler            points - edges + faces - hexes

    Its arrays are read-only.
    """

    def __init__(self, facts):
        self.certified = facts["certified"]
        self.conforming = facts["conforming"]
        self.proper = facts["proper"]
        self.boundary_exact = facts["boundary_exact"]
        self.euler = facts["euler"]
        self.undecided = facts["undecided"]
        self.nonpositive = _array(facts["nonpositive"], np.int32)
        self.witnesses = _array(facts["witnesses"], np.float64, 3)
        self.doublets = _array(facts["doublets"], np.int32, 2)
        self.improper = _array(facts["improper"], np.int32)
        for array in (self.nonpositive, self.witnesses, self.doublets, self.improper):
            array.flags.writeable = False

    def as_dict(self):
        """Plain numbers, for JSON; lists are cut at 1000 entries; no witness: None."""
        facts = dict(vars(self))
        for name in ("nonpositive", "doublets", "improper"):
            facts[name + "_count"] = len(facts[name])
            facts[name] = facts[name][:1000].tolist()
        facts["witnesses"] = [None if np.isnan(point[0]) else point.tolist()
                              for point in self.witnesses[:1000]]
        return facts

    def __repr__(self):
        if self.certified:
            return "<certified>"
        return (f"<not certified: conforming {self.conforming}, proper {self.proper}, boundary "
                f"exact {self.boundary_exact}, {len(self.nonpositive)} hexes not positive>")


class Quality:
    """Quality of a hex mesh.

    scaled_jacobian  (H,) float64, Verdict's, in [-1, 1]
    min, mean, q05   of it; q05 is the 5 % quantile
    """

    def __init__(self, scaled_jacobian):
        self.scaled_jacobian = scaled_jacobian
        self.min = float(scaled_jacobian.min())
        self.mean = float(scaled_jacobian.mean())
        self.q05 = float(np.quantile(scaled_jacobian, 0.05))

    def as_dict(self):
        """Plain numbers, for JSON."""
        return {"min": self.min, "mean": self.mean, "q05": self.q05}

    def __repr__(self):
        return f"<scaled Jacobian min {self.min:.4f}, 5 % {self.q05:.4f}, mean {self.mean:.4f}>"


class Mesh:
    """A hex mesh and what is known of it.

    points       (P, 3) float64; rows 0 .. V-1 are the surface's points, bit for bit
    hexes        (H, 8) int32, or (H, 20) at order 2; VTK order, positive orientation
    quads        (n, 4) int32, the surface's quads in their order, outward; four-split: and then
                 the inner quads, outward too
    order        1 or 2 (mid-edge points on straight edges)
    method       what made it
    topological  its method is one of TOPOLOGICAL_METHODS: conforming, but for no solver
    certificate  Certificate; None if certify was False
    quality      Quality; None if it was left out
    report       dict of figures: counts, "seconds <stage>", quality; "log": list of what was tried;
                 "hexes of <stage>" count those that each stage put in (boundary layers, cells, ...);
                 in hexes they lie one after the other, from outside to inside
    """

    def __init__(self, facts):
        self.order = facts["order"]
        self.points = _array(facts["points"], np.float64, 3)
        self.hexes = _array(facts["hexes"], np.int32, 20 if self.order == 2 else 8)
        self.quads = _array(facts["quads"], np.int32, 4)
        self.method = facts["method"]
        self.topological = facts["topological"]
        self.certificate = facts["certificate"] and Certificate(facts["certificate"])
        self.quality = facts["quality"] and Quality(_array(facts["quality"], np.float64))
        self.report = dict(facts["report"], hexes=len(self.hexes), points=len(self.points),
                           log=facts["log"].splitlines())
        if self.quality:
            self.report["quality"] = self.quality.as_dict()

    def __repr__(self):
        kind = "topological " if self.topological else ""
        return (f"<{kind}{self.method} mesh of {len(self.hexes)} hexes, order {self.order}, "
                f"{self.certificate or 'not checked'}, {self.quality}>")


def mesh(points, quads, method="auto", *, order=1, layers=0, threads=0, tetrahedralise=None,
         pairing="all", core=True, budget=0.0, progress=None, allow_uncertified=False, certify=True):
    """Fill a closed quad surface with hexes whose boundary is exactly its quads.

    points, quads      as check_surface
    method             "swept": a cap's quads times rings; "cells": any even surface whose points
                       can be coloured black and white, of a star-shaped body or, given a tetrahedralise,
                       of any: 31 hexes a quad and tetrahedra inside, each cut into 4 hexes; "sheets", for balls: layers of hexes, each of which takes a dual loop
                       away, until a cube is left: boxes, convex polyhedra with three edges a corner
                       whose faces are cut about their middles, and mixtures that are no sweep; or
                       until a core is left, which is filled as by "smallest" or "cells": then some
                       45 hexes a quad of the core;
                       "diced": a surface that is a coarser one of triangles and quads, with every
                       edge split in two and every face cut about a centre, of a body of any shape
                       and genus: 4 hexes for each tetrahedron inside, and 26 on each coarse quad, or
                       36 where there are coarse triangles as well; "smallest": up to 16 quads of
                       genus 0, from a table of the smallest fillings known; "shelling": as sheets,
                       after some edges have been rotated in shells under the surface, with 38 hexes
                       each: most surfaces of genus 0 up to some 400 quads, with three to six hexes a
                       quad, more where quads are few or very uneven;
                       "auto": swept, sheets, diced, smallest, shelling, sheets and a core, cells, until one is certified and
                       good, or else the best of them: report["log"] tells of each.
                       The TOPOLOGICAL_METHODS are those of Carbonera and Shepherd (2006), for n
                       quads of genus 0: "pyramid" 76 n hexes, "pyramid-alt" 58 n, "geode" 130 n,
                       "geode-alt" 112 n, "pillowed" 139 n without doublets; and of any genus "four-split" 28 n, layers under the
                       surface down to quads that are all split in four. With a tetrahedralise the last
                       three go round holes, too: 4 hexes for each tetrahedron between the Geodes
    order              1, or 2 for mid-edge points on straight edges
    layers             cells: at least so many layers of plain hexes under the surface, before any
                       cell; there may be one more, where it makes the cells better. With
                       layers, auto takes cells at once
    threads            0: one per processor; the result does not depend on it
    tetrahedralise     cells, diced, sheets: None, and all meets in one point; or a callable
                       (points (P, 3), triangles (T, 3)) that fills a closed, outward triangulation:
                       it returns new points (K, 3) and tetrahedra (M, 4) of positive volume, ids
                       of given points, then of new ones, whose boundary is exactly the triangles;
                       or None where it finds none. The better of both is taken
    pairing            topological methods: "all" quads are paired, the "fewest" that remove the self-crossings
                       (see pairing), or "none", which needs a surface whose
                       loops do not cross themselves, or your pairs (k, 2) of quads that share an
                       edge, such that no loop crosses itself then
    core               sheets: False: do not fill what the layers leave, but refuse (NO_SHEETS)
    budget             seconds, kept within a second or 5 %; 0: no limit. The time to prove the mesh at hand
                       is kept back: what is being tried is given up that much earlier, and the
                       best mesh until then is taken
    progress           callable (stage, fraction in 0 .. 1); returning False, raising, or Ctrl-C
                       cancels. As far as there is a mesh, ", " and what is known of it follow the
                       stage's name: "optimisation, 64 hexes, worst scaled Jacobian 0.312", or
                       "untangling, 3 of 64 hexes inverted"
    allow_uncertified  return the best mesh found even if its certificate fails
    certify            False: prove nothing; the mesh has no certificate, and a topological one no
                       quality
    Every method gives the same mesh, bit for bit, however points, quads and their corners are numbered:
    the surface is numbered by its shape first (points along a Morton curve, then by x, y, z; quads by
    their corners), and ids come back as the caller's, those of errors too. Where points coincide, they
    keep their order. tetrahedralise sees that order; what it answers must not depend on anything else.
    Returns a Mesh. Raises HexconError: those of check_surface, SEVERAL_COMPONENTS
    (elements: one quad of each body), ODD (of a single shell of several: elements: one quad of each
    such shell), NO_HEX_MESH (elements: points of closed paths, mostly one, that bound inside and are
    odd: no hex mesh exists; of all methods but four-split), NOT_SWEPT
    (elements: the quads where the best attempt failed), NO_SHEETS (elements: the surface's quads in
    the core that no loop can be taken from; the message says how large it is; where layers take next to nothing
    away, or core is False), NOT_DICED (elements:
    quads that do not fit the subdivision that fits best), UNFILLABLE_QUAD (elements: quads on which
    no positive hex can stand), NOT_STAR_SHAPED, NOT_BIPARTITE
    (elements: points of an odd closed path; another method may do), NO_PAIRING, BAD_PAIRING (elements:
    quads of pairs that are none), SELF_CROSSING (elements: quads that a loop passes twice), NO_SIDES
    (elements: points of a closed path that crosses a family of loops an odd number of times; never
    on a sphere), NOT_A_BALL (holes or cavities that the method cannot deal with), NO_ROTATIONS (shelling: no rotations were found that help), NO_SMALL_FILLING (more than 16 quads, or elements: two quads with two
    opposite corners in common), NOT_CERTIFIED (elements: hexes), OUT_OF_TIME (before there was a
    mesh, or a proof of it), CANCELLED, BAD_ARGUMENT, OUT_OF_MEMORY. Topological meshes are returned if they are
    conforming and their boundary is exact.
    Cost: linear in the hexes made, plus the improvement of what is bad.
    """
    check_options(method, order=order, layers=layers, threads=threads, pairing=pairing, budget=budget)
    mesher = None if tetrahedralise is None else _Mesher(tetrahedralise)
    given = None if isinstance(pairing, str) else _ids(pairing, 2, "pairing")
    return Mesh(_core.mesh(_points(points), _ids(quads, 4, "quads"), METHODS[method], int(order),
                           allow_uncertified, threads, layers, mesher,
                           _GIVEN_PAIRS if given is not None else PAIRINGS[pairing], given,
                           not certify, not core, float(budget), progress))


class _Mesher:
    """A tetrahedral mesher for the core: buffers in, bytes out."""

    def __init__(self, tetrahedralise):
        self.tetrahedralise = tetrahedralise

    def __call__(self, points, triangles):
        made = self.tetrahedralise(_array(points, np.float64, 3), _array(triangles, np.int32, 3))
        if made is None:
            return None
        new_points, tetrahedra = made
        return (np.ascontiguousarray(new_points, np.float64).reshape(-1, 3).tobytes(),
                _ids(tetrahedra, 4, "tetrahedra").tobytes())


def _check_count(name, value):
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise HexconError(f"{name} must be an integer of at least 0, not {value!r}",
                          ErrorCode.BAD_ARGUMENT)


def check_options(method="auto", *, order=1, layers=0, threads=0, pairing="all", budget=0.0):
    """Raise BAD_ARGUMENT for options that mesh would refuse: for callers with work to do before."""
    if method not in METHODS:
        raise HexconError(f"there is no method {method!r}; there are {', '.join(METHODS)}",
                          ErrorCode.BAD_ARGUMENT)
    _check_count("layers", layers)
    _check_count("threads", threads)
    if layers and method not in ("auto", "cells"):
        raise HexconError("only cells have boundary layers: choose method cells",
                          ErrorCode.BAD_ARGUMENT)
    if isinstance(pairing, str) and pairing not in PAIRINGS:
        raise HexconError(f"there is no pairing {pairing!r}; there are {', '.join(PAIRINGS)}, or an "
                          "array of pairs", ErrorCode.BAD_ARGUMENT)
    if not (isinstance(pairing, str) and pairing == "all") and method not in TOPOLOGICAL_METHODS:
        raise HexconError("a pairing is for the topological methods: "
                          f"{', '.join(sorted(TOPOLOGICAL_METHODS))}", ErrorCode.BAD_ARGUMENT)
    if isinstance(budget, bool) or not isinstance(budget, (int, float)) or not 0 <= budget < float("inf"):
        raise HexconError(f"budget must be a number of seconds, not {budget!r}", ErrorCode.BAD_ARGUMENT)
    if isinstance(order, bool) or order not in (1, 2):
        raise HexconError(f"order must be 1 or 2, not {order!r}", ErrorCode.BAD_ARGUMENT)


def quality(points, hexes):
    """Scaled Jacobian of every hex. points (P, 3) float; hexes (H, 8) or (H, 20) int, VTK order.

    Raises WRONG_SHAPE, WRONG_TYPE, EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE. Linear.
    """
    return Quality(_array(_core.quality(_points(points), _hexes(hexes)), np.float64))


def certify(points, hexes, quads, *, progress=None):
    """Prove a hex mesh, or say what is wrong: see Certificate. quads (n, 4): the surface, outward.

    Hexes of order 2 are judged by their corners: their edges are taken as straight.
    Raises as quality, and REPEATED_VERTEX (a hex with a corner twice), CANCELLED, OUT_OF_MEMORY.
    A mesh that fails raises nothing. Cost: linear in H.
    """
    return Certificate(_core.certify(_points(points), _hexes(hexes), _ids(quads, 4, "quads"),
                                     progress))


def _boundary_points(hexes, point_count):
    faces = hexes[:, [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4],
                      [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]].reshape(-1, 4)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True,
                                return_counts=True)
    fixed = np.zeros(point_count, np.uint8)
    fixed[faces[first[count == 1]]] = 1
    return fixed


def _fixed_mask(fixed, hexes, point_count):
    if fixed is None:
        return _boundary_points(hexes, point_count)
    fixed = _rectangular(fixed, "fixed")
    if fixed.dtype == bool:
        if fixed.shape != (point_count,):
            raise HexconError(f"fixed must have shape ({point_count},), not {fixed.shape}",
                              ErrorCode.WRONG_SHAPE)
        return np.ascontiguousarray(fixed, dtype=np.uint8)
    ids = _ids(fixed.reshape(-1, 1), 1, "fixed").ravel()
    if len(ids) and ids.max() >= point_count:
        raise HexconError(f"fixed names points outside 0 .. {point_count - 1} (listed)",
                          ErrorCode.INDEX_OUT_OF_RANGE, ids[ids >= point_count])
    mask = np.zeros(point_count, np.uint8)
    mask[ids] = 1
    return mask


def _mesh(points, hexes):
    """A mesh of order 1 whose ids are valid; points are a copy."""
    points, hexes = _points(points), _ids(hexes, 8, "hexes")
    outside = (hexes >= len(points)).any(axis=1)
    if outside.any():
        raise HexconError(f"{int(outside.sum())} hexes (listed) name points outside 0 .. "
                          f"{len(points) - 1}", ErrorCode.INDEX_OUT_OF_RANGE,
                          np.flatnonzero(outside))
    return np.array(points), hexes


@contextlib.contextmanager
def _best_when_cancelled(points):
    """Hand out what has been reached with the error."""
    try:
        yield
    except HexconError as fault:
        if fault.code == ErrorCode.CANCELLED:
            fault.points = points
        raise


def optimize(points, hexes, fixed=None, *, rounds=0, target=1.0, mean_passes=0, threads=0,
             progress=None):
    """Untangle and improve a hex mesh of order 1 by moving its free points.

    points, hexes  as quality
    fixed          (P,) bool, or ids of the points that stay; None: those of the boundary
    rounds         passes over what is inverted, and then over what can be better (0: 9)
    target         what reaches this scaled Jacobian is left alone
    mean_passes    passes that raise the mean after that; for its sake a hex may be lowered to 3/4
                   of the worst scaled Jacobian, but not below 0.1
    threads        0: one per processor; the result does not depend on it
    Returns (P, 3) float64, never a worse mesh than it was given: no more inverted hexes, then
    (without mean_passes) no lower worst scaled Jacobian; hexes proved positive are counted, so a certified mesh stays so.
    The numbering of the mesh does not matter either. Raises as certify, BAD_ARGUMENT, CANCELLED;
    the best points so far are then the error's `points`.
    """
    points, hexes = _mesh(points, hexes)
    mask = _fixed_mask(fixed, hexes, len(points))
    with _best_when_cancelled(points):
        _core.optimize(points, hexes, mask, rounds, threads, float(target), mean_passes,
                       progress)
    return points


def morph(points, hexes, goal, fixed=None, *, target=1.0, progress=None):
    """Homotopy: take a valid hex mesh of order 1 to another boundary of the same connectivity.

    points, hexes  as quality; every hex positive
    goal           (P, 3) where the points go, those that are not fixed as a first guess;
                   or (F, 3): where the fixed points go, in ascending order of their ids
    fixed          as optimize: the points that go straight to their goals
    target         stop improving when the worst scaled Jacobian reaches it
    Returns points (P, 3) float64 and the part of the way that was reached: 1, the fixed points are
    at their goals; or less where no valid mesh was found farther on, and they are that far on their
    way. Every state on the way is proved positive; at its end the worst hex is raised.
    Raises as optimize, WRONG_SHAPE, NOT_CERTIFIED (the start is not positive).
    """
    points, hexes = _mesh(points, hexes)
    mask, goal = _fixed_mask(fixed, hexes, len(points)), _points(goal)
    count = int(np.count_nonzero(mask))
    boundary_only = len(goal) == count != len(points)
    if boundary_only:
        fixed_goal, goal = goal, points.copy()
        goal[mask != 0] = fixed_goal
    if len(goal) != len(points):
        raise HexconError(f"goal has {len(goal)} rows: give one for each of the {len(points)} points, "
                          f"or one for each of the {count} fixed ones", ErrorCode.WRONG_SHAPE)
    with _best_when_cancelled(points):
        reached = _core.morph(points, hexes, mask, goal, boundary_only, float(target), progress)
    return points, reached


def raise_order(points, hexes):
    """Put a point in the middle of every edge of a mesh of order 1.

    points, hexes  as quality, hexes (H, 8)
    Returns (points (P + E, 3), hexes (H, 20) int32): the given rows bit for bit, then the middles;
    VTK_QUADRATIC_HEXAHEDRON order. Raises as quality, OUT_OF_MEMORY. Linear.
    """
    raised, corners_and_middles = _core.raise_order(_points(points), _ids(hexes, 8, "hexes"))
    return _array(raised, np.float64, 3), _array(corners_and_middles, np.int32, 20)
