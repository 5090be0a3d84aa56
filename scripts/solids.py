# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files of a folder from solid to certificate: which are certified, how good, and why the others are not.

    PYTHONPATH=.:workbench python3 scripts/solids.py FOLDER [--surface-method auto] [--method auto] [--quads 700]
                                                   [--limit 200] [--timeout 120] [--result output/solids.jsonl]
                                                   [--match PART_OF_NAME] [--diagonal 15]

The size of each is sqrt(area / quads), or that part of the diagonal of its bounding box. Every file is meshed in a
process of its own, with a limit of processor time. What is called certified is judged once more by
tests/python/mesh_checker.py, which shares no code with the core. A line of the result file is kept: a run that was
stopped goes on where it was; remove the file to measure anew.
"""
import argparse
import json
import os
import statistics
import sys

from measuring import already, failures, in_a_child, judged, keep, processor_seconds

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ENDINGS = (".step", ".stp", ".brep", ".brp")


def measured(path, options):
    """Figures of one file, in this process."""
    import hexcon
    found = {"quads wanted": options.quads}
    try:
        area, diagonal = _area_and_diagonal(path)
        size = options.size or (diagonal / options.diagonal if options.diagonal else (area / options.quads) ** 0.5)
        found["size"] = size
        mesh = hexcon.mesh_solid(path, size, surface_method=options.surface_method, method=options.method, threads=1,
                                 timeout=options.timeout)
    except hexcon.HexconError as error:
        return found | {"code": error.code.name, "message": str(error)[:2000]}
    surface = mesh.surface
    return found | judged(mesh, surface.points, surface.quads) | {
        "surface": surface.method, "quads": len(surface.quads), "nodes": len(mesh.points), "notes": list(surface.notes)}


def _area_and_diagonal(path):
    """(Of the surface, of the bounding box) of the one solid in a file."""
    import gmsh

    from hexcon.errors import FaultCode, ToolError
    gmsh.initialize([], False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
        gmsh.model.occ.importShapes(path, highestDimOnly=False)
        gmsh.model.occ.synchronize()
        solids = gmsh.model.getEntities(3)
        if len(solids) != 1:
            raise ToolError(f"{path}: {len(solids)} solids; one is needed", FaultCode.BAD_SHAPE)
        box = gmsh.model.getBoundingBox(*solids[0])
        area = sum(gmsh.model.occ.getMass(2, tag) for _, tag in gmsh.model.getBoundary(solids, oriented=False))
        return area, sum((b - a) ** 2 for a, b in zip(box[:3], box[3:])) ** 0.5
    finally:
        gmsh.finalize()


def in_its_own_process(path, options):
    command = [sys.executable, __file__, path, "--one", "--surface-method", options.surface_method, "--method",
               options.method, "--quads", str(options.quads), "--limit", str(options.limit),
               "--timeout", str(options.timeout)]
    for name in ("size", "diagonal"):
        if getattr(options, name):
            command += ["--" + name, str(getattr(options, name))]
    before = processor_seconds()
    found = in_a_child(command, processor=options.limit)
    return {"file": os.path.basename(path), "seconds": processor_seconds() - before, **found}


def line_of(found):
    words = f"{found['file']:40.40s} {found['code']:15s} {found['seconds']:6.1f} s"
    if "hexes" in found:
        words += "  {surface:12s} {method:9s} {quads:5d} quads {hexes:6d} hexes  {min:.3f} {q05:.3f} {mean:.3f}".format(
            **found)
    return words + (" | " + found["message"][:200] if found.get("message") else "")


def summary(found):
    """Lines: how many are certified, medians of those, and what the others are told."""
    good = [one for one in found if one["code"] == "CERTIFIED"]
    words = [f"{len(good)} of {len(found)} certified"]
    if good:
        words[0] += ": medians of min {:.2f}, 5 % {:.2f}, mean {:.2f}; {:.0f} hexes, {:.1f} s".format(
            *(statistics.median(one[name] for one in good) for name in ("min", "q05", "mean", "hexes", "seconds")))
    return "\n".join(words + failures(found, "file"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--surface-method", default="auto")
    parser.add_argument("--method", default="auto")
    parser.add_argument("--quads", type=float, default=700.0)
    parser.add_argument("--size", type=float, default=0.0, help="in place of --quads")
    parser.add_argument("--diagonal", type=float, default=0.0, help="of the box by the size, in place of --quads")
    parser.add_argument("--limit", type=float, default=200.0, help="seconds of processor time for a process")
    parser.add_argument("--timeout", type=float, default=120.0, help="of hexcon.mesh_solid, whose own it is")
    parser.add_argument("--match", default="")
    parser.add_argument("--result", default="output/solids.jsonl")
    parser.add_argument("--one", action="store_true")
    options = parser.parse_args()
    sys.path[:0] = [os.path.join(ROOT, "tests", "python")]
    if options.one:
        print("\n" + json.dumps(measured(options.folder, options)), flush=True)
        return
    known = already(options.result, "file")
    names = sorted(n for n in os.listdir(options.folder) if n.lower().endswith(ENDINGS) and options.match in n)
    for name in names:
        if name not in known:
            known[name] = in_its_own_process(os.path.join(options.folder, name), options)
            keep(options.result, known[name])
        print(line_of(known[name]), flush=True)
    print(summary([known[name] for name in names]))


if __name__ == "__main__":
    main()
