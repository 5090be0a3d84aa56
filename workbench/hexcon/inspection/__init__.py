# SPDX-License-Identifier: LGPL-2.1-or-later
"""What there is to see inside a hex mesh and on its surface, in arrays.

Numpy alone: no window, no FreeCAD. The panels of hexcon.gui and hexcon.pictures draw it.
"""
