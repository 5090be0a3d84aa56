# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGNS files of the box of deck_texts, node by node as the format says (CGNS, "File Mapping to HDF5", and its SIDS)."""
import h5py
import numpy as np
from deck_texts import GRID, HEXES, OUTER

NODE, QUAD_4, HEXA_8 = 2, 7, 17
_TYPES = {"int32": "I4", "float64": "R8", "float32": "R4", "int8": "C1"}
HEX_SECTIONS = {
    "one section": [(HEXA_8, HEXES)], "two sections": [(HEXA_8, HEXES[:3]), (HEXA_8, HEXES[3:])],
    "quads behind them": [(HEXA_8, HEXES), (QUAD_4, OUTER)], "quads before them": [(QUAD_4, OUTER), (HEXA_8, HEXES)],
    "nodes before them": [(NODE, np.arange(8)[:, None]), (HEXA_8, HEXES)]}


def write(path, sections, zones=1, dimension=3):
    """Unstructured zones, each 100 beside the one before.

    sections: [(type, rows from 0)] of each;  dimension: of the cells
    """
    with h5py.File(path, "w", track_order=True) as file:
        base = _base(file, dimension)
        for k in range(zones):
            _unstructured(base, f"Zone{k + 1}", GRID + [100.0 * k, 0, 0], sections)


def write_structured(path):
    """The box as one zone of 3 x 3 x 3 points."""
    with h5py.File(path, "w", track_order=True) as file:
        zone = _node(_base(file, 3), "Zone1", "Zone_t", np.array([[3] * 3, [2] * 3, [0] * 3], np.int32))
        _node(zone, "ZoneType", "ZoneType_t", "Structured")
        _coordinates(zone, GRID.reshape(3, 3, 3, 3))


def _node(parent, name, label, data=None):
    made = parent.create_group(name, track_order=True)
    data = np.frombuffer(data.encode(), np.int8) if isinstance(data, str) else data
    made.attrs["name"], made.attrs["label"] = np.array(name, "S33"), np.array(label, "S33")
    made.attrs["type"] = np.array("MT" if data is None else _TYPES[data.dtype.name], "S3")
    made.attrs["flags"] = np.array([1], np.int32)
    if data is not None:
        made.create_dataset(" data", data=data)
    return made


def _base(file, dimension):
    file.attrs["name"] = np.array("HDF5 MotherNode", "S33")
    file.attrs["label"] = np.array("Root Node of HDF5 File", "S33")
    file.attrs["type"] = np.array("MT", "S3")
    file.create_dataset(" format", data=np.frombuffer(b"IEEE_LITTLE_32\0", np.int8))
    file.create_dataset(" hdf5version", data=np.frombuffer(b"HDF5 Version 1.8.0".ljust(33, b"\0"), np.int8))
    _node(file, "CGNSLibraryVersion", "CGNSLibraryVersion_t", np.array([3.3], np.float32))
    return _node(file, "Base", "CGNSBase_t", np.array([dimension, 3], np.int32))


def _unstructured(base, name, points, sections):
    count = sum(len(rows) for _, rows in sections)
    zone = _node(base, name, "Zone_t", np.array([[len(points)], [count], [0]], np.int32))
    _node(zone, "ZoneType", "ZoneType_t", "Unstructured")
    _coordinates(zone, points)
    first = 1
    for k, (kind, rows) in enumerate(sections, 1):
        section = _node(zone, f"Section{k}", "Elements_t", np.array([kind, 0], np.int32))
        _node(section, "ElementRange", "IndexRange_t", np.array([first, first + len(rows) - 1], np.int32))
        _node(section, "ElementConnectivity", "DataArray_t", (rows + 1).astype(np.int32).ravel())
        first += len(rows)


def _coordinates(zone, points):
    places = _node(zone, "GridCoordinates", "GridCoordinates_t")
    for axis, values in zip("XYZ", np.moveaxis(points, -1, 0)):
        _node(places, f"Coordinate{axis}", "DataArray_t", np.ascontiguousarray(values))
