# SPDX-License-Identifier: LGPL-2.1-or-later
import enum
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import HexconError as HexconError

__version__: str

_Progress = Callable[[str, float], Any]

_Project = Callable[[NDArray[np.float64], NDArray[np.int32]], tuple[ArrayLike, ArrayLike]]

CARRIERS: dict[str, tuple[int, int, str]]
METHODS: dict[str, int]
TOPOLOGICAL_METHODS: frozenset[str]
PAIRINGS: dict[str, int]
PILLOWS: dict[str, int]
STAGES: dict[str, str]
HEX_STAGES: dict[str, str]
METHOD_TABLE: dict[str, Method]
METHOD_CHOICES: list[str]

class ErrorCode(enum.IntEnum):
    # made by scripts/make_docs.py: begin ErrorCode
    OUT_OF_MEMORY = 1
    CANCELLED = 2
    BAD_ARGUMENT = 3
    TOO_LARGE = 4
    WRONG_SHAPE = 5
    WRONG_TYPE = 6
    EMPTY = 7
    INDEX_OUT_OF_RANGE = 8
    REPEATED_VERTEX = 9
    NOT_FINITE = 10
    UNUSED_POINT = 11
    NOT_CLOSED = 12
    NON_MANIFOLD_EDGE = 13
    NON_MANIFOLD_VERTEX = 14
    NOT_ORIENTABLE = 15
    INCONSISTENT_ORIENTATION = 16
    SEVERAL_COMPONENTS = 17
    ODD = 18
    NOT_BIPARTITE = 19
    NO_PAIRING = 20
    BAD_PAIRING = 21
    SELF_CROSSING = 22
    NO_SIDES = 23
    NOT_A_BALL = 24
    UNFILLABLE_QUAD = 25
    NOT_STAR_SHAPED = 26
    NOT_SWEPT = 27
    NO_SHEETS = 28
    NOT_DICED = 29
    NOT_CERTIFIED = 30
    OUT_OF_TIME = 31
    NO_SMALL_FILLING = 32
    NO_ROTATIONS = 33
    NO_HEX_MESH = 34
    SELF_INTERSECTING = 35
    BAD_PROPOSAL = 36
    # end ErrorCode
    @property
    def meaning(self) -> str: ...
    @property
    def listed(self) -> str: ...
    @property
    def advice(self) -> str: ...

@dataclass(frozen=True)
class MethodTry:
    turn: int
    good_worst: float
    most_hexes: int
    no_core: bool

@dataclass(frozen=True)
class Method:
    number: int
    name: str
    label: str
    purpose: str
    told: str
    topological: bool
    layers: bool
    core: bool
    pairing: bool
    pillow: bool
    tetrahedralise: bool
    proposal: bool
    holes: bool
    cavities: bool
    odd_colours: bool
    odd_paths: bool
    hexes_a_quad: float | None
    tries: tuple[MethodTry, ...]

def methods_that(wanted: Callable[[Method], bool]) -> list[str]: ...

class Loops:
    lengths: NDArray[np.int64]
    self_crossings: NDArray[np.int64]
    def __len__(self) -> int: ...

class SurfaceReport:
    n: int
    points: int
    edges: int
    genus: int
    components: int
    cavities: int
    euler: int
    even: bool
    embedded: bool | None
    crossings: NDArray[np.int32]
    embedding_reason: str
    bipartite: bool
    fillable: bool | None
    oriented: bool
    convex: bool
    star_center: NDArray[np.float64] | None
    star_margin: float
    volume: float | None
    loops: Loops
    def as_dict(self) -> dict[str, Any]: ...

class Certificate:
    certified: bool
    conforming: bool
    proper: bool
    boundary_exact: bool
    embedded: bool | None
    crossings: NDArray[np.int32]
    embedding_reason: str
    euler: int
    undecided: int
    nonpositive: NDArray[np.int32]
    witnesses: NDArray[np.float64]
    doublets: NDArray[np.int32]
    improper: NDArray[np.int32]
    def as_dict(self) -> dict[str, Any]: ...

class Quality:
    scaled_jacobian: NDArray[np.float64]
    min: float
    mean: float
    q05: float
    def as_dict(self) -> dict[str, float]: ...

