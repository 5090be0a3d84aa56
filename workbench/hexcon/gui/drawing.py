# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of our own in place of a FEM mesh object's.

They hang in the scene graph of the object's view provider, and FreeCAD's own display is switched off there: the
document, and with it what is saved and undone, knows nothing of them.
"""
import FreeCAD
from pivy import coin

from .nodes import in_object_space

NODE = "HexConDrawing"
NO_CHILD = coin.SO_SWITCH_NONE


class Drawing:
    """A separator in the view of a mesh object; its own display, and that of others, off meanwhile.

    instead_of  more objects that are not to be seen, as the solid that covers its mesh
    """

    def __init__(self, mesh_object, instead_of=()):
        self.mesh_object = mesh_object
        self.root = coin.SoSeparator()
        self.root.setName(NODE)
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE  # FreeCAD would look for our faces among its own
        self.root.addChild(style)
        self.root.addChild(in_object_space(mesh_object))
        mesh_object.ViewObject.RootNode.addChild(self.root)
        self._switched = [(thing, _switch_off(thing)) for thing in (mesh_object, *instead_of)]

    def add(self, node):
        self.root.addChild(node)
        return node

    def instead(self, old, new, group=None):
        """Draw a new node, or None, where an old one, or None, was in the group (else: the root); the new one."""
        group = group or self.root
        if old is not None:
            group.removeChild(old)
        if new is not None:
            group.addChild(new)
        return new

    def remove(self):
        """The view as it was. Objects that are gone took theirs with them."""
        for thing, shown in self._switched:
            view = _view_of(thing)
            if view and view.Visibility and view.SwitchNode.whichChild.getValue() == NO_CHILD:
                view.SwitchNode.whichChild = shown
        self._switched = []
        view = _view_of(self.mesh_object)
        if view and view.RootNode.findChild(self.root) >= 0:
            view.RootNode.removeChild(self.root)


def _view_of(thing):
    """The view provider, or None of an object that is gone."""
    try:
        return thing.ViewObject
    except (ReferenceError, NameError):  # FreeCAD's words for objects and for documents
        return None


def _switch_off(thing):
    """Hide without the property Visibility, which would be saved; what the switch showed."""
    switch = thing.ViewObject.SwitchNode
    shown = switch.whichChild.getValue()
    switch.whichChild = NO_CHILD
    return shown


class Drawings:
    """One kind of drawing, at most one for each object; ends with its object or its mesh.

    Drawings of other kinds of the same object go when one begins: two would hide each other.
    """

    _kinds = []

    def __init__(self):
        self._open = {}
        self._kinds.append(self)

    def find(self, mesh_object):
        return self._open.get(_key(mesh_object))

    def put(self, mesh_object, make):
        """Let make() draw."""
        for kind in self._kinds:
            kind.remove(mesh_object)
        self._open[_key(mesh_object)] = drawing = make()
        _Watcher.begin()
        return drawing

    def remove(self, mesh_object):
        """The view as it was; nothing if it still is."""
        self.forget(_key(mesh_object))

    def forget(self, key):
        drawing = self._open.pop(key, None)
        if drawing is not None:
            drawing.remove()


def _key(thing):
    return thing.Document.Name, thing.Name


class _Watcher:
    """FreeCAD's document observer, from the first drawing on: it must not be taken away while it is called."""

    the_one = None

    @classmethod
    def begin(cls):
        if cls.the_one is None:
            cls.the_one = cls()
            FreeCAD.addDocumentObserver(cls.the_one)

    def slotChangedObject(self, thing, name):
        if name == "FemMesh":
            self.slotDeletedObject(thing)

    def slotDeletedObject(self, thing):
        for kind in Drawings._kinds:
            kind.forget(_key(thing))

    def slotDeletedDocument(self, document):
        for kind in Drawings._kinds:
            for key in [key for key in kind._open if key[0] == document.Name]:
                kind.forget(key)
