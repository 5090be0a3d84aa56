# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts share that run inside FreeCAD's window: steps, waiting, pictures, the end."""
import os
import subprocess
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

OUT = os.environ["HEXCON_TEST_OUT"]
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
    """A picture of the whole screen; the 3D view does not show in a grab of the window."""
    settle()
    path = os.path.join(OUT, name)
    if subprocess.run(["import", "-window", "root", path], check=False).returncode:
        FreeCADGui.getMainWindow().grab().save(path)


def run(*steps):
    """Run the steps once the window is there, then end FreeCAD: status 0 if all passed."""
    def all_steps():
        status = 1
        try:
            wait(FreeCADGui.getMainWindow().isVisible, "FreeCAD's window")
            for step in steps:
                started = time.monotonic()
                step()
                say(f"ok {step.__name__} ({time.monotonic() - started:.1f} s)")
            status = 0
        except BaseException:
            say(traceback.format_exc())
            picture("failure.png")
        os._exit(status)
    QtCore.QTimer.singleShot(0, all_steps)
