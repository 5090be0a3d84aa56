# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse of the X server itself (XTest), where events made in Qt would not show what a user meets.

Qt's places on the screen are the server's but for the scale that it draws in.
"""
import ctypes
import ctypes.util

from PySide import QtCore, QtGui

LEFT = 1


def _library(name):
    found = ctypes.util.find_library(name)
    assert found, f"lib{name} is missing (Debian: apt install lib{name.lower()}6)"
    return ctypes.CDLL(found)


class Mouse:
    """Moved and pressed as by hand."""

    def __init__(self):
        self._x11, self._test = _library("X11"), _library("Xtst")
        self._x11.XOpenDisplay.restype = ctypes.c_void_p
        self._screen = ctypes.c_void_p(self._x11.XOpenDisplay(None))
        assert self._screen, "no X server"

    def move_to(self, widget):
        """To the middle of a widget."""
        place = widget.mapToGlobal(widget.rect().center())
        scale = QtGui.QApplication.screens()[0].devicePixelRatio()
        self._test.XTestFakeMotionEvent(self._screen, -1, round(scale * place.x()), round(scale * place.y()),
                                        ctypes.c_ulong(0))
        self._x11.XFlush(self._screen)

    def _button(self, down):
        self._test.XTestFakeButtonEvent(self._screen, LEFT, int(down), ctypes.c_ulong(0))
        self._x11.XFlush(self._screen)

    def click(self, widget, milliseconds=150):
        """Press on the middle of a widget, and let go that much later; returns at once."""
        self.move_to(widget)
        self._button(True)
        QtCore.QTimer.singleShot(milliseconds, lambda: self._button(False))
