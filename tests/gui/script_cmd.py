# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same addon in freecadcmd: Init.py alone makes the actions importable."""
import os
import sys
import traceback


def main():
    import FreeCAD
    assert "hexcon" not in sys.modules  # the start costs nothing
    import hexcon
    from hexcon.gui import actions

    doc = FreeCAD.newDocument("Cmd")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    made = actions.mesh_solid_object(box, 5.0, order=2)
    assert made.FemMesh.HexaCount == 8 and len(doc.Objects) == 3
    told = str(actions.check_mesh_object(made))
    assert "certified:" in told and "second order" in told, told
    inspected, looped = actions.inspect_mesh_object(made), actions.loops_of_object(made)
    assert inspected.thickness == 1 and len(inspected.scaled_jacobian) == 8
    assert len(looped.loops) == 6 and not len(looped.crossings)
    try:
        actions.mesh_solid_object(made, 5.0)
    except hexcon.HexconError as fault:
        assert "0 solids" in str(fault)
    else:
        raise AssertionError("a mesh has no solid")
    assert [actions.default_size(shape) for shape in (box.Shape, box.Shape.scaled(0.01))] == [
        1.5, 0.015]


status = 1
try:
    main()
    status = 0
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)
