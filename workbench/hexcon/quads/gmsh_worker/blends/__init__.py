# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of layered solids: meshed as if their corners were sharp, a sheet under them, then brought on to the CAD."""
