# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the command line."""
import argparse
import math

import hexcon_native

from .. import pillows
from ..examples import example_names
from ..femmesh.element_types import ELEMENT_TYPES, element_type
from ..files import READERS, SOLVER_ENDINGS, WRITERS, shown
from ..files.lengths import UNITS
from ..files.surfaces import SURFACE_ENDINGS
from ..quads import METHOD_TABLE as SURFACE_METHOD_TABLE
from ..quads.files import MESH_ENDINGS
from ..quads.local_sizes import WAYS
from . import commands, examples
from .terminal import Parser

PAIRINGS = tuple(hexcon_native.PAIRINGS)
CHOSEN = {name: hexcon_native.METHOD_TABLE[name] for name in hexcon_native.METHOD_CHOICES}


def methods_help(table):
    """What the methods of a table are for, for the help of an option."""
    return "; ".join(f"{name}: {row.purpose}" for name, row in table.items()).replace("%", "%%")


_EXIT = ("exit status: 0 done; 1 a fault, its words on standard error; 2 wrong usage; 3 check, repair, smooth: not "
         "certified; 129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM: no file is half written; 141 nobody read the "
         "answer to its end")


def _face_vector(text):
    """Face2=0,0,-100 -> ("Face2", (0, 0, -100))"""
    try:
        face, _, values = text.rpartition("=")
        vector = tuple(float(v) for v in values.split(","))
        if not face or len(vector) != 3 or not all(map(math.isfinite, vector)):
            raise ValueError
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r}: write NAME=fx,fy,fz") from None
    return face, vector


def _face_value(text):
    """Face2=1.5 -> ("Face2", 1.5)"""
    try:
        face, _, value = text.rpartition("=")
        if not face or not math.isfinite(float(value)):
            raise ValueError
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r}: write NAME=MPa") from None
    return face, float(value)


def _add_solid_choice(command):
    command.add_argument("--object", dest="object_name", metavar="NAME",
                         help="of a document with several solids: the object (name or label) that holds the one meant")
    command.add_argument("--solid", dest="solid_number", type=int, metavar="N",
                         help="of several solids: which, as the refusal numbers them (1, 2, ...)")


def _length(text):
    """A number above zero."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is no number above zero")
    return value


def _add_lengths(command, merging=True):
    command.add_argument("--unit", choices=list(UNITS), help="what lengths of IN are in (default: what it says, else "
                                                             "mm)")
    command.add_argument("--scale", type=_length, default=1.0, metavar="F", help="what lengths of IN are multiplied by")
    if merging:
        command.add_argument("--merge-tolerance", type=_length, metavar="T",
                             help="points nearer than T mm become one (default: where a surface is open, 1e-7 of its "
                                  "diagonal)")


def _add_meshing(command):
    _add_solid_choice(command)
    command.add_argument("--size", type=float, metavar="H",
                         help="wanted edge length in mm; needed for solids")
    add_surface(command)
    _add_filling(command)


def add_surface(command):
    """Options of how a solid's surface is meshed with quads, and where with smaller ones; the batch has them too."""
    command.add_argument("--surface-method", choices=list(SURFACE_METHOD_TABLE), default="auto",
                         help=f"how a solid's surface is meshed with quads. {methods_help(SURFACE_METHOD_TABLE)}")
    command.add_argument("--local-size", action="append", default=[], dest="local_sizes", metavar="WHERE=H",
                         help=f"a smaller edge length at a place; may be given several times. WHERE: {WAYS}")
    command.add_argument("--per-turn", type=int, default=0, metavar="N",
                         help="so many quads, about, round a full turn of round faces (default: as many as come by "
                              "the size)")
    command.add_argument("--volume-error", type=float, default=0.0, metavar="P",
                         help="percent of the volume that chords of round faces may cut: more quads are taken there "
                              "(default: 1 in a grid; elsewhere a note tells of more)")


