# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the calls share that make document objects and make them anew."""
from hexcon import freecad_compat


def update(obj, result, mark, settings, set_settings):
    """Give an object settings and what was made by them, in one undo step, then what is made from it."""
    with freecad_compat.transaction(obj.Document, f"Update {obj.Label}"):
        set_settings(obj, settings)
        obj.Proxy.take(obj, result, mark)
        obj.Document.recompute()


def hide(*objects):
    """Not to be seen any more, as something made from them covers them."""
    for thing in objects:
        if getattr(thing, "ViewObject", None) is not None:
            thing.ViewObject.Visibility = False
