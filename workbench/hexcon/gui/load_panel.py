# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel "Hold, load and solve": two clicks on faces, and the displacements."""
import re

import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon import freecad_compat, preferences
from hexcon.calculix.by_names import names_of
from hexcon.errors import FaultCode, ToolError

from . import recording
from .chosen_parts import ChosenParts
from .filling import narrow_box
from .icons import icon_path
from .panel import Panel
from .sizing import in_unit, quantity_box
from .work import in_words

translate = FreeCAD.Qt.translate
COLOURS = {"held": (0.13, 0.35, 0.85), "loaded": (0.9, 0.4, 0.05)}     # of faces and groups that are chosen
AXES = {"x": (1, 0, 0), "-x": (-1, 0, 0), "y": (0, 1, 0), "-y": (0, -1, 0), "z": (0, 0, 1), "-z": (0, 0, -1)}


class LoadPanel(Panel):
    """Faces clicked in the 3D view are held, or loaded, as the upper buttons say."""

    failed = FreeCAD.Qt.QT_TRANSLATE_NOOP("HexCon", "Not solved")
    command = "HexCon_Solve"

    def __init__(self, mesh_object):
        self.solid = freecad_compat.solid_of_mesh_object(mesh_object)
        self.names = self._groups_of(mesh_object)
        self.faces, self.solved = {"held": [], "loaded": []}, False
        self.parts = ChosenParts(self.solid, mesh_object)
        super().__init__(mesh_object, translate("HexCon", "Hold, load and solve"),
                         icon_path("HexCon_Solve"))
        if self.solid is None and not self.names:
            self.solve.setEnabled(False)
            self.result.setText(translate("HexCon", "This mesh has no solid whose faces could be clicked, and no named "
                                                    "groups."))
        elif self.solid is None:
            self.result.setText(translate("HexCon", "This mesh has no solid: choose its groups by name."))
        else:  # its faces must be there to be clicked
            mesh_object.ViewObject.Visibility = False
            self.solid.ViewObject.Visibility = True
        self._advise(mesh_object)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addObserver(self)

    def fill(self, layout):
        advice = QtGui.QLabel(translate("HexCon", "Click faces of the solid in the 3D view"))
        advice.setWordWrap(True)
        layout.addWidget(advice)
        rows = QtGui.QFormLayout()
        self.pick, self.listed = {}, {}
        for kind, text in (("held", translate("HexCon", "Held")), ("loaded", translate("HexCon", "Loaded"))):
            self.pick[kind], self.listed[kind] = QtGui.QPushButton(text), QtGui.QLabel("-")
            self.pick[kind].setObjectName(kind)
            self.pick[kind].setCheckable(True)
            self.pick[kind].setAutoExclusive(True)
            self.listed[kind].setObjectName(f"{kind}_faces")
            self.listed[kind].setWordWrap(True)
            red, green, blue = (round(255 * part) for part in COLOURS[kind])
            self.listed[kind].setStyleSheet(f"color: rgb({red}, {green}, {blue}); font-weight: bold")
            rows.addRow(self.pick[kind], self.listed[kind])
        self.pick["held"].setChecked(True)
        self._make_groups(rows)
        self._make_force(rows)
        layout.addLayout(rows)
        self.solve = QtGui.QPushButton(translate("HexCon", "Solve"))
        self.solve.setObjectName("run")
        self.solve.clicked.connect(self.on_solve)
        layout.addWidget(self.solve)

    def _advise(self, mesh_object):
        """Where the mesh was made here and its hexes are poor."""
        if hasattr(mesh_object, "MethodUsed"):
            self.advice.tell(mesh_object.MethodUsed, int(mesh_object.Order))

    def _groups_of(self, mesh_object):
        """Names of the mesh's groups; without those of CAD faces where the solid's can be clicked."""
        return [name for name in names_of(mesh_object) if self.solid is None or not re.fullmatch(r"Face\d+", name)]

    def _make_groups(self, rows):
        """A choice that holds, or loads, a named group as a click does a face; not there without any."""
        self.groups = narrow_box("groups")
        self.groups.addItem(translate("HexCon", "choose a group"))
        for name in self.names:
            self.groups.addItem(name)
        self.groups.activated.connect(self.on_group)
        if self.names:
            rows.addRow(translate("HexCon", "Groups"), self.groups)

    def on_group(self, place):
        if place > 0:
            self._toggle(self.names[place - 1])
            self.groups.setCurrentIndex(0)

    def _make_force(self, rows):
        self.force = quantity_box("force", "N", preferences.value("Force"))
        self.force.setToolTip(translate("HexCon", "All of it together, shared evenly by what is loaded"))
        self.axis = narrow_box("axis")
        for name, vector in AXES.items():
            self.axis.addItem(translate("HexCon", "along {axis}").format(axis=name), vector)
        self.axis.setCurrentIndex(self.axis.count() - 1)
        rows.addRow(translate("HexCon", "Force"), self.force)
        rows.addRow("", self.axis)

    # FreeCAD's selection observer
    def addSelection(self, document, name, part, position):
        if self.solid is None or (document, name) != (self.document_name, self.solid.Name) \
                or not part.startswith("Face"):
            return
        self._toggle(part)

    def _toggle(self, part):
        """Hold or load a face or a group, as the upper buttons say."""
        kind = "held" if self.pick["held"].isChecked() else "loaded"
        faces = self.faces[kind]
        if part in faces:
            faces.remove(part)  # a second click takes it back
        else:
            faces.append(part)
        self.listed[kind].setText(", ".join(faces) or "-")
        self._show_chosen()

    def _show_chosen(self):
        """All that is held or loaded in its colour, until the panel goes: the selection shows the last click only."""
        self.overlay.show_coloured([(COLOURS[kind], *self.parts.polygons(name))
                                    for kind, names in self.faces.items() for name in names])

    def on_solve(self):
        self.result.clear()
        try:
            self._solve()
        except Exception as error:
            fault = in_words(error)
            self.show_fault(fault)

    def _solve(self):
        for kind, text in (("held", translate("HexCon", "no face is held: press Held and click one")),
                           ("loaded", translate("HexCon", "no face is loaded: press Loaded and click one"))):
            if not self.faces[kind]:
                raise ToolError(text, FaultCode.BAD_OPTION)
        if self.about() is None:
            raise ToolError(translate("HexCon", "the mesh is gone"), FaultCode.BAD_MESH)
        force = in_unit(self.force, "N")
        preferences.set_value("Force", force)
        share = force / len(self.faces["loaded"])
        vector = tuple(share * part for part in self.axis.currentData())
        force = {face: vector for face in self.faces["loaded"]}
        FreeCADGui.Selection.clearSelection()
        result = recording.run("load_and_solve", f"{self.reference()}, {self.faces['held']!r}, {force!r}")
        self.solved = True
        self.overlay.hide()     # it would lie over the displaced mesh
        self.result.setText(translate(
            "HexCon", "<b>Solved.</b> Displacement at most {length:.4g} mm, von Mises stress at most "
            "{stress:.4g} MPa. The analysis in the tree has everything; the FEM workbench changes it.").format(
                length=result.max_displacement, stress=float(result.von_mises.max())))

    def close(self):
        if self._open:
            FreeCADGui.Selection.removeObserver(self)
            mesh_object = self.about()
            if not self.solved and mesh_object is not None and self.solid is not None:
                mesh_object.ViewObject.Visibility = True
                self.solid.ViewObject.Visibility = False
        super().close()