def add_hexes(command, method="auto"):
    """Options of how a surface is filled with hexes; method: the default. The batch has them too."""
    command.add_argument("--method", choices=hexcon_native.METHOD_CHOICES, default=method,
                         help=f"how the surface is filled with hexes. {methods_help(CHOSEN)}")
    command.add_argument("--layers", type=int, default=0, metavar="K",
                         help="at least K layers of plain hexes under the surface, for methods "
                              f"{', '.join(hexcon_native.methods_that(lambda method: method.layers))}")
    command.add_argument("--pillow", type=pillows.pillow_of, default="auto", metavar="auto|never|K", help=pillows.HELP)
    command.add_argument("--pairing", choices=PAIRINGS, default=PAIRINGS[0],
                         help="topological methods: pair all quads, as few as will do, or none (default all)")
    command.add_argument("--order", type=int, choices=(1, 2),
                         help="2: mid-edge nodes, on the solid (default 1, or that of --element-type)")
    command.add_argument("--element-type", choices=list(ELEMENT_TYPES),
                         help="what .inp and solve get (default C3D8; of order 2 C3D20R, but C3D20 where hexes "
                              "stand in single rows); R: reduced integration")


def _add_filling(command, method="auto"):
    """Options of the hexes, and of the work on them; method: the default."""
    add_hexes(command, method)
    command.add_argument("--allow-uncertified", action="store_true",
                         help="write the best mesh found even if its certificate fails")
    command.add_argument("--allow-topological", action="store_true",
                         help="give a mesh of topology only to a solver all the same: "
                              f"{', '.join(shown(SOLVER_ENDINGS))}, solve")
    command.add_argument("--timeout", type=float, default=120.0, metavar="S",
                         help="seconds for gmsh (default 120)")
    command.add_argument("--budget", type=float, default=0.0, metavar="S",
                         help="seconds for filling: the best mesh until then is taken (default: no "
                              "limit)")


def settle_order(options):
    """Fill in options.order where it was left to the element type; nothing of commands without them.

    Raises ToolError BAD_OPTION where they differ."""
    if "element_type" not in options:
        return
    wanted = options.element_type and ELEMENT_TYPES[options.element_type]
    if options.order is None:
        options.order = wanted or 1
    element_type(options.element_type, options.order)


def _add_mesh(commands_parser):
    command = commands_parser.add_parser(
        "mesh", help="fill a solid or a quad surface with hexes", epilog=_EXIT,
        description=f"IN is a solid ({' '.join(shown(commands.SOLID_ENDINGS))}), a quad surface "
                    f"({' '.join(MESH_ENDINGS)}) or example:NAME (see hexcon example). OUT's ending decides its "
                    f"format: {' '.join(shown(WRITERS))} (.med and .FCStd through FreeCAD; .specfem3d is a folder).")
    command.add_argument("input", metavar="IN")
    command.add_argument("-o", "--output", metavar="OUT", action="append", required=True,
                         help="may be given several times")
    _add_meshing(command)
    _add_lengths(command)
    command.set_defaults(run=commands.mesh)


def _add_check(commands_parser):
    command = commands_parser.add_parser(
        "check", help="prove a hex mesh, or say what is wrong with it", epilog=_EXIT,
        description=f"MESH is any hex mesh ({' '.join(shown(READERS))}).")
    command.add_argument("input", metavar="MESH")
    command.add_argument("--surface", metavar="QUADS",
                         help="the quad surface that the boundary must equal (default: the mesh's "
                              "own outer faces)")
    _add_lengths(command)
    command.set_defaults(run=commands.check)


def _add_repair(commands_parser):
    command = commands_parser.add_parser(
        "repair", help="untangle and improve a hex mesh, with new hexes where moving points does not do", epilog=_EXIT,
        description=f"MESH is any hex mesh ({' '.join(shown(READERS))}), OUT as of hexcon mesh. The boundary stays "
                    "as it is. The exit status is that of a check of OUT.")
    command.add_argument("input", metavar="MESH")
    command.add_argument("-o", "--output", metavar="OUT", action="append", required=True,
                         help="may be given several times")
    command.add_argument("--pillow", type=pillows.pillow_of, default="auto", metavar="auto|never|K", help=pillows.HELP)
    _add_lengths(command)
    command.set_defaults(run=commands.repair)


