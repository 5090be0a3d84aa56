# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one module that knows FreeCAD's versions (0.20 to 1.1) and where it is installed.

Measured on 0.20.2. What later versions do is marked *unverified*.
"""
import importlib
import os
import sys
from contextlib import contextmanager

from hexcon.errors import FaultCode, ToolError

# Where Debian and Ubuntu put FreeCAD: Python modules, and the home folder that holds Mod and
# Ext. FREECAD_LIB (the folder of FreeCAD.so) and FREECAD_HOME take their place where set.
DEBIAN_LIB = "/usr/lib/freecad-python3/lib"
DEBIAN_HOME = "/usr/lib/freecad"

PACKAGES = "AdditionalPythonPackages"   # the Addon Manager's folder of them

DRAWN_BY_FEM = ("Fem::FemMeshObject", "Fem::FemPostObject")  # what of an analysis fills the 3D view


def _on_path(folder):
    # at the end: FreeCAD's folders hold modules with common names
    if folder and os.path.isdir(folder) and folder not in sys.path:
        sys.path.append(folder)


def _missing(cause):
    return ToolError(
        "this needs FreeCAD's Python modules and they cannot be imported "
        f"({cause}). Run it with freecadcmd, or install FreeCAD (Debian: apt install "
        "freecad) and use the Python it was built for, or set FREECAD_LIB to the folder "
        "that holds FreeCAD.so", FaultCode.FREECAD_MISSING)


def freecad():
    """The FreeCAD module. Raises ToolError(FREECAD_MISSING)."""
    if sys.modules.get("FreeCAD") is not None:
        return sys.modules["FreeCAD"]
    _on_path(os.environ.get("FREECAD_LIB") or DEBIAN_LIB)
    try:
        return importlib.import_module("FreeCAD")
    except ImportError as error:
        raise _missing(error) from error


def freecad_module(name):
    """A module that comes with FreeCAD's library folder, e.g. "Part"."""
    freecad()
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise _missing(error) from error


def fem_module(name):
    """One module of FreeCAD's FEM workbench, e.g. "Fem" or "femtools.ccxtools".

    Raises ToolError(FREECAD_MISSING)."""
    app = freecad()
    # freecadcmd has these folders on its path; a plain Python that imported FreeCAD has not
    for home in (os.environ.get("FREECAD_HOME"), app.getHomePath(), DEBIAN_HOME):
        if home:
            _on_path(os.path.join(home, "Mod", "Fem"))
            _on_path(os.path.join(home, "Ext"))  # the PySide shim
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise _missing(f"FEM workbench: {error}") from error


def mod_folders_on_path():
    """Let FreeCAD find the modules of its workbenches, as freecadcmd does: a type that a document names is loaded by
    importing its module (PartDesign::Body: PartDesign), and objects of types not found are left out in silence."""
    for home in (os.environ.get("FREECAD_HOME"), freecad().getHomePath(), DEBIAN_HOME):
        mod = os.path.join(home, "Mod") if home else ""
        if os.path.isdir(mod):
            for name in sorted(os.listdir(mod)):
                _on_path(os.path.join(mod, name))
            _on_path(mod)
            _on_path(os.path.join(home, "Ext"))


def version():
    """(major, minor) of the running FreeCAD."""
    text = freecad().Version()
    return int(text[0]), int(text[1])


def packages_folder():
    """Where the Addon Manager puts Python packages, and FreeCAD looks for them: since 0.21 by the Python's version."""
    folder = os.path.join(freecad().getUserAppDataDir(), PACKAGES)
    return folder if version() < (0, 21) else os.path.join(folder, "py{}{}".format(*sys.version_info[:2]))


def add_mesh_object(doc, name, solid):
    """A Fem::FemMeshObjectPython linked to the solid, so that FEM does not warn of a
    "mesh without a link to a Shape". The link is called Part up to 0.21 and Shape from
    1.0 on (*unverified*)."""
    mesh_object = doc.addObject("Fem::FemMeshObjectPython", name)
    link = "Shape" if version() >= (1, 0) else "Part"
    if link not in mesh_object.PropertiesList:
        mesh_object.addProperty("App::PropertyLink", link, "FEM Mesh",
                                "The solid this mesh was made from")
    setattr(mesh_object, link, solid)
    return mesh_object


def shape_of(obj):
    """The Part.Shape of a document object, or None of one without: a FEM mesh object of 1.0 and later has a property
    Shape too, which is the link to its solid."""
    shape = getattr(obj, "Shape", None)
    return shape if hasattr(shape, "Solids") else None


