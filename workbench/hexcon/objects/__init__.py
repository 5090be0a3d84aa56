# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's parametric document objects: quad surface, hex mesh, quality report.

Each module has the proxy class, which saved documents name (never rename or move one), and
makers. Making an object never half-succeeds: the work is done before the document is touched.
hexcon.gui.actions has the calls for macros; these modules work in freecadcmd too.
"""