class Mesh:
    points: NDArray[np.float64]
    hexes: NDArray[np.int32]
    quads: NDArray[np.int32]
    order: int
    method: str
    topological: bool
    certificate: Certificate | None
    quality: Quality | None
    report: dict[str, Any]

class Repaired:
    points: NDArray[np.float64]
    hexes: NDArray[np.int32]
    pillows: int

class Carrier(NamedTuple):
    kind: str
    origin: tuple[float, float, float] = ...
    axis: tuple[float, float, float] = ...
    across: tuple[float, float, float] = ...
    sizes: tuple[float, ...] = ...
    tag: int = ...

class Facets(NamedTuple):
    points: Any
    triangles: Any
    carriers: Any
    pieces: Any
    normals: Any = ...

def check_surface(points: ArrayLike, quads: ArrayLike) -> SurfaceReport: ...
def orient(points: ArrayLike, quads: ArrayLike) -> tuple[NDArray[np.int32], int, int]: ...
def loops(quads: ArrayLike) -> list[NDArray[np.int32]]: ...
def colouring(quads: ArrayLike) -> NDArray[np.uint8]: ...
def pairing(quads: ArrayLike, points: ArrayLike | None = ..., *, fewest: bool = ...,
            progress: _Progress | None = ...) -> NDArray[np.int32]: ...
def mesh(points: ArrayLike, quads: ArrayLike, method: str = ..., *, order: int = ...,
         layers: int = ..., threads: int = ...,
         tetrahedralise: Callable[[NDArray[np.float64], NDArray[np.int32]],
                                  tuple[ArrayLike, ArrayLike] | None] | None = ...,
         hexes: ArrayLike | tuple[ArrayLike, ArrayLike] | None = ...,
         pairing: str | ArrayLike = ..., core: bool = ..., pillow: str | int = ..., budget: float = ...,
         progress: _Progress | None = ...,
         allow_uncertified: bool = ..., allow_topological: bool = ...,
         certify: bool = ...) -> Mesh: ...
def check_options(method: str = ..., *, order: int = ..., layers: int = ..., threads: int = ...,
                  pairing: str | ArrayLike = ..., budget: float = ..., core: bool = ...,
                  pillow: str | int = ...) -> None: ...
def quality(points: ArrayLike, hexes: ArrayLike) -> Quality: ...
def certify(points: ArrayLike, hexes: ArrayLike, quads: ArrayLike, *,
            progress: _Progress | None = ...) -> Certificate: ...
def optimize(points: ArrayLike, hexes: ArrayLike, fixed: ArrayLike | None = ..., *,
             rounds: int = ..., target: float = ..., mean_passes: int = ..., threads: int = ...,
             progress: _Progress | None = ...) -> NDArray[np.float64]: ...
def morph(points: ArrayLike, hexes: ArrayLike, goal: ArrayLike, fixed: ArrayLike | None = ..., *,
          target: float = ...,
          progress: _Progress | None = ...) -> tuple[NDArray[np.float64], float]: ...
def project_points(points: ArrayLike, carrier_of_point: ArrayLike,
                   carriers: Iterable[Carrier | Sequence[Carrier]], *,
                   project: _Project | None = ..., facets: Facets | None = ...) -> tuple[NDArray[np.float64],
                                                                                   NDArray[np.float64]]: ...
def relax(points: ArrayLike, hexes: ArrayLike, carrier_of_point: ArrayLike,
          carriers: Iterable[Carrier | Sequence[Carrier]], *, project: _Project | None = ...,
          facets: Facets | None = ..., rounds: int = ..., passes: int = ..., mean_passes: int = ..., threads: int = ..., budget: float = ...,
          progress: _Progress | None = ...) -> NDArray[np.float64]: ...
def repair(points: ArrayLike, hexes: ArrayLike, fixed: ArrayLike | None = ..., *,
           pillow: str | int = ..., threads: int = ..., progress: _Progress | None = ...) -> Repaired: ...
def raise_order(points: ArrayLike, hexes: ArrayLike) -> tuple[NDArray[np.float64],
                                                              NDArray[np.int32]]: ...
