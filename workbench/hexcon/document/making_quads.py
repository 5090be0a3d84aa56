# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surface objects, made and made anew.

These are calls for macros; hexcon.gui.actions has them too.
"""
import math

from hexcon import freecad_compat
from hexcon.objects import quad_surface as quad_surface_objects
from hexcon.quads.local_sizes import written

from .changing import hide, update
from .prepared import prepared, taken

_NICE = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)


def default_size(shape):
    """A tenth of the bounding box's diagonal, rounded to a handy figure, in mm."""
    tenth = shape.BoundBox.DiagonalLength / 10.0
    if not (math.isfinite(tenth) and tenth > 0.0):
        return 1.0
    power = math.floor(math.log10(tenth))
    return min((float(f"{n}e{power}") for n in _NICE), key=lambda size: abs(size - tenth))


def make_quad_surface(source, size=None, *, method="auto", local_sizes=(), per_turn=0):
    """A quad surface object made from a document object; returns it.

    source  an object whose Shape holds exactly one solid, or a FEM mesh object whose quads
            (or the outer faces of whose volumes) are taken; then size and method do not matter
    size    wanted edge length, mm; None: a tenth of the solid's diagonal
    method  hexcon.quads.METHODS
    local_sizes, per_turn  smaller quads at places of the solid, as hexcon.quads.surface_from_solid
    The solid is hidden, as the quads cover it. Raises HexconError: those of
    hexcon.quads.surface_from_solid and surface_from_object.
    """
    if size is None:
        shape = freecad_compat.shape_of(source)
        size = 1.0 if shape is None else default_size(shape)
    settings = {"source": source, "size": float(size), "method": method,
                "local_sizes": written(local_sizes), "per_turn": int(per_turn)}
    return _new_quad_surface(source.Document, settings)


def import_quad_surface(path, document=None, *, scale=1.0, merge_tolerance=0.0):
    """A quad surface object with the quads of a mesh file (hexcon.quads.files.MESH_ENDINGS).

    scale     what its lengths are multiplied by: 1000 where they are metres;  merge_tolerance: mm, points nearer than
              this become one, 0: only where the surface is open
    document  None: the active one, or a new one. The object is made anew on recompute when the
    file has changed. Raises HexconError: those of hexcon.quads.surface_from_file.
    """
    settings = {"file": str(path), "scale": float(scale), "merge_tolerance": float(merge_tolerance)}
    mark, job = quad_surface_objects.job_of(**settings)
    surface = job(None)  # may fail: before there is a document
    app = freecad_compat.freecad()
    document = document or app.ActiveDocument or app.newDocument()
    with prepared(surface):
        return _new_quad_surface(document, settings)


def _new_quad_surface(document, settings, name="QuadSurface"):
    mark, job = quad_surface_objects.job_of(**settings)
    surface = taken() or job(None)
    with freecad_compat.transaction(document, "Quad surface"):
        made = quad_surface_objects.add_quad_surface(document, surface, mark, settings, name)
        hide(settings.get("source"))
    return made


def last_size(solid_object):
    """The size of the newest quad surface made from the object, mm; 0 where there is none."""
    made = [one for one in solid_object.InList
            if quad_surface_objects.is_quad_surface(one) and one.Source == solid_object]
    return max(made, key=lambda one: one.ID).Size.Value if made else 0.0


def update_quad_surface(surface_object, **settings):
    """Make a quad surface anew with other settings (size, method), then what is made from it.

    Nothing changes if the quads cannot be made; a hex mesh that then fails keeps its hexes and
    says so in its Status. Raises HexconError as make_quad_surface.
    """
    whole = {"source": surface_object.Source, "file": surface_object.File, "example": surface_object.Example,
             "size": surface_object.Size.Value, "method": surface_object.Method,
             "local_sizes": list(surface_object.LocalSizes), "per_turn": surface_object.PerTurn,
             "scale": surface_object.Scale, "merge_tolerance": surface_object.MergeTolerance.Value, **settings}
    mark, job = quad_surface_objects.job_of(**whole)
    update(surface_object, taken() or job(None), mark, settings,
            quad_surface_objects.set_settings)
