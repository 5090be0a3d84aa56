# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of each hex of any hex mesh is inside a solid."""
import numpy as np

RAYS = 4               # rays a hex and direction
CHUNK = 200_000        # hexes at a time
# For each local axis: its lower face, and the corners across from it.
_ENDS = (([0, 3, 7, 4], [1, 2, 6, 5]), ([0, 1, 5, 4], [3, 2, 6, 7]), ([0, 1, 2, 3], [4, 5, 6, 7]))


def fullness(points, hexes, solid):
    """(H,) 0 ... 1 of each hex.

    points (P, 3) float64 and solid (a SolidRays) in one frame, hexes (H, 8) in VTK order. A hex is measured along 4 x 4
    rays: the pieces of them between its two faces that are most across z. So boxes along the axes are measured
    exactly along z, and other hexes as if their pieces were upright. Cost: 16 rays a hex, or a column of hexes.
    """
    parts = [_fullness(points[hexes[k:k + CHUNK]], solid) for k in range(0, len(hexes), CHUNK)]
    return np.concatenate(parts) if parts else np.zeros(0)


def _fullness(corners, solid):
    bottom, top = np.empty((len(corners), 4, 3)), np.empty((len(corners), 4, 3))
    along = np.stack([corners[:, high].mean(axis=1) - corners[:, low].mean(axis=1) for low, high in _ENDS], axis=1)
    steep = np.abs(along[:, :, 2]) / np.maximum(np.linalg.norm(along, axis=2), 1e-300)
    axis = np.argmax(steep + 1e-9 * np.arange(3), axis=1)
    for k, (low, high) in enumerate(_ENDS):
        rows = axis == k
        bottom[rows], top[rows] = corners[rows][:, low], corners[rows][:, high]
    weights = _weights()
    bottom, top = np.einsum("sk,hkc->hsc", weights, bottom), np.einsum("sk,hkc->hsc", weights, top)
    xy = (bottom[:, :, :2] + top[:, :, :2]) / 2
    low, high = np.minimum(bottom[:, :, 2], top[:, :, 2]), np.maximum(bottom[:, :, 2], top[:, :, 2])
    inside = solid.lengths(xy.reshape(-1, 2), low.ravel(), high.ravel()).reshape(low.shape)
    return np.clip(inside.sum(axis=1) / np.maximum((high - low).sum(axis=1), 1e-300), 0, 1)


def _weights():
    """(16, 4) of the four corners, at places where no face of a designer's lies."""
    u = (np.arange(RAYS) + 0.5 + 0.0137) / RAYS
    v = (np.arange(RAYS) + 0.5 + 0.0274) / RAYS
    u, v = (x.ravel() for x in np.meshgrid(u, v, indexing="ij"))
    return np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
