# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of the programs and files around the core."""
import enum

from hexcon_native.errors import HexconError


class FaultCode(enum.Enum):
    """One member per fault: the value is the word used in logs and in --json; .meaning, .listed (what a
    HexconError's elements are; "": nothing) and .advice are for people."""

    def __new__(cls, word, meaning, listed, advice):
        code = object.__new__(cls)
        code._value_ = word
        code.meaning, code.listed, code.advice = meaning, listed, advice
        return code

    TOOL_MISSING = ("tool missing", "gmsh, CalculiX or FreeCAD's command line program is not installed, or not found",
                    "", "install what the message names, or say where it is")
    TOOL_FAILED = ("tool failed", "a program ran and reported an error, or crashed", "CAD faces left without elements",
                   "read its last words in the message; another size or method may do")
    TOOL_TIMEOUT = ("tool timeout", "a program ran into its time limit", "", "allow more time, or take a larger size")
    NOT_SWEEPABLE = ("solid not sweepable", "surface method sweep was given a solid that is no sweep", "",
                     "take another surface method, or auto")
    NOT_BLOCKS = ("solid not made of blocks", "surface method blocks was given a solid with other than three edges "
                  "at a corner, or round elsewhere than it can be", "CAD faces at fault",
                  "take another surface method, or auto")
    NOT_REVOLVED = ("solid not revolved", "surface method revolved was given a solid that is no body of revolution "
                    "by a full turn", "CAD faces at fault", "take another surface method, or auto")
    NOT_LAYERED = ("solid not layered", "surface method layered found no direction in which every face lies across it, "
                   "along it, or is seen from it everywhere, or no good mesh along one", "CAD faces at fault",
                   "take another size, another surface method, or auto")
    NOT_BOXED = ("solid not boxed", "surface method boxed found no direction in which only round holes and bosses lie "
                 "across the layers, or no good mesh along one", "CAD faces at fault",
                 "take another size, another surface method, or auto")
    NOT_GRIDDED = ("solid not gridded", "surface method grid found no grid that takes up all of the solid's features "
                   "and is certified", "CAD faces at fault", "take a smaller size, as the message says, another "
                   "surface method, or auto")
    NOT_FILLED = ("no rooms filled", "surface method filled found no rooms round places where pipes or bores meet or "
                  "lie askew, or the solid beside them has no layers, or a room no certified hexes",
                  "CAD faces at fault",
                  "take another size, another surface method, or auto")
    NOT_TRANSFINITE = ("solid not transfinite", "a face does not have four sides", "CAD faces",
                       "take another surface method, or auto")
    NOT_ALL_QUAD = ("not all quads", "triangles are left in the surface", "",
                    "take another size, or a subdivided surface")
    ODD_SURFACE = ("odd surface", "the number of quads is odd whatever the size", "", "take a subdivided surface")
    OFF_CAD = ("points off the CAD surface", "points lie further than 1e-7 from their CAD faces", "points",
               "mend the solid's geometry, or take another size")
    NOT_ON_SOLID = ("mesh not on the solid", "points of a mesh's boundary do not lie on the solid that it is to be "
                    "smoothed on", "points", "give the solid that the mesh was made for, a larger tolerance, or keep "
                    "such points where they are")
    BAD_SHAPE = ("bad shape", "there is no solid, or there are several, or its geometry is invalid", "points or quads",
                 "give one valid, closed solid; Part, Check geometry tells what is wrong with it")
    BAD_OPTION = ("bad option", "an option is unknown or out of its range", "", "give what the message asks for")
    FILE_FORMAT = ("file format", "a file's ending is unknown, or its content is not what the ending says", "",
                   "give a file of the formats that the message lists, whole and undamaged")
    FILE_IO = ("file input/output", "a file is missing, or cannot be read or written", "",
               "check its name, the permissions and the room on the disk")
    FREECAD_MISSING = ("FreeCAD missing", "the call needs FreeCAD's Python modules", "",
                       "run it in FreeCAD or by freecadcmd, or give a STEP or BREP file")
    BAD_TRIANGLES = ("bad triangles", "triangles are not closed, not outward, or hold a point that is unused or not "
                     "finite", "triangles, or points", "give a closed, outward triangulation")
    TOPOLOGICAL_MESH = ("topological mesh", "a mesh of topology only was asked for where a solver would take it", "",
                        "take a method for solvers, or allow topological meshes to look at them")
    BAD_MESH = ("bad mesh", "what was given is no hex mesh: wrong shape, or ids out of range", "elements",
                "check what was read or selected")


class ToolError(HexconError):
    """A fault outside the core; `code` is a FaultCode."""
