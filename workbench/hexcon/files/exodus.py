# SPDX-License-Identifier: LGPL-2.1-or-later
""".exo: Exodus II, which MOOSE, libMesh, Sierra, Nek5000's exo2nek and ParaView read; through SciPy's netCDF.

Names of dimensions, variables and attributes are those of the Exodus II manual (Schoof and Yarberry, SAND92-2137) and
of the SEACAS library: one block of HEX8 or HEX20, one side set for each group of boundary faces.
"""
import io

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.node_orders import HEX20

EXODUS_SIDE = np.array([5, 6, 1, 2, 3, 4])      # of the rows of hexahedron.FACES
EXODUS_HEX = {1: HEX20["Exodus II"][:8], 2: HEX20["Exodus II"]}
NAME, LINE = 33, 81     # characters of a name and of a line, with the NUL that ends them
MOST_BYTES = 2 ** 32 - 4    # of a variable, in netCDF's format with offsets of 64 bits


def write(path, elements):
    """Block "solid" (1), side sets "Face3" (3) of the CAD faces and of named groups, "Boundary" of what lies on none,
    node
    sets of groups of nodes.

    Raises ToolError: TOOL_MISSING (SciPy), BAD_MESH (more than 4 GiB of one array)."""
    netcdf_file = _netcdf_file(path)
    if elements.hexes.size * 4 > MOST_BYTES or len(elements.points) * 8 > MOST_BYTES:
        raise ToolError(f"{path}: an array of {len(elements.hexes)} hexes passes 4 GiB, which this format cannot hold; "
                        "write .vtu or .med", FaultCode.BAD_MESH)
    made = io.BytesIO()     # and then the file: on a full disk netcdf_file would try again whenever it is collected
    data = netcdf_file(made, "w", version=2)
    _describe(data)
    _write_points(data, elements.points)
    _write_block(data, elements)
    _write_side_sets(data, elements)
    _write_node_sets(data, elements)
    data.flush()
    with open(path, "wb") as stream:
        stream.write(made.getbuffer())


def _netcdf_file(path):
    try:
        from scipy.io import netcdf_file
    except ImportError as error:
        raise ToolError(f"{path} needs the Python package scipy (Debian: apt install python3-scipy)",
                        FaultCode.TOOL_MISSING) from error
    return netcdf_file


def _describe(data):
    """What every Exodus file has, whatever is in it."""
    data.api_version = data.version = np.float32(5.1)
    data.floating_point_word_size, data.file_size = np.int32(8), np.int32(1)
    data.title = b"Hex mesh by HexCon"
    for name, length in (("time_step", None), ("len_string", NAME), ("len_line", LINE), ("four", 4)):
        data.createDimension(name, length)
    data.createVariable("time_whole", "d", ("time_step",))


def _write_points(data, points):
    data.createDimension("num_dim", 3)
    data.createDimension("num_nodes", len(points))
    for axis, name in enumerate("xyz"):
        _variable(data, f"coord{name}", "d", ("num_nodes",), points[:, axis])
    _variable(data, "coor_names", "c", ("num_dim", "len_string"), _names("xyz"))


def _write_block(data, elements):
    hexes = elements.hexes[:, EXODUS_HEX[elements.order]] + 1
    for name, length in (("num_elem", len(hexes)), ("num_el_blk", 1), ("num_el_in_blk1", len(hexes)),
                         ("num_nod_per_el1", hexes.shape[1])):
        data.createDimension(name, length)
    _properties(data, "eb", "num_el_blk", [1], ["solid"])
    connected = _variable(data, "connect1", "i", ("num_el_in_blk1", "num_nod_per_el1"), hexes)
    connected.elem_type = b"HEX%d" % hexes.shape[1]


def _write_side_sets(data, elements):
    groups = elements.all_groups()
    data.createDimension("num_side_sets", len(groups))
    _properties(data, "ss", "num_side_sets", [number for number, _, _ in groups], [name for _, name, _ in groups])
    for k, (_, _, rows) in enumerate(groups, 1):
        data.createDimension(f"num_side_ss{k}", len(rows))
        _variable(data, f"elem_ss{k}", "i", (f"num_side_ss{k}",), elements.hex_of_quad[rows] + 1)
        _variable(data, f"side_ss{k}", "i", (f"num_side_ss{k}",), EXODUS_SIDE[elements.side_of_quad[rows]])


def _write_node_sets(data, elements):
    if not elements.node_groups:
        return
    data.createDimension("num_node_sets", len(elements.node_groups))
    _properties(data, "ns", "num_node_sets", range(1, len(elements.node_groups) + 1), list(elements.node_groups))
    for k, name in enumerate(elements.node_groups, 1):
        nodes = elements.nodes_of_set(name)
        data.createDimension(f"num_nod_ns{k}", len(nodes))
        _variable(data, f"node_ns{k}", "i", (f"num_nod_ns{k}",), nodes + 1)


def _properties(data, kind, dimension, numbers, names):
    """Status, number and name of blocks (eb), side sets (ss) or node sets (ns)."""
    _variable(data, f"{kind}_status", "i", (dimension,), np.ones(len(numbers)))
    _variable(data, f"{kind}_prop1", "i", (dimension,), numbers).name = b"ID"
    _variable(data, f"{kind}_names", "c", (dimension, "len_string"), _names(names))


def _variable(data, name, kind, dimensions, values):
    made = data.createVariable(name, kind, dimensions)
    made[:] = values
    return made


def _names(names):
    """(n, NAME) characters, NULs behind each name."""
    return np.array([name.encode("utf-8")[:NAME - 1] for name in names], f"S{NAME}").view("S1").reshape(-1, NAME)
