# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one table of surface methods: how a solid's surface is meshed with quads.

Read by the worker, which makes the quads, and by all that names or offers methods: so nothing is imported here.
"""
from dataclasses import dataclass

VOLUME_ERROR = 0.01     # part of the volume that chords may cut, where nothing else is said


@dataclass(frozen=True)
class SurfaceMethod:
    """What a surface method is for, who does it, and what to expect of its quads.

    name          as users write it; saved documents hold it
    label         in a list that people choose from
    purpose       one line, without its full stop
    maker         "module.function" of this package, called with solid, size, link and what `takes` names
    takes         further arguments of the maker: "method", "care", "timeout"; "sizes": it follows local sizes
    turn          when auto tries it, from 1 on; 0: never
    refusal       code of the WorkerFault with which auto goes on to the next; "": any
    refused       how auto tells of that
    natural       its hexes are natural ones
    cavities      it meshes solids with cavities
    leaves_out    edges much shorter than the size can be taken as points before
    spares_volume  it takes smaller elements on round faces, by itself, where chords would cut 1 % of the volume
    filled_by     the method of hexes that such quads are made for; "": none in particular
    hexes_a_quad  to be expected for each quad then; None: it depends on the volume, not the quads
    diced_first   auto dices large surfaces of it before anything else: no method makes fewer hexes of them
    """

    name: str
    label: str
    purpose: str
    maker: str = ""
    takes: tuple = ()
    turn: int = 0
    refusal: str = ""
    refused: str = ""
    natural: bool = False
    cavities: bool = True
    leaves_out: bool = False
    spares_volume: bool = False
    filled_by: str = ""
    hexes_a_quad: "float | None" = None
    diced_first: bool = False


_ROWS = (
    SurfaceMethod("auto", "automatic", "the first of the others that can be, in the order of what hexes they lead to",
                  hexes_a_quad=3),
    SurfaceMethod("sweep", "sweep", "solids that go from one cap to another: prisms, pipes, frusta, wedges, bent bars",
                  "sweep.sweep_surface", ("sizes",), turn=1, refusal="NOT_SWEEPABLE", refused="not swept", natural=True,
                  cavities=False, leaves_out=True, filled_by="swept"),
    SurfaceMethod("blocks", "blocks", "round solids, and those with three edges at each corner: quads of a few blocks "
                  "of hexes", "blocks.blocks_surface", turn=2, refusal="NOT_BLOCKS", refused="not of blocks",
                  natural=True, cavities=False, leaves_out=True, filled_by="sheets"),
    SurfaceMethod("revolved", "revolved", "turned parts: bodies of revolution by a full turn, with any profile",
                  "revolved.surface.revolved_surface", ("sizes",), turn=3, refusal="NOT_REVOLVED", refused="not revolved",
                  natural=True, filled_by="proposal"),
    SurfaceMethod("layered", "layers", "solids whose faces lie across one direction or along it, or are seen from it: "
                  "plates with bosses, pockets, steps, holes", "layered.tries.layered_surface", ("timeout", "care", "sizes"),
                  turn=4, refusal="NOT_LAYERED", refused="not layered", natural=True, leaves_out=True, spares_volume=True,
                  filled_by="proposal"),
    SurfaceMethod("boxed", "layers and boxes", "solids of layers but for round holes and bosses across them, each in a box "
                  "with layers of its own", "boxed.tries.boxed_surface", ("timeout", "care"), turn=5,
                  refusal="NOT_BOXED", refused="not boxed", natural=True, spares_volume=True, filled_by="proposal"),
    SurfaceMethod("grid", "grid", "any solid whose features are not much smaller than the elements: a grid of hexes that "
                  "takes them up", "grid.tries.grid_surface", ("timeout", "care", "sizes"), turn=6, refused="not gridded",
                  natural=True, leaves_out=True, spares_volume=True, filled_by="proposal"),
    SurfaceMethod("filled", "layers and filler", "solids of layers and boxes but for rooms, where pipes or bores meet or lie "
                  "askew, which the constrained methods fill", "filler.tries.filled_surface", ("timeout", "care"), turn=7,
                  refusal="NOT_FILLED", refused="no rooms filled", filled_by="proposal"),
    # Hexes inside: 3 a quad on triangles, 10 to 22, and worse ones, where there are coarse quads.
    SurfaceMethod("subdivided", "subdivided quads", "any solid: gmsh's quads and triangles, each cut about its middle",
                  "whole.whole_surface", ("method", "sizes"), turn=9, leaves_out=True, filled_by="diced", hexes_a_quad=10),
    SurfaceMethod("subdivided-triangles", "subdivided triangles",
                  "any solid: gmsh's triangles, each cut into three quads", "triangles.triangle_surface", ("care", "sizes"),
                  turn=8, refused="no subdivided triangles", leaves_out=True, filled_by="diced", hexes_a_quad=3,
                  diced_first=True),
    SurfaceMethod("blossom", "blossom", "any solid, by luck: gmsh's triangles, paired to quads; few and even ones",
                  "whole.whole_surface", ("method", "sizes"), filled_by="shelling", hexes_a_quad=4),
    SurfaceMethod("transfinite", "transfinite", "solids whose faces all have four sides: grids",
                  "whole.whole_surface", ("method",), filled_by="sheets"),
)

METHOD_TABLE = {row.name: row for row in _ROWS}
"""name: SurfaceMethod, in the order in which users are to see them."""

METHODS = tuple(METHOD_TABLE)


def tried_by_auto():
    """The rows that auto tries, in their order."""
    return sorted((row for row in _ROWS if row.turn), key=lambda row: row.turn)
