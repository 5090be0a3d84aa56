# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's core: hexahedral meshes whose boundary is exactly a given quad surface.

Arrays in, arrays out, no other program. All ids are 0-based; quads are counter-clockwise seen
from outside; hexes are in VTK order. The GIL is released while the core works; Ctrl-C and a
`progress` callback cancel. Every fault is a HexconError with a code and the offending ids.
"""
import contextlib
import enum
import functools
import numbers
import operator
import reprlib

import numpy as np

from . import core_builds
from .errors import HexconError

try:
    __path__.append(core_builds.folder())  # noqa: F821  a package has it
    from . import _core
except ImportError as fault:
    raise ImportError(core_builds.what_is_missing(fault)) from fault

from .carriers import Carrier, Facets, packed, packed_facets  # after the guard: it reads the core
from .tables import (
    CARRIERS,
    GIVEN,
    HEX_STAGES,
    METHOD_CHOICES,
    METHOD_TABLE,
    METHODS,
    MOST_PILLOWS,
    PAIRING_NUMBERS,
    PAIRINGS,
    PILLOWS,
    STAGES,
    TOPOLOGICAL_METHODS,
    ErrorCode,
    Method,
    MethodTry,
    methods_that,
)

__version__ = _core.version()

__all__ = [
    "CARRIERS", "Carrier", "Certificate", "ErrorCode", "Facets", "HEX_STAGES", "HexconError", "Loops", "METHODS", "METHOD_CHOICES", "METHOD_TABLE", "Mesh", "Method",
    "MethodTry", "PAIRINGS", "PILLOWS", "Quality", "Repaired", "STAGES", "SurfaceReport", "TOPOLOGICAL_METHODS", "certify", "check_options",
    "check_surface", "colouring", "loops", "mesh", "methods_that", "morph", "optimize", "orient", "pairing", "project_points",
    "quality", "raise_order", "relax", "repair",
]


def _raise(message, status, elements):
    """Called by the extension module for every status that is not OK."""
    raise HexconError(message, ErrorCode(status), elements)


# ---------------------------------------------------------------------------- arrays at the border

_MOST = np.iinfo(np.int32).max
"""Ids and options are C's int."""


def _named_memory(call):
    """A call whose MemoryError, of numpy or of the extension module, is OUT_OF_MEMORY."""
    @functools.wraps(call)
    def named(*arguments, **options):
        try:
            return call(*arguments, **options)
        except MemoryError as fault:
            raise HexconError(f"out of memory in {call.__name__}: there are more rows than this machine holds",
                              ErrorCode.OUT_OF_MEMORY) from fault
    return named


def _plain(values, name, ragged=ErrorCode.WRONG_SHAPE):
    """numpy's own array of the values, whatever class they came in; lists of uneven rows are `ragged`."""
    if np.ma.is_masked(values):
        raise HexconError(f"{name} are masked in part: fill or leave out what is masked", ErrorCode.WRONG_TYPE)
    try:
        return np.asarray(values)
    except ValueError as fault:
        raise HexconError(f"{name} must be a rectangular array of numbers", ragged) from fault
    except MemoryError:
        raise
    except Exception as fault:  # of the object's own making
        raise HexconError(f"{name} cannot be read as an array: {fault}", ErrorCode.WRONG_TYPE) from fault


def _check_rows(array, width, name):
    if array.ndim != 2 or array.shape[1] != width:
        raise HexconError(f"{name} must have shape (., {width}), not {array.shape}",
                          ErrorCode.WRONG_SHAPE)
    if len(array) > _MOST:
        raise HexconError(f"{name} have {len(array)} rows, more than 32-bit ids count", ErrorCode.TOO_LARGE)


def _points(points):
    array = _plain(points, "points", ErrorCode.WRONG_TYPE)
    if array.dtype.kind not in "fiu":
        raise HexconError(f"points must be real numbers, not {array.dtype}", ErrorCode.WRONG_TYPE)
    _check_rows(array, 3, "points")
    with np.errstate(all="ignore"):  # what float64 cannot hold becomes infinite, which the core refuses
        return np.ascontiguousarray(array, dtype=np.float64)


