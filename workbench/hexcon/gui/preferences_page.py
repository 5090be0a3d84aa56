# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's page in FreeCAD's preferences. InitGui.py registers it by way of the folder commands."""
from html import escape

import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon import packages, preferences
from hexcon.judging import words
from hexcon.quads import METHOD_TABLE as SURFACE_METHOD_TABLE
from hexcon_native import METHOD_CHOICES, METHOD_TABLE, HexconError

from . import filling, waiting
from .setup_check import check_setup

translate = FreeCAD.Qt.translate
FEM_CCX = "User parameter:BaseApp/Preferences/Mod/Fem/Ccx"  # one truth: the FEM workbench's


def build(form):
    """Fill the page's widget; returns functions (load, save)."""
    form.setWindowTitle(translate("HexCon", "General"))
    layout = QtGui.QVBoxLayout(form)
    programs, fields = QtGui.QFormLayout(), _fields()
    programs.addRow(translate("HexCon", "Python with gmsh (empty: sought)"), fields["GmshPython"])
    programs.addRow(translate("HexCon", "CalculiX, ccx (empty: sought)"), fields["ccx"])
    programs.addRow(translate("HexCon", "Threads"), fields["Threads"])
    layout.addWidget(_group(translate("HexCon", "Programs"), programs))
    defaults = QtGui.QFormLayout()
    defaults.addRow(translate("HexCon", "Surface"), fields["SurfaceMethod"])
    defaults.addRow(translate("HexCon", "Method"), fields["Method"])
    defaults.addRow(translate("HexCon", "Order"), fields["Order"])
    defaults.addRow(fields["Remember"])
    defaults.addRow(fields["FemMenu"])
    layout.addWidget(_group(translate("HexCon", "Defaults of the panels"), defaults))
    found = QtGui.QLabel()
    found.setObjectName("setup")
    found.setWordWrap(True)
    button = QtGui.QPushButton(translate("HexCon", "Check what is there"))
    button.setObjectName("check_setup")

    getter = QtGui.QPushButton(translate("HexCon", "Get gmsh for FreeCAD's Python"))
    getter.setObjectName("get_gmsh")
    getter.setVisible(False)

    def check():
        _save(fields)
        findings = check_setup()
        found.setText(findings_in_words(findings))
        getter.setVisible(any(finding.name == "gmsh" and not finding.present for finding in findings))

    def get():
        try:
            waiting.run(packages.install, getter.text())
        except HexconError as fault:
            found.setText(escape(str(fault)))
            return
        check()
    button.clicked.connect(check)
    getter.clicked.connect(get)
    layout.addWidget(button)
    layout.addWidget(getter)
    layout.addWidget(found)
    layout.addStretch()
    return lambda: _load(fields), lambda: _save(fields)


def _group(title, layout):
    box = QtGui.QGroupBox(title)
    box.setLayout(layout)
    return box


def _fields():
    solved = [METHOD_TABLE[name] for name in METHOD_CHOICES if not METHOD_TABLE[name].topological]
    threads = QtGui.QSpinBox()
    threads.setRange(0, 1024)
    threads.setSpecialValueText(translate("HexCon", "one per processor"))
    fields = {"GmshPython": _file_field(), "ccx": _file_field(), "Threads": threads,
              "SurfaceMethod": filling.choice_of_methods("SurfaceMethod", list(SURFACE_METHOD_TABLE.values())),
              "Method": filling.choice_of_methods("Method", solved),
              "Order": filling.choice_of("Order", words.ORDERS, words.ORDERS),
              "Remember": QtGui.QCheckBox(translate("HexCon", "Panels begin with what was used last")),
              "FemMenu": QtGui.QCheckBox(translate("HexCon", "HexCon's menu in the FEM workbench too"))}
    for name, field in fields.items():
        field.setObjectName(name)
    return fields


def _file_field():
    """FreeCAD's field for a path, with a button that chooses the file."""
    return FreeCADGui.UiLoader().createWidget("Gui::FileChooser")


PROGRAMS = ("GmshPython", "ccx")     # names of the fields of files


def _load(fields):
    for name, field in fields.items():
        value = _ccx() if name == "ccx" else preferences.value(name)
        if name in PROGRAMS:
            field.setProperty("fileName", value)
        elif isinstance(field, QtGui.QSpinBox):
            field.setValue(value)
        elif isinstance(field, QtGui.QCheckBox):
            field.setChecked(value)
        else:
            filling.choose(field, value)


def _save(fields):
    for name, field in fields.items():
        if name == "ccx":
            _set_ccx(str(field.property("fileName")).strip())
        elif name in PROGRAMS:
            preferences.set_value(name, str(field.property("fileName")).strip())
        elif isinstance(field, QtGui.QSpinBox):
            preferences.set_value(name, field.value())
        elif isinstance(field, QtGui.QCheckBox):
            preferences.set_value(name, field.isChecked())
        else:
            preferences.set_value(name, field.currentData())


def _ccx():
    group = FreeCAD.ParamGet(FEM_CCX)
    return "" if group.GetBool("UseStandardCcxLocation", True) else group.GetString("ccxBinaryPath", "")


def _set_ccx(path):
    if path != _ccx():
        group = FreeCAD.ParamGet(FEM_CCX)
        group.SetBool("UseStandardCcxLocation", not path)
        group.SetString("ccxBinaryPath", path)


def findings_in_words(findings):
    """What check_setup found, as rich text."""
    lines = []
    for finding in findings:
        mark = "<b style='color:#2e7d32'>\u2713</b>" if finding.present else "<b style='color:#b00020'>\u2717</b>"
        lines.append(f"{mark} <b>{escape(finding.name)}</b>: {escape(finding.words)}")
    return "<br>".join(lines)
