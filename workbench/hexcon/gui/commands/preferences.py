# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's page in FreeCAD's preferences, there without the core."""
from PySide import QtGui

from .missing_core import how_to_build


class PreferencesPage:
    """FreeCAD's preferences show this; without the core it says how to build it."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self._load = self._save = lambda: None
        try:
            from hexcon.gui.preferences_page import build
        except ImportError as fault:
            QtGui.QVBoxLayout(self.form).addWidget(QtGui.QLabel(how_to_build(fault)))
        else:
            self._load, self._save = build(self.form)

    def loadSettings(self):
        self._load()

    def saveSettings(self):
        self._save()
