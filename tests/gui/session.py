# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts share that run inside FreeCAD's window: steps, waiting, clicks, pictures."""
import contextlib
import glob
import os
import subprocess
import threading
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

OUT = os.environ["HEXCON_TEST_OUT"]
WORKERS = ("gmsh_worker", "tetrahedra_worker")
PATIENCE = 120.0  # seconds until something that should happen counts as missing


def say(*what):
    """Print at once, to the file the test shows: FreeCAD takes stdout for itself."""
    with open(os.path.join(OUT, "steps.log"), "a", encoding="utf-8") as log:
        print(*what, file=log)


def wait(condition, what):
    """Let the window live until condition() holds; its value."""
    loop, limit = QtCore.QEventLoop(), time.monotonic() + PATIENCE
    while True:
        QtCore.QTimer.singleShot(20, loop.quit)
        loop.exec_()
        value = condition()
        if value:
            return value
        assert time.monotonic() < limit, f"waited {PATIENCE:g} s in vain: {what}"


def settle():
    """Let the window finish what it has begun."""
    for _ in range(5):
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)


def find(kind, name):
    """A widget of the open HexCon panel, or None."""
    form = FreeCADGui.getMainWindow().findChild(QtGui.QWidget, "HexConPanel")
    return form and form.findChild(kind, name)


def picture(name):
    """A picture of the whole screen (ImageMagick); the 3D view does not show in a grab of the window."""
    settle()
    subprocess.run(["import", "-window", "root", os.path.join(OUT, name)], check=True)


def see_all():
    """All of the active document, from a corner."""
    from hexcon import freecad_compat
    freecad_compat.see_all(FreeCADGui.ActiveDocument.ActiveView)


def select(thing, part=""):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(thing.Document.Name, thing.Name, part)


def words():
    """What the open panel says, as plain text."""
    text = QtGui.QTextDocument()
    text.setHtml(find(QtGui.QLabel, "result").text())
    return text.toPlainText().replace("\u00a0", " ")


def button(name):
    return find(QtGui.QPushButton, name)


def open_panel(command):
    FreeCADGui.runCommand(command)
    wait(lambda: find(QtGui.QLabel, "result"), f"the panel of {command}")


def displacements_by_clicks():
    """From an empty FreeCAD to displacements of the bracket, each click one of the user's; the document."""
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    clicks = 2                                               # the list of workbenches, HexCon
    FreeCADGui.runCommand("HexCon_Example_bracket")
    clicks += 2                                              # the arrow of Examples, Bracket
    doc = FreeCAD.ActiveDocument
    open_panel("HexCon_MeshSolid")
    clicks += 1
    button("mesh").click()
    clicks += 1
    wait(lambda: doc.getObject("HexMesh") and button("mesh").isEnabled() and words(), "the mesh")
    button("solve").click()
    clicks += 1
    wait(lambda: button("run"), "the panel of loads")
    picture("loads.png")
    faces = doc.Bracket.Shape.Faces
    low = min(range(len(faces)), key=lambda k: faces[k].CenterOfMass.z)
    high = max(range(len(faces)), key=lambda k: faces[k].CenterOfMass.z)
    FreeCADGui.Selection.addSelection(doc.Name, "Bracket", f"Face{low + 1}")
    clicks += 1
    button("loaded").click()
    clicks += 1
    FreeCADGui.Selection.addSelection(doc.Name, "Bracket", f"Face{high + 1}")
    clicks += 1
    assert find(QtGui.QLabel, "held_faces").text() == f"Face{low + 1}"
    assert find(QtGui.QLabel, "loaded_faces").text() == f"Face{high + 1}"
    axis = find(QtGui.QComboBox, "axis")
    button("run").click()
    clicks += 1
    wait(words, "CalculiX")
    assert "Solved" in words(), words()
    say(words(), clicks, "clicks", axis.currentText())
    picture("solved.png")
    assert clicks <= 12
    return doc


