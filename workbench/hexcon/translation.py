# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts for people, in their language where FreeCAD runs; in English without it."""
import sys


def translate(context, text):
    """FreeCAD.Qt.translate; scripts/translations.py collects the texts by this name."""
    freecad = sys.modules.get("FreeCAD")
    return freecad.Qt.translate(context, text) if freecad else text


def QT_TRANSLATE_NOOP(context, text):  # Qt's name
    """The text as it is, to be translated where it is shown."""
    return text
