# SPDX-License-Identifier: LGPL-2.1-or-later
"""A long job inside FreeCAD's recompute: in a thread, with a dialog that can cancel it."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.judging import words

from .work import Work

translate = FreeCAD.Qt.translate
PATIENCE = 700  # milliseconds before the dialog shows
NEVER = 2 ** 31 - 1


def run(job, name):
    """Result of job(progress); raises the HexconError it ends with, CANCELLED after Cancel.

    The window stays alive but takes no input except Cancel, as the document is being recomputed.
    """
    dialog = _dialog(name)
    loop, ended = QtCore.QEventLoop(), {}

    def on_stage(stage, fraction):
        done, figures = words.stage(stage)
        dialog.setLabelText(f"{name}: {done}\n{figures}")
        dialog.setValue(int(1000 * min(max(fraction, 0.0), 0.999)))

    def on_end(result, fault):
        ended.update(result=result, fault=fault)
        loop.quit()

    work = Work(job, on_stage, on_end)
    dialog.canceled.connect(work.cancel)
    work.start()
    # short jobs without a dialog that flashes up; what is typed and clicked meanwhile waits
    QtCore.QTimer.singleShot(PATIENCE, loop.quit)
    loop.exec_(QtCore.QEventLoop.ExcludeUserInputEvents)
    if not ended:
        dialog.show()
        timer = QtCore.QTimer()
        timer.timeout.connect(lambda: work.cancel() if _pressed(dialog) else None)
        timer.start(20)
        loop.exec_()
        timer.stop()
    dialog.canceled.disconnect(work.cancel)
    dialog.close()
    dialog.deleteLater()
    if ended["fault"] is not None:
        raise ended["fault"]
    return ended["result"]


def _pressed(dialog):
    """Whether the mouse is down on Cancel: FreeCAD swallows all clicks while it recomputes."""
    button = dialog.findChild(QtGui.QPushButton)
    place = button.mapFromGlobal(QtGui.QCursor.pos())
    return QtGui.QApplication.mouseButtons() & QtCore.Qt.LeftButton and button.rect().contains(place)


def _dialog(name):
    dialog = QtGui.QProgressDialog(name, translate("HexCon", "Cancel"), 0, 1000, FreeCADGui.getMainWindow())
    dialog.setObjectName("HexConWaiting")
    dialog.setWindowTitle("HexCon")
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(NEVER)  # of itself: without news it would not show at all
    dialog.setAutoReset(False)
    dialog.setAutoClose(False)
    return dialog
