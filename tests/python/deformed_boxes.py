# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deformed boxes, pairs of boxes and pyramids, and the images of templates in them.

A template is carried by its corners: the 8 of a half-cell or the Geode, the 12 of a domino, the
5 of the pyramid. Its image in other corners is trilinear (the domino's in either half; the
pyramid's over the base, collapsed to the apex), so cells with equal corners on a side agree there.
"""
import numpy as np
from mesh_checker import CORNERS, nonpositive
from template_files import load_template

BINS = np.append(np.arange(2, 10), 10) / 10    # .2 .. .3, ..., .9 .. 1
LOWER, UPPER = ("O0 O1 O2 O3 I0 I1 I2 I3", "B0 B1 B2 B3 T0 T1 T2 T3")
CORNER_LABELS = (LOWER + " bO2 bO3 bI2 bI3", LOWER, UPPER, "B0 B1 B2 B3 A")
# Of a domino's 12 corners those of its second half, in the first half's order: its mirror image.
SECOND = np.array([0, 1, 8, 9, 4, 5, 10, 11])
# At each corner of a hex the ends of its three edges, right-handed.
_ENDS = np.array([[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7],
                  [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]])


# ----------------------------------------------------------------------------------------- images

def corner_rows(template):
    """Rows of the template's points that are its corners: (8,), (12,) or (5,) int."""
    for labels in CORNER_LABELS:
        if set(labels.split()) <= set(template.labels):
            return np.array([template.labels.index(label) for label in labels.split()])
    raise ValueError(f"{template.name} is neither over a box nor over a pyramid")


def image(template, corners):
    """All points of a template (P, 3) where its corners (8, 12 or 5 rows of 3) are."""
    at = template.points
    if len(corners) == 5:
        return _in_pyramid(corners, at)
    if len(corners) == 8:
        return _in_box(corners, at)
    first = _in_box(corners[:8], at)
    second = _in_box(corners[SECOND], at * [1, -1, 1])
    return np.where(at[:, 1:2] >= 0, first, second)


def _in_box(corners, at):
    weights = np.where(CORNERS[None], at[:, None], 1 - at[:, None]).prod(axis=2)
    return weights @ corners


def _in_pyramid(corners, at):
    """Level z is the base over -1 .. 1, shrunk by 1 - z towards the apex."""
    width = 1 - at[:, 2:]
    across = np.divide(at[:, :2], width, out=np.zeros((len(at), 2)), where=width > 0)
    u, v = (1 + across.T[:, :, None]) / 2
    low, high = (1 - u) * corners[0] + u * corners[1], (1 - u) * corners[3] + u * corners[2]
    return width * ((1 - v) * low + v * high) + at[:, 2:] * corners[4]


def affine_image(template, corners):
    """The template under the affine map that takes its corners nearest to the given ones."""
    def lifted(points):
        return np.column_stack([points, np.ones(len(points))])
    flat = np.linalg.lstsq(lifted(template.points[corner_rows(template)]), corners, rcond=None)[0]
    return lifted(template.points) @ flat, np.linalg.det(flat[:3])


# ---------------------------------------------------------------------------------------- measures

def _corner_quality(points, corner, ends):
    """Scaled determinants of edges from points[corner] (k,) to points[ends] (k, 3)."""
    edges = points[ends] - points[corner][:, None]
    lengths = np.linalg.norm(edges, axis=2).prod(axis=1)
    return np.linalg.det(edges) / np.maximum(lengths, 1e-300)


def measure(corners):
    """Smallest scaled Jacobian at the corners of the box or of either box; of a pyramid at the
    four of the base, in units of the undeformed one's."""
    if len(corners) == 5:
        k = np.arange(4)
        ends = np.column_stack([(k + 1) % 4, (k - 1) % 4, np.full(4, 4)])
        return float(_corner_quality(corners, k, ends).min() * 3 ** 0.5)
    value = _corner_quality(corners[:8], np.arange(8), _ENDS).min()
    if len(corners) == 12:    # the second box is a mirror image
        value = min(value, -_corner_quality(corners[SECOND], np.arange(8), _ENDS).max())
    return float(value)


def is_valid(corners):
    """The image's map is positive everywhere; a pyramid's is where its lower half's is."""
    if len(corners) == 5:
        boxes = [np.vstack([corners[:4], (corners[:4] + corners[4]) / 2])]
    elif len(corners) == 8:
        boxes = [corners]
    else:
        boxes = [corners[:8], corners[SECOND][[3, 2, 1, 0, 7, 6, 5, 4]]]
    return not len(nonpositive(np.vstack(boxes), np.arange(8 * len(boxes)).reshape(-1, 8)))


# ------------------------------------------------------------------------------------ deformations

def _recipe(rng, reference):
    """A random path of corners, from the reference at strength 0: callable(strength) -> corners.

    Bend, twist, taper, shear, warp and noise, some strong and most weak, in proportions 1:1 to 5:1.
    """
    middle = (reference.min(axis=0) + reference.max(axis=0)) / 2
    half = np.ptp(reference, axis=0) / 2
    weight = rng.dirichlet(np.full(6, 0.5))
    order, sign = rng.permutation(3), rng.choice([-1, 1], 2)
    shear, noise = rng.uniform(-1, 1, (3, 3)), rng.uniform(-1, 1, reference.shape)
    shear[np.diag_indices(3)] = 0
    taper, warp = rng.uniform(-1, 1, 2), rng.uniform(-1, 1, 3)
    proportions = 5 ** rng.uniform(0, 1, 3)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))

    def corners(strength):
        amount = 2.5 * strength * weight
        points = (reference - middle) / half
        points = points + amount[0] * noise + amount[1] * points @ shear
        points = points + amount[2] * warp * np.prod(points[:, order[:2]], axis=1)[:, None]
        x, y, z = points[:, order].T    # any of the three may be the axis of what follows
        x, y = np.stack([x, y]) * np.maximum(1 + amount[3] * np.outer(taper, z), 0.05)
        angle = sign[0] * amount[4] * z
        x, y = x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)
        reach = 1 / max(amount[5], 1e-6)    # radius of the bend
        turned = reach + sign[1] * z
        y, z = turned * np.sin(y / reach), sign[1] * (turned * np.cos(y / reach) - reach)
        bent = np.empty_like(points)
        bent[:, order] = np.column_stack([x, y, z])
        return (bent * half * proportions) @ turn.T
    return corners


