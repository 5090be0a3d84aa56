# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs inside the gmsh subprocess for curved edges: `python -m curving_worker JOB.json`."""
