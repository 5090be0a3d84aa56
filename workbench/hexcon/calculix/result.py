# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run through FreeCAD's FEM gives back."""
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Result:
    """Rows in the mesh's own node order, 0-based; mm, N, MPa.

    document_object   FreeCAD's result object (Fem::FemResultObject...)
    document_objects  every object the run added: analysis, solver, material, constraints,
                      result, result mesh
    displacements (P,3), von_mises (P,), stress (P,6) xx yy zz xy yz zx, at the nodes
    inp_path, frd_path  files of the run;  ccx_log  ccx's output
    report            dict: "notes" list of what was put right, "force_sum" [fx, fy, fz] of all
                      nodal loads in the deck
    """

    document_object: object
    document_objects: list
    displacements: np.ndarray
    stress: np.ndarray
    von_mises: np.ndarray
    inp_path: str
    frd_path: str
    ccx_log: str
    report: dict = field(default_factory=dict)

    @property
    def max_displacement(self):
        """Largest magnitude of the displacements."""
        return float(np.linalg.norm(self.displacements, axis=1).max(initial=0.0))
