# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files by the libraries that read them, one after the other."""
import contextlib
import importlib
import io
import os

import numpy as np

from .refusal import Refusal

# Who reads what, the first that can.
ROADS = {**dict.fromkeys((".vtk", ".vtu"), ("with_vtk", "with_meshio")), ".msh": ("with_gmsh", "with_meshio"),
         **dict.fromkeys((".vtp", ".vts", ".vtr", ".vti", ".ply"), ("with_vtk",)),
         **dict.fromkeys((".exo", ".e", ".ex2", ".cgns"), ("with_vtk_blocks",))}
OTHERS = ("with_meshio",)


def read_mesh(job):
    """Arrays of a mesh, as hexcon.files.library.MESH lists them."""
    words, missing = [], []
    for road in ROADS.get(os.path.splitext(job["file"])[1].lower(), OTHERS):
        said = io.StringIO()
        try:
            with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):    # meshio's rich words
                return importlib.import_module("file_worker." + road).read(job["file"])
        except ModuleNotFoundError as error:
            missing.append(error.name)
        except SystemExit:
            words.append(" ".join(said.getvalue().split()) or "meshio gave up")
        except (OSError, MemoryError, Refusal):
            raise
        except Exception as error:
            words.append(f"{type(error).__name__}: {error}")
    if not words:
        raise Refusal("TOOL_MISSING", f"needs the Python package {' or '.join(missing)} (Debian: apt install "
                      "python3-meshio python3-vtk9)")
    raise Refusal("FILE_FORMAT", "; ".join(words))


def mesh_arrays(points, blocks, groups=(), notes=()):
    """The arrays of the answer.

    points    (P, 2 or 3);  blocks  [(kind, rows), ...], kinds by meshio's names, each once, rows (k,n) of points
    groups    [(name, kind, members), ...]: kind "nodes" (points), "faces" (corners (k,4)), or that of a block (its rows)
    Raises ValueError where a cell or a group names a point that does not exist.
    """
    points = np.asarray(points)
    places = np.zeros((len(points), 3))
    places[:, :points.shape[1]] = points
    kinds, counts, widths, entries = [], [], [], []
    for kind, rows in blocks:
        count, rows = len(rows), _table(kind, rows)
        if not _in_range(rows, len(points)):
            raise ValueError(f"a {kind} names a point that does not exist ({rows.min()} to {rows.max()} of {len(points)})")
        kinds.append(kind)
        counts.append(count)
        widths.append(rows.shape[1])
        entries.append(rows.ravel())
    members = [np.asarray(ids).astype(np.int64).ravel() for _, _, ids in groups]
    for (name, kind, _), ids in zip(groups, members):
        if not _in_range(ids, len(points) if kind in ("nodes", "faces") else dict(zip(kinds, counts)).get(kind, 0)):
            raise ValueError(f"group {name!r} names a point or an element that does not exist")
    return {"points": places, "kinds": np.array(kinds, str), "counts": np.array(counts, np.int64),
            "widths": np.array(widths, np.int64), "entries": np.concatenate([np.zeros(0, np.int64), *entries]),
            "group_names": np.array([n for n, _, _ in groups], str), "group_kinds": np.array([k for _, k, _ in groups], str),
            "group_counts": np.array([len(ids) for ids in members], np.int64),
            "members": np.concatenate([np.zeros(0, np.int64), *members]), "notes": np.array(list(notes), str)}


def joined(blocks):
    """[(kind, rows)] with each kind once, from [(kind, rows), ...]; and [(kind, first row)] of the ones given."""
    together, places = {}, []
    for kind, rows in blocks:
        before = together.setdefault(kind, [])
        places.append((kind, sum(map(len, before))))
        before.append(_table(kind, rows))
    return [(kind, np.concatenate(tables) if len({t.shape[1] for t in tables}) == 1
             else np.zeros((sum(map(len, tables)), 0), np.int64)) for kind, tables in together.items()], places


def _in_range(rows, count):
    return not rows.size or (rows.min() >= 0 and rows.max() < count)


def groups_of_fields(fields):
    """[(name, "faces", corners)] of what older HexCons wrote beside the cells, from a dict of field arrays."""
    if "boundary_quads" not in fields or "face_of_quad" not in fields:
        return []
    quads = np.asarray(fields["boundary_quads"]).astype(np.int64).reshape(-1, 4)
    numbers = np.asarray(fields["face_of_quad"]).astype(np.int64).ravel()
    if len(quads) != len(numbers) or len(numbers) and not 0 <= numbers.min() <= numbers.max() <= 10 ** 9:
        raise ValueError("its boundary quads are not as many as their CAD faces, or name faces that there are not")
    return [(f"Face{number}", "faces", quads[numbers == number]) for number in np.unique(numbers[numbers > 0]).tolist()]


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
