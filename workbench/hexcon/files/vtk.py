# SPDX-License-Identifier: LGPL-2.1-or-later
""".vtu (XML) and .vtk (legacy): hexahedra with data, for ParaView and VTK.

Both are written without the VTK library: float64, bit for bit. The cells are the hexahedra
alone, so that a viewer shows one solid; the boundary quads and their CAD faces go along as
field data boundary_quads (n,4) and face_of_quad (n,).
"""
import base64

import numpy as np

from hexcon.femmesh.scaled_jacobian import scaled_jacobian

_CELL_TYPE = {1: 12, 2: 25}
_XML_TYPE = {"f": "Float64", "i": "Int64", "u": "UInt8"}


def _cell_data(elements, cell_data):
    data = {"scaled_jacobian": scaled_jacobian(elements.points, elements.hexes)}
    data.update(cell_data or {})
    return data


def _field_data(elements):
    return {"boundary_quads": elements.quads[:, :4], "face_of_quad": elements.face_of_quad}


def _plain(array):
    """float64 or int64, C order."""
    array = np.asarray(array)
    return np.ascontiguousarray(array, "<f8" if array.dtype.kind == "f" else "<i8")


def _xml_array(stream, name, array, field=False):
    array = np.ascontiguousarray(array) if array.dtype == np.uint8 else _plain(array)
    count = f' NumberOfTuples="{len(array)}"' if field else ""
    parts = array.shape[1] if array.ndim == 2 else 1
    stream.write(f'<DataArray type="{_XML_TYPE[array.dtype.kind]}" Name="{name}" '
                 f'NumberOfComponents="{parts}"{count} format="binary">\n')
    # base64 of the byte count and of the data, each on its own
    stream.write(base64.b64encode(np.uint64(array.nbytes).tobytes()
                                  + array.tobytes()).decode("ascii"))
    stream.write("\n</DataArray>\n")


def _xml_section(stream, name, arrays, field=False):
    stream.write(f"<{name}>\n")
    for key, array in arrays.items():
        _xml_array(stream, key, np.asarray(array), field)
    stream.write(f"</{name}>\n")


def write_vtu(path, elements, point_data=None, cell_data=None):
    """point_data, cell_data: {name: (P,) or (P,k)}, {name: (H,) or (H,k)}, optional."""
    n, size = elements.hexes.shape
    cells = {"connectivity": elements.hexes.ravel(),
             "offsets": np.arange(size, size * n + 1, size),
             "types": np.full(n, _CELL_TYPE[elements.order], np.uint8)}
    with open(path, "w", encoding="ascii") as stream:
        stream.write('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
                     'byte_order="LittleEndian" header_type="UInt64">\n<UnstructuredGrid>\n')
        _xml_section(stream, "FieldData", _field_data(elements), field=True)
        stream.write(f'<Piece NumberOfPoints="{len(elements.points)}" '
                     f'NumberOfCells="{n}">\n')
        _xml_section(stream, "PointData", point_data or {})
        _xml_section(stream, "CellData", _cell_data(elements, cell_data))
        _xml_section(stream, "Points", {"Points": elements.points})
        _xml_section(stream, "Cells", cells)
        stream.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def _legacy_field(stream, title, arrays):
    stream.write(f"FIELD {title} {len(arrays)}\n".encode())
    for key, array in arrays.items():
        array = _plain(array)
        parts = array.shape[1] if array.ndim == 2 else 1
        # VTK's legacy "long" is 8 bytes on 64-bit Unix but 4 on Windows: write int
        kind = "double" if array.dtype.kind == "f" else "int"
        array = array.astype(">f8" if kind == "double" else ">i4")
        stream.write(f"{key} {parts} {len(array)} {kind}\n".encode())
        stream.write(array.tobytes() + b"\n")


def write_vtk(path, elements, point_data=None, cell_data=None):
    """As write_vtu, legacy format 3.0, binary."""
    n, size = elements.hexes.shape
    with open(path, "wb") as stream:
        stream.write(b"# vtk DataFile Version 3.0\nHex mesh by HexCon\nBINARY\n"
                     b"DATASET UNSTRUCTURED_GRID\n")
        _legacy_field(stream, "FieldData", _field_data(elements))
        stream.write(f"POINTS {len(elements.points)} double\n".encode())
        stream.write(elements.points.astype(">f8").tobytes())
        stream.write(f"\nCELLS {n} {n * (size + 1)}\n".encode())
        cells = np.column_stack([np.full(n, size), elements.hexes])
        stream.write(cells.astype(">i4").tobytes())
        stream.write(f"\nCELL_TYPES {n}\n".encode())
        stream.write(np.full(n, _CELL_TYPE[elements.order], ">i4").tobytes())
        stream.write(f"\nCELL_DATA {n}\n".encode())
        _legacy_field(stream, "FieldData", _cell_data(elements, cell_data))
        if point_data:
            stream.write(f"POINT_DATA {len(elements.points)}\n".encode())
            _legacy_field(stream, "FieldData", point_data)
