# SPDX-License-Identifier: LGPL-2.1-or-later
"""Named parts (any_solids.py) from solid to solved model: what parts_table.py prints.

One line a part, surface method and size: genus, cavities, quads, hexes, scaled Jacobian, certificate and Euler
characteristic, the error of a patch test in ccx, and the largest displacement and von Mises stress of a static analysis.
"""
import argparse
import os
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(p) for p in (ROOT, ROOT / "workbench", ROOT / "tests", HERE, HERE.parent / "python")]
FACTORS = {"torus": (1.0, 0.75, 0.5)}      # of a body's size: three gradings


def face_at(shape, point):
    """Name of the face a point lies on."""
    from quads_solids import Part, Vector
    vertex = Part.Vertex(Vector(*point))
    return f"Face{1 + min(range(len(shape.Faces)), key=lambda k: shape.Faces[k].distToShape(vertex)[0])}"


def faults_of(mesh, body):
    """What is wrong with a mesh of a body, in words; nothing here trusts the core."""
    import mesh_checker
    from csg_table import mesh_euler
    surface = mesh.surface
    faults = mesh_checker.faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    if mesh_euler(mesh) != 1 + body.cavities - body.handles:
        faults.append(f"Euler characteristic {mesh_euler(mesh)}")
    return faults + ([] if mesh.certificate.certified else ["not certified"])


def solved(mesh, shape, body):
    """(result of a static analysis through FreeCAD's FEM, names of the groups of the mesh object)."""
    import FreeCAD

    import hexcon
    from hexcon import femmesh
    document = FreeCAD.newDocument("HexConParts")
    try:
        solid = document.addObject("Part::Feature", "Solid")
        solid.Shape = shape
        mesh_object = femmesh.add_to_document(document, mesh, solid)
        held = mesh_object.FemMesh
        groups = {held.getGroupName(g) for g in held.Groups}
        result = hexcon.solve(document, mesh_object, solid, fixed=[face_at(shape, body.fixed)],
                              force={face_at(shape, body.loaded): body.force})
        return result, groups
    finally:
        FreeCAD.closeDocument(document.Name)


def line_of(name, body, surface_method, size):
    from test_calculix_deck import patch_error

    import hexcon
    shape = body.make()
    start = time.monotonic()
    words = f"{name:20s}{surface_method:9s}{size:5.2f}  genus {body.handles} cavities {body.cavities}  "
    try:
        mesh = hexcon.mesh_solid(shape, size, surface_method=surface_method)
    except hexcon.HexconError as fault:
        return words + f"{fault.code.name}: {str(fault)[:160]}"
    seconds = time.monotonic() - start
    faults = faults_of(mesh, body)
    words += (f"{mesh.surface.method:21s}{len(mesh.quads):5d} quads  {mesh.method:7s}{len(mesh.hexes):6d} hexes  "
              f"{mesh.quality.min:.3f} {mesh.quality.mean:.3f}  {seconds:5.1f} s  "
              f"{'; '.join(faults) or 'certified'}  patch {patch_error(mesh, 1)[0]:.0e}")
    if body.fixed:
        result, groups = solved(mesh, shape, body)
        words += (f"  u {result.max_displacement:.3e} mm  von Mises {result.von_mises.max():6.2f} MPa"
                  f"  {len(groups)} of {len(shape.Faces)} face groups")
    return words


def main(given):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--surface-method", nargs="+", default=["auto", "blossom"])
    parser.add_argument("--part", nargs="+")
    parser.add_argument("--factor", nargs="+", type=float)
    parser.add_argument("--result", default="output/parts.txt", help="FreeCAD talks in between on the terminal")
    options = parser.parse_args(given)
    from any_solids import BODIES
    os.makedirs(os.path.dirname(options.result) or ".", exist_ok=True)
    with open(options.result, "w", encoding="utf-8") as stream:
        for line in lines(options, BODIES):
            print(line, file=stream, flush=True)


def lines(options, bodies):
    for name in options.part or bodies:
        for method in options.surface_method:
            for factor in options.factor or FACTORS.get(name, (1.0, 0.6)):
                yield line_of(name, bodies[name], method, factor * bodies[name].size)
