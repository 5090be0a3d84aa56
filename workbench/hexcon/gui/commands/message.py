# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box with words that stops nobody."""
import FreeCADGui
from PySide import QtCore, QtGui


def show_message(name, message):
    """A box with the words that stops nobody; the older one of the same name goes."""
    for old in FreeCADGui.getMainWindow().findChildren(QtGui.QMessageBox, name):
        old.close()
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "HexCon", message, QtGui.QMessageBox.Ok,
                            FreeCADGui.getMainWindow())
    box.setObjectName(name)
    box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setWindowModality(QtCore.Qt.NonModal)
    box.show()
