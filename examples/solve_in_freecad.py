# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD document from a solid to displacements: freecadcmd solve_in_freecad.py"""
import os
import sys
import traceback

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [ROOT, os.path.join(ROOT, "workbench")]


def main():
    import FreeCAD

    import hexcon
    from hexcon.femmesh import add_to_document

    document = FreeCAD.newDocument("Beam")
    beam = document.addObject("Part::Box", "Beam")
    beam.Length, beam.Width, beam.Height = 100, 10, 10
    document.recompute()

    mesh = hexcon.mesh_solid(beam.Shape, 5.0, order=2)
    mesh_object = add_to_document(document, mesh, beam)
    result = hexcon.solve(document, mesh_object, beam, fixed=["Face1"], force={"Face2": (0, 0, -100.0)})
    # A slender cantilever of steel: F L^3 / (3 E I)
    expected = 100.0 * 100.0 ** 3 / (3 * 210000.0 * 10.0 * 10.0 ** 3 / 12)
    print(f"mesh          {len(mesh.hexes)} C3D20R, {mesh.certificate}")
    print(f"deflection    {result.max_displacement:.4f} mm, beam theory without shear {expected:.4f} mm")
    print(f"von Mises     {result.von_mises.max():.1f} MPa at most")


if __name__ in ("__main__", "solve_in_freecad"):
    status = 0
    try:
        main()
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)    # FreeCAD would run a script that raises a second time and exit with 0
