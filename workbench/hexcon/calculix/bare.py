# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving a bare .inp deck, without FreeCAD."""
import os
import re
from contextlib import nullcontext
from dataclasses import dataclass

import numpy as np

from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.files.regular import regular_file

from . import frd
from .judging import judged_points
from .runner import run_ccx


@dataclass
class InpResult:
    """What ccx found, last step.

    node_ids (n,) the deck's own numbers; displacements (n,3); stress (n,6)|None xx yy zz
    xy yz zx at the nodes; von_mises (n,)|None; integration_points (m,8)|None: element
    number, point number, the six stresses (where the deck asks *EL PRINT S); log: ccx's.
    """

    node_ids: np.ndarray
    displacements: np.ndarray
    stress: np.ndarray
    von_mises: np.ndarray
    integration_points: np.ndarray
    log: str

    @property
    def max_displacement(self):
        return float(np.linalg.norm(self.displacements, axis=1).max(initial=0.0))


def _deck_text(deck):
    """Text of a deck given as text or path; relative *INCLUDE files become absolute."""
    if not isinstance(deck, os.PathLike) and "\n" in deck:
        return deck
    path = os.path.abspath(regular_file(deck))
    try:
        with open(path, encoding="utf-8", errors="replace") as stream:
            text = stream.read()
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}", FaultCode.FILE_IO) from error

    def absolute(match):
        return match.group(1) + os.path.join(os.path.dirname(path), match.group(2))
    return re.sub(r"(?im)^(\*INCLUDE\s*,\s*INPUT\s*=\s*)(\S+)", absolute, text)


def solve_inp(deck, *, timeout=3600, threads=None, workdir=None, ccx=None, nodes=None):
    """Run ccx on a deck (text, or path of an .inp file) and read its results.

    workdir  folder that keeps deck.inp, deck.frd, ...; a temporary one if None
    nodes    node numbers that the results must cover, all others being strangers; None: any
    Raises ToolError: TOOL_MISSING, TOOL_FAILED with ccx's words, TOOL_TIMEOUT, FILE_IO.
    """
    text = _deck_text(deck)
    place = nullcontext(workdir) if workdir else disk.working_folder("hexcon-ccx-")
    with place as folder, disk.naming(folder, f"work in {folder}"):
        path = os.path.join(folder, "deck.inp")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        found, log = run_ccx(path, timeout=timeout, threads=threads, ccx=ccx, nodes=nodes)
        points = judged_points(os.path.join(folder, "deck.dat"))
    stress = found["stress"]
    return InpResult(found["node_ids"], found["displacements"], stress,
                     None if stress is None else frd.von_mises(stress), points, log)
