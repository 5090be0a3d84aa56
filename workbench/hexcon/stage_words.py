# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the stages of work are called: those of the core's tables, and those of the programs around it."""
import re

import hexcon_native

ALL = "all hexes"  # the one stage of hexes of a method that tells none apart

# Told by gmsh's workers, CalculiX and this package.
AROUND = {
    "start": "Surface: starting gmsh",
    "load": "Surface: reading the solid",
    "cap": "Surface: quads of the cap",
    "walls": "Surface: quads of the walls",
    "faces": "Surface: quads of the blocks' faces",
    "mesh": "Surface: quads by gmsh",
    "section": "Turned part: quads of half a section",
    "turn": "Turned part: turning the section",
    "levels": "Layers: the solid's outlines and levels",
    "features": "Grid: the solid's faces, edges and corners",
    "cells": "Grid: which cells are inside",
    "capture": "Grid: taking up edges and corners",
    "sheets": "Grid: putting layers in",
    "curve": "Curved edges: places on the solid",
    "unfold": "Curved edges: bending what would fold",
    "fit": "Curved edges: volume, area and distance from the solid",
    "slide": "Moving all points, which slide on the solid",
    "landing": "Smoothing: where the mesh lies on the solid",
    "check": "Surface: distance from the solid",
    "read": "Reading the file",
    "relax": "Hexes: evening out the tetrahedra inside",
    "CalculiX": "CalculiX solves",
}

STAGES = {**AROUND, **hexcon_native.STAGES}
"""name: words, of all stages that a progress callback may be told of."""

# Of surface methods that propose hexes; several are numbered.
PIECES = {"layers round the boxes": "layers round the boxes", "box": "box"}

HEX_STAGES = {**hexcon_native.HEX_STAGES, **PIECES, ALL: "all hexes"}
"""name: words, of the stages that put hexes in."""

FIGURES = ("{inverted} of {hexes} hexes inverted", "{hexes} hexes", "{hexes} hexes, worst scaled Jacobian {worst}")
"""What the core tells behind a stage and ", ": see context_tell_mesh."""

_NUMBERED = re.compile(r"(.+) (\d+)")


def figures_of(told):
    """(one of FIGURES, {name: text}) of what is told behind a stage; (told, {}) for what is none of them."""
    for template in FIGURES:
        found = re.fullmatch(re.sub(r"{(\w+)}", r"(?P<\1>[-+.\\w]+)", template), told)
        if found:
            return template, found.groupdict()
    return told, {}


def hex_stage(name):
    """(name in HEX_STAGES, number or None) of a stage in a report: "split layer 2" is ("split layer", "2")."""
    numbered = _NUMBERED.fullmatch(name)
    return (numbered[1], numbered[2]) if numbered and numbered[1] in HEX_STAGES else (name, None)
