# SPDX-License-Identifier: LGPL-2.1-or-later
"""A framed label in a panel that says what would help where a mesh disappoints; not there where it does not."""
from PySide import QtCore, QtGui

from hexcon.judging import words
from hexcon.judging.advice import of_poor_hexes

# Readable in light and in dark themes: its own ground and its own letters.
STYLE = "QLabel { background: #fff4ce; color: #3d2f00; border: 1px solid #c8a400; padding: 4px }"


class AdviceLabel(QtGui.QLabel):
    """Hidden until tell() has something to say."""

    def __init__(self):
        super().__init__()
        self.setObjectName("advice")
        self.setWordWrap(True)
        self.setTextFormat(QtCore.Qt.RichText)
        self.setStyleSheet(STYLE)
        self.hide()

    def tell(self, method, order, size=0.0):
        """As judging.advice.of_poor_hexes."""
        rows = of_poor_hexes(method, order, size)
        self.setText(words.as_html(rows))
        self.setVisible(bool(rows))
