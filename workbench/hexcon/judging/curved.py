# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved edges in words: which hexes of order 2 have some, and what became of a mesh's edges on its solid."""
import numpy as np

from hexcon.femmesh.second_order import curved_edges
from hexcon.translation import translate

MOST_LISTED = 10


def curved_hexes(points, hexes):
    """Rows of the hexes (H,8|20) with an edge that is not straight; none of order 1."""
    return np.flatnonzero(curved_edges(points, hexes).any(axis=1))


def of_curving(report):
    """Sentences about a mesh's report["curved"], see curving.curve; none of a mesh whose edges nobody curved."""
    if "straight edges" in report:
        return [report["straight edges"]]
    if "curved as given" in report:
        return [_as_given(report["curved as given"])]
    told = report.get("curved")
    if told is None:
        return []
    said = [translate("HexCon", "{edges} edges curved along edges of the solid, {faces} on its faces").format(
        edges=told["on_edges"], faces=told["on_faces"])]
    if told["inner"]:
        said.append(translate("HexCon", "{count} edges inside bend along, so that no hex folds").format(
            count=told["inner"]))
    if told["moved"]:
        said.append(translate("HexCon", "{count} corners inside moved, so that no hex folds").format(
            count=told["moved"]))
    if told["straight"]:
        said.append(translate("HexCon", "{count} edges of the boundary found no place on the solid: they are "
                              "straight").format(count=told["straight"]))
    if told["reduced_count"]:
        said.append(translate("HexCon", "{count} hexes would fold or cross, and keep part of their curvature: "
                              "{hexes}").format(
            count=told["reduced_count"], hexes=_parts(told["reduced"], told["reduced_count"])))
    said.append(translate("HexCon", "volume {volume:+.2g} of the solid's, area {area:+.2g}; curved faces at most "
                          "{chord:.3g} off it").format(volume=told["volume"] / told["cad_volume"] - 1,
                                                       area=told["area"] / told["cad_area"] - 1, chord=told["chord"]))
    return said


def _as_given(told):
    said = translate("HexCon", "{edges} edges curved as the surface's 8-node quads are").format(edges=told["edges"])
    if told["reduced"]:
        said += translate("HexCon", "; {count} hexes would fold, and keep part of their curvature").format(
            count=told["reduced"])
    return said


def _parts(reduced, count):
    """The first of them: hex 12 to 0.81."""
    shown = ", ".join(translate("HexCon", "hex {number} to {part:.2f}").format(number=number, part=part)
                      for number, part in list(reduced.items())[:MOST_LISTED])
    return shown + (" ..." if count > MOST_LISTED else "")