def close_panel():
    box = FreeCADGui.getMainWindow().findChild(QtGui.QDialogButtonBox)
    box.button(QtGui.QDialogButtonBox.Close).click()
    wait(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")


def start_macro(name="recorded"):
    """Through the recorder's dialog, which has no call of its own."""
    def press():
        dialog = wait(QtGui.QApplication.activeModalWidget, "the macro recorder's dialog")
        dialog.findChild(QtGui.QLineEdit, "lineEditMacroPath").setText(os.path.join(OUT, ""))
        dialog.findChild(QtGui.QLineEdit, "lineEditPath").setText(name)
        dialog.findChild(QtGui.QPushButton, "buttonStart").click()
    QtCore.QTimer.singleShot(0, press)
    FreeCADGui.runCommand("Std_DlgMacroRecord")


def stop_macro():
    """By its own command, or by the one that begins (1.1)."""
    known = FreeCADGui.listCommands()
    FreeCADGui.runCommand("Std_MacroStopRecord" if "Std_MacroStopRecord" in known else "Std_DlgMacroRecord")


def is_idle():
    return button("mesh").isEnabled() and words()


def mesh(size, surface_method="auto", order=1, method="auto", layers=0):
    """Set the open panel's widgets and press Mesh."""
    find(QtGui.QAbstractSpinBox, "size").setProperty("rawValue", size)
    find(QtGui.QSpinBox, "layers").setValue(layers)
    for name, data in (("surface_method", surface_method), ("method", method), ("order", order)):
        box = find(QtGui.QComboBox, name)
        box.setCurrentIndex(box.findData(data))
    button("mesh").click()


def gmsh_runs():
    """Whether a gmsh process of this FreeCAD is alive."""
    for folder in glob.glob("/proc/[0-9]*"):
        try:
            with open(f"{folder}/stat") as stat, open(f"{folder}/cmdline") as line:
                fields = stat.read().rsplit(")", 1)[1].split()
                command = line.read()
                if any(worker in command for worker in WORKERS) and int(fields[1]) == os.getpid():
                    return True
        except OSError:
            pass  # it ended while we looked
    return False


@contextlib.contextmanager
def held_at(stage, module=None, name="mesh_solid"):
    """The next mesh waits in this stage; yields (reached, go on), so no test races the core.

    module, name  where the worker is looked up; None: in the panel of the short road
    """
    from hexcon.gui import mesh_panel
    module = module or mesh_panel
    reached, go_on, real = threading.Event(), threading.Event(), getattr(module, name)

    def slow(*given, progress, **options):
        def report(now, fraction):
            answer = progress(now, fraction)
            if now.partition(", ")[0] == stage and fraction > 0.4:
                reached.set()
                go_on.wait(PATIENCE)
            return answer and progress(now, fraction)
        return real(*given, progress=report, **options)
    setattr(module, name, slow)
    try:
        yield reached, go_on
    finally:
        setattr(module, name, real)


@contextlib.contextmanager
def called_topological():
    """The next meshes of topological methods are certified ones that are called so: what is
    tested is the panel's word, whatever the core makes."""
    from hexcon.gui import mesh_panel
    real = mesh_panel.mesh_solid

    def mesh_solid(shape, size, *, method, **options):
        made = real(shape, size, method="auto", **options)
        made.method, made.topological = method, True
        return made
    mesh_panel.mesh_solid = mesh_solid
    try:
        yield
    finally:
        mesh_panel.mesh_solid = real


def leave(status):
    """FreeCAD's own way out after success. From 1.0 on it asks whether to save what has changed."""
    if status:
        os._exit(status)
    for name in FreeCAD.listDocuments() if int(FreeCAD.Version()[0]) >= 1 else ():
        FreeCADGui.getDocument(name).Modified = False
    QtGui.QApplication.quit()


def run(*steps, end=os._exit):
    """Run the steps once the window is there, then end FreeCAD: status 0 if all passed."""
    def all_steps():
        status = 1
        try:
            wait(FreeCADGui.getMainWindow().isVisible, "FreeCAD's window")
            for step in steps:
                started = time.monotonic()
                step()
                say(f"ok {step.__name__} ({time.monotonic() - started:.1f} s)")
            say("all steps passed")
            status = 0
        except BaseException:
            say(traceback.format_exc())
            with contextlib.suppress(Exception):  # whatever is wrong, FreeCAD must end
                picture("failure.png")
        end(status)
    QtCore.QTimer.singleShot(0, all_steps)
