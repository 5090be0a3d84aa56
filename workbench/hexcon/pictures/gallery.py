# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of how hexes are built under a quad surface: its loops, its pairs, and every stage of the hexes.

This file decides what is seen; gallery_scene.py, a program of its own, draws it.
"""
import os

import numpy as np

import hexcon_native
from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.hexahedron import FACES
from hexcon.inspection.dual_loops import centres_of, dual_loops
from hexcon.inspection.pairs import bars_of_pairs
from hexcon.inspection.stages import stages_of
from hexcon.quads.surface import edges_of

from . import draw, kept
from .pair_colours import colours_of_pairs
from .palette import DARK, PLAIN, STAGE_COLOURS, loop_colours

SIZE = np.array([1000, 640])                  # pixels of a picture with one row of panels
ROW = 340                                     # more for every other row
FRONT = np.array([-0.75, -1.0, 0.53])         # from the body to the viewer; no example has a side edge-on to it
BEHIND = -FRONT
TOWARDS = FRONT * (1, 1, 0)                   # normal of the cut, the half before which is taken away
SHRINK = 0.82                                 # hexes towards their centres, so that each is seen for itself


__all__ = ["stages", "stages_of"]


def stages(surface, mesh, folder, *, name="surface"):
    """Draw a surface and the stages of its hexes; returns the paths of the pictures, in their order.

    surface  .points (V,3), .quads (n,4): a quads.QuadSurface; n even
    mesh     its hexes, or None: .points (P,3), .hexes (H,8|20) and .report, of which stages_of tells the stages
    folder   made where it does not exist; pictures of the same names are replaced
    name     of the surface, for the titles
    Drawn are 1-surface.png, its dual loops; 2-pairs.png, the pairs of quads; of more than one stage 3-stages.png, all
    of them cut open; then one picture for every stage, such as 7-closure.png: its hexes, whole and cut open.
    Raises ToolError: FILE_IO, BAD_MESH, and those of pictures.draw; HexconError ODD and those of pairing.
    """
    jobs = [("surface", _loops_job(surface, name)), ("pairs", _pairs_job(surface, name))]
    if mesh is not None:
        jobs += _hexes_jobs(surface, mesh, name)
    place = _place_of(folder)
    names = [f"{k}-{words.replace(' ', '-')}.png" for k, (words, _) in enumerate(jobs, 1)]
    with disk.naming(place, f"write into {folder}"), disk.working_folder(".hexcon-", place) as beside:
        for file_name, (_, job) in zip(names, jobs):
            draw("gallery_scene.py", job, os.path.join(beside, file_name))
        os.makedirs(folder, exist_ok=True)
        for file_name in names:
            os.replace(os.path.join(beside, file_name), os.path.join(folder, file_name))
    return [os.path.join(folder, file_name) for file_name in names]


def _place_of(folder):
    """The folder, or of those in which it will be made the one that is there: its disk takes the pictures until all are
    drawn. Raises FILE_IO where nothing can be put into it: before the drawing, not after it."""
    place = os.path.abspath(folder)
    while not os.path.lexists(place):
        place = os.path.dirname(place)
    if not os.path.isdir(place) or not os.access(place, os.W_OK | os.X_OK):
        raise ToolError(f"cannot make the folder {folder}: {place} is no folder, or not to be written into",
                        FaultCode.FILE_IO)
    return place


# ---------------------------------------------------------------------------------------- surface

def _loops_job(surface, name):
    """The dual loops through the middles of edges; where one crosses itself, a dot."""
    loops = dual_loops(surface.points, surface.quads)
    colours = loop_colours(len(loops))
    dots = centres_of(surface.points, surface.quads[np.concatenate([loop.crossings for loop in loops])])
    drawn = {**_faces(surface.points, surface.quads, np.tile(PLAIN, (len(surface.quads), 1))),
             **_tubes([loop.curve for loop in loops], colours),
             "ball_points": dots, "ball_colours": np.tile(DARK, (len(dots), 1))}
    legend = [f"loop of length {len(loop)}{_crossing_words(loop.crossings)}" for loop in loops]
    return _job(f"{name}: {len(surface.quads)} quads, {_count(len(loops), 'dual loop')}",
                "Each loop passes quads from edge to opposite edge. Dark dots: a loop crosses itself.",
                _both_sides(surface.points, drawn), 2, *_legend(legend, colours))


def _crossing_words(twice):
    return f", crosses itself {_count(len(twice), 'time')}" if len(twice) else ", simple"


def _legend(words, colours, most=6):
    """(words, colours), of the first few where there are too many."""
    if len(words) <= most:
        return words, colours
    return [*words[:most - 1], f"and {len(words) - most + 1} more"], np.vstack([colours[:most - 1], DARK])


def _pairs_job(surface, name):
    """Each pair of quads in one colour, with a bar from quad to quad across their edge."""
    points, quads = surface.points, surface.quads
    pairs, centres = hexcon_native.pairing(quads, points), centres_of(points, quads)
    bars = bars_of_pairs(points, quads, pairs)
    drawn = {**_faces(points, quads, colours_of_pairs(quads, pairs)),
             **_tubes(bars, np.tile(DARK, (len(bars), 1))),
             "ball_points": centres, "ball_colours": np.tile(DARK, (len(quads), 1))}
    return _job(f"{name}: {len(pairs)} pairs of quads",
                "Every quad has one neighbour as its partner: the paired partition.",
                _both_sides(points, drawn), 2)


def _both_sides(points, drawn):
    """Two panels of the same things: nothing hides behind."""
    return [_panel("from the front, above", FRONT, points, drawn),
            _panel("from behind, below", BEHIND, points, drawn)]


# ------------------------------------------------------------------------------------------ hexes

def _hexes_jobs(surface, mesh, name):
    """[(words for the file's name, job)] of the stages: all together if there are several, then each."""
    points, hexes = np.asarray(mesh.points, float), np.asarray(mesh.hexes)[:, :8]
    found = stages_of(mesh)
    title = f"{name}: {len(hexes)} hexes, method {getattr(mesh, 'method', 'unknown')}"
    colours = STAGE_COLOURS[np.arange(len(found)) % len(STAGE_COLOURS)]
    frame = surface.points[edges_of(surface.quads)]
    panels = [_panel(f"{words}: {_count(len(hexes[rows]), 'hex')}", FRONT, surface.points,
                     {**_hexes(points, hexes[rows], colour, True), "lines": frame})
              for (words, rows), colour in zip(found, colours)]
    columns = int(np.ceil(np.sqrt(len(panels))))
    jobs = [("stages", _job(title, "The stages from outside to inside, cut open.", panels, columns))]
    for (words, rows), colour in zip(found, colours):
        jobs.append((words, _stage_job(f"{name}: {words}", points, hexes, rows, colour)))
    return jobs if len(found) > 1 else jobs[1:]


def _stage_job(title, points, hexes, rows, colour):
    """One stage large: all of its hexes, and cut open."""
    part = hexes[rows]
    seen = points[np.unique(part)]
    panels = [_panel("all of them", FRONT, seen, _hexes(points, part, colour, False)),
              _panel("cut open", FRONT, seen, _hexes(points, part, colour, True))]
    return _job(title, f"{len(part)} of {len(hexes)} hexes, each shrunk towards its centre.", panels, 2)


def _hexes(points, hexes, colour, cut_open):
    """The faces of the hexes, each hex shrunk towards its centre; cut_open: without those before the middle."""
    cut = ((points.min(axis=0) + points.max(axis=0)) / 2, TOWARDS) if cut_open else None
    corners = points[hexes[kept(points, hexes, cut)]]
    centres = corners.mean(axis=1, keepdims=True)
    shrunk = (centres + SHRINK * (corners - centres)).reshape(-1, 3)
    quads = (8 * np.arange(len(corners))[:, None, None] + FACES).reshape(-1, 4)
    return _faces(shrunk, quads, np.tile(colour, (len(quads), 1)))


# -------------------------------------------------------------------------------- what the scene is

def _faces(points, quads, colours):
    return {"face_points": points, "faces": quads, "face_colours": colours}


def _tubes(polylines, colours):
    starts = np.cumsum([0, *map(len, polylines)])
    return {"tube_points": np.concatenate(polylines), "tube_starts": starts, "tube_colours": colours}


def _panel(caption, view, seen, drawn):
    """The arrays of one panel, as gallery_scene.py lists them."""
    nothing = {"lines": np.zeros((0, 2, 3)), "tube_points": np.zeros((0, 3)), "ball_points": np.zeros((0, 3))}
    return {**nothing, **drawn, "caption": caption, "view": view, "seen": seen}


def _job(title, subtitle, panels, columns, legend=(), legend_colours=()):
    """The arrays of one picture."""
    job = {f"{k} {key}": value for k, panel in enumerate(panels) for key, value in panel.items()}
    more_rows = -(-len(panels) // columns) - 1
    return dict(job, size=SIZE + (0, ROW * more_rows), columns=columns, title=title, subtitle=subtitle,
                legend=np.array(legend, str), legend_colours=np.array(legend_colours).reshape(-1, 3))


def _count(number, thing):
    plural = "" if number == 1 else "es" if thing.endswith("x") else "s"
    return f"{number} {thing}{plural}"
