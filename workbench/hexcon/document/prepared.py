# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel's worker has just computed, for the very call that puts it into the document.

So the panels work in a thread, and what lands in the macro recorder is still the whole call.
"""
from contextlib import contextmanager

_prepared = {}


@contextmanager
def prepared(result):
    """Inside, the next action takes this result instead of computing it."""
    _prepared["result"] = result
    try:
        yield
    finally:
        _prepared.clear()


def taken():
    """The prepared result, once; None if there is none."""
    return _prepared.pop("result", None)
