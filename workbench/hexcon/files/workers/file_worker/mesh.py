# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files by meshio, and by VTK where meshio does not know them (legacy POLYDATA)."""
import contextlib
import importlib
import io
import os

import numpy as np

from .refusal import Refusal

ROADS = {".vtk": ("with_meshio", "with_vtk"), ".vtu": ("with_meshio", "with_vtk")}


def read_mesh(job):
    """Arrays of a mesh, as hexcon.files.library.MESH lists them."""
    words, missing = [], []
    for road in ROADS.get(os.path.splitext(job["file"])[1].lower(), ("with_meshio",)):
        said = io.StringIO()
        try:
            with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):    # meshio's rich words
                return importlib.import_module("file_worker." + road).read(job["file"])
        except ModuleNotFoundError as error:
            missing.append(error.name)
        except SystemExit:
            words.append(" ".join(said.getvalue().split()) or "meshio gave up")
        except (OSError, MemoryError):
            raise
        except Exception as error:
            words.append(f"{type(error).__name__}: {error}")
    if not words:
        raise Refusal("TOOL_MISSING", f"needs the Python package {' or '.join(missing)} (Debian: apt install "
                      "python3-meshio python3-vtk9)")
    raise Refusal("FILE_FORMAT", "; ".join(words))


def mesh_arrays(points, blocks, names=(), boundary=None):
    """The arrays of the answer.

    points    (P, 2 or 3);  blocks  [(kind, rows, tags or None), ...], kinds by meshio's names, rows (k,n) of points
    names     [(name, tag, dimension), ...] of groups;  boundary  (quads (q,4), CAD face numbers (q,)) or None
    Raises ValueError where a cell names a point that does not exist.
    """
    points = np.asarray(points)
    places = np.zeros((len(points), 3))
    places[:, :points.shape[1]] = points
    kinds, counts, widths, entries, tags = [], [], [], [], []
    for kind, rows, row_tags in blocks:
        count, rows = len(rows), _table(kind, rows)
        if not _in_range(rows, len(points)):
            raise ValueError(f"a {kind} names a point that does not exist ({rows.min()} to {rows.max()} of {len(points)})")
        kinds.append(kind)
        counts.append(count)
        widths.append(rows.shape[1])
        entries.append(rows.ravel())
        tags.append(np.zeros(count, np.int64) if row_tags is None else np.asarray(row_tags).astype(np.int64))
    arrays = {"points": places, "kinds": np.array(kinds, str), "counts": np.array(counts, np.int64),
              "widths": np.array(widths, np.int64), "entries": np.concatenate([np.zeros(0, np.int64), *entries]),
              "tags": np.concatenate([np.zeros(0, np.int64), *tags]), "names": np.array([n for n, _, _ in names], str),
              "tags_of_names": np.array([t for _, *t in names], np.int64).reshape(-1, 2)}
    if boundary is not None:
        if len(boundary[0]) != len(boundary[1]) or not _in_range(boundary[0], len(points)):
            raise ValueError("its boundary quads name points that do not exist, or are not as many as their faces")
        arrays["boundary_quads"], arrays["face_of_quad"] = boundary
    return arrays


def _in_range(rows, count):
    return not rows.size or (rows.min() >= 0 and rows.max() < count)


def boundary_of(fields):
    """What hexcon.files.vtk writes beside the cells, from a dict of field arrays; None where it is not there."""
    if "boundary_quads" not in fields or "face_of_quad" not in fields:
        return None
    return (np.asarray(fields["boundary_quads"]).astype(np.int64).reshape(-1, 4),
            np.asarray(fields["face_of_quad"]).astype(np.int64).ravel())


def _table(kind, rows):
    """(k,n) int64; (k,0) of lines and points, which are passed over, and of ragged rows (polyhedra)."""
    if kind.startswith(("line", "vertex")):
        return np.zeros((len(rows), 0), np.int64)
    try:
        table = np.asarray(rows)
    except ValueError:
        table = np.zeros(0)
    if table.ndim != 2 or table.dtype.kind not in "iu":
        return np.zeros((len(rows), 0), np.int64)
    return table.astype(np.int64)
