# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method layered: solids whose faces lie across a direction or along it, by one plane mesh in many levels."""
