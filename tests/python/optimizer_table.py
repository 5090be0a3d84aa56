# SPDX-License-Identifier: LGPL-2.1-or-later
"""hn.optimize beside other programs that move inner points of hex meshes: scattered points, the boundary at rest.

    PYTHONPATH=.:workbench python3 tests/python/optimizer_table.py [FOLDER] [--smoother PATH]

FOLDER holds hex meshes that HexCon reads; without it there are six made by formula (scrambled.py). Inner points are
moved by up to so many times the mean length of their edges (--amounts). Who then optimises: hn.optimize, with two
passes for the mean; gmsh's Relocate3D, of the package; and innerSmoother of github.com/fprotais/hexsmoothing, where
--smoother names its program (innerSmoother IN.mesh OUT.mesh). Each in one thread; the processor seconds of programs
contain their files. Boundary points are put back to the bits they had, and all results are judged by hn.certify.

One line a mesh: hexes, hexes inverted by the scattering; then for each certified or the hexes that are not positive,
least and mean scaled Jacobian, seconds. Then their medians.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import meshio
import numpy as np
from scrambled import on_boundary, scramble, swept_meshes

import hexcon_native as hn
from hexcon.files import read_mesh
from hexcon.gmsh_process import gmsh_python

LIMIT = 300     # processor seconds of one program on one mesh
_RELOCATE = """
import sys, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0); gmsh.option.setNumber("General.NumThreads", 1)
gmsh.option.setNumber("Mesh.MshFileVersion", 2.2); gmsh.option.setNumber("Mesh.SaveAll", 1)
gmsh.open(sys.argv[1])
gmsh.model.mesh.optimize("Relocate3D", True, 10)
gmsh.write(sys.argv[2])
"""


def by_hexcon(points, hexes, fixed, folder):
    del folder
    return hn.optimize(points, hexes, fixed, mean_passes=2, threads=1)


def by_gmsh(points, hexes, fixed, folder):
    return _by_program([gmsh_python(), "-c", _RELOCATE], ".msh", points, hexes, fixed, folder)


def by_program(path):
    def smooth(points, hexes, fixed, folder):
        return _by_program([path], ".mesh", points, hexes, fixed, folder)
    return smooth


def _by_program(command, ending, points, hexes, fixed, folder):
    """Points as a program leaves them; the given ones where it crashes, stops or hands back another mesh."""
    given, made = (os.path.join(folder, name + ending) for name in ("given", "made"))
    with open(os.devnull, "w", encoding="ascii") as nothing:
        os.path.exists(made) and os.remove(made)
        one = [np.ones(len(hexes), np.int32)]
        tags = {"gmsh:physical": one, "gmsh:geometrical": one} if ending == ".msh" else {}
        meshio.write(given, meshio.Mesh(points, [("hexahedron", hexes)], cell_data=tags),
                     **({"file_format": "gmsh22", "binary": False} if ending == ".msh" else {}))
        try:
            subprocess.run([*command, given, made], stdout=nothing, stderr=nothing, check=False, preexec_fn=lambda: (
                resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))), env={**os.environ, "OMP_NUM_THREADS": "1"})
            stdout, sys.stdout = sys.stdout, nothing      # meshio tells of what it passes over
            try:
                found = meshio.read(made)
            finally:
                sys.stdout = stdout
        except Exception:   # no file, or none that can be read
            return points
    same = [block.data for block in found.cells if block.type == "hexahedron"]
    if len(found.points) != len(points) or len(same) != 1 or not np.array_equal(same[0], hexes):
        return points
    return np.where(fixed[:, None], points, found.points)


def processor_seconds():
    return sum(used.ru_utime + used.ru_stime
               for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def measured(optimise, points, hexes, fixed, quads, folder):
    """(certified, hexes not positive, least, mean, seconds) of one program on one mesh."""
    start = processor_seconds()
    found = optimise(points, hexes, fixed, folder)
    seconds = processor_seconds() - start
    assert found[fixed].tobytes() == points[fixed].tobytes()
    certificate, quality = hn.certify(found, hexes, quads), hn.quality(found, hexes)
    return certificate.certified, len(certificate.nonpositive), quality.min, quality.mean, seconds


def meshes(folder, size):
    """Yields (name, points, hexes, fixed, quads) of meshes that are certified as they are."""
    if folder is None:
        given = ((name, *mesh[:2]) for name, mesh in swept_meshes(size))
    else:
        read = ((path.stem, read_mesh(path)) for path in sorted(pathlib.Path(folder).iterdir()))
        given = ((name, mesh.points, mesh.hexes[:, :8]) for name, mesh in read)
    for name, points, hexes in given:
        used, ids = np.unique(hexes, return_inverse=True)   # some files hold points of no hex
        points, hexes = points[used], ids.reshape(-1, 8)
        fixed, quads = on_boundary(hexes), outer_quads(hexes)
        if hn.certify(points, hexes, quads).certified and not fixed.all():
            yield name, points, hexes, fixed, quads
        else:
            print(f"{name}: left out, as it is not certified to begin with", flush=True)


def outer_quads(hexes):
    from hexcon.femmesh.boundary import boundary_quads
    from hexcon.femmesh.hexahedron import FACES
    rows, sides = boundary_quads(hexes, int(hexes.max()) + 1)
    return hexes[rows[:, None], FACES[sides]]


def words(certified, bad, least, mean, seconds):
    return f"{'certified' if certified else f'{bad:5d} bad':9s} {least:6.3f} {mean:.3f} {seconds:6.1f} s"


def summary(name, results):
    good = sum(certified for certified, *_ in results)
    least, mean, seconds = (statistics.median(one[k] for one in results) for k in (2, 3, 4))
    return (f"{name:14s} certified {good} of {len(results)}; medians: minimum {least:.2f}, mean {mean:.2f}, "
            f"{seconds:.1f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--smoother", help="innerSmoother of fprotais/hexsmoothing")
    parser.add_argument("--amounts", type=float, nargs="+", default=[0.5, 1.0])
    parser.add_argument("--size", type=int, default=2000, help="hexes of meshes made by formula")
    options = parser.parse_args()
    programs = {"hn.optimize": by_hexcon, "Relocate3D": by_gmsh}
    if options.smoother:
        programs["innerSmoother"] = by_program(os.path.abspath(options.smoother))
    results = {name: [] for name in programs}
    print(f"{'least and mean scaled Jacobian, seconds of':47s} | " + " | ".join(f"{name:31s}" for name in programs))
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        for name, points, hexes, fixed, quads in meshes(options.folder, options.size):
            for amount in options.amounts:
                tangled = scramble(points, hexes, fixed, amount, seed=1)
                bad = int((hn.quality(tangled, hexes).scaled_jacobian <= 0).sum())
                for program, optimise in programs.items():
                    results[program].append(measured(optimise, tangled, hexes, fixed, quads, folder))
                print(f"{name[:24]:24s} {len(hexes):6d} hexes, {bad:5d} inverted | "
                      + " | ".join(words(*found[-1]) for found in results.values()), flush=True)
    for program, found in results.items():
        print(summary(program, found))
    print(f"# {time.monotonic() - start:.0f} s by the clock", file=sys.stderr)


if __name__ == "__main__":
    main()