def _add_smooth(commands_parser):
    command = commands_parser.add_parser(
        "smooth", help="smooth a hex mesh on its solid: points slide on faces and edges", epilog=_EXIT,
        description=f"MESH is any hex mesh ({' '.join(shown(READERS))}) of SOLID "
                    f"({' '.join(shown(commands.SOLID_ENDINGS))}). The mesh that is written is never worse than the "
                    "one given.")
    command.add_argument("input", metavar="MESH")
    command.add_argument("solid", metavar="SOLID")
    command.add_argument("-o", "--output", metavar="OUT", action="append", default=[],
                         help="may be given several times; without it: only what could be had is told")
    command.add_argument("--tolerance", type=float, default=0.0, metavar="T",
                         help="how far a point of the boundary may be off the solid (default: 1/100 of the edges "
                              "about it)")
    _add_solid_choice(command)
    command.add_argument("--keep", action="store_true",
                         help="keep boundary points that lie on nothing where they are; without it the mesh is refused")
    command.add_argument("--timeout", type=float, default=120.0, metavar="S",
                         help="seconds for finding the boundary on the solid and relaxing (default 120)")
    _add_lengths(command, merging=False)
    command.set_defaults(run=commands.smooth)


def _add_info(commands_parser):
    command = commands_parser.add_parser("info", help="facts of a quad surface", epilog=_EXIT)
    command.add_argument("input", metavar="SURFACE", help="a file, or example:NAME")
    _add_lengths(command)
    command.set_defaults(run=commands.info)


def _add_example(commands_parser):
    command = commands_parser.add_parser(
        "example", help="list, write, fill or draw a surface of the literature", epilog=_EXIT,
        description=f"Without NAME: the list. NAME is one of {', '.join(example_names())}. OUT is a surface "
                    f"({' '.join(SURFACE_ENDINGS)}) or, with --method, a hex mesh, as of hexcon mesh.")
    command.add_argument("name", metavar="NAME", nargs="?")
    command.add_argument("-o", "--output", metavar="OUT", action="append", default=[],
                         help="may be given several times")
    command.add_argument("--gallery", metavar="FOLDER",
                         help="draw the surface with its loops, the pairs and, with --method, every stage of the "
                              "hexes: numbered .png files in that folder")
    _add_filling(command, method=None)
    command.set_defaults(run=examples.example, input="")  # no input file


def _add_solve(commands_parser):
    command = commands_parser.add_parser(
        "solve", help="linear static analysis in CalculiX", epilog=_EXIT,
        description="IN is a hex mesh that `hexcon mesh` wrote, with its CAD faces, or a solid, "
                    "which is meshed first. Units: N, mm, MPa.")
    command.add_argument("input", metavar="IN")
    command.add_argument("-o", "--output", metavar="OUT",
                         help="results: .vtu or .vtk, and .png for a picture", action="append",
                         default=[])
    _add_meshing(command)
    command.add_argument("--fixed", metavar="NAME", action="append", required=True,
                         help="a CAD face (Face3), or a group of the mesh by its name: held")
    command.add_argument("--force", metavar="NAME=fx,fy,fz", action="append", default=[],
                         type=_face_vector, help="total force on the face, N")
    command.add_argument("--pressure", metavar="NAME=p", action="append", default=[],
                         type=_face_value, help="MPa, positive onto the face")
    command.add_argument("--young", type=float, default=210000.0, help="MPa (default 210000)")
    command.add_argument("--poisson", type=float, default=0.3, help="(default 0.3)")
    command.add_argument("--ccx-timeout", type=float, default=3600.0, metavar="S")
    _add_lengths(command, merging=False)
    command.set_defaults(run=commands.solve)


def parse(arguments=None):
    """Parsed options; .run is the command's function, .command its name."""
    parser = Parser(
        prog="hexcon", epilog=_EXIT,
        description="Hexahedral meshes whose boundary is exactly a given quad surface.")
    commands_parser = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for add in (_add_mesh, _add_check, _add_repair, _add_smooth, _add_info, _add_example, _add_solve):
        add(commands_parser)
    for command in commands_parser.choices.values():
        command.add_argument("--json", action="store_true", help="one JSON object for machines")
    return parser.parse_args(arguments)
