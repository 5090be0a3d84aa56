# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of length of files, and whether a model can be of the size that its numbers say, in mm."""
import numpy as np

UNITS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4, "foot": 304.8, "um": 0.001}
SMALL, LARGE = 0.1, 1e5     # mm across: below and above, another unit is likelier


def doubt(points):
    """[a sentence] where a model of these points (P,3), in mm, is smaller or larger than parts are; else []."""
    if not len(points) or not np.isfinite(points).all():
        return []
    across = float(np.linalg.norm(np.ptp(points, axis=0)))
    if 0.0 < across < SMALL:
        return [f"the model is {across:.3g} mm across: are its lengths metres? --unit m, or --scale 1000, converts "
                f"them"]
    if across > LARGE:
        return [f"the model is {across:.3g} mm across ({across / 1000:.4g} m): are its lengths micrometres? --unit "
                f"um, or "
                "--scale 0.001, converts them"]
    return []