def _ids(ids, width, name):
    """Rows of 0-based ids as contiguous int32; ids that int32 cannot hold are out of range."""
    array = _plain(ids, name)
    _check_rows(array, width, name)
    if array.dtype.kind not in "iu" and array.size:  # an empty list is float64 to numpy
        raise HexconError(f"{name} must be integers of at most 64 bits, not {array.dtype}",
                          ErrorCode.WRONG_TYPE)
    if array.size == 0:
        return np.zeros((0, width), np.int32)
    wide = (array < 0) | (array > _MOST)
    if wide.any():
        rows = np.flatnonzero(wide.any(axis=1))
        raise HexconError(f"{len(rows)} rows of {name} (listed) hold ids outside 0 .. 2^31 - 1",
                          ErrorCode.INDEX_OUT_OF_RANGE, rows[:1000])
    return np.ascontiguousarray(array, dtype=np.int32)


def _hexes_of_any_order(hexes):
    """Rows of 8 ids or of 20."""
    array = _plain(hexes, "hexes")
    return _ids(array, 20 if array.ndim == 2 and array.shape[1] == 20 else 8, "hexes")


def _array(buffer, dtype, width=None):
    array = np.frombuffer(buffer, dtype=dtype)
    return array.reshape(-1, width) if width else array


# --------------------------------------------------------------------------- options at the border

def _shown(value):
    try:
        return reprlib.repr(value)
    except Exception:  # a number of too many digits, or the object's own
        return f"this {type(value).__name__}"


def _bad_option(name, value, wanted):
    return HexconError(f"{name} must be {wanted}, not {_shown(value)}", ErrorCode.BAD_ARGUMENT)


def _count(name, value):
    """An int of C from any integer but a bool."""
    try:
        number = -1 if isinstance(value, (bool, np.bool_)) else operator.index(value)
    except Exception:  # no integer; an array of several
        number = -1
    if not 0 <= number <= _MOST:
        raise _bad_option(name, value, f"an integer in 0 .. {_MOST}")
    return number


def _number(name, value, wanted, most=float("inf")):
    """A finite float of 0 .. most from any real number but a bool."""
    number = -1.0
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_)):
        with contextlib.suppress(OverflowError):  # an int beyond all floats
            number = float(value)
    if not 0 <= number <= most or number == float("inf"):
        raise _bad_option(name, value, wanted)
    return number


def _target(value):
    return _number("target", value, "a number in 0 .. 1", 1)


def _flag(name, value):
    if not isinstance(value, (bool, np.bool_)):
        raise _bad_option(name, value, "True or False")
    return bool(value)


def _progress(progress):
    """The callback as the extension module calls it: False and nothing else cancels."""
    if progress is None:
        return None
    if not callable(progress):
        raise _bad_option("progress", progress, "a callable (stage, fraction) or None")

    def tell(stage, fraction):
        answer = progress(stage, fraction)
        return not isinstance(answer, (bool, np.bool_)) or bool(answer)
    return tell


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


_EMBEDDED = (None, True, False)  # hexcon_embedded


def _set_embedding(owner, embedding):
    owner.embedded = _EMBEDDED[embedding["embedded"]]
    owner.crossings = _array(embedding["pairs"], np.int32, 2)
    owner.crossings.flags.writeable = False
    owner.embedding_reason = embedding["reason"]


class SurfaceReport:
    """Facts of a closed quad surface.

    n, points, edges      counts
    genus, components     of the whole, the genus summed over the components; euler = points - edges + quads
    cavities              components inside an odd number of others; components - cavities are bodies
    even                  every component has an even number of quads
    embedded              True: it crosses and touches itself nowhere (as bilinear patches, proved); False:
                          `crossings` do; None: these come too near to each other to tell
    crossings             (K, 2) int32 quads, K <= 1000; the same twice: a flat quad that is folded
    embedding_reason      words for what is not True; "" if it is
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
    volume                enclosed, without cavities; positive. None: the surface crosses or touches itself, and bounds
                          no solid
    loops                 Loops
    """

    def __init__(self, facts, loop_figures, embedding):
        self.n = facts["quads"]
        _set_embedding(self, embedding)
        for name in ("points", "edges", "genus", "components", "cavities", "euler", "even", "bipartite",
                     "oriented", "convex", "star_margin"):
            setattr(self, name, facts[name])
        self.fillable = (None, True, False)[facts["fillable"]]
        self.star_center = np.array(facts["star_center"]) if facts["star_shaped"] else None
        self.volume = None if self.embedded is False else abs(facts["volume"])
        self.loops = loop_figures

    def as_dict(self):
        """Plain numbers, for JSON."""
        facts = {k: v for k, v in vars(self).items() if k not in ("loops", "star_center")}
        facts["crossings"] = self.crossings.tolist()
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


