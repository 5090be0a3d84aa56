# SPDX-License-Identifier: LGPL-2.1-or-later
"""What document objects want of FreeCAD's window, where there is one.

Nothing below the window imports it: its parts are named here, as FreeCAD names view providers in saved documents.
"""
import importlib

VIEWS, WAITING, DISPLACEMENT = "hexcon.gui.views", "hexcon.gui.waiting", "hexcon.gui.displacement"


def is_shown(obj):
    """Whether the object's document has a window."""
    return getattr(obj, "ViewObject", None) is not None


def attach_view(obj, view):
    """Give the object its view provider, by the name of its class in gui.views, where there is a window."""
    if is_shown(obj):
        getattr(importlib.import_module(VIEWS), view)(obj.ViewObject)


def wait_for(job, obj):
    """Result of job(progress) about an object: in the window with a progress dialog."""
    return waiting()(job, obj.Label) if is_shown(obj) else job(None)


def waiting():
    """function(job, name) -> job's result, with a progress dialog. Only where there is a window."""
    return importlib.import_module(WAITING).run


def show_displacement(result_object):
    """Draw a result's mesh bent, coloured by displacement; returns the factor. Only where there is a window."""
    return importlib.import_module(DISPLACEMENT).show(result_object)
