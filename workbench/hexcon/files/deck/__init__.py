# SPDX-License-Identifier: LGPL-2.1-or-later
"""Abaqus and CalculiX decks, read by ourselves: the one reader for all commands.

meshio knows one *NODE block, no parts, no generation, no 8-node shells; gmsh reads no .inp; FreeCAD takes what it
itself writes. All of them leave out in silence what they do not understand.
"""
from .model import read_deck

__all__ = ["read_deck"]
