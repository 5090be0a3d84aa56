# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs inside the gmsh subprocess for smoothing: `python -m smoothing_worker JOB.json`."""
