# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws one prepared scene: python3 scene.py ARRAYS.npz PICTURE.png

A program of its own, started by hexcon.pictures; it imports nothing of HexCon but palette.py beside it.
"""
import sys

import numpy as np
from palette import INVERTED, QUALITY
from vtkmodules import vtkInteractionStyle, vtkRenderingContextOpenGL2, vtkRenderingFreeType, vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkActor2D,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

TEXT = (0.13, 0.15, 0.18)
EDGE = (0.16, 0.18, 0.22)
# Viridis, seven stops: even in lightness, readable without colour vision
VIRIDIS = np.array([(68, 1, 84), (70, 50, 127), (54, 92, 141), (39, 127, 142),
                    (31, 161, 135), (74, 194, 109), (159, 218, 58), (253, 231, 37)]) / 255
VIEW = np.array([-0.42, -1.0, 0.52])  # from the solid to the viewer
FREE = (0.17, 0.85)  # of the height: between the scalar bar and the captions


def points_of(array):
    made = vtkPoints()
    made.SetData(numpy_to_vtk(np.ascontiguousarray(array, np.float64), deep=True))
    return made


def cells_of(starts, ids):
    """vtkCellArray of cells of unequal length."""
    made = vtkCellArray()
    made.SetData(*(numpy_to_vtkIdTypeArray(np.ascontiguousarray(a, np.int64), deep=True) for a in (starts, ids)))
    return made


class Patches:
    """Quads (q,4|8), curved where they have 8 nodes, each drawn in rows of flat pieces.

    weights (r r, 4|8): the shape functions of the nodes at r x r places of a quad, row by row; pieces (k,4), rim (m,):
    quads among these places, and what is round all of them
    """

    def __init__(self, job, name):
        self._quads, self._weights, self._pieces = job[name], job["weights"], job["pieces"]
        self._first = len(self._weights) * np.arange(len(self._quads))[:, None]
        self._rim = np.append(job["rim"], job["rim"][0])

    def spread(self, values):
        """(q r r, ...) what the nodes' values (P, ...) are at the places."""
        return np.einsum("pn,qn...->qp...", self._weights, values[self._quads]).reshape(-1, *values.shape[1:])

    def surface(self, points, values=None, on_points=False):
        """vtkPolyData of the pieces; values of the points (P,), or of the quads (q,), as its scalars."""
        made = vtkPolyData()
        made.SetPoints(points_of(self.spread(points)))
        corners = (self._first[:, :, None] + self._pieces).reshape(-1)
        made.SetPolys(cells_of(np.arange(0, len(corners) + 1, 4), corners))
        if values is not None:
            array = numpy_to_vtk(self.spread(values) if on_points else np.repeat(values, len(self._pieces)), deep=True)
            (made.GetPointData() if on_points else made.GetCellData()).SetScalars(array)
        return made

    def edges(self, points):
        """vtkPolyData of the quads' rims."""
        made = vtkPolyData()
        made.SetPoints(points_of(self.spread(points)))
        along = (self._first + self._rim).reshape(-1)
        made.SetLines(cells_of(np.arange(0, len(along) + 1, len(self._rim)), along))
        return made

    def __len__(self):
        return len(self._quads)


def table(colours, low, high, below_zero=None):
    """Lookup table of 256 colours between the stops.

    With below_zero (1,3) the stops span 0 to high, and lower values have that colour."""
    made = vtkLookupTable()
    made.SetNumberOfTableValues(256)
    start = low if below_zero is None else max(low, 0.0)
    stops = np.linspace(start, high, len(colours))
    for k, value in enumerate(np.linspace(low, high, 256)):
        colour = (below_zero[0] if value < start
                  else [np.interp(value, stops, c) for c in colours.T])
        made.SetTableValue(k, *colour, 1.0)
    made.SetRange(low, high)
    made.Build()
    return made


def surface_actor(data, lookup):
    """The outside of hexes, coloured."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetLookupTable(lookup)
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()    # edges lie before their faces
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 20.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.55)
    look.SetDiffuse(0.50)
    return actor


def edges_actor(patches, points):
    """The edges of the hexes' faces."""
    actor = _lines_actor(EDGE, 1.0 if len(patches) < 20000 else 0.5)
    actor.GetMapper().SetInputData(patches.edges(points))
    actor.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -5.0)     # and before the outline
    return actor


def outline_actor(patches, points):
    """The undisplaced solid's sharp edges, grey."""
    joined, sharp = vtkCleanPolyData(), vtkFeatureEdges()
    joined.SetInputData(patches.surface(points))
    joined.SetTolerance(1e-7)
    sharp.SetInputConnection(joined.GetOutputPort())
    sharp.SetFeatureAngle(35)
    sharp.ColoringOff()
    sharp.NonManifoldEdgesOff()
    actor = _lines_actor((0.55, 0.57, 0.60), 1.5)
    actor.GetMapper().SetInputConnection(sharp.GetOutputPort())
    return actor


def _lines_actor(colour, width):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.LightingOff()
    look.SetColor(colour)
    look.SetLineWidth(width)
    return actor


def text_actor(text, x, y, size, bold=False, centred=False):
    """Text whose lower left (or middle) is at (x, y) of its renderer, 0 to 1."""
    actor = vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetColor(TEXT)
    style.SetBold(bold)
    if centred:
        style.SetJustificationToCentered()
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    return actor


