# SPDX-License-Identifier: LGPL-2.1-or-later
"""A linear elastic material, from HexCon's or FreeCAD's way of writing it."""
import math
import re
from dataclasses import dataclass

from hexcon.errors import FaultCode, ToolError

_MPA = {"PA": 1e-6, "KPA": 1e-3, "MPA": 1.0, "GPA": 1e3, "N/MM^2": 1.0, "": 1.0}
_TONNE_PER_MM3 = {"KG/M^3": 1e-12, "G/CM^3": 1e-9, "KG/MM^3": 1e-3, "T/MM^3": 1.0, "": 1.0}


@dataclass(frozen=True)
class Material:
    """young in MPa, poisson without unit, density in tonne/mm^3 (N, mm, s)."""

    name: str = "Steel"
    young: float = 210000.0
    poisson: float = 0.3
    density: float = 7.9e-9

    def card(self):
        """FreeCAD's material dictionary."""
        return {"Name": self.name, "YoungsModulus": f"{self.young!r} MPa",
                "PoissonRatio": repr(self.poisson),
                "Density": f"{self.density * 1e12!r} kg/m^3"}


def _number(text, units, what):
    match = re.match(r"^\s*([-+0-9.eE]+)\s*(\S*)\s*$", str(text))
    if not match or match.group(2).upper() not in units:
        raise ToolError(f"material: {what} {text!r} is not a number with one of the units "
                        f"{', '.join(u for u in units if u)}", FaultCode.BAD_OPTION)
    return float(match.group(1)) * units[match.group(2).upper()]


def material_of(given):
    """Material of None (steel), a Material, or a dict.

    dict keys: name, young (MPa), poisson, density (tonne/mm^3), or FreeCAD's Name,
    YoungsModulus ("210 GPa"), PoissonRatio, Density ("7900 kg/m^3").
    Raises ToolError(BAD_OPTION) for missing or impossible values.
    """
    if given is None:
        return Material()
    if isinstance(given, Material):
        made = given
    else:
        young = given.get("young", given.get("YoungsModulus"))
        poisson = given.get("poisson", given.get("PoissonRatio"))
        if young is None or poisson is None:
            raise ToolError("material: Young's modulus and Poisson's ratio are both needed "
                            "(keys young and poisson, or YoungsModulus and PoissonRatio)",
                            FaultCode.BAD_OPTION)
        made = Material(
            str(given.get("name", given.get("Name", "Material"))),
            _number(young, _MPA, "Young's modulus"),
            _number(poisson, {"": 1.0}, "Poisson's ratio"),
            _number(given.get("density", given.get("Density", Material.density)),
                    _TONNE_PER_MM3, "density"))
    if not (math.isfinite(made.young) and made.young > 0 and -1 < made.poisson < 0.5):
        raise ToolError(f"material {made.name}: Young's modulus {made.young} MPa must be "
                        f"positive and Poisson's ratio {made.poisson} between -1 and 0.5",
                        FaultCode.BAD_OPTION)
    return made
