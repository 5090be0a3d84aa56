# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a STEP file to a solved hex model: freecadcmd run_bracket.py [-- FOLDER]

Meshes resources/examples/bracket.step, holds the underside of its long leg, pulls the end of the
short one, solves in CalculiX, and leaves .FCStd, .inp, .vtu and .png in FOLDER, or in output/.
Copy it and change `PART`, `SIZE`, `ORDER` and `loads()` for a part of your own.
"""
import os
import sys
import time
import traceback

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "workbench")]

PART = os.path.join(ROOT, "resources", "examples", "bracket.step")
OUTPUT = os.path.abspath(sys.argv[-1]) if "--" in sys.argv else os.path.join(ROOT, "output")
SIZE = 5.0  # mm
ORDER = 2   # C3D20R


def face_at(shape, axis, position):
    """Name of the plane face whose points all have this coordinate."""
    for number, face in enumerate(shape.Faces, 1):
        box = face.BoundBox
        low, high = ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))[axis]
        if abs(low - position) < 1e-6 and abs(high - position) < 1e-6:
            return f"Face{number}"
    raise ValueError(f"no face of the part lies at {'xyz'[axis]} = {position}")


def loads(shape):
    """What holds and what pulls the part: mm, N."""
    return {"fixed": (face_at(shape, 2, 0.0),),
            "force": {face_at(shape, 2, 70.0): (1500.0, 0.0, 0.0)}}


def main():
    from hexcon.chatter import chatter_to

    os.makedirs(OUTPUT, exist_ok=True)
    with chatter_to(os.path.join(OUTPUT, "freecad.log")):
        facts = mesh_and_solve()
    report(*facts)


def mesh_and_solve():
    import FreeCAD
    import Part

    import hexcon
    from hexcon.femmesh import add_to_document
    from hexcon.pictures import render

    name = os.path.splitext(os.path.basename(PART))[0]
    paths = {ending: os.path.join(OUTPUT, name + ending)
             for ending in (".FCStd", ".inp", ".vtu", ".png")}
    document = FreeCAD.newDocument(name)
    solid = document.addObject("Part::Feature", name)
    solid.Shape = Part.read(PART)
    document.recompute()

    started = time.monotonic()
    mesh = hexcon.mesh_solid(solid.Shape, SIZE, order=ORDER)
    meshed = time.monotonic()
    mesh_object = add_to_document(document, mesh, solid)
    result = hexcon.solve(document, mesh_object, solid, **loads(solid.Shape))
    solved = time.monotonic()
    hexcon.write(mesh, paths[".inp"])
    hexcon.write(mesh, paths[".vtu"], point_data={"displacement": result.displacements,
                                                  "von_mises": result.von_mises})
    render(mesh, paths[".png"], displacements=result.displacements,
           title=f"{name}: {len(mesh.hexes)} hexes of order {mesh.order}, certified")
    document.saveAs(paths[".FCStd"])
    return mesh, result, meshed - started, solved - meshed, paths


def report(mesh, result, mesh_seconds, solve_seconds, paths):
    from hexcon.judging.curved import of_curving

    quality = mesh.quality
    print(f"part          {os.path.relpath(PART, ROOT)}, size {SIZE} mm")
    print(f"surface       {len(mesh.quads)} quads")
    for note in mesh.report["surface notes"]:
        print(f"              {note}")
    print(f"mesh          {len(mesh.hexes)} hexes, {len(mesh.points)} nodes, order {mesh.order}, "
          f"{mesh_seconds:.1f} s")
    print(f"quality       scaled Jacobian min {quality.min:.3f}, 5 % {quality.q05:.3f}, "
          f"mean {quality.mean:.3f}")
    for sentence in of_curving(mesh.report):
        print(f"curved        {sentence}")
    print("certificate   " + ("every Jacobian proved positive, proper, boundary exact"
                              if mesh.certificate.certified else repr(mesh.certificate)))
    print(f"solved        CalculiX, {solve_seconds:.1f} s")
    for note in result.report["notes"]:
        print(f"              {note}")
    print(f"deflection    {result.max_displacement:.5f} mm at most, von Mises "
          f"{result.von_mises.max():.1f} MPa at most")
    for path in paths.values():
        print(f"written       {path}")


if __name__ in ("__main__", "run_bracket"):
    status = 0
    try:
        main()
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # FreeCAD would run a script that raises a second time and exit with 0
