# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the parametric objects share: declared properties, and a recompute that loses nothing.

On recompute an object asks whether its inputs differ from those its content was made from
(MadeFrom holds their fingerprint). If not, nothing is done, so a solid that merely moved in the
tree costs no meshing. If so, it makes its content anew; with AutoUpdate off it only says in
Status that it is out of date. A fault leaves the content as it was and stands in Status.

It is not raised: FreeCAD would print a traceback for the user, and skip what depends on us.
"""
import hashlib

from hexcon import freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.window import attach_view, wait_for
from hexcon_native import ErrorCode, HexconError

CURRENT = "Up to date"
OUTDATED = "Out of date"
MOST_KEPT = 4  # FEM meshes that undo can bring back
FAILED = "Failed"
HIDDEN = ("MadeFrom", "Proposal")   # for programs alone

COMMON = (
    ("App::PropertyBool", "AutoUpdate", "HexCon", "Make the content anew on recompute when an "
     "input has changed; off: only say in Status that it is out of date", True, False),
    ("App::PropertyString", "Status", "Result", "Whether the content belongs to the inputs, and "
     "if not, why", CURRENT, True),
    ("App::PropertyString", "MadeFrom", "Result", "Fingerprint of the inputs that the content was "
     "made from", "", True),
)


def declare(obj, rows):
    """Add the properties that the object does not have yet; values of others stay.

    rows  (type, name, group, meaning, default, read only); the default of an enumeration is the
          tuple of its choices. So documents of older versions get new properties when opened.
    """
    for kind, name, group, meaning, default, read_only in rows:
        if name in obj.PropertiesList:
            _widen(obj, kind, name, default)
            continue
        obj.addProperty(kind, name, group, meaning)
        if default is not None:
            setattr(obj, name, list(default) if kind.endswith("Enumeration") else default)
        obj.setEditorMode(name, 2 if name in HIDDEN else int(read_only))


def _widen(obj, kind, name, choices):
    """Offer choices that came after the document was saved."""
    if kind.endswith("Enumeration") and obj.getEnumerationsOfProperty(name) != list(choices):
        kept = getattr(obj, name)
        setattr(obj, name, list(choices))
        if kept in choices:
            setattr(obj, name, kept)


def fingerprint(*parts):
    """Hex digest of strings, numbers and arrays."""
    digest = hashlib.sha256()
    for part in parts:
        data = part.tobytes() if hasattr(part, "tobytes") else repr(part).encode()
        digest.update(str(len(data)).encode() + b":" + data)
    return digest.hexdigest()


def set_changed(obj, values):
    """Set the properties that differ: an equal value would touch the object for nothing."""
    for name, value in values.items():
        if getattr(obj, name) != value:
            setattr(obj, name, value)


class Parametric:
    """Base of the proxies. A subclass has PROPERTIES, inputs(), and store()."""

    Type = ""
    PROPERTIES = ()
    _shown = None    # fingerprint of what FemMesh holds, once it was set in this session
    _taking = False  # take() is at work: what changes is no undo
    _kept = None     # fingerprint: FemMesh, for undo
    fault = None     # the HexconError that the last recompute ended with

    def __init__(self, obj):
        obj.Proxy = self
        declare(obj, COMMON + self.PROPERTIES)

    def inputs(self, obj):
        """(fingerprint, job(progress) -> result) of the object's inputs; None: they are gone.

        Called in the window's thread; the job touches no document. Raises HexconError.
        """
        raise NotImplementedError

    def store(self, obj, result):
        """Put a result into the object. Raises HexconError, the object untouched."""
        raise NotImplementedError

    def take(self, obj, result, mark):
        """Store a result that was made from the inputs with this fingerprint."""
        self._keep(obj, obj.MadeFrom if self._shown is None else self._shown)
        self._taking = True
        try:
            self.store(obj, result)
            set_changed(obj, {"MadeFrom": mark, "Status": CURRENT})
            self._shown = mark
        finally:
            self._taking = False

    def _keep(self, obj, mark):
        """Remember the FemMesh under its fingerprint, the last few only."""
        if not mark or not hasattr(obj, "FemMesh") or not obj.Document.UndoMode:
            return
        self._kept = self._kept or {}
        if mark not in self._kept:
            self._kept[mark] = obj.FemMesh.copy()
            for oldest in list(self._kept)[:-MOST_KEPT]:
                del self._kept[oldest]

    def onChanged(self, obj, name):
        """Undo and redo bring the fingerprint back, but not the mesh: FreeCAD writes a new FemMesh
        into the old one, which its undo then no longer has (0.20; later: *unverified*)."""
        if name != "MadeFrom" or self._taking or self._shown in (None, obj.MadeFrom):
            return
        self._keep(obj, self._shown)
        kept = (self._kept or {}).get(obj.MadeFrom)
        if kept is not None:
            obj.FemMesh, self._shown = kept, obj.MadeFrom

    def execute(self, obj):
        """FreeCAD's recompute."""
        try:
            self.fault = None
            self._refresh(obj)
        except HexconError as fault:
            self.fault = fault
            cancelled = fault.code == ErrorCode.CANCELLED
            status = f"{OUTDATED}: cancelled" if cancelled else f"{FAILED}: {fault}"
            self._tell(obj, status)

    def waits_for(self, obj):
        """Why the object cannot be made anew now, though it is not at fault itself; or ""."""
        return ""

    def _refresh(self, obj):
        reason = self.waits_for(obj)
        if reason:
            set_changed(obj, {"Status": f"{OUTDATED}: {reason}"})
            return
        found = self.inputs(obj)
        if found is None:
            if obj.MadeFrom and obj.MadeFrom != "given":
                self._tell(obj, f"{OUTDATED}: what it was made from is gone; it is kept as it is")
            return
        mark, job = found
        if mark == obj.MadeFrom and self._shown in (None, mark):
            set_changed(obj, {"Status": CURRENT})
        elif not obj.AutoUpdate:
            set_changed(obj, {"Status": f"{OUTDATED}: an input changed and AutoUpdate is off; "
                                        "double-click to make it anew"})
        else:
            self.take(obj, wait_for(job, obj), mark)

    @staticmethod
    def _tell(obj, status):
        """In the object and, once, in the report view."""
        if obj.Status != status:
            obj.Status = status
            freecad_compat.freecad().Console.PrintError(f"HexCon: {obj.Label}: {status}. "
                                                        "The old content is kept.\n")

    def onDocumentRestored(self, obj):
        declare(obj, COMMON + self.PROPERTIES)

    def dumps(self):
        return None

    def loads(self, state):
        return None

    # FreeCAD before 0.21.2 calls the pickle names
    __getstate__ = dumps

    def __setstate__(self, state):
        return None


def is_a(obj, proxy_type):
    """Whether a document object is one of ours, of this Type."""
    return getattr(getattr(obj, "Proxy", None), "Type", None) == proxy_type


def new_mesh_object(document, name, solid, proxy, view):
    """A Fem::FemMeshObjectPython with proxy (a class) and view (name of a class in gui.views)."""
    obj = freecad_compat.add_mesh_object(document, name, solid)
    proxy(obj)
    attach_view(obj, view)
    return obj


def solid_shape(solid_object):
    """A copy of the object's shape, where FEM has it, that another thread may use. Raises ToolError(BAD_SHAPE)."""
    shape = freecad_compat.fem_shape_of(solid_object)
    count = len(getattr(shape, "Solids", ()))
    if count != 1:
        raise ToolError(f"{getattr(solid_object, 'Label', solid_object)} holds {count} solids; "
                        "exactly one is needed", FaultCode.BAD_SHAPE)
    # without the triangles that the 3D view left in it: they are no part of the solid
    return shape.copy(True, False)