def _reach(path, wanted, steps=40):
    """The first strength at which the measure has fallen to the wanted one, or None."""
    strengths = np.arange(steps + 1) / steps
    first = next((k for k, s in enumerate(strengths) if measure(path(s)) < wanted), 0)
    if first == 0:    # a stretched pyramid may be below it from the start
        return None
    low, high = strengths[first - 1], strengths[first]
    for _ in range(40):
        mid = (low + high) / 2
        low, high = (mid, high) if measure(path(mid)) >= wanted else (low, mid)
    return low


def deformed_corners(reference, count, seed):
    """`count` deformations of reference corners, as many in each of BINS: pairs (corners, measure).

    The map they carry is positive everywhere.
    """
    rng = np.random.default_rng(seed)
    for k in range(count):
        low, high = BINS[k % (len(BINS) - 1):][:2]
        while True:    # the first path will do, but for some pyramids
            path = _recipe(rng, reference)
            strength = _reach(path, rng.uniform(low, high))
            if strength is not None and is_valid(corners := path(strength)):
                yield corners, measure(corners)
                break


def deformed_cells(template_name, count, seed):
    """Yields (start (P, 3), target (P, 3), measure in .2 .. 1), `count` times.

    start   an affine image of the template, so valid: the nearest one to the target
    target  its image in deformed corners; the boundary's rows are where start's are to go
    """
    template = load_template(template_name)
    reference = template.points[corner_rows(template)]
    for corners, value in deformed_corners(reference, count, seed):
        start, volume = affine_image(template, corners)
        assert volume > 0, "a valid box whose nearest affine image is inside out"
        yield start, image(template, corners), value
