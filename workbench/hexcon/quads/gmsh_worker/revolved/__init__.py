# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface method `revolved`: quads of half a section, turned round the axis of a solid of revolution."""
