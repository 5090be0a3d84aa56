# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls that make and change document objects, each one undo step and all or nothing; they need no window.

hexcon.gui.actions offers them to macros under names that stay.
"""
