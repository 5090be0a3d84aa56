# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads one file by a library, in a process that may die of it; see hexcon.files.reading. Imports nothing of hexcon
but where FreeCAD's modules are needed."""
