# SPDX-License-Identifier: LGPL-2.1-or-later
"""The core's tables: methods, pairings, stages and faults, as the C sources list them.

Nothing here types a name or a number again: command line, window, document objects and pages read these.
"""
import enum
from dataclasses import dataclass

from . import _core


@dataclass(frozen=True)
class MethodTry:
    """One try of method auto.

    turn        1 comes first
    good_worst  scaled Jacobian, or nearly what the surface allows, with which nothing after it is tried ..
    most_hexes  .. if the mesh has so many hexes a quad at most; 0: any number
    no_core     it is tried with core=False
    """

    turn: int
    good_worst: float
    most_hexes: int
    no_core: bool


@dataclass(frozen=True)
class Method:
    """What a method is for, what it takes, and what is to be expected of it.

    number          as the C API and saved macros have it
    name            as users write it
    label           in a list that people choose from
    purpose         one line, without its full stop
    told            how a mesh's report is told: see tell
    topological     its meshes are conforming, but some Jacobians are zero or negative: for no solver
    layers, core, pairing, pillow, tetrahedralise, proposal
                    it takes these options of mesh; a proposal is its `hexes`
    holes, cavities it fills such bodies
    odd_colours     it takes points that cannot be coloured black and white along edges
    odd_paths       it takes surfaces that bound no hex mesh, as it fills no body
    hexes_a_quad    to be expected for each quad; None: it depends on the volume, not the quads
    tries           MethodTry, those of auto
    """

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


def _method(row):
    tries = tuple(MethodTry(**one) for one in row["tries"] if one)
    return Method(**{**row, "tries": tries, "hexes_a_quad": row["hexes_a_quad"] or None})


class _Fault(enum.IntEnum):
    """One member per fault of the core, with .meaning, .listed (what a HexconError's elements are) and .advice."""

    @property
    def meaning(self):
        """One sentence, without its full stop."""
        return _STATUSES[self][1]

    @property
    def listed(self):
        """What the elements of the error are; "" where there are none."""
        return _STATUSES[self][2]

    @property
    def advice(self):
        """What the user can do."""
        return _STATUSES[self][3]


_STATUSES = _core.statuses()

ErrorCode = _Fault("ErrorCode", {row[0]: number for number, row in enumerate(_STATUSES) if number},
                   module="hexcon_native")
ErrorCode.__doc__ = _Fault.__doc__

METHOD_TABLE = {row["name"]: _method(row) for row in _core.methods()}
"""name: Method, in the order in which users are to see them."""

METHODS = {name: method.number for name, method in METHOD_TABLE.items()}

TOPOLOGICAL_METHODS = frozenset(name for name, method in METHOD_TABLE.items() if method.topological)
"""Methods whose meshes are conforming, but have Jacobians of zero or below: for no solver."""

GIVEN = "given"  # the pairing of those who hand over their own pairs
PAIRING_NUMBERS = {name: number for number, name in enumerate(_core.pairings())}
PAIRINGS = {name: number for name, number in PAIRING_NUMBERS.items() if name != GIVEN}

PILLOWS = {"auto": 0, "never": -1}
"""What the option pillow may be besides a number of sheets, by HEXCON_PILLOW_* in hexcon.h."""

MOST_PILLOWS = 16
"""HEXCON_PILLOW_MOST."""

STAGES = dict(_core.progress_stages())
"""name: words, of the stages that a progress callback is told of."""

HEX_STAGES = dict(_core.hex_stages())
"""name: words, of the stages that put hexes in: "hexes of NAME" in a mesh's report."""


CARRIERS = {name: (number, freedom, fields) for number, (name, freedom, fields) in enumerate(_core.carriers())}
"""kind: (number, in how many directions a point moves on it, what its fields are for), of what points slide on."""


def methods_that(wanted):
    """Names of the methods of which wanted(Method) holds, in the table's order."""
    return [name for name, method in METHOD_TABLE.items() if wanted(method)]


METHOD_CHOICES = methods_that(lambda method: method.name == "auto" or not method.proposal)
"""Methods that need nothing but a surface: those that people choose from."""
