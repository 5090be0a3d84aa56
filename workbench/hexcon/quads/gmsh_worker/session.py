# SPDX-License-Identifier: LGPL-2.1-or-later
"""One job in a subprocess with gmsh: read it, do it, leave result.npz or fault.json beside it.

The tetrahedra's worker runs in the same way and imports this, fault and link.
"""
import json
import os

import gmsh
import numpy as np
from file_worker import limits

from .fault import WorkerFault
from .link import Link


def run(job_path, work):
    """work: callable(job, link) -> arrays of result.npz; a WorkerFault from it is written to fault.json. Returns 0."""
    with open(job_path, encoding="utf-8") as stream:
        job = json.load(stream)
    folder = os.path.dirname(job_path)
    limits.keep_to(job["timeout"])
    link = Link(folder, job["avoid"])
    gmsh.initialize([], False)
    try:
        for name, value in (("Terminal", 1), ("NumThreads", 1), ("Verbosity", 4)):
            gmsh.option.setNumber("General." + name, value)
        result = work(job, link)
    except WorkerFault as fault:
        with open(os.path.join(folder, "fault.json"), "w", encoding="utf-8") as stream:
            json.dump({"code": fault.code, "message": str(fault), "elements": fault.elements}, stream)
        return 0
    np.savez(os.path.join(folder, "result.npz"), **result)
    return 0
