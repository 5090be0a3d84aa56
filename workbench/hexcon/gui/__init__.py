# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon in FreeCAD's window.

actions.py is what it does, one documented call each, and works in freecadcmd too; the folder
commands puts it into menus, the panels show it.
"""