def shape_in_whole(obj):
    """A document object's shape, copied to its place in the whole: by its own Placement and those of what holds it."""
    moved = obj.Shape.copy()
    moved.Placement = obj.getGlobalPlacement() * obj.Placement.inverse() * moved.Placement
    return moved


def fem_shape_of(obj):
    """shape_of, at the place where FreeCAD's FEM meshes it and seeks the nodes of constraints on its faces.

    In 0.20 that is where its own Placement says, whatever App::Parts hold it; in 1.1 it is the place in the whole. What
    versions between do is *unverified*: the FEM that is there is asked."""
    shape = shape_of(obj)
    if shape is None or not hasattr(obj, "getGlobalPlacement"):
        return shape
    own, whole = obj.Placement.Matrix.A, obj.getGlobalPlacement().Matrix.A
    if max(abs(a - b) for a, b in zip(own, whole)) <= 1e-12:    # of turned solids the copy would differ by rounding
        return shape
    in_whole = hasattr(fem_module("femmesh.meshtools"), "sub_shape_at_global_placement")
    return shape_in_whole(obj) if in_whole else shape


def takes_no_node_group(constraint):
    """Whether FEM seeks the element faces under a constraint by distance alone, whatever node groups the mesh has:
    those of forces, contacts, ties and heat fluxes in 0.20 and 1.1, and in 1.1 of pressures."""
    kind = getattr(getattr(constraint, "Proxy", None), "Type", None) or constraint.TypeId
    kinds = {"Fem::ConstraintForce", "Fem::ConstraintContact", "Fem::ConstraintTie", "Fem::ConstraintHeatflux"}
    if hasattr(fem_module("femmesh.meshtools"), "get_ccx_subelements_by_references"):     # pressures go by it in 1.1
        kinds.add("Fem::ConstraintPressure")
    return kind in kinds


def solid_of_mesh_object(mesh_object):
    """The linked solid, or None."""
    for link in ("Shape", "Part"):
        solid = getattr(mesh_object, link, None)
        if solid is not None and shape_of(solid) is not None:
            return solid
    return None


def see_all(view):
    """All that a 3D view shows, from a corner, at once: 1.0 and later turn the camera little by little, and a view
    that is fitted while it turns is fitted to nothing."""
    turns = view.isAnimationEnabled()
    view.setAnimationEnabled(False)
    view.viewIsometric()
    view.fitAll()
    view.setAnimationEnabled(turns)


@contextmanager
def transaction(doc, title):
    """All or nothing: on any exception the objects made inside are gone again.

    A transaction that the caller has already opened is joined, not closed. Without undo
    (freecadcmd's default) FreeCAD aborts nothing, so new objects are removed by name.
    """
    before = {o.Name for o in doc.Objects}
    joined = bool(getattr(doc, "HasPendingTransaction", False))
    if not joined:
        doc.openTransaction(title)
    try:
        yield
    except BaseException:
        if not joined:
            doc.abortTransaction()
        for added in [o.Name for o in doc.Objects if o.Name not in before][::-1]:
            if doc.getObject(added) is not None:
                doc.removeObject(added)
        raise
    if not joined:
        doc.commitTransaction()


def ccx_preference():
    """Path of ccx set in FreeCAD's preferences, or None where the standard place is used."""
    group = freecad().ParamGet("User parameter:BaseApp/Preferences/Mod/Fem/Ccx")
    if group.GetBool("UseStandardCcxLocation", True):
        return None
    return group.GetString("ccxBinaryPath", "") or None


def set_quantity(obj, name, value, unit):
    """Set a property that is a plain float in 0.20 (in N, MPa) and a quantity later on (in 1.1; when it became one is
    *unverified*), where a bare float would be taken in FreeCAD's own units (mN, kPa)."""
    if hasattr(getattr(obj, name), "getValueAs"):
        setattr(obj, name, f"{value!r} {unit}")
    else:
        setattr(obj, name, value)


def make_ccx_solver(doc):
    """The FEM workbench's CcxTools solver object, linear static."""
    objects = fem_module("ObjectsFem")
    for maker in ("makeSolverCalculixCcxTools", "makeSolverCalculiXCcxTools"):
        if hasattr(objects, maker):  # the second spelling: 1.0 or 1.1, *unverified*
            solver = getattr(objects, maker)(doc, "SolverCcxTools")
            break
    else:
        raise _missing("ObjectsFem makes no CcxTools solver")
    for name, value in (("AnalysisType", "static"), ("GeometricalNonlinearity", "linear"),
                        ("MaterialNonlinearity", "linear"), ("SplitInputWriter", False),
                        ("IterationsControlParameterTimeUse", False)):
        if name in solver.PropertiesList:
            setattr(solver, name, value)
    return solver
