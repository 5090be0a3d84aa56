# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged files of every kind, a seeded sample of what mutate_files.py makes: no traceback, no hang, no death."""
import json
import os
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from mutate_files import FINDINGS, KINDS  # noqa: E402

# Files of each kind; fewer where a reader of a damaged file often has to be stopped.
COUNT = {**dict.fromkeys(KINDS, 14), "brep": 4, "step": 8, "step-gmsh": 2, "brep-gmsh": 2}
FIRST = 500_000     # seeds that longer runs by hand do not come to


@pytest.mark.parametrize("kind", KINDS)
def test_damaged_files(kind, tmp_path):
    """In a process of its own, which must be there at the end."""
    done = subprocess.run([sys.executable, str(HERE / "mutate_files.py"), kind, "--first", str(FIRST), "--count", str(COUNT[kind])],
                          capture_output=True, text=True, check=False, env={**os.environ, "TMPDIR": str(tmp_path)})
    assert done.returncode == 0, done.stderr[-3000:]
    found = json.loads(done.stdout)
    assert found["files"] == COUNT[kind] == sum(found["counts"].values())
    assert not found["findings"] and not set(FINDINGS) & set(found["counts"]), done.stderr[-3000:]
    assert not list(tmp_path.iterdir())
