# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading CalculiX's .frd results (ASCII): nodal displacements and stresses."""
import re

import numpy as np

END = b"9999"  # the last line
_VALUE = re.compile(rb"[-+]?\d\.\d{5}E[-+]\d{2,3}")


def _last_block(data, name):
    """Bytes of the data lines of the last nodal result called name, or None."""
    start = data.rfind(b"\n -4  " + name.ljust(8))
    if start < 0:
        return None
    first = data.find(b"\n -1", start)
    end = data.find(b"\n -3", start)
    return data[first + 1:end + 1] if 0 <= first < end else b""


def _table(block, components):
    """(ids (n,), values (n,components)) of fixed-width lines: I10 after " -1", then E12.5."""
    width = 13 + 12 * components + 1
    if len(block) % width == 0:
        grid = np.frombuffer(block, "S1").reshape(-1, width)
        if (grid[:, -1] == b"\n").all():
            ids = np.ascontiguousarray(grid[:, 3:13]).view("S10").astype(np.int64)
            values = np.ascontiguousarray(grid[:, 13:-1]).view("S12").astype(float)
            return ids.reshape(-1), values.reshape(-1, components)
    # three-digit exponents make some lines longer
    lines = block.splitlines()
    ids = np.array([int(line[3:13]) for line in lines])
    values = np.array([_VALUE.findall(line[13:])[:components] for line in lines])
    return ids, values.astype(float)


def read(path):
    """{"node_ids" (n,), "displacements" (n,3), "stress" (n,6)|None} of the last step.

    Stress components xx yy zz xy yz zx, in the deck's units, extrapolated to the nodes.
    Returns None where the file holds no displacements, or lacks its last line: ccx did not get
    that far, or the disk was full, which it does not notice.
    """
    with open(path, "rb") as stream:
        data = stream.read()
    if data.rstrip()[-4:] != END:
        return None
    block = _last_block(data, b"DISP")
    if not block:
        return None
    ids, displacements = _table(block, 3)
    block = _last_block(data, b"STRESS")
    stress = None
    if block:
        stress_ids, listed = _table(block, 6)
        stress = np.full((len(ids), 6), np.nan)
        place = np.searchsorted(ids, stress_ids)
        stress[place] = listed
    return {"node_ids": ids, "displacements": displacements, "stress": stress}


def von_mises(stress):
    """(n,) of (n,6) stresses xx yy zz xy yz zx."""
    x, y, z, xy, yz, zx = np.asarray(stress, float).T
    return np.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2)
                   + 3 * (xy * xy + yz * yz + zx * zx))
