# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD and its libraries print: many lines and no news."""
import contextlib
import os
import sys


@contextlib.contextmanager
def chatter_to(path=os.devnull):
    """Send standard output, of C++ libraries too, to a file (a new one) while inside."""
    sys.stdout.flush()
    kept = os.dup(1)
    with open(path, "wb") as log:
        os.dup2(log.fileno(), 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
