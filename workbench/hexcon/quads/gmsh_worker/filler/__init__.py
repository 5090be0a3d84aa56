# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method filled: rooms that no template knows are filled from the quads round them, the rest is natural."""