@_named_memory
def check_surface(points, quads):
    """Check a surface and tell its facts.

    points  (P, 3) float; quads (n, 4) int, 0-based.
    Returns a SurfaceReport. Raises HexconError with codes WRONG_SHAPE, WRONG_TYPE, EMPTY,
    TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE, REPEATED_VERTEX, UNUSED_POINT, NON_MANIFOLD_EDGE,
    NOT_CLOSED, NOT_ORIENTABLE, INCONSISTENT_ORIENTATION, NON_MANIFOLD_VERTEX, OUT_OF_MEMORY.
    An odd, a non-bipartite or an inward surface, one of several components, or one that crosses
    itself, is reported, not raised. Cost: n log n; of a surface that is not bipartite near-linear, times the genus squared.
    """
    points = np.array(_points(points))
    quads = np.array(_ids(quads, 4, "quads"))  # the same for all calls
    facts = _core.check_surface(points, quads)
    embedding = _core.embedding(points, quads, None)
    offsets, _, crossings = _core.loops(quads)
    figures = Loops(np.diff(_array(offsets, np.uintp)).astype(np.int64),
                    _array(crossings, np.uintp).astype(np.int64))
    return SurfaceReport(facts, figures, embedding)


@_named_memory
def orient(points, quads):
    """Turn quads whose corners run in any sense until they face out of the solid, into its cavities.

    points, quads  as check_surface
    Returns (quads (n, 4) int32, number of bodies, number of cavities); the corners of those that are turned are
    reversed. Raises as check_surface, but never INCONSISTENT_ORIENTATION. Cost: linear in n; of several shells,
    linear in the quads of those round each other.
    """
    turned, bodies, cavities = _core.orient_surface(_points(points), _ids(quads, 4, "quads"))
    return _array(turned, np.int32, 4), bodies, cavities


@_named_memory
def loops(quads):
    """Dual loops: a list of int32 arrays, the quads each loop passes, in order.

    Every quad occurs twice in all. Raises as check_surface. Cost: linear in n.
    """
    with _packed_ids(_ids(quads, 4, "quads")) as (packed, _):
        offsets, passed, _ = _core.loops(packed)
    return np.split(_array(passed, np.int32), _array(offsets, np.uintp)[1:-1].astype(np.int64))


@_named_memory
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


@_named_memory
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
    quads, progress = _ids(quads, 4, "quads"), _progress(progress)
    if _flag("fewest", fewest):
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
    embedded         True: the boundary, each quad the bilinear patch on its corners (of hexes with
                     curved edges the patch of its 8 nodes), crosses and touches
                     itself nowhere, and no body lies in another: with the rest above, no two hexes
                     overlap. False: `crossings` do. None: not told, `embedding_reason` says why
    crossings        (K, 2) int32, pairs of given quads, K <= 1000
    embedding_reason words for what is not True; "" if it is
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
        _set_embedding(self, facts["embedding"])
        for array in (self.nonpositive, self.witnesses, self.doublets, self.improper):
            array.flags.writeable = False

    def as_dict(self):
        """Plain numbers, for JSON; lists are cut at 1000 entries; no witness: None."""
        facts = dict(vars(self))
        for name in ("nonpositive", "doublets", "improper", "crossings"):
            facts[name + "_count"] = len(facts[name])
            facts[name] = facts[name][:1000].tolist()
        facts["witnesses"] = [None if np.isnan(point[0]) else point.tolist()
                              for point in self.witnesses[:1000]]
        return facts

    def __repr__(self):
        if self.certified:
            return "<certified>"
        return (f"<not certified: conforming {self.conforming}, proper {self.proper}, boundary "
                f"exact {self.boundary_exact}, embedded {self.embedded}, {len(self.nonpositive)} hexes not "
                f"positive>")


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
    order        1 or 2; mid-edge points lie on straight edges, until hexcon.mesh_solid curves them
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


