# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is read of each format, by whom, what is written, and what is lost on the way: one row a format, for people.

READERS and WRITERS dispatch; docs/files.md is made from this, and a test holds the three together.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Format:
    """endings: of files, small letters;  read, written, lost: Markdown, "" for nothing;  reader: who reads it."""

    name: str
    endings: tuple
    reader: str
    read: str
    written: str
    lost: str


FORMATS = (
    Format("Abaqus, CalculiX", (".inp",), "HexCon",
           "nodes and elements in any number of blocks, parts and instances at their places, includes, "
           "generated nodes and elements, systems; all shells, membranes and plane elements of 4, 8, 9 "
           "nodes, all hexes of 8, 20, 27 nodes; node and element sets, surfaces",
           "hexes, a node set and a surface for each CAD face and group, node sets, a material",
           "materials, steps and sections; characters in names that ccx does not take; digits beyond 14"),
    Format("Gmsh", (".msh",), "gmsh",
           "versions 1 to 4.1, ASCII and binary, partitions, parametric nodes, physical groups of "
           "points, surfaces and volumes",
           "2.2, binary: physical groups; quads in several are there once for each",
           "entities, periodicity; elements of third order are refused"),
    Format("VTK", (".vtk", ".vtu",), "VTK, then meshio",
           "unstructured and structured grids, images, polygons of four, pixels and voxels; arrays of 0 "
           "and 1, or of whole numbers on quads, as groups",
           "hexes; groups and CAD faces as arrays on the sides of hexes (H,6), node groups as arrays of "
           "0 and 1",
           "other data; what is no cell of a surface or volume. Gmsh 4.15 opens no binary `.vtk`, its own "
           "neither: take `.msh` for it. ParaView 6.1 and PyVista 0.48 open both orders, but VTK 9.6 gives a "
           "twelfth of the volume of quadratic hexes, of its own too"),
    Format("VTK XML, others", (".vtp", ".vts", ".vtr", ".vti",), "VTK",
           "as .vtu",
           "",
           "as .vtu"),
    Format("I-DEAS universal", (".unv",), "HexCon",
           "datasets 15, 781, 2411; 780, 2412; coordinate systems 2420; units 164, converted to mm; "
           "groups 2417 to 2477 of nodes and elements; 27-node hexes as gmsh writes them",
           "nodes, hexes, boundary quads, groups",
           "materials and results; metres that SMESH writes whatever the unit"),
    Format("MED (Salome)", (".med",), "FreeCAD (SMESH)",
           "the first mesh, its quads or volumes, groups",
           "through FreeCAD: hexes, boundary quads, groups",
           "fields; names of families"),
    Format("FreeCAD document", (".fcstd",), "FreeCAD",
           "solids at their places (see [the command line](command-line.md)), or the one FEM mesh with "
           "its groups",
           "the mesh object with groups, and its solid",
           "analyses"),
    Format("Wavefront", (".obj",), "HexCon",
           "quads with textures, normals, colours, weights, indices from either end, continued lines; "
           "groups, and objects and materials where there are several",
           "surfaces only: points and quads",
           "textures, normals, colours; n-gons are refused with their line"),
    Format("Medit", (".mesh",), "HexCon",
           "ASCII of any version and layout; references of quads as groups",
           "surfaces only",
           "ridges, required entities; binary is refused"),
    Format("Nastran", (".bdf", ".nas",), "HexCon",
           "GRID in the basic system, CQUAD4, CQUAD8, CQUADR, CHEXA of 8 and 20 nodes, and of 27 as gmsh writes "
           "them, free, small and long fields, includes; properties of quads as groups",
           "",
           "loads, materials; other coordinate systems are refused"),
    Format("Exodus II", (".exo", ".e", ".ex2",), "VTK",
           "element blocks, side sets, node sets",
           "block of hexes, side sets of CAD faces and groups, node sets",
           "variables; names beyond 32 characters"),
    Format("CGNS", (".cgns",), "VTK",
           "unstructured and structured zones; files of gmsh by VTK 9.6 (9.1 finds no elements in them: refused)",
           "",
           "boundary conditions, flow data; zones are not merged (`hexcon repair --merge-tolerance` does)"),
    Format("Stanford", (".ply",), "VTK",
           "quads",
           "",
           "colours, normals"),
    Format("Object file format", (".off",), "HexCon",
           "quads",
           "",
           "colours, normals"),
    Format("Stereolithography", (".stl",), "-",
           "refused: it holds triangles only",
           "",
           ""),
    Format("Nek5000", (".re2",), "",
           "",
           "hexes, curved edges, the number of the first group of each boundary face",
           "names of groups, overlaps between groups, node groups"),
    Format("SPECFEM3D", (".specfem3d",), "",
           "",
           "a folder; a file of faces for each CAD face and group",
           "node groups"))
