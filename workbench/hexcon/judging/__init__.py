# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be said of a mesh or a surface: one judge for the command line, the window and the document objects."""
