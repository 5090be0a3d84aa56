# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels share: progress, words, cancel, and an end with their object."""
from contextlib import contextmanager
from html import escape

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.judging import words
from hexcon.quads.surface import edges_along
from hexcon_native import ErrorCode

from .advice_label import AdviceLabel
from .help_page import ADVICE, HelpKey
from .overlay import Overlay
from .work import Work, in_words

translate = FreeCAD.Qt.translate
STEPS = 1000  # of the progress bar

# Faults whose elements are quads of the surface.
ABOUT_QUADS = {ErrorCode[name] for name in (
    "UNFILLABLE_QUAD", "NOT_SWEPT", "NO_SHEETS", "NOT_DICED", "SELF_CROSSING", "SELF_INTERSECTING", "BAD_PAIRING",
    "NO_SMALL_FILLING") if name in ErrorCode.__members__}

# Faults whose elements are the points of a closed path of edges.
ABOUT_PATHS = {ErrorCode[name] for name in ("NO_HEX_MESH", "NOT_BIPARTITE", "NO_SIDES") if name in ErrorCode.__members__}

# Panels whose work has not ended: a closed one lives until its thread is gone.
_working = set()


@contextmanager
def hourglass():
    """Around what has to be done in the window's thread and may take seconds."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()


class Panel:
    """A FreeCAD task panel about one document object.

    form holds, below what fill() adds: progress (bar), figures (label), cancel (button), result (label).
    """

    failed = ""  # how the words of a fault begin
    command = ""    # whose panel it is: F1 opens that command's page

    def __init__(self, about, title, icon):
        self.document_name, self.object_name = about.Document.Name, about.Name
        self._work = None
        self._open = True
        self.overlay = Overlay(self.document_name)
        self.form = QtGui.QWidget()
        self.form.setObjectName("HexConPanel")
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon))
        layout = QtGui.QVBoxLayout(self.form)
        self.fill(layout)
        self._add_progress(layout)
        self._help = HelpKey(self.form, self.page)
        self._help.watch(self.form)
        FreeCAD.addDocumentObserver(self)

    def fill(self, layout):
        """Add the panel's own widgets above the progress bar."""

    def page(self):
        """What help_page.PAGES has the page of."""
        return ADVICE if self.advice.isVisible() else self.command

    def _add_progress(self, layout):
        self.progress = QtGui.QProgressBar()
        self.progress.setObjectName("progress")
        self.progress.setRange(0, STEPS)
        self.figures = QtGui.QLabel()
        self.figures.setObjectName("figures")
        self.figures.setWordWrap(True)
        self.cancel = QtGui.QPushButton(translate("HexCon", "Cancel"))
        self.cancel.setObjectName("cancel")
        self.cancel.clicked.connect(self.on_cancel)
        self.running = QtGui.QWidget()
        rows = QtGui.QVBoxLayout(self.running)  # side by side the stage's name had no room
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addWidget(self.progress)
        rows.addWidget(self.figures)
        rows.addWidget(self.cancel)
        self.running.hide()
        self.advice = AdviceLabel()
        self.result = QtGui.QLabel()
        self.result.setObjectName("result")
        self.result.setWordWrap(True)
        self.result.setTextFormat(QtCore.Qt.RichText)
        self.result.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(self.running)
        layout.addWidget(self.advice)
        layout.addWidget(self.result)

    # ----------------------------------------------------------------------------------- the work

    def about(self):
        """The document object, or None if it is gone."""
        if self.document_name not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self.document_name).getObject(self.object_name)

    def reference(self):
        """The object as a Python expression, for macros."""
        active = FreeCAD.ActiveDocument
        if active is not None and active.Name == self.document_name:
            document = "FreeCAD.ActiveDocument"  # such a macro is good for other documents too
        else:
            document = f"FreeCAD.getDocument({self.document_name!r})"
        return f"{document}.getObject({self.object_name!r})"

    def select_newest(self):
        """Select what the recorded call has just made, so that the next command takes it."""
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(FreeCAD.getDocument(self.document_name).Objects[-1])

    def add_solve_button(self, layout):
        """A button, hidden, that goes on to the panel of loads with the newest object."""
        def go_on():
            made = FreeCAD.getDocument(self.document_name).Objects[-1]
            self.close()
            from .load_panel import LoadPanel
            QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.showDialog(LoadPanel(made)))
        button = QtGui.QPushButton(translate("HexCon", "Hold, load and solve ..."))
        button.setObjectName("solve")
        button.clicked.connect(go_on)
        button.hide()
        layout.addWidget(button)
        return button

    def is_working(self):
        return self._work is not None

    def begin(self, job):
        """Run job(progress) in a thread; succeed(result) or words of the fault follow."""
        self.result.clear()
        self.overlay.hide()
        self._show_stage("start", 0.0)
        self._set_running(True)
        _working.add(self)
        self._work = Work(job, self._show_stage, self._end)
        self._work.start()

    def succeed(self, result):
        """The work is done, in the window's thread; returns rows of words."""
        raise NotImplementedError

    def on_cancel(self):
        if self._work is not None:
            self.cancel.setEnabled(False)
            self.progress.setFormat(translate("HexCon", "Stopping"))
            self._work.cancel()

    def _end(self, result, fault):
        self._work = None
        _working.discard(self)
        if not self._open:
            return  # the form is FreeCAD's to delete, and gone
        self._set_running(False)
        rows = []
        if fault is None:
            try:
                rows = self.succeed(result)
            except Exception as error:
                fault = in_words(error)
        if fault is None:
            self.result.setText(words.as_html(rows))
        else:
            self.show_fault(fault)

    def show_fault(self, fault):
        """The words of a HexconError, in the panel and in the report view."""
        if fault.code == ErrorCode.CANCELLED:
            self.result.setText(translate("HexCon", "Cancelled. The document is unchanged."))
            return
        failed = translate("HexCon", self.failed)
        FreeCAD.Console.PrintWarning(f"HexCon: {failed}: {fault}\n")
        lines = "<br>".join(escape(str(fault)).splitlines())  # gmsh's last words are several
        self.result.setText(f"<p><b style='color:#b00020'>{escape(failed)}:</b> {lines}</p>"
                            + words.as_html(self._show_quads(fault)))

    def _show_quads(self, fault):
        """Draw the quads at fault, or the path, into the 3D view; rows of words that tell of them."""
        surface = getattr(fault, "surface", None)
        if surface is None or fault.code not in ABOUT_QUADS | ABOUT_PATHS or not fault.elements:
            return []
        FreeCADGui.Selection.clearSelection()  # its green would hide the red
        if fault.code in ABOUT_PATHS:
            self.overlay.show_path(surface.points, edges_along(surface.quads, fault.elements))
            return [(translate("HexCon", "Marked in red"), words.of_path(len(fault.elements)))]
        self.overlay.show(surface.points, surface.quads, fault.elements)
        name = words.of_pairs if fault.code == ErrorCode.SELF_INTERSECTING else words.of_quads
        return [(translate("HexCon", "Marked in red"), name(fault.elements))]

    def _show_stage(self, stage, fraction):
        if self._open and self.cancel.isEnabled():
            self.progress.setValue(int(STEPS * min(max(fraction, 0.0), 1.0)))
            name, figures = words.stage(stage)
            self.progress.setFormat(name)
            self.figures.setText(figures)

    def _set_running(self, running):
        self.running.setVisible(running)
        self.cancel.setEnabled(running)

    # ---------------------------------------------------------------------------------- the dialog

    def getStandardButtons(self):
        close = QtGui.QDialogButtonBox.Close
        return int(getattr(close, "value", close))  # an enum in Qt 6 (*unverified*)

    def isAllowedAlterDocument(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterSelection(self):
        return True

    def reject(self):
        """Close was pressed: stop the work and go."""
        self.close()
        return True

    def close(self):
        if not self._open:
            return
        self._open = False
        self.overlay.hide()
        FreeCAD.removeDocumentObserver(self)
        if self._work is not None:
            self._work.cancel()
        FreeCADGui.Control.closeDialog()

    # FreeCAD's document observer: the panel ends with what it is about
    def slotDeletedDocument(self, document):
        if document.Name == self.document_name:
            QtCore.QTimer.singleShot(0, self.close)

    def slotDeletedObject(self, gone):
        if gone.Name == self.object_name and gone.Document.Name == self.document_name:
            QtCore.QTimer.singleShot(0, self.close)
