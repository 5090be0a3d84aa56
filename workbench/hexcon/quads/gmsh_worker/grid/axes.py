# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame that most of a solid's surface is aligned with."""
import numpy as np

_MOST = 8           # directions looked at
_SHARP = 12         # exponent: how little a face counts that is not quite along an axis
_SAME = 1e-6        # of the cosine: directions that are one
_ALIGNED = 1e-3     # so much of the score for each axis of the document, where all else is equal


def axes_of(features):
    """(3, 3) rows: a right-handed frame; the document's own where that is as good."""
    area = np.linalg.norm(features.normals, axis=1)
    unit = features.normals / np.maximum(area, 1e-300)[:, None]
    best, found = -1.0, np.eye(3)
    for frame in _frames(_directions(features.cad)):
        score = (area * (np.abs(unit @ frame.T) ** _SHARP).max(1)).sum()
        score *= 1.0 + _ALIGNED * (np.abs(frame).max(1) > 1.0 - 1e-9).sum()
        if score > best * (1.0 + 1e-6):
            best, found = score, frame
    return found


def _directions(cad):
    """Normals of planes and axes of round faces, those with most area first."""
    merged = []
    for face, carrier in cad.carriers.items():
        if carrier.kind in ("other", "Sphere"):
            continue
        area = cad.solid.area(face)
        same = next((m for m in merged if abs(m[0] @ carrier.axis) > 1.0 - _SAME), None)
        if same:
            same[1] += area
        else:
            merged.append([carrier.axis, area])
    return [d for d, _ in sorted(merged, key=lambda m: -m[1])[:_MOST]]


def _frames(directions):
    yield np.eye(3)
    directions = directions + list(np.eye(3))
    for i, a in enumerate(directions):
        for b in directions[i + 1:]:
            b = b - (a @ b) * a
            if np.linalg.norm(b) < 0.2:
                continue
            b = b / np.linalg.norm(b)
            yield _like_the_document(np.array([a, b, np.cross(a, b)]))


def _like_the_document(rows):
    """The frame, each axis next to the document's that it is closest to: an aligned one is the identity."""
    order = np.abs(rows).argmax(axis=0)
    if sorted(order.tolist()) != [0, 1, 2]:
        order = np.arange(3)
    frame = rows[order]
    frame *= np.where(np.diag(frame) < 0.0, -1.0, 1.0)[:, None]
    if np.linalg.det(frame) < 0.0:
        frame[2] *= -1.0
    return frame