def scalar_bar(lookup, label_format, labels):
    """A horizontal bar at the foot; its caption is a text of its own, because VTK's
    title scales with the bar."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(lookup)
    bar.SetOrientationToHorizontal()
    bar.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    bar.SetPosition(0.16, 0.05)
    bar.SetWidth(0.68)
    bar.SetHeight(0.075)
    bar.SetNumberOfLabels(labels)
    bar.SetMaximumNumberOfColors(256)
    bar.SetUnconstrainedFontSize(True)
    bar.SetLabelFormat(label_format)
    style = bar.GetLabelTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(19)
    style.SetColor(TEXT)
    style.SetItalic(0)
    style.SetBold(0)
    style.SetShadow(0)
    return bar


def renderer(window, viewport, actors, bounds_of, aspect, view=VIEW, free=FREE):
    """A part of the picture, its camera fitted to the points bounds_of (k,3)."""
    made = vtkRenderer()
    made.SetBackground(1, 1, 1)
    made.SetViewport(*viewport)
    for actor in actors:
        (made.AddActor2D if isinstance(actor, vtkActor2D) else made.AddActor)(actor)
    window.AddRenderer(made)
    fit_camera(made, bounds_of, aspect, view, free)
    return made


def fit_camera(made, points, aspect, view, free):
    """Parallel projection that fits the points into the part of the height that is free of text."""
    view = view / np.linalg.norm(view)
    right = np.cross((0, 0, 1.0), view)
    right /= np.linalg.norm(right)
    up = np.cross(view, right)
    u, v = points @ right, points @ up
    width, height = max(np.ptp(u), 1e-12), max(np.ptp(v), 1e-12)
    scale = max(height / (free[1] - free[0] - 0.06), width / (0.88 * aspect)) / 2
    middle = ((u.min() + u.max()) / 2 * right + (v.min() + v.max()) / 2 * up
              - scale * (free[0] + free[1] - 1) * up)
    depth = points @ view
    middle = middle + (depth.min() + depth.max()) / 2 * view
    camera = made.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + view * (np.ptp(depth) + scale) * 4))
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(scale)
    made.ResetCameraClippingRange()


def mesh_half(job):
    """(actors, points that must be seen) of the mesh with its cut."""
    points, quality = job["points"], job["quality"]
    shown, whole = (Patches(job, name) for name in ("shown", "outside"))
    # round ends, so that the labels are round: 0 to 1, or from -0.2, -0.4, ... to 1
    steps = 5 + int(np.ceil(max(0.0, -float(quality.min())) / 0.2 - 1e-9))
    low = 1.0 - 0.2 * steps
    lookup = table(QUALITY, low + 1e-9, 1.0 + 1e-9, INVERTED)  # 1e-9: no label "-0.00"
    actors = [surface_actor(shown.surface(points, quality[job["shown_hexes"]]), lookup), edges_actor(shown, points),
              outline_actor(whole, points),
              scalar_bar(lookup, "%-#.2f", steps + 1),
              text_actor("scaled Jacobian", 0.5, 0.133, 20, centred=True),
              text_actor(f"{len(quality):,} hexahedra", 0.03, 0.885, 26, bold=True),
              text_actor(f"scaled Jacobian {quality.min():.3g} to {quality.max():.3g}, "
                         f"mean {quality.mean():.3g}"
                         + ("; cut open" if job["cut"] else ""), 0.03, 0.845, 19)]
    return actors, points


def displaced_half(job):
    """(actors, points that must be seen) of the displaced shape."""
    points, shift = job["points"], job["displacements"]
    warp = float(job["warp"])
    size = np.linalg.norm(shift, axis=1)
    moved = points + warp * shift
    lookup, patches = table(VIRIDIS, 0.0, float(size.max()) or 1.0), Patches(job, "outside")
    actors = [surface_actor(patches.surface(moved, size, on_points=True), lookup), edges_actor(patches, moved),
              outline_actor(patches, points),
              scalar_bar(lookup, "%-.3g", 6),
              text_actor("displacement in mm", 0.5, 0.133, 20, centred=True),
              text_actor("Displaced shape", 0.03, 0.885, 26, bold=True),
              text_actor(f"largest displacement {size.max():.4g} mm, drawn {warp:g} times",
                         0.03, 0.845, 19)]
    return actors, np.vstack([points, moved])


def window_of(size):
    """An empty render window of (width, height) pixels, drawn without a screen."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    return window


def save(window, path):
    """Draw all renderers to a PNG."""
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def draw(job, path):
    """The whole picture to a PNG."""
    width, height = (int(n) for n in job["size"])
    window = window_of((width, height))
    halves = [mesh_half(job)]
    if "displacements" in job:
        halves.append(displaced_half(job))
    share = 1.0 / len(halves)
    for k, (actors, seen) in enumerate(halves):
        if k == 0 and str(job["title"]):
            actors.append(text_actor(str(job["title"]), 0.03, 0.94, 30, bold=True))
        renderer(window, (k * share, 0, (k + 1) * share, 1), actors, seen,
                 width * share / height)
    save(window, path)


if __name__ == "__main__":
    with np.load(sys.argv[1]) as loaded:
        draw({name: loaded[name] for name in loaded.files}, sys.argv[2])
