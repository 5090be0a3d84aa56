# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialogs that choose a mesh file: a filter a format, and the folder and format of the last time."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon import preferences
from hexcon.files import WRITERS, ending_of
from hexcon.files.formats import FORMATS
from hexcon.quads.files import MESH_ENDINGS

translate = FreeCAD.Qt.translate


def _filters(formats):
    """{filter of a file dialog: row of FORMATS}."""
    return {f"{row.name} ({' '.join('*' + ending for ending in row.endings)})": row for row in formats}


def export_filters():
    """{filter: row} of all formats that a hex mesh can be written in; a document is saved, not exported."""
    return _filters([row for row in FORMATS if row.endings[0] in WRITERS and row.endings != (".fcstd",)])


def with_ending(path, row):
    """The path as typed, with the format's ending where it has none that is known."""
    return path if ending_of(path) in WRITERS else path + row.endings[0]


def choose_export(mesh_object, title):
    """A path to write the mesh to, or ""."""
    filters = export_filters()
    last = next((one for one, row in filters.items() if row.name == preferences.value("ExportFormat")), "")
    path, chosen = QtGui.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), title, os.path.join(preferences.value("Folder"), mesh_object.Label),
        ";;".join(filters), last)
    if not path:
        return ""
    row = filters.get(chosen, next(iter(filters.values())))
    preferences.set_value("Folder", os.path.dirname(path))
    preferences.set_value("ExportFormat", row.name)
    return with_ending(path, row)


def choose_import(title):
    """A path to read quads from, or ""."""
    everything = translate("HexCon", "Meshes ({endings})").format(endings=" ".join(f"*{e}" for e in MESH_ENDINGS))
    rows = _filters([row for row in FORMATS if any(ending in MESH_ENDINGS for ending in row.endings)])
    path, _ = QtGui.QFileDialog.getOpenFileName(
        FreeCADGui.getMainWindow(), title, preferences.value("Folder"), ";;".join([everything, *rows]))
    if path:
        preferences.set_value("Folder", os.path.dirname(path))
    return path
