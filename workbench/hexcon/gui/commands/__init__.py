# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, and what they say where the native core is missing.

InitGui.py loads this folder by its path, as a package of its own outside hexcon: it imports nothing
of HexCon before a command runs.
"""
from .missing_core import core_is_there
from .preferences import PreferencesPage
from .registration import in_context_menu, join_freecad, register

__all__ = ["PreferencesPage", "core_is_there", "in_context_menu", "join_freecad", "register"]
