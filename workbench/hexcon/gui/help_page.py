# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's pages in a window of their own: F1 in a panel, or on an entry of a menu, opens the one that tells of it."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .icons import FOLDER

translate = FreeCAD.Qt.translate
DOCS = os.path.join(os.path.dirname(os.path.dirname(FOLDER)), "docs")

ADVICE = "advice"     # stands for a command where a mesh disappoints

# command: (page, the heading to begin at)
PAGES = {
    "HexCon_MeshSolid": ("guide.md", "From a solid to a hex mesh"),
    "HexCon_QuadSurface": ("guide.md", "Quads first"), "HexCon_HexMesh": ("guide.md", "Quads first"),
    "HexCon_Import": ("files.md", ""), "HexCon_Export": ("files.md", ""),
    "HexCon_Check": ("architecture.md", "What a certificate proves"),
    "HexCon_Inspect": ("guide.md", "Is it a good mesh?"), "HexCon_Loops": ("guide.md", "Dual loops"),
    "HexCon_Quality": ("guide.md", "Is it a good mesh?"), "HexCon_Repair": ("files.md", "Repair"),
    "HexCon_IntoAnalysis": ("guide.md", "Hold, load and solve"), "HexCon_Solve": ("guide.md", "Hold, load and solve"),
    "HexCon_Examples": ("guide.md", ""), ADVICE: ("design.md", "")}


class HelpPage(QtGui.QTextBrowser):
    """One window; its links lead to the other pages, and to the browser where they leave the addon."""

    def __init__(self):
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("HexConHelp")
        self.setWindowFlags(QtCore.Qt.Window)
        self.setWindowTitle(translate("HexCon", "HexCon help"))
        self.setOpenLinks(False)
        self.anchorClicked.connect(self._follow)
        self.resize(760, 640)
        self.page = ""

    def open(self, page, heading=""):
        """Show docs/<page>, from a heading on, or from its beginning."""
        self.show()     # before the text, whose lines are as long as the window is wide
        self.raise_()
        self.page = page
        with open(os.path.join(DOCS, page), encoding="utf-8") as stream:
            self.document().setMarkdown(stream.read())
        self.moveCursor(QtGui.QTextCursor.Start)
        if heading and self.find(heading):
            self.verticalScrollBar().setValue(self.verticalScrollBar().value() + self.cursorRect().top())

    def loadResource(self, kind, url):
        """Qt's: pictures beside the page, no wider than the window."""
        path = os.path.join(DOCS, os.path.dirname(self.page), url.path())
        if kind != QtGui.QTextDocument.ImageResource or not os.path.exists(path):
            return super().loadResource(kind, url)
        image = QtGui.QImage(path)
        return image.scaledToWidth(min(image.width(), self.viewport().width() - 30), QtCore.Qt.SmoothTransformation)

    def _follow(self, url):
        path, fragment = url.path(), url.fragment()
        if url.scheme() or not (path or self.page).endswith(".md"):
            QtGui.QDesktopServices.openUrl(url)
            return
        page = os.path.normpath(os.path.join(os.path.dirname(self.page), path)) if path else self.page
        if os.path.exists(os.path.join(DOCS, page)):
            self.open(page, fragment.replace("-", " "))


def show_page(command):
    """Open the page of a command; the one of the guide where it has none."""
    window = FreeCADGui.getMainWindow()
    page = window.findChild(HelpPage, "HexConHelp") or HelpPage()
    page.open(*PAGES.get(command, ("guide.md", "")))
    return page


class HelpKey(QtCore.QObject):
    """F1 for widgets: where the focus is in one of them, FreeCAD's own shortcut for it is overridden."""

    def __init__(self, parent, page_of):
        super().__init__(parent)
        self._page_of = page_of

    def watch(self, widget):
        """The widget, and all that it holds now."""
        for one in (widget, *widget.findChildren(QtGui.QWidget)):
            one.installEventFilter(self)

    def eventFilter(self, widget, event):
        """Qt's: True where the event is done with."""
        kind = event.type()
        if kind not in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress) or event.key() != QtCore.Qt.Key_F1:
            return False
        command = self._page_of()
        if command is None:
            return False
        if kind == QtCore.QEvent.KeyPress:
            show_page(command)
        event.accept()
        return True
