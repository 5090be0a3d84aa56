# SPDX-License-Identifier: LGPL-2.1-or-later
"""Order 2 on solids: the boundary's middle nodes lie on the CAD, and what would fold keeps part of its curvature."""
import curved_solids
import numpy as np
import pytest
from mesh_checker import boundary_faults

import hexcon
import hexcon_native as hn

EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])


@pytest.fixture(scope="module")
def solids(tmp_path_factory):
    folder = tmp_path_factory.mktemp("solids")
    return {name: curved_solids.write(name, folder / f"{name}.brep") for name in curved_solids.SOLIDS}


def boundary_middles(mesh):
    """Middle nodes of the boundary's edges."""
    ring = np.sort(np.stack([mesh.quads, np.roll(mesh.quads, -1, axis=1)], -1).reshape(-1, 2), axis=1)
    ends = np.sort(mesh.hexes[:, EDGES].reshape(-1, 2), axis=1)
    wanted = {tuple(row) for row in ring.tolist()}
    return np.unique([m for m, row in zip(mesh.hexes[:, 8:].reshape(-1), ends.tolist()) if tuple(row) in wanted])


def volume(points, hexes):
    """By Gauss points of the 20-node hexes."""
    from curved_judge import _SHAPES as shapes
    places, weights = np.polynomial.legendre.leggauss(4)
    places, weights = (places + 1) / 2, weights / 2
    total, powers = 0.0, np.arange(3)
    for r, wr in zip(places, weights):
        for s, ws in zip(places, weights):
            for t, wt in zip(places, weights):
                value = [x ** powers for x in (r, s, t)]
                slope = [powers * x ** np.maximum(powers - 1, 0) for x in (r, s, t)]
                rows = [np.einsum("nijk,i,j,k->n", shapes, *(slope[m] if m == axis else value[m] for m in range(3)))
                        for axis in range(3)]
                jacobian = np.einsum("an,hnc->hac", np.array(rows), points[hexes])
                total += wr * ws * wt * np.linalg.det(jacobian).sum()
    return total


@pytest.mark.parametrize(("name", "size", "exact"), [("cylinder", 5, 2000 * np.pi), ("ball", 3.5, 4000 * np.pi / 3)])
def test_round_solids(solids, name, size, exact):
    mesh = hexcon.mesh_solid(solids[name], size, order=2)
    flat = hexcon.mesh_solid(solids[name], size)
    told = mesh.report["curved"]
    assert mesh.certificate.certified and hn.certify(mesh.points, mesh.hexes, mesh.quads).certified
    assert boundary_faults(mesh.hexes[:, :8], mesh.quads) == []
    assert told["straight"] == told["reduced_count"] == 0
    middles = boundary_middles(mesh)
    assert told["on_edges"] + told["on_faces"] == len(middles)
    caps = np.isin(mesh.points[middles, 2], (0.0, 20.0)) if name == "cylinder" else np.zeros(len(middles), bool)
    rim = np.abs(np.hypot(*mesh.points[middles, :2].T) - 10) < 1e-9
    assert curved_solids.off(name, mesh.points[middles[~caps]]).max() < 1e-9
    assert name != "cylinder" or (caps & rim).sum() == told["on_edges"] > 0
    corners = mesh.hexes[:, :8]
    assert (mesh.points[corners] == flat.points[flat.hexes]).all()    # bit for bit
    straight = hn.raise_order(flat.points, flat.hexes)
    errors = [abs(volume(*one) - exact) for one in ((mesh.points, mesh.hexes), straight)]
    assert 50 * errors[0] < errors[1]
    assert told["volume"] == pytest.approx(volume(mesh.points, mesh.hexes), rel=1e-9)
    assert told["cad_volume"] == pytest.approx(exact, rel=1e-6)


def test_surfaces_without_closed_forms(solids):
    mesh = hexcon.mesh_solid(solids["barrel"], 5, order=2)
    told = mesh.report["curved"]
    assert mesh.certificate.certified and told["straight"] == 0 and told["on_edges"] > 0
    assert abs(told["volume"] / told["cad_volume"] - 1) < 2e-3 and told["chord"] < 0.05


def test_what_would_fold_keeps_part_of_its_curvature(solids):
    """Few, long quads round a thin pipe: each outer arc alone would pass the inner wall."""
    mesh = hexcon.mesh_solid(solids["pipe"], 5, order=2)
    told = mesh.report["curved"]
    assert mesh.certificate.certified
    assert told["inner"] == 0 or told["reduced_count"] >= 0
    assert curved_solids.off("pipe", mesh.points[np.unique(mesh.hexes[:, :8])]).max() < 1e-6
