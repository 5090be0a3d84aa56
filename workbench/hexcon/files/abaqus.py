# SPDX-License-Identifier: LGPL-2.1-or-later
""".inp: CalculiX and Abaqus mesh input. C3D8 and C3D20 have VTK's node order there.

C3D8I is never written: it fails the patch test on any hexahedron that is not a
parallelepiped (stress error 19 % at scaled Jacobian 0.66, measured with ccx 2.20).
"""
import re

import numpy as np

from hexcon.femmesh.element_types import default_type, element_type

from .text import write_list, write_numbered, write_rows

STEEL_YOUNG, STEEL_POISSON, STEEL_DENSITY = 210000, 0.3, 7.9e-9     # N, mm, MPa, tonne
STEEL = f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{STEEL_YOUNG}, {STEEL_POISSON}\n*DENSITY\n7.9e-9\n"


def _field(value):
    """A float in the at most 20 characters that ccx reads, exact where they suffice."""
    text = repr(value)
    if len(text) <= 20:
        return text
    return "%.13e" % value if abs(value) > 1e-99 else "0.0"


def write_mesh(stream, elements, element=None):
    """*NODE, *ELEMENT, one *NSET and one *SURFACE per CAD face and named group, one *NSET per group of nodes.

    element  see femmesh.element_types
    Names: NALL, EALL, FACE3_NODES, FACE3, and those of groups by deck_names. Node and element numbers are rows + 1. A
    comment says so where the mesh is topological.
    """
    kind = element_type(element, elements.order) or default_type(elements)
    if elements.topological:
        stream.write("** TOPOLOGICAL: topology only, some Jacobians are zero or negative; not for "
                     "solving\n")
    stream.write("*NODE, NSET=NALL\n")
    text = np.array([_field(x) for x in elements.points.ravel().tolist()], object)
    write_numbered(stream, "%d, %s, %s, %s\n", text.reshape(-1, 3))
    stream.write(f"*ELEMENT, TYPE={kind}, ELSET=EALL\n")
    # ccx takes at most 16 entries a line: a 20-node element needs two
    row = ("%d" + ", %d" * 8 if elements.order == 1
           else "%d" + ", %d" * 15 + ",\n" + ", ".join(["%d"] * 5)) + "\n"
    write_numbered(stream, row, elements.hexes + 1)
    names = deck_names([name for _, name, _ in elements.named()])
    for name, (_, _, rows) in zip(names, elements.named()):
        stream.write(f"*NSET, NSET={name}_NODES\n")
        write_list(stream, np.unique(elements.quads[rows]) + 1)
    taken = ["NALL", *(f"{name}_NODES" for name in names)]
    for name, nodes in zip(deck_names(elements.node_groups, taken), elements.node_groups):
        stream.write(f"*NSET, NSET={name}\n")
        write_list(stream, elements.nodes_of_set(nodes) + 1)
    for name, (_, _, rows) in zip(names, elements.named()):
        stream.write(f"*SURFACE, NAME={name}, TYPE=ELEMENT\n")
        write_rows(stream, "%d, S%d\n", np.column_stack(
            [elements.hex_of_quad[rows] + 1, elements.side_of_quad[rows] + 1]))


def deck_names(names, taken=()):
    """The names in a form that ccx and Abaqus take: a letter first, then letters, digits, _ and -, at most 70
    characters, different whatever their capitals. "Face3" becomes FACE3, as ever."""
    taken, made = {name.upper() for name in taken}, []
    for name in names:
        plain = name.upper() if re.fullmatch(r"Face\d+", name) else re.sub(r"[^A-Za-z0-9_-]", "_", name)
        plain = (plain if plain[:1].isalpha() else "G" + plain)[:70]
        number, one = 1, plain
        while one.upper() in taken:
            number += 1
            one = f"{plain}_{number}"
        taken.add(one.upper())
        made.append(one)
    return made


def write(path, elements, element=None):
    """The mesh with a default material (steel, N and mm): add a step and ccx runs it.

    element  C3D8, C3D8R, C3D20, C3D20R; None: see femmesh.element_types.default_type
    """
    names = deck_names([name for _, name, _ in elements.named()])
    with open(path, "w", encoding="ascii") as stream:
        stream.write("** Hex mesh by HexCon; CalculiX / Abaqus, lengths in mm\n")
        if names:
            stream.write("** node sets " + names[0] + "_NODES ..., surfaces "
                         + names[0] + " ... : one per CAD face or named group\n")
        write_mesh(stream, elements, element)
        stream.write("** Default material (steel; N, mm, MPa, tonne): replace as needed.\n")
        stream.write(STEEL + "*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL\n")
        stream.write(_advice(names))


def _advice(names):
    """How to go on, with sets that are there; nothing of sets where there are none."""
    if not names:
        return "** No faces are named in this mesh: sets for supports and loads are to be added.\n"
    return (f"** To solve, add for example:\n** *BOUNDARY\n** {names[0]}_NODES, 1, 3, 0\n** *STEP\n** *STATIC\n"
            f"** *DSLOAD\n** {names[min(1, len(names) - 1)]}, P, 1.0\n"
            "** *NODE FILE\n** U\n** *EL FILE\n** S\n** *END STEP\n")
