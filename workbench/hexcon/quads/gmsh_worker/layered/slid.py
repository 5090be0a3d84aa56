# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of a layered mesh moved together: those inside a CAD face slide on it, those on edges stay, others are free."""
import numpy as np

import hexcon_native as hn

FREE, STAYS = -1, -2        # of hexcon.h
ROUNDS = 4          # of hexcon_native.relax; its passes would raise angles at the cost of even edges


def slid(shape, mesh):
    """(P,3) points of an extrude.LayeredMesh. shape: roles.Shape. Faces without a closed form keep their points."""
    faces = [f for f in shape.solid.faces if shape.carriers[f].kind != "other"]
    row = {f: k for k, f in enumerate(faces)}
    least, most = np.full(len(mesh.points), np.iinfo(int).max), np.full(len(mesh.points), -1)
    np.minimum.at(least, mesh.quads, mesh.faces[:, None])
    np.maximum.at(most, mesh.quads, mesh.faces[:, None])
    carrier = np.where(most < 0, FREE, STAYS)
    inside = np.flatnonzero((least == most) & np.isin(most, faces))
    carrier[inside] = [row[f] for f in most[inside].tolist()]
    return hn.relax(mesh.points, mesh.hexes, carrier, [shape.carriers[f].core for f in faces], rounds=ROUNDS,
                    threads=1)
