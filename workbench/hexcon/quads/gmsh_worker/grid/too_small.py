# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which features of a solid are much smaller than its elements, and the size that would do for them."""
import numpy as np

ENOUGH = 0.25       # of the size: what is smaller often finds no elements of its own
MOST = 5            # that are named


def too_small(features, h):
    """(words, CAD faces) of short curves and narrow patches, smallest first; ("", []) where there are none."""
    found = details(features, ENOUGH * h)
    if not found:
        return "", []
    return f"small for this size: {named(found)}; a size of {found[0][0] / ENOUGH:.3g} would hold them all", \
        sorted(set().union(*(one[2] for one in found[:MOST])))


def named(found):
    """Some of `details` in words."""
    return ", ".join(one[1] for one in found[:MOST]) + (f" and {len(found) - MOST} more" if len(found) > MOST else "")


def details(features, limit):
    """[(length or width, words, CAD faces)] of curves and patches below a limit, smallest first."""
    found = []
    for curve in features.curves:
        edges = [features.edges[k] for k in curve.edges]
        found.append((curve.length, f"Edge{edges[0].tag} is {curve.length:.3g} long", {e.left for e in edges}))
    around = np.zeros(len(features.patches))
    for curve in features.curves:
        around[[curve.left, curve.right]] += curve.length
    for patch, border in zip(features.patches, around):
        if border > 0.0:
            width = 2.0 * patch.area / border
            found.append((width, f"Face{patch.faces[0]} about {width:.3g} wide", set(patch.faces)))
    return sorted((one for one in found if one[0] < limit), key=lambda one: (one[0], one[1]))
