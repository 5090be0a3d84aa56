# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a hex mesh: fill a quad surface, or fill it anew in another way."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon.document.prepared import prepared
from hexcon.errors import FaultCode, ToolError
from hexcon.judging import words
from hexcon.objects import hex_mesh
from hexcon_native import HexconError

from . import last_used
from .filling import Filling, guess, written
from .icons import icon_path
from .panel import Panel, hourglass

translate = FreeCAD.Qt.translate


class HexMeshPanel(Panel):
    """About a quad surface, for a new mesh; about a hex mesh object, to change it."""

    failed = FreeCAD.Qt.QT_TRANSLATE_NOOP("HexCon", "No mesh")
    command = "HexCon_HexMesh"

    def __init__(self, about):
        self.edited = hex_mesh.is_hex_mesh(about)
        self.surface = about.Surface if self.edited else about
        super().__init__(about, translate("HexCon", "Hex mesh"),
                         icon_path("HexCon_HexMesh"))
        self._estimate()

    def fill(self, layout):
        rows = QtGui.QFormLayout()
        rows.setHorizontalSpacing(4)
        rows.addRow(translate("HexCon", "Surface"), QtGui.QLabel(
            translate("HexCon", "{name}, {quads} quads").format(
                name=self.surface.Label, quads=words.count(self.surface.Quads))))
        self.expected = QtGui.QLabel()
        self.expected.setWordWrap(True)
        self.filling = Filling(self._estimate)
        self.filling.add_to(rows)
        if self.edited:
            mesh = self.about()
            self.filling.show_settings(mesh.Method, mesh.Layers, int(mesh.Order), mesh.Budget,
                                       mesh.AllowTopological, mesh.Pillow)
        else:
            self.filling.show_settings(last_used.value("Method"), 0, last_used.value("Order"), 0)
        rows.addRow("", self.expected)
        layout.addLayout(rows)
        self.mesh = QtGui.QPushButton(translate("HexCon", "Mesh anew") if self.edited else
                                      translate("HexCon", "Mesh"))
        self.mesh.setObjectName("mesh")
        self.mesh.clicked.connect(self.on_mesh)
        layout.addWidget(self.mesh)

    def _estimate(self):
        """How many hexes to expect, where that depends on the quads alone."""
        a_quad = self.filling.hexes_a_quad(self.surface.MethodUsed)
        if not a_quad:
            self.expected.clear()
            return
        self.expected.setText(translate("HexCon", "about {count} hexes").format(
            count=guess(a_quad * self.surface.Quads)))

    def start(self):
        """As its button that makes the object does, for whoever has opened it."""
        self.on_mesh()

    def on_mesh(self):
        self.advice.hide()
        self._used, self._allowed = self.filling.settings(), self.filling.allowed()
        try:
            self.filling.refuse_topological()
            self._mark, job = self._job()
        except HexconError as fault:
            self.show_fault(fault)
            return
        self.begin(job)

    def _job(self):
        return hex_mesh.job_of(self.surface, **self._used, allow_topological=self._allowed,
                               try_other_surfaces=self.edited and self.about().TryOtherSurfaces)

    def succeed(self, result):
        """Put the mesh into the document by the call that the macro recorder keeps."""
        if self.about() is None or self._job()[0] != self._mark:
            raise ToolError(translate(
                "HexCon", "the quads changed while they were filled; press Mesh again"),
                FaultCode.BAD_SHAPE)
        said = written(self._used, self._allowed or self.edited and self.about().AllowTopological)
        if self.edited:
            said = said.replace("allow_topological=True", f"allow_topological={self._allowed!r}")
            said += "" if self._used["pillow"] != "auto" else ", pillow='auto'"
            said += "" if self._used["budget"] else ", budget=0.0"
        call = "update_hex_mesh" if self.edited else "make_hex_mesh"
        FreeCADGui.addModule("hexcon.gui.actions")
        with hourglass(), prepared(result):
            FreeCADGui.doCommand(f"hexcon.gui.actions.{call}({self.reference()}, {said})")
        if not self.edited:
            self.select_newest()
        self.filling.remember()
        self.advice.tell(result.method, result.order, self.surface.Size.Value)
        return words.of_mesh(result)

    def _set_running(self, running):
        super()._set_running(running)
        self.mesh.setEnabled(not running)
        self.filling.enable(not running)
