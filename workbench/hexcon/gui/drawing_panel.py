# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels share that draw in place of their object, as long as they are open."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.document.prepared import prepared
from hexcon_native import HexconError

from . import actions
from .panel import Panel, hourglass


class DrawingPanel(Panel):
    """Reads its object, works out in a thread what there is to draw, and reads again when the mesh changes.

    What it draws, it draws by actions that FreeCAD's macro recorder keeps (as comments, if the user
    wants no matters of the view in macros).
    """

    hide = ""  # the action that ends the drawing

    def __init__(self, mesh_object, title, icon):
        super().__init__(mesh_object, title, icon)
        self.form.destroyed.connect(self._on_destroyed)
        self.read()

    def job(self, mesh_object):
        """Reads the object; returns function() -> what succeed() is to draw, for another thread.

        Raises HexconError."""
        raise NotImplementedError

    def read(self):
        mesh_object = self.about()
        if not self._open or mesh_object is None or self.is_working():
            return
        self.controls.setEnabled(False)
        try:
            with hourglass():
                work = self.job(mesh_object)
        except HexconError as fault:
            self.show_fault(fault)
        else:
            self.begin(lambda progress: work())

    def perform(self, action, result=None, **options):
        """An action of hexcon.gui.actions on the object, recorded."""
        words = "".join(f", {name}={value!r}" for name, value in options.items())
        FreeCADGui.addModule("hexcon.gui.actions")
        with prepared(result):
            FreeCADGui.doCommandGui(f"hexcon.gui.actions.{action}({self.reference()}{words})")

    def close(self):
        if self._open and self.about() is not None:
            self.perform(self.hide)
        super().close()

    def _on_destroyed(self, *_):
        """A macro closed the dialog, and no button."""
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)
            if self.about() is not None:
                getattr(actions, self.hide)(self.about())

    def slotChangedObject(self, thing, name):
        if name == "FemMesh" and (thing.Document.Name, thing.Name) == (self.document_name, self.object_name):
            QtCore.QTimer.singleShot(0, self.read)


def choice_table(name, headings):
    """A table of rows to choose from, one at a time, without row numbers."""
    table = QtGui.QTableWidget(0, len(headings))
    table.setObjectName(name)
    table.setHorizontalHeaderLabels(headings)
    table.horizontalHeader().setStretchLastSection(True)
    table.verticalHeader().hide()
    table.verticalHeader().setDefaultSectionSize(20)
    table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
    table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
    return table


def fill_table(table, rows, colours=()):
    """Rows of words, the first cell of each in front of its colour (3,), if there are any."""
    table.clearContents()
    table.setRowCount(len(rows))
    for row, cells in enumerate(rows):
        for column, text in enumerate(cells):
            item = QtGui.QTableWidgetItem(text)
            if column == 0 and len(colours):
                swatch = QtGui.QPixmap(12, 12)
                swatch.fill(QtGui.QColor.fromRgbF(*map(float, colours[row])))
                item.setIcon(QtGui.QIcon(swatch))
            table.setItem(row, column, item)
    for column in range(table.columnCount() - 1):  # the last one has what is left
        table.resizeColumnToContents(column)
