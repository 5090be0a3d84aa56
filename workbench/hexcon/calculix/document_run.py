# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all ways of solving in a FreeCAD document share: the deck's folder, the run, and what comes back of it."""
from contextlib import contextmanager

import numpy as np

from hexcon import disk, keeper
from hexcon.errors import FaultCode, HexconError, ToolError
from hexcon.labels import rows_of

from .runner import run_ccx


@contextmanager
def kept_for_a_reason(folder, given=None):
    """A folder of ours is kept with the deck in it, unless the disk could not hold that, or the process is ended.

    given   the folder, where it is the caller's and stays in any case
    """
    try:
        with disk.naming(folder, f"work in {folder}"):
            yield
    except HexconError as fault:
        if fault.code is FaultCode.FILE_IO and not given:
            disk.remove_folder(folder)
        keeper.let_folder_go(folder)
        raise
    keeper.let_folder_go(folder)


@contextmanager
def staying_in_its_group(mesh_object):
    """If anything fails inside, the mesh object is in its group, an analysis mostly, as before. None: nothing to do."""
    group = mesh_object.getParentGroup() if mesh_object is not None else None
    try:
        yield
    except BaseException:
        if group is not None and mesh_object not in group.Group:
            group.addObject(mesh_object)
        raise


def run_deck(path, mesh, hex_numbers, node_numbers, waiting=None, **options):
    """ccx on a deck. FreeCAD's own ccx_run has no time limit, and makes an empty result of a failed run.

    hex_numbers, node_numbers  the deck's numbers of the mesh's hexes and points
    waiting  as analysis.solve;  options  of runner.run_ccx
    Returns (results, log) of run_ccx. Raises as that; .elements are rows of hexes.
    """
    def job(progress):
        return run_ccx(path, progress=progress, nodes=node_numbers[np.unique(mesh.hexes)], **options)
    try:
        return waiting(job, "CalculiX") if waiting else job(None)
    except ToolError as error:
        # ccx names the deck's element numbers; users of arrays want rows
        rows = np.flatnonzero(np.isin(hex_numbers, np.array(error.elements) + 1))
        error.elements = rows.tolist()[:1000]
        error.args = (f"{error}\n(the deck is kept: {path})",)
        raise


def result_object_of(analysis):
    """FreeCAD's newest result object in an analysis. Raises ToolError TOOL_FAILED without one, or without values."""
    results = [o for o in analysis.Group if o.isDerivedFrom("Fem::FemResultObject")]
    if not results or not results[-1].DisplacementVectors:
        raise ToolError("FreeCAD read no displacements from CalculiX's results", FaultCode.TOOL_FAILED)
    return results[-1]


def in_order_of(node_numbers, found):
    """(displacements (P,3), stress (P,6)) of run_deck's results, a row for each of the deck's node_numbers (P,)."""
    rows = rows_of(node_numbers, found["node_ids"])
    displacements, stress = np.zeros((len(node_numbers), 3)), np.zeros((len(node_numbers), 6))
    displacements[rows], stress[rows] = found["displacements"], found["stress"]
    return displacements, stress
