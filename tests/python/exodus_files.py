# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exodus II files of the box of deck_texts, by scipy's netCDF (Sandia, "EXODUS: A Finite Element Data Model")."""
import numpy as np
from deck_texts import GRID
from scipy.io import netcdf_file


def write(path, blocks, side_sets=(), node_sets=()):
    """blocks [(type, rows from 0)]; side_sets [(name, elements, sides)], node_sets [(name, nodes)], from 1."""
    with netcdf_file(path, "w") as file:
        file.api_version, file.version = np.float32(5.1), np.float32(5.1)
        file.floating_point_word_size, file.file_size, file.title = 8, 1, "box"
        for name, size in (("time_step", None), ("len_string", 33), ("len_name", 33), ("num_dim", 3),
                           ("num_nodes", len(GRID)),
                           ("num_elem", sum(len(rows) for _, rows in blocks)), ("num_el_blk", len(blocks))):
            file.createDimension(name, size)
        for axis, values in zip("xyz", GRID.T):
            _put(file, f"coord{axis}", "d", ("num_nodes",), values)
        _put(file, "eb_prop1", "i", ("num_el_blk",), np.arange(1, len(blocks) + 1))
        file.variables["eb_prop1"].name = "ID"
        _put(file, "eb_status", "i", ("num_el_blk",), np.ones(len(blocks)))
        for k, (kind, rows) in enumerate(blocks, 1):
            file.createDimension(f"num_el_in_blk{k}", len(rows))
            file.createDimension(f"num_nod_per_el{k}", rows.shape[1])
            _put(file, f"connect{k}", "i", (f"num_el_in_blk{k}", f"num_nod_per_el{k}"), rows + 1)
            file.variables[f"connect{k}"].elem_type = kind
        _sets(file, "side", "ss", "ss_prop1", side_sets, ("elem_ss", "side_ss"))
        _sets(file, "node", "ns", "ns_prop1", node_sets, ("node_ns",))


def _sets(file, long, short, prop, sets, names):
    if not sets:
        return
    file.createDimension(f"num_{long}_sets", len(sets))
    _put(file, prop, "i", (f"num_{long}_sets",), np.arange(1, len(sets) + 1))
    file.variables[prop].name = "ID"
    _put(file, f"{short}_status", "i", (f"num_{long}_sets",), np.ones(len(sets)))
    text = np.zeros((len(sets), 33), "S1")
    for k, (name, *members) in enumerate(sets, 1):
        text[k - 1, :len(name)] = list(name)
        dimension = f"num_side_ss{k}" if short == "ss" else f"num_nod_ns{k}"
        file.createDimension(dimension, len(members[0]))
        for variable, values in zip(names, members):
            _put(file, f"{variable}{k}", "i", (dimension,), np.asarray(values))
    file.createVariable(f"{short}_names", "c", (f"num_{long}_sets", "len_name"))[:] = text


def _put(file, name, kind, dimensions, values):
    file.createVariable(name, kind, dimensions)[:] = values
