# SPDX-License-Identifier: LGPL-2.1-or-later
import enum
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import HexconError as HexconError

Progress = Callable[[str, float], Any]

METHODS: dict[str, int]
TOPOLOGICAL_METHODS: frozenset[str]
PAIRINGS: dict[str, int]

class ErrorCode(enum.IntEnum):
    OUT_OF_MEMORY: int
    CANCELLED: int
    BAD_ARGUMENT: int
    TOO_LARGE: int
    WRONG_SHAPE: int
    WRONG_TYPE: int
    EMPTY: int
    INDEX_OUT_OF_RANGE: int
    REPEATED_VERTEX: int
    NOT_FINITE: int
    UNUSED_POINT: int
    NOT_CLOSED: int
    NON_MANIFOLD_EDGE: int
    NON_MANIFOLD_VERTEX: int
    NOT_ORIENTABLE: int
    INCONSISTENT_ORIENTATION: int
    SEVERAL_COMPONENTS: int
    ODD: int
    NOT_BIPARTITE: int
    NO_PAIRING: int
    UNFILLABLE_QUAD: int
    NOT_STAR_SHAPED: int
    NOT_SWEPT: int
    NO_SHEETS: int
    NOT_CERTIFIED: int
    NO_SMALL_FILLING: int
    NO_HEX_MESH: int
    SELF_INTERSECTING: int

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
    volume: float
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

def check_surface(points: ArrayLike, quads: ArrayLike) -> SurfaceReport: ...
def loops(quads: ArrayLike) -> list[NDArray[np.int32]]: ...
def colouring(quads: ArrayLike) -> NDArray[np.uint8]: ...
def pairing(quads: ArrayLike, points: ArrayLike | None = ..., *, fewest: bool = ...,
            progress: Progress | None = ...) -> NDArray[np.int32]: ...
def mesh(points: ArrayLike, quads: ArrayLike, method: str = ..., *, order: int = ...,
         layers: int = ..., threads: int = ...,
         tetrahedralise: Callable[[NDArray[np.float64], NDArray[np.int32]],
                                  tuple[ArrayLike, ArrayLike] | None] | None = ...,
         pairing: str | ArrayLike = ..., core: bool = ..., budget: float = ...,
         progress: Progress | None = ...,
         allow_uncertified: bool = ..., allow_topological: bool = ...,
         certify: bool = ...) -> Mesh: ...
def check_options(method: str = ..., *, order: int = ..., layers: int = ..., threads: int = ...,
                  pairing: str | ArrayLike = ..., budget: float = ...) -> None: ...
def quality(points: ArrayLike, hexes: ArrayLike) -> Quality: ...
def certify(points: ArrayLike, hexes: ArrayLike, quads: ArrayLike, *,
            progress: Progress | None = ...) -> Certificate: ...
def optimize(points: ArrayLike, hexes: ArrayLike, fixed: ArrayLike | None = ..., *,
             rounds: int = ..., target: float = ..., threads: int = ...,
             progress: Progress | None = ...) -> NDArray[np.float64]: ...
def morph(points: ArrayLike, hexes: ArrayLike, goal: ArrayLike, fixed: ArrayLike | None = ..., *,
          target: float = ...,
          progress: Progress | None = ...) -> tuple[NDArray[np.float64], float]: ...
def raise_order(points: ArrayLike, hexes: ArrayLike) -> tuple[NDArray[np.float64],
                                                              NDArray[np.int32]]: ...
