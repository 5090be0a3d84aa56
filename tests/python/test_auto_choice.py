# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which surface method's mesh auto takes, on rows of a table and meshes of one quad made for it."""
from types import SimpleNamespace

import numpy as np
import pytest

from hexcon.quads.gmsh_worker.auto import taken
from hexcon.quads.gmsh_worker.fault import WorkerFault


def row(name, natural=True, refusal="NOT_SWEEPABLE"):
    return SimpleNamespace(label=name, natural=natural, refusal=refusal, refused=f"no {name}")


def mesh(sine, note):
    """One rhombus whose corners have this sine."""
    x, y = np.sqrt(1.0 - sine * sine), sine
    return {"points": np.array([[0.0, 0, 0], [1, 0, 0], [1 + x, y, 0], [x, y, 0]]), "quads": np.array([[0, 1, 2, 3]]),
            "notes": np.array([note])}


def chosen(sines, natural=(True, True, True, False)):
    """(Note of the mesh taken, all notes, names tried, sines settled); None among sines: that method refuses."""
    rows = [row(f"method{k}", natural[k]) for k in range(len(sines))]
    tried, settled = [], []

    def made(one, notes):
        k = rows.index(one)
        tried.append(k)
        if sines[k] is None:
            raise WorkerFault("NOT_SWEEPABLE", "for this reason")
        own = mesh(sines[k], f"made by {k}")
        return {**own, "notes": np.array([*notes, *own["notes"]])}

    found = taken(rows, made, ["given"], lambda arrays: settled.append(str(arrays["notes"][-1])))
    notes = [str(note) for note in found["notes"]]
    assert notes[0] == "given" and len(set(notes)) == len(notes)
    return notes[-1], notes, tried, settled


def test_the_first_good_one_ends_it():
    assert chosen([None, 0.5, 0.9])[::2] == ("made by 1", [0, 1])


def test_poor_natural_hexes_are_kept_until_better_ones_are_there():
    last, notes, tried, settled = chosen([0.1, None, 0.5, 0.9])
    assert last == "made by 2" and tried == [0, 1, 2] and settled == ["made by 0"]
    assert "auto: method0: a least scaled Jacobian of 0.10, so other methods were tried" in notes
    assert "auto: no method1: for this reason" in notes


def test_poor_natural_hexes_stay_where_others_are_no_better():
    last, notes, tried, settled = chosen([0.1, 0.11, None, 0.9])
    assert last == "made by 0" and tried == [0, 1, 2] and settled == ["made by 0"] * 2
    assert notes[-2] == "auto: no method2: for this reason"


def test_what_is_not_natural_is_taken_as_it_is():
    assert chosen([None, None, None, 0.1])[0] == "made by 3"


def test_the_last_refusal_is_told_and_others_at_once():
    with pytest.raises(WorkerFault, match="for this reason"):
        chosen([None, None])
    rows = [row("one", refusal="NOT_BLOCKS"), row("two")]

    def refuse(one, _notes):
        raise WorkerFault("NOT_SWEEPABLE", one.label)
    with pytest.raises(WorkerFault, match="one"):
        taken(rows, refuse, [], None)
