# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method boxed: layered but for features across the layers, in boxes with layers of their own."""