@_named_memory
def mesh(points, quads, method="auto", *, hexes=None, order=1, layers=0, threads=0, tetrahedralise=None,
         pairing="all", core=True, pillow="auto", budget=0.0, progress=None, allow_uncertified=False,
         allow_topological=False, certify=True):
    """Fill a closed quad surface with hexes whose boundary is exactly its quads.

    points, quads      as check_surface
    method             one of METHODS; METHOD_TABLE tells what each is for, what it takes and makes, and docs/methods.md
                       more. "auto" tries those for solvers until one is certified and good, or else takes the
                       best of them: report["log"] tells of each. Of the TOPOLOGICAL_METHODS see Mesh
    hexes              a proposal, for "auto", which tries it first, and "proposal": hexes (H, 8) int in VTK
                       order that have exactly the quads for their boundary. Ids are rows of points;
                       those beyond are inner points, for which places are found. Or (inner points (K, 3),
                       hexes): with places, which stay where they are good
    order              1, or 2 for mid-edge points, on straight edges
    layers             at least so many layers of plain hexes under the surface, before anything else;
                       there may be one more, where it makes the hexes better. With layers, auto tries only
                       methods that take them
    threads            0: one per processor; the result does not depend on it
    tetrahedralise     None, and all meets in one point; or a callable
                       (points (P, 3), triangles (T, 3)) that fills a closed, outward triangulation:
                       it returns new points (K, 3) and tetrahedra (M, 4) of positive volume, ids
                       of given points, then of new ones, whose boundary is exactly the triangles;
                       or None where it finds none. The better of both is taken
    pairing            topological methods: "all" quads are paired, the "fewest" that remove the self-crossings
                       (see pairing), or "none", which needs a surface whose
                       loops do not cross themselves, or your pairs (k, 2) of quads that share an
                       edge, such that no loop crosses itself then
    core               False: do not fill what the layers leave, but refuse (NO_SHEETS)
    pillow             sheets of hexes under the whole surface, each as many hexes as there are quads, laid as the
                       last step of a method; all is improved then. "auto": one, where the worst scaled Jacobian is
                       below 0.4, the surface's corners allow a clearly better one (report["pillow bound"]), and it
                       comes out so; "never"; or so many, 1 to 16, better or not. report["pillows"] and report["log"]
                       tell. Topological methods take none
    budget             seconds, kept within a second or 5 %; 0: no limit. The time to prove the mesh at hand
                       is kept back: what is being tried is given up that much earlier, and the
                       best mesh until then is taken
    progress           callable (stage, fraction in 0 .. 1); returning False, raising, or Ctrl-C
                       cancels. As far as there is a mesh, ", " and what is known of it follow the
                       stage's name: "optimisation, 64 hexes, worst scaled Jacobian 0.312", or
                       "untangling, 3 of 64 hexes inverted"
    allow_uncertified  return the best mesh found even if its certificate fails
    allow_topological  topological methods: take a surface that crosses or touches itself too; its hexes
                       overlap, and the certificate's `embedded` says so
    certify            False: prove nothing; the mesh has no certificate, and a topological one no
                       quality
    Every method gives the same mesh, bit for bit, however points, quads and their corners are numbered:
    the surface is numbered by its shape first (points along a Morton curve, then by x, y, z; quads by
    their corners), and ids come back as the caller's, those of errors too. Where points coincide, they
    keep their order. tetrahedralise sees that order; what it answers must not depend on anything else.
    Returns a Mesh. Raises HexconError: those of check_surface, SELF_INTERSECTING (elements: quads,
    pair after pair, at most 1000 in all: the surface crosses or touches itself there, or comes too near to
    itself to tell), BAD_PROPOSAL (elements: hexes that meet improperly, or rows of the inner points; "auto"
    turns to other methods), SEVERAL_COMPONENTS
    (elements: one quad of each body), ODD (of a single shell of several: elements: one quad of each
    such shell), NO_HEX_MESH (elements: points of closed paths, mostly one, that bound inside and are
    odd: no hex mesh exists; of all methods that fill bodies), NOT_SWEPT
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
    check_options(method, order=order, layers=layers, threads=threads, pairing=pairing, budget=budget, core=core,
                  pillow=pillow)
    if tetrahedralise is not None and not callable(tetrahedralise):
        raise _bad_option("tetrahedralise", tetrahedralise, "a callable (points, triangles) or None")
    mesher = None if tetrahedralise is None else _Mesher(tetrahedralise)
    points = _points(points)
    given = None if isinstance(pairing, str) else _ids(pairing, 2, "pairing")
    return Mesh(_core.mesh(points, _ids(quads, 4, "quads"), METHODS[method], _count("order", order),
                           _flag("allow_uncertified", allow_uncertified), _count("threads", threads),
                           _count("layers", layers), mesher,
                           PAIRING_NUMBERS[GIVEN if given is not None else pairing], given,
                           *_proposal(hexes, method, len(points)),
                           not _flag("certify", certify), not _flag("core", core),
                           _flag("allow_topological", allow_topological), _pillow(pillow), float(budget),
                           _progress(progress)))


def _proposal(hexes, method, point_count):
    """(hexes, number of inner points, their places) for the core; None for what is not given."""
    if hexes is None:
        if method == "proposal":
            raise HexconError("method proposal needs hexes", ErrorCode.BAD_ARGUMENT)
        return None, 0, None
    _refuse_option("proposed hexes", method, lambda one: one.proposal)
    inner = None
    if isinstance(hexes, tuple):
        if len(hexes) != 2:
            raise _bad_option("hexes", hexes, "an array (H, 8), or (inner points, hexes)")
        inner, hexes = hexes
        inner = _plain(inner, "inner points")
        inner = _points(inner if inner.size else np.empty((0, 3)))
    hexes = _ids(hexes, 8, "hexes")
    return hexes, len(inner) if inner is not None else max(int(hexes.max(initial=-1)) + 1 - point_count, 0), inner


class _Mesher:
    """A tetrahedral mesher for the core: buffers in, bytes out."""

    def __init__(self, tetrahedralise):
        self.tetrahedralise = tetrahedralise

    def __call__(self, points, triangles):
        made = self.tetrahedralise(_array(points, np.float64, 3), _array(triangles, np.int32, 3))
        if made is None:
            return None
        if not isinstance(made, (tuple, list)) or len(made) != 2:
            raise _bad_option("what tetrahedralise returns", made, "None or (new points, tetrahedra)")
        new_points, tetrahedra = (_plain(rows, name) for rows, name in zip(made, ("new points", "tetrahedra")))
        return (_points(new_points if new_points.size else np.empty((0, 3))).tobytes(),
                _ids(tetrahedra if tetrahedra.size else np.empty((0, 4)), 4, "tetrahedra").tobytes())


def _refuse_option(option, method, takes_it):
    """An option that only some methods take."""
    if not takes_it(METHOD_TABLE[method]):
        takers = [name for name in methods_that(takes_it) if METHOD_TABLE[name].tries or METHOD_TABLE[name].topological]
        raise HexconError(f"{option}: only for method {', '.join(takers)}", ErrorCode.BAD_ARGUMENT)


def _pillow(pillow):
    """The option as the core has it."""
    if isinstance(pillow, str) and pillow in PILLOWS:
        return PILLOWS[pillow]
    if isinstance(pillow, str) or not 1 <= (sheets := _count("pillow", pillow)) <= MOST_PILLOWS:
        raise _bad_option("pillow", pillow, f"{', '.join(PILLOWS)}, or a number of sheets in 1 .. {MOST_PILLOWS}")
    return sheets


def check_options(method="auto", *, order=1, layers=0, threads=0, pairing="all", budget=0.0, core=True,
                  pillow="auto"):
    """Raise BAD_ARGUMENT for options that mesh would refuse: for callers with work to do before."""
    if not isinstance(method, str) or method not in METHODS:
        raise HexconError(f"there is no method {_shown(method)}; there are {', '.join(METHODS)}",
                          ErrorCode.BAD_ARGUMENT)
    _count("threads", threads)
    if _count("layers", layers):
        _refuse_option("boundary layers", method, lambda one: one.layers)
    if not _flag("core", core):
        _refuse_option("to refuse a core", method, lambda one: one.core)
    if _pillow(pillow) > 0:
        _refuse_option("a pillow", method, lambda one: one.pillow)
    if isinstance(pairing, str) and pairing not in PAIRINGS:
        raise HexconError(f"there is no pairing {_shown(pairing)}; there are {', '.join(PAIRINGS)}, or an "
                          "array of pairs", ErrorCode.BAD_ARGUMENT)
    if not (isinstance(pairing, str) and pairing == "all"):
        _refuse_option("a pairing", method, lambda one: one.pairing)
    _number("budget", budget, "a number of seconds")
    if _count("order", order) not in (1, 2):
        raise _bad_option("order", order, "1 or 2")


@_named_memory
def quality(points, hexes):
    """Scaled Jacobian of every hex. points (P, 3) float; hexes (H, 8) or (H, 20) int, VTK order.

    Of (H, 8) the least at the corners; of (H, 20) a proved bound from below on the whole element as it is curved, at most
    0.005 under its least value; positive only of hexes that are proved positive everywhere.
    Raises WRONG_SHAPE, WRONG_TYPE, EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE. Linear.
    """
    hexes = _hexes_of_any_order(hexes)
    return Quality(_array(_core.quality(_points(points), hexes, 2 if hexes.shape[1] == 20 else 1), np.float64))


@_named_memory
def certify(points, hexes, quads, *, progress=None):
    """Prove a hex mesh, or say what is wrong: see Certificate.

    points, hexes  as quality: hexes (H, 8), or (H, 20), judged as they are, curved or not
    quads          (n, 4): the surface, outward; of hexes (H, 20) also (n, 8), VTK_QUADRATIC_QUAD order: then the
                   middle nodes of the boundary must be these, too
    Raises as quality, and REPEATED_VERTEX (a hex with a corner twice), CANCELLED, OUT_OF_MEMORY.
    A mesh that fails raises nothing. Cost: linear in H; of (H, 20) some ten microseconds a hex, and a sort of the edges.
    Source: of (H, 20) Johnen, Remacle, Geuzaine, Geometrical validity of curvilinear finite elements (2013).
    """
    hexes, quads = _hexes_of_any_order(hexes), _plain(quads, "quads")
    middles = None
    if quads.ndim == 2 and quads.shape[1] == 8 and hexes.shape[1] == 20:
        middles = _ids(quads, 8, "quads")
        quads = middles[:, :4]
    order = 2 if hexes.shape[1] == 20 else 1
    facts = _core.certify(_points(points), hexes, _ids(quads, 4, "quads"), order, _progress(progress))
    if middles is not None and facts["boundary_exact"] and not _has_middles(hexes, middles):
        facts["boundary_exact"] = facts["certified"] = False
    return Certificate(facts)


_EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])


def _has_middles(hexes, quads):
    """Whether every edge of quads (n, 8) has the middle node that it has in some hex of (H, 20)."""
    def rows(ends, middles):
        return np.unique(np.column_stack([np.sort(ends.reshape(-1, 2), axis=1), middles.reshape(-1)]), axis=0)
    wanted = rows(np.stack([quads[:, :4], np.roll(quads[:, :4], -1, axis=1)], axis=-1), quads[:, 4:])
    there = rows(hexes[:, _EDGES], hexes[:, 8:])
    return len(np.unique(np.vstack([wanted, there]), axis=0)) == len(there)


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
    fixed = _plain(fixed, "fixed")
    if fixed.ndim != 1 or (fixed.dtype == bool and len(fixed) != point_count):
        raise HexconError(f"fixed must have shape ({point_count},), or be a list of ids, not {fixed.shape}",
                          ErrorCode.WRONG_SHAPE)
    if fixed.dtype == bool:
        return fixed.astype(np.uint8)
    ids = _ids(fixed.reshape(-1, 1), 1, "fixed").ravel()
    if len(ids) and ids.max() >= point_count:
        raise HexconError(f"fixed names points outside 0 .. {point_count - 1} (listed)",
                          ErrorCode.INDEX_OUT_OF_RANGE, ids[ids >= point_count][:1000])
    mask = np.zeros(point_count, np.uint8)
    mask[ids] = 1
    return mask


def _mesh(points, hexes):
    """A mesh of order 1 whose ids are valid; both are copies, as others may change theirs."""
    points, hexes = np.array(_points(points)), np.array(_ids(hexes, 8, "hexes"))
    outside = ((hexes < 0) | (hexes >= len(points))).any(axis=1)
    if outside.any():
        raise HexconError(f"{int(outside.sum())} hexes (listed) name points outside 0 .. "
                          f"{len(points) - 1}", ErrorCode.INDEX_OUT_OF_RANGE,
                          np.flatnonzero(outside)[:1000])
    return points, hexes


@contextlib.contextmanager
def _best_when_cancelled(points):
    """Hand out what has been reached with the error."""
    try:
        yield
    except HexconError as fault:
        if fault.code == ErrorCode.CANCELLED:
            fault.points = points
        raise


@_named_memory
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
        _core.optimize(points, hexes, mask, _count("rounds", rounds), _count("threads", threads),
                       _target(target), _count("mean_passes", mean_passes), _progress(progress))
    return points


class Repaired:
    """points (P, 3) float64 and hexes (H, 8) int32: the given ones in their order, then those of `pillows` sheets."""

    def __init__(self, points, hexes, pillows):
        self.points, self.hexes, self.pillows = _array(points, np.float64, 3), _array(hexes, np.int32, 8), pillows

    def __repr__(self):
        return f"<Repaired: {len(self.points)} points, {len(self.hexes)} hexes, {self.pillows} pillows>"


@_named_memory
def repair(points, hexes, fixed=None, *, pillow="auto", threads=0, progress=None):
    """Repair a hex mesh of order 1, with new hexes where moving points does not do.

    points, hexes  as quality
    fixed          as optimize
    pillow         "auto": where hexes are inverted or below 0.4 after optimize(mean_passes=2), as where one has two
                   faces of the boundary in one plane, a sheet of hexes is laid under the whole boundary, and all is
                   improved again; kept if fewer are inverted, or the worst scaled Jacobian is clearly higher (by 0.1
                   or a quarter), or no lower and the mean 0.05 higher. "never"; or so many sheets, 1 to 16, better
                   or not
    threads        0: one per processor; the result does not depend on it
    Returns a Repaired. The boundary's faces are those of the given mesh. Raises as optimize, TOO_LARGE; a cancelled
    call hands out nothing. Cost: as optimize, twice.
    """
    points, hexes = _mesh(points, hexes)
    mask = _fixed_mask(fixed, hexes, len(points))
    return Repaired(*_core.repair(points, hexes, mask, _pillow(pillow), _count("threads", threads), _progress(progress)))


@_named_memory
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
        reached = _core.morph(points, hexes, mask, goal, boundary_only, _target(target), _progress(progress))
    return points, reached


class _Projector:
    """Places on curves and surfaces for the core: buffers in, bytes out."""

    def __init__(self, project):
        self.project = project

    def __call__(self, points, tags):
        rows = len(tags) // np.dtype(np.int32).itemsize
        answer = self.project(_array(points, np.float64, 3), _array(tags, np.int32))
        if not isinstance(answer, (tuple, list)) or len(answer) != 2:
            raise _bad_option("what project returns", answer, "(places, directions)")
        places, directions = (_points(one) for one in answer)
        if len(places) != rows or len(directions) != rows:
            raise HexconError(f"project answers with {len(places)} places and {len(directions)} directions for "
                              f"{rows} points", ErrorCode.WRONG_SHAPE)
        return places.tobytes(), directions.tobytes()


def _sliding(carrier_of_point, carriers, project, facets, point_count):
    """What points slide on, for the core."""
    numbers = _plain(carrier_of_point, "carrier_of_point")
    if numbers.shape != (point_count,):
        raise HexconError(f"carrier_of_point must have shape ({point_count},), not {numbers.shape}",
                          ErrorCode.WRONG_SHAPE)
    if numbers.dtype.kind not in "iu" and numbers.size:
        raise HexconError(f"carrier_of_point must be integers, not {numbers.dtype}", ErrorCode.WRONG_TYPE)
    wide = (numbers < -2) | (numbers > _MOST)
    if wide.any():
        raise HexconError(f"{int(wide.sum())} points (listed) name carriers that do not exist",
                          ErrorCode.INDEX_OUT_OF_RANGE, np.flatnonzero(wide)[:1000])
    if project is not None and not callable(project):
        raise _bad_option("project", project, "a callable (points, tags) or None")
    starts, pieces = packed(carriers)
    return (np.ascontiguousarray(numbers, np.int32), starts, pieces,
            None if project is None else _Projector(project), packed_facets(facets, starts))


@_named_memory
def project_points(points, carrier_of_point, carriers, *, project=None, facets=None):
    """Put points on what they lie on: the nearest place on the nearest piece of their carrier.

    As relax; returns points (P, 3), and (P, 3) unit tangents of curves and normals of surfaces, 0 of points that lie
    on neither. Linear.
    """
    points = _points(points)
    placed, directions = _core.project_points(points, *_sliding(carrier_of_point, carriers, project, facets,
                                                                  len(points)))
    return _array(placed, np.float64, 3), _array(directions, np.float64, 3)


@_named_memory
def relax(points, hexes, carrier_of_point, carriers, *, project=None, facets=None, rounds=0, passes=0, mean_passes=0,
          threads=0, budget=0.0, progress=None):
    """Untangle and smooth a hex mesh of order 1 and its boundary together: points slide on what they lie on.

    points, hexes     as quality; hexes may have no volume at the start
    carrier_of_point  (P,) int: a row of carriers; -1: the point moves freely, -2: it stays
    carriers          what points slide on: each a Carrier, or a list of them, all curves or all surfaces, of which
                      the nearest counts, as the faces of a smooth patch
    project           callable (points (n, 3), tags (n,) int32) -> (places (n, 3), directions (n, 3)): the nearest
                      places on the carriers of kind "curve" and "surface" with these tags, and a tangent or normal
                      there, of any length but 0; called for many points at once, some 50 times
    facets            None, or Facets: triangles that tell where each piece of a carrier counts, as surfaces go on without
                      end; the nearest one's piece counts then. Carriers of kind "facets" are such triangles themselves,
                      curved by their normals
    rounds            of untangling and evening (0: 16)
    passes            after that, over what is inverted and over what can be better, as optimize makes them, while
                      points slide; those that project is asked for are held. 0: none, nor any for the mean
    mean_passes       as of optimize, after those
    threads           0: one per processor; the result does not depend on it
    budget            seconds, after which the best so far is returned; 0: no limit
    Returns (P, 3) float64, on the carriers as near as rounding allows, and never worse than the start put on them:
    fewer inverted corners, then (without mean_passes) a higher worst scaled Jacobian. The numbering of the mesh does not matter,
    as long as no two points lie in one place. Raises as optimize, WRONG_SHAPE, INDEX_OUT_OF_RANGE (elements:
    points whose carrier does not exist), BAD_ARGUMENT (elements: carriers), CANCELLED; the best points so far are then the
    error's `points`. Cost: linear in the hexes, some ten Newton steps.
    """
    points, hexes = _mesh(points, hexes)
    sliding = _sliding(carrier_of_point, carriers, project, facets, len(points))
    with _best_when_cancelled(points):
        _core.relax(points, hexes, *sliding, _count("rounds", rounds), _count("passes", passes),
                    _count("mean_passes", mean_passes), _count("threads", threads),
                    _number("budget", budget, "a number of seconds"), _progress(progress))
    return points


@_named_memory
def raise_order(points, hexes):
    """Put a point in the middle of every edge of a mesh of order 1.

    points, hexes  as quality, hexes (H, 8)
    Returns (points (P + E, 3), hexes (H, 20) int32): the given rows bit for bit, then the middles;
    VTK_QUADRATIC_HEXAHEDRON order. Raises as quality, OUT_OF_MEMORY. Linear.
    """
    raised, corners_and_middles = _core.raise_order(_points(points), _ids(hexes, 8, "hexes"))
    return _array(raised, np.float64, 3), _array(corners_and_middles, np.int32, 20)
