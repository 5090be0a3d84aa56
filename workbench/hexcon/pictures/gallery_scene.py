# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws one picture of the gallery: python3 gallery_scene.py ARRAYS.npz PICTURE.png

A program of its own, started by hexcon.pictures; it imports nothing of HexCon but what lies beside it. It decides
nothing: gallery.py says what is where, in which colour. Arrays, k = 0, 1 ... being a panel:

size (2,) pixels; columns; title, subtitle; legend (L,) str and legend_colours (L,3)
k view (3,) from the body to the viewer; k caption; k seen (S,3) points that must be seen
k face_points (F,3), k faces (f,4), k face_colours (f,3)
k lines (s,2,3) thin segments
k tube_points (T,3), k tube_starts (t+1,) rows where each tube begins and ends, k tube_colours (t,3)
k ball_points (B,3), k ball_colours (B,3)
Colours are 0 to 1. Any array may be empty.
"""
import sys

import numpy as np
from scene import EDGE, cells_of, points_of, renderer, save, text_actor, window_of
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

HEAD, LEGEND_ROW = 95, 36  # pixels: title and subtitle; one row of the legend
FREE = (0.11, 1.0)  # of a panel's height: above its caption
LIGHTS = (((-0.5, 1.2, 1.0), 0.75), ((0.6, -0.2, 1.0), 0.35))  # where, seen from the viewer, and how strong
THICKNESS = 0.011  # of a tube, of the size of what is seen
PALE = (0.60, 0.62, 0.65)


def bytes_of(colours):
    made = numpy_to_vtk(np.ascontiguousarray(np.rint(255 * colours), np.uint8), deep=True)
    made.SetName("colour")
    return made


def actor_of(mapper):
    """Lit half from everywhere, so that a colour stays that colour."""
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.50)
    actor.GetProperty().SetDiffuse(0.58)
    return actor


def mapper_of(data=None, source=None):
    """Mapper of a poly data, or of what a filter puts out, in the colours that it carries."""
    made = vtkPolyDataMapper()
    if source is None:
        made.SetInputData(data)
    else:
        made.SetInputConnection(source.GetOutputPort())
    return made


def faces_actor(points, quads, colours):
    """Flat quads with their edges."""
    data = vtkPolyData()
    data.SetPoints(points_of(points))
    data.SetPolys(cells_of(np.arange(0, 4 * len(quads) + 1, 4), quads.ravel()))
    data.GetCellData().SetScalars(bytes_of(colours))
    actor = actor_of(mapper_of(data))
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(EDGE)
    look.SetLineWidth(1.5 if len(quads) < 1000 else 1.0)
    return actor


def lines_actor(segments):
    """Thin pale segments (s,2,3), for what is not there any more."""
    data = vtkPolyData()
    data.SetPoints(points_of(segments.reshape(-1, 3)))
    data.SetLines(cells_of(np.arange(0, 2 * len(segments) + 1, 2), np.arange(2 * len(segments))))
    actor = actor_of(mapper_of(data))
    actor.GetProperty().SetColor(PALE)
    actor.GetProperty().SetLineWidth(1.5)
    return actor


def tubes_actor(points, starts, colours, radius):
    """Tubes along polylines."""
    data = vtkPolyData()
    data.SetPoints(points_of(points))
    data.SetLines(cells_of(starts, np.arange(len(points))))
    data.GetCellData().SetScalars(bytes_of(colours))
    tube = vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(16)
    tube.CappingOn()
    return actor_of(mapper_of(source=tube))


def balls_actor(points, colours, radius):
    data = vtkPolyData()
    data.SetPoints(points_of(points))
    data.GetPointData().SetScalars(bytes_of(colours))
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(24)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    glyphs.SetColorModeToColorByScalar()
    return actor_of(mapper_of(source=glyphs))


def actors_of(panel):
    """Everything in a panel, its caption included."""
    size = np.linalg.norm(np.ptp(panel["seen"], axis=0))
    found = []
    if len(panel["faces"]):
        found.append(faces_actor(panel["face_points"], panel["faces"], panel["face_colours"]))
    if len(panel["lines"]):
        found.append(lines_actor(panel["lines"]))
    if len(panel["tube_points"]):
        found.append(tubes_actor(panel["tube_points"], panel["tube_starts"], panel["tube_colours"],
                                 THICKNESS * size / 2))
    if len(panel["ball_points"]):
        found.append(balls_actor(panel["ball_points"], panel["ball_colours"], THICKNESS * size))
    return [*found, text_actor(str(panel["caption"]), 0.5, 0.03, 21, centred=True)]


def add_lights(panel):
    """From above and left of the viewer, and some from below: sides that meet differ in brightness."""
    for place, strength in LIGHTS:
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*place)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        panel.AddLight(light)


def add_strip(window, low, high, texts):
    """A renderer of text alone, from low to high of the height."""
    strip = vtkRenderer()
    strip.SetBackground(1, 1, 1)
    strip.SetViewport(0, low, 1, high)
    for text in texts:
        strip.AddActor2D(text)
    window.AddRenderer(strip)


def legend_texts(words, colours):
    """Two entries a row, each in its colour; a row is 1 / rows of the strip's height."""
    rows = max(1, (len(words) + 1) // 2)
    found = []
    for k, (word, colour) in enumerate(zip(words, colours)):
        text = text_actor(str(word), (0.04, 0.52)[k % 2], 1 - (k // 2 + 0.8) / rows, 20, bold=True)
        text.GetTextProperty().SetColor(*colour)
        found.append(text)
    return found


def add_panels(window, panels, columns, low, high):
    """Panels row by row, between low and high of the height."""
    width, height = window.GetSize()
    rows = -(-len(panels) // columns)
    for k, panel in enumerate(panels):
        row, column = divmod(k, columns)
        top, tall = high - (high - low) * row / rows, (high - low) / rows
        add_lights(renderer(window, (column / columns, top - tall, (column + 1) / columns, top), actors_of(panel),
                            panel["seen"], width / columns / (tall * height), panel["view"], FREE))


def draw(job, path):
    """The whole picture to a PNG."""
    window = window_of([int(n) for n in job["size"]])
    height = window.GetSize()[1]
    low, high = LEGEND_ROW * ((len(job["legend"]) + 1) // 2) / height, 1 - HEAD / height
    add_strip(window, high, 1, [text_actor(str(job["title"]), 0.03, 0.52, 30, bold=True),
                               text_actor(str(job["subtitle"]), 0.03, 0.14, 21)])
    panels = [{name.split(" ", 1)[1]: job[name] for name in job if name.startswith(f"{k} ")}
              for k in range(sum(name.endswith(" view") for name in job))]
    add_panels(window, panels, int(job["columns"]), low, high)
    if low:
        add_strip(window, 0, low, legend_texts(job["legend"], job["legend_colours"]))
    save(window, path)


if __name__ == "__main__":
    with np.load(sys.argv[1]) as loaded:
        draw({name: loaded[name] for name in loaded.files}, sys.argv[2])
