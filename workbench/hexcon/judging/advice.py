# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would help where automatic choices have ended in poor hexes: to be told before anybody solves with them."""
from hexcon.translation import QT_TRANSLATE_NOOP, translate

# method: what its hexes are like; both fill what no method of natural hexes takes
POOR = {"diced": QT_TRANSLATE_NOOP(
            "HexCon", "these hexes are cut out of tetrahedra (method diced): valid, but crooked, and many for what "
            "they tell; automatic takes them where no method of natural hexes will do"),
        "cells": QT_TRANSLATE_NOOP(
            "HexCon", "these hexes are laid round every quad (method cells): valid, but small and very many; "
            "automatic takes them where nothing else will do")}


def of_poor_hexes(method, order, size=0.0):
    """Rows (heading, sentence) for a mesh by a method of hexcon_native, of order 1 or 2; none for natural hexes.

    size: what was asked for, mm; 0: not known
    """
    if method not in POOR:
        return []
    known = translate("HexCon", "another size: {size} mm lets small features be taken up")
    helps = [known.format(size=f"{size / 2:.3g}") if size else
             translate("HexCon", "another size: half of it lets small features be taken up"),
             translate("HexCon", "the part without, or split at, the features that the notes name (F1 tells how)")]
    if order == 1:
        helps.append(translate("HexCon", "order 2 (C3D20R): the same hexes bend, and most of the error goes"))
    return [(translate("HexCon", "Before you solve"), translate("HexCon", POOR[method])),
            (translate("HexCon", "What would help"), "; ".join(helps))]
