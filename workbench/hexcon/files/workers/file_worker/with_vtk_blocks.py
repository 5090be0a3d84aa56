# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's readers of files in blocks: Exodus II, with side and node sets, and CGNS."""
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkVersion

from .mesh import joined, mesh_arrays
from .with_vtk import arrays_of


def read(path):
    """Arrays of mesh.mesh_arrays. Raises ValueError."""
    vtkObject.GlobalWarningDisplayOff()
    return _cgns(path) if os.path.splitext(path)[1].lower() == ".cgns" else _exodus(path)


def _cgns(path):
    from vtkmodules.vtkFiltersCore import vtkAppendFilter
    from vtkmodules.vtkIOCGNSReader import vtkCGNSReader
    reader = vtkCGNSReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.LoadBndPatchOff()
    reader.Update()
    together = vtkAppendFilter()
    together.MergePointsOff()
    count = 0
    for data in _leaves(reader.GetOutput()):
        together.AddInputData(data)
        count += 1
    if not count:
        raise ValueError("VTK finds no cells in it")
    together.Update()
    found = arrays_of(together.GetOutput())
    if not any(str(kind).startswith(("quad", "hexahedron")) for kind in found["kinds"]):    # gmsh's files, VTK 9.1
        raise ValueError(f"VTK {vtkVersion.GetVTKVersion()} finds no quads and no hexes in it, only "
                         + ", ".join(f"{count} {kind}" for kind, count in zip(found["kinds"], found["counts"]))
                         + "; later versions (9.6) find more in some files")
    return found


def _leaves(blocks):
    for k in range(blocks.GetNumberOfBlocks() if blocks is not None else 0):
        block = blocks.GetBlock(k)
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            yield from _leaves(block)
        elif block is not None and block.GetNumberOfCells():
            yield block


def _exodus(path):
    """Element blocks by the file's numbers of points; sets by the same."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    if not reader.CanReadFile(path):
        raise ValueError("no Exodus II file")
    reader.SetGenerateGlobalNodeIdArray(True)
    reader.UpdateInformation()
    for kind in (reader.SIDE_SET, reader.NODE_SET):
        for k in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, k, 1)
    reader.Update()
    output, total = reader.GetOutput(), reader.GetTotalNumberOfNodes()
    points, blocks, groups = np.zeros((total, 3)), [], []
    for k in range(output.GetNumberOfBlocks()):
        held, name = output.GetBlock(k), output.GetMetaData(k).Get(output.NAME()) if output.HasMetaData(k) else ""
        for j in range(held.GetNumberOfBlocks() if held is not None and held.IsA("vtkMultiBlockDataSet") else 0):
            data = held.GetBlock(j)
            if data is None or not data.GetNumberOfPoints():
                continue
            label = held.GetMetaData(j).Get(output.NAME()) if held.HasMetaData(j) else f"{name} {j + 1}"
            ids = vtk_to_numpy(data.GetPointData().GetArray("GlobalNodeId")).astype(np.int64) - 1
            if "Node Set" in name:
                groups.append((label, "nodes", np.unique(ids)))
                continue
            found = arrays_of(data)
            rows = ids[found["entries"]]
            points[ids] = found["points"]
            at = 0
            for kind, count, width in zip(found["kinds"], found["counts"], found["widths"]):
                cells = rows[at:at + count * width].reshape(count, width)
                at += count * width
                if "Side Set" in name or "Face Set" in name:
                    if str(kind).startswith("quad"):
                        groups.append((label, "faces", cells[:, :4]))
                else:
                    blocks.append((str(kind), cells))
    if not blocks:
        raise ValueError("VTK finds no elements in it")
    together, _ = joined(blocks)
    return mesh_arrays(points, together, groups)
