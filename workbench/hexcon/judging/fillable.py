# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether hexes can fill a surface, in the one sentence that everybody says."""
from hexcon.translation import translate


def fillable(quads, can_be, embedded):
    """The sentence about a surface of so many quads.

    can_be    SurfaceReport.fillable: True, False, or None, where it is not known
    embedded  SurfaceReport.embedded: a surface that crosses itself bounds nothing that could be filled
    """
    if quads % 2:
        return translate("HexCon", "an odd number: no hex mesh has such a boundary")
    if can_be is False:
        return translate("HexCon", "an even number, but a closed path of edges that bounds a surface inside is odd: "
                         "no hex mesh has such a boundary")
    if not embedded:
        return translate("HexCon", "an even number, but the surface is not known to bound a solid")
    if can_be is None:
        return translate("HexCon", "an even number; whether hexes can fill it is not known")
    return translate("HexCon", "an even number: hexes can fill it")
