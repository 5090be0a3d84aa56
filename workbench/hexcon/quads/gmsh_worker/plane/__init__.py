# SPDX-License-Identifier: LGPL-2.1-or-later
"""All-quad meshes of regions of a plane whose boundary is divided already."""
