# SPDX-License-Identifier: LGPL-2.1-or-later
"""A histogram of scaled Jacobians that is the legend of their colours, too."""
import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from hexcon.inspection.figures import spread
from hexcon.pictures.palette import quality_colours

translate = FreeCAD.Qt.translate

HEIGHT, LEFT, RIGHT, TOP = 140, 10, 14, 16  # pixels
BAND = 12  # the strip of colours under the bars
LEAST = 2  # a bar of any hex at all is seen: one bad hex matters
TICKS = (0.25, 0.5)  # the first where there is room for its figures


class Histogram(QtGui.QWidget):
    """Bars of how many hexes lie between two scaled Jacobians, over a strip of the colours they have in the view."""

    def __init__(self):
        super().__init__()
        self.setObjectName("histogram")
        self.setMinimumHeight(HEIGHT)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        self.setToolTip(translate("HexCon", "How many hexahedra have which scaled Jacobian: 1 is a cube's, 0 or less "
                                            "no solver should be given"))
        self.counts, self.limits = np.zeros(0, int), np.array([0.0, 1.0])

    def show_values(self, scaled_jacobian):
        self.counts, self.limits = spread(scaled_jacobian)
        self.update()

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        foot = self.height() - 2 * painter.fontMetrics().height() - BAND - 2
        self._paint_bars(painter, foot)
        self._paint_scale(painter, foot + 2)
        painter.end()

    def _x(self, value):
        low, high = self.limits[0], self.limits[-1]
        return LEFT + (value - low) / (high - low) * (self.width() - LEFT - RIGHT)

    def _ticks(self, letters):
        fits = [step for step in TICKS if self._x(step) - self._x(0) > 2.2 * letters]
        step = (fits or TICKS[-1:])[0]
        return np.arange(np.ceil(self.limits[0] / step), round(1 / step) + 1) * step

    def _box(self, low, high, top, bottom):
        return QtCore.QRectF(self._x(low), top, max(1.0, self._x(high) - self._x(low) - 1), bottom - top)

    def _paint_bars(self, painter, foot):
        most = max(1, self.counts.max(initial=0))
        colours = quality_colours((self.limits[1:] + self.limits[:-1]) / 2)
        for count, low, high, colour in zip(self.counts, self.limits, self.limits[1:], colours):
            if count:
                tall = max(LEAST, (foot - TOP) * count / most)
                painter.setPen(QtGui.QPen(QtGui.QColor(90, 90, 90), 0.5))
                painter.setBrush(QtGui.QColor.fromRgbF(*colour))
                painter.drawRect(self._box(low, high, foot - tall, foot))
        if len(self.counts):
            painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
            painter.drawText(QtCore.QPointF(LEFT, TOP - 4), translate("HexCon", "highest bar: {count} hexes").format(
                count=f"{most:,}".replace(",", "\u00a0")))

    def _paint_scale(self, painter, top):
        """The strip of colours, figures under it, and what they are."""
        fine = np.linspace(self.limits[0], self.limits[-1], 121)
        for low, high, colour in zip(fine, fine[1:], quality_colours((fine[1:] + fine[:-1]) / 2)):
            painter.fillRect(self._box(low, high, top, top + BAND).adjusted(0, 0, 1, 0),
                             QtGui.QColor.fromRgbF(*colour))
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        letters = painter.fontMetrics().height()
        for value in self._ticks(painter.fontMetrics().height()):
            where = QtCore.QRectF(self._x(value) - 20, top + BAND, 40, letters)
            painter.drawText(where, QtCore.Qt.AlignHCenter, f"{value:.2f}".rstrip("0").rstrip("."))
        painter.drawText(QtCore.QRectF(0, top + BAND + letters, self.width(), letters), QtCore.Qt.AlignHCenter,
                         translate("HexCon", "scaled Jacobian"))
