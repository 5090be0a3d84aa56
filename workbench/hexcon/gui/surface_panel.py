# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a quad surface: preview it with its counts, then make or update the object."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon.document.making_quads import default_size
from hexcon.document.prepared import prepared
from hexcon.freecad_compat import shape_of
from hexcon.judging import words
from hexcon.objects import quad_surface
from hexcon_native import HexconError

from . import last_used
from .filling import choose
from .icons import icon_path
from .panel import Panel, hourglass
from .sizing import method_box, size_box

translate = FreeCAD.Qt.translate


class SurfacePanel(Panel):
    """About a solid, or another mesh, for a new surface; about a quad surface object, to change it."""

    failed = FreeCAD.Qt.QT_TRANSLATE_NOOP("HexCon", "No quads")
    command = "HexCon_QuadSurface"

    def __init__(self, about):
        self.edited = quad_surface.is_quad_surface(about)
        self.source = about.Source if self.edited else about
        self._made = self._used = None
        super().__init__(about, translate("HexCon", "Quad surface"),
                         icon_path("HexCon_QuadSurface"))

    def fill(self, layout):
        rows = QtGui.QFormLayout()
        rows.setHorizontalSpacing(4)
        about = self.about()
        solid = shape_of(self.source) is not None
        rows.addRow(translate("HexCon", "From"), QtGui.QLabel(_origin(about, self.source)))
        size = about.Size.Value if self.edited else default_size(about.Shape) if solid else 1.0
        self.size, self.method = size_box(size, self._outdated), method_box()
        choose(self.method, about.Method if self.edited else last_used.value("SurfaceMethod"))
        self.method.currentIndexChanged.connect(self._outdated)
        if solid:
            rows.addRow(translate("HexCon", "Size"), self.size)
            rows.addRow(translate("HexCon", "Method"), self.method)
        layout.addLayout(rows)
        self.preview = self._button("preview", translate("HexCon", "Preview"), self.on_preview, layout)
        self.make = self._button("mesh", translate("HexCon", "Update quads") if self.edited else
                                 translate("HexCon", "Make quads"), self.on_make, layout)

    def _button(self, name, text, action, layout):
        button = QtGui.QPushButton(text)
        button.setObjectName(name)
        button.clicked.connect(action)
        layout.addWidget(button)
        return button

    def _settings(self):
        if shape_of(self.source) is None:
            return {}
        return {"size": float(self.size.property("rawValue")), "method": self.method.currentData()}

    def _inputs(self):
        """job_of's arguments for what the widgets say."""
        about = self.about()
        kept = {"source": self.source}
        if self.edited:
            kept.update(file=about.File, example=about.Example, local_sizes=list(about.LocalSizes),
                        per_turn=about.PerTurn, scale=about.Scale, merge_tolerance=about.MergeTolerance.Value)
        return {**kept, **self._settings()}

    def _outdated(self, *_):
        """What the preview shows is no longer what would be made."""
        if self.overlay.visible():
            self.overlay.hide()
            self.result.clear()

    def on_preview(self):
        self._start(False)

    def start(self):
        """As its button that makes the object does, for whoever has opened it."""
        self.on_make()

    def on_make(self):
        self._start(True)

    def _start(self, keep):
        """Make the quads, unless the preview has made them; then show or keep them."""
        self._keep = keep
        try:
            used = self._inputs()
            found = quad_surface.job_of(**used)
        except HexconError as fault:
            self.show_fault(fault)
            return
        if found is None:
            self.result.setText(translate("HexCon", "What the quads were made from is gone; they "
                                                    "stay as they are."))
            return
        mark, job = found
        if self._made is not None and self._made[0] == mark:
            self.finish(self._made[1])
        else:
            self.begin(lambda progress: (mark, job(progress)))

    def succeed(self, result):
        self._made = result
        return self._rows(result[1])

    def finish(self, surface):
        """The preview's quads become the object's: no work is left."""
        try:
            self.result.setText(words.as_html(self._rows(surface)))
        except HexconError as fault:
            self.show_fault(fault)

    def _rows(self, surface):
        facts = quad_surface.facts_of(surface)
        if self._keep:
            self._record(surface)
        else:
            FreeCADGui.Selection.clearSelection()  # its green would shine through
            self.overlay.show(surface.points, surface.quads)
        return words.of_surface(surface, facts)

    def _record(self, surface):
        """Make or update the object by the call that the macro recorder keeps."""
        said = "".join(f", {name}={value!r}" for name, value in self._settings().items())
        FreeCADGui.addModule("hexcon.gui.actions")
        call = "update_quad_surface" if self.edited else "make_quad_surface"
        self.overlay.hide()
        with hourglass(), prepared(surface):
            FreeCADGui.doCommand(f"hexcon.gui.actions.{call}({self.reference()}{said})")
        if not self.edited:
            self.select_newest()

    def _set_running(self, running):
        super()._set_running(running)
        for widget in (self.size, self.method, self.preview, self.make):
            widget.setEnabled(not running)


def _origin(about, source):
    """What the quads come from, in one word."""
    if source is not None:
        return source.Label
    return os.path.basename(getattr(about, "File", "")) or getattr(about, "Example", "")
