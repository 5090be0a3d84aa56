# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Hex mesh from solid"."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon import preferences
from hexcon.document.making_quads import default_size, last_size
from hexcon.document.prepared import prepared
from hexcon.errors import FaultCode, ToolError
from hexcon.judging import words
from hexcon.meshing import mesh_solid
from hexcon.objects.parametric import solid_shape
from hexcon.objects.quad_surface import TIMEOUT
from hexcon.topological import is_topological

from . import last_used
from .filling import Filling, choose, guess, written
from .icons import icon_path
from .panel import Panel, hourglass
from .sizing import method_box, size_box

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class MeshPanel(Panel):
    """Size, methods, layers and order; a certified mesh in the document, or the reason why not."""

    failed = QT_TRANSLATE_NOOP("HexCon", "No mesh")
    command = "HexCon_MeshSolid"

    def __init__(self, solid):
        self._shape = solid.Shape
        super().__init__(solid, translate("HexCon", "Hex mesh from solid"),
                         icon_path("HexCon_MeshSolid"))
        self._estimate()

    def fill(self, layout):
        rows = QtGui.QFormLayout()
        rows.setHorizontalSpacing(4)
        rows.addRow(translate("HexCon", "Solid"), QtGui.QLabel(self.about().Label))
        self.size = size_box(last_size(self.about()) or default_size(self._shape), self._estimate)
        self.expected = QtGui.QLabel()
        self.expected.setObjectName("expected")
        self.expected.setWordWrap(True)
        self.surface_method = method_box()
        choose(self.surface_method, last_used.value("SurfaceMethod"))
        self.filling = Filling(self._estimate)
        self.filling.show_settings(last_used.value("Method"), 0, last_used.value("Order"), 0)
        self.mesh = QtGui.QPushButton(translate("HexCon", "Mesh"))
        self.mesh.setObjectName("mesh")
        self.mesh.clicked.connect(self.on_mesh)
        rows.addRow(translate("HexCon", "Size"), self.size)
        rows.addRow("", self.expected)
        rows.addRow(translate("HexCon", "Surface"), self.surface_method)
        self.filling.add_to(rows)
        layout.addLayout(rows)
        layout.addWidget(self.mesh)
        self.solve = self.add_solve_button(layout)

    def _settings(self):
        return {"size": float(self.size.property("rawValue")),
                "surface_method": self.surface_method.currentData(), **self.filling.settings()}

    def _estimate(self, *_):
        settings = self._settings()
        size = settings["size"]
        if size <= 0.0:
            self.expected.clear()
            return
        hexes_a_quad = self.filling.hexes_a_quad(settings["surface_method"])
        natural = guess(self._shape.Volume / size ** 3)
        by_quads = guess(self._shape.Area / size ** 2 * hexes_a_quad) if hexes_a_quad else natural
        open_choice = settings["method"] == settings["surface_method"] == "auto" and not settings["layers"]
        text = (translate("HexCon", "at least about {natural} hexes in sweeps and blocks, several times as many where "
                                    "holes and thin walls are smaller than the size; about {count} otherwise")
                if open_choice
                else translate("HexCon", "about {count} hexes"))
        self.expected.setText(text.format(natural=natural, count=by_quads))

    def start(self):
        """As the button does."""
        self.on_mesh()

    def on_mesh(self):
        self.advice.hide()
        self._used = self._settings()
        self._allowed = self.filling.allowed()
        solid = self.about()
        try:
            self.filling.refuse_topological()
            shape = solid_shape(solid)
        except ToolError as fault:
            self.show_fault(fault)
            return
        self._shape = solid.Shape
        options = dict(self._used, timeout=TIMEOUT, threads=preferences.value("Threads"))
        self.begin(lambda progress: mesh_solid(shape, progress=progress, **options))

    def _set_running(self, running):
        super()._set_running(running)
        for widget in (self.size, self.surface_method, self.mesh):
            widget.setEnabled(not running)
        self.filling.enable(not running)

    def succeed(self, result):
        """Put the mesh into the document by the call that the macro recorder keeps."""
        solid = self.about()
        if solid is None or not solid.Shape.isSame(self._shape):
            raise ToolError(translate(
                "HexCon", "the solid changed while it was meshed; press Mesh again"),
                FaultCode.BAD_SHAPE)
        used = self._used
        FreeCADGui.addModule("hexcon.gui.actions")
        with hourglass(), prepared(result):
            FreeCADGui.doCommand(
                f"hexcon.gui.actions.mesh_solid_object({self.reference()}, {used['size']!r}, "
                f"surface_method={used['surface_method']!r}, {written(used, self._allowed)})")
        self.select_newest()
        self.filling.remember(used["surface_method"])
        self.advice.tell(result.method, result.order, used["size"])
        self.solve.setVisible(not is_topological(result))
        rows = words.of_mesh(result)
        FreeCAD.Console.PrintMessage(f"HexCon: {words.as_text(rows)}\n")
        return rows
