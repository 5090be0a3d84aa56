# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX: through FreeCAD's FEM (solve), or a bare deck (static_deck, solve_inp)."""
from .bare import InpResult, solve_inp
from .deck import static_deck
from .material import Material
from .result import Result
from .runner import find_ccx

__all__ = ["InpResult", "Material", "Result", "find_ccx", "solve", "solve_inp",
           "static_deck"]


def solve(*arguments, **options):
    """Solve through FreeCAD's FEM workbench; see analysis.solve."""
    from .analysis import solve as through_freecad
    return through_freecad(*arguments, **options)
