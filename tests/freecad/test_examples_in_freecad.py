# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example for freecadcmd: its deflection is that of beam theory, and a little more for shear."""
import re

from test_batch import in_freecadcmd


def test_solve_in_freecad():
    status, lines, errors = in_freecadcmd("examples/solve_in_freecad.py")
    assert status == 0, errors
    said = "\n".join(lines)
    assert re.search(r"^mesh +80 C3D20R, <certified>$", said, re.MULTILINE), said
    told = re.search(r"deflection +([\d.]+) mm, beam theory without shear ([\d.]+) mm", said)
    found, expected = map(float, told.groups())
    assert expected < found * 1.001 and found < 1.02 * expected
