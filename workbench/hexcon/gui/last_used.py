# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel begins with: what was used last in this session, if the user wants that, else the preferences.

Not for longer: a method chosen for one part would be taken, unseen, for another one a week later.
"""
from hexcon import preferences

_used = {}


def value(name):
    """Of SurfaceMethod, Method and Order, as preferences.value."""
    return _used.get(name, preferences.value(name)) if preferences.value("Remember") else preferences.value(name)


def keep(**used):
    """{name: value} of what has just made a mesh."""
    _used.update(used)
