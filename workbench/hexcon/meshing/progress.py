# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress callbacks as surfaces take them, and the clock that ends them."""
import time

from hexcon_native import ErrorCode, HexconError


def raising(progress):
    """A progress for surfaces, which cancel by exception only: a False is turned into one."""
    if progress is None:
        return None

    def report(stage, fraction):
        if progress(stage, fraction) is False:
            raise HexconError(f"cancelled during {stage}", ErrorCode.CANCELLED)
    return report


def limited(progress, deadline):
    """A progress for surfaces that ends them once the budget is used up: their programs are killed."""
    if deadline is None:
        return progress

    def report(stage, fraction):
        if time.monotonic() > deadline:
            raise out_of_time()
        if progress is not None:
            progress(stage, fraction)
    return report


def deadline_of(options):
    """When the monotonic clock says so, the budget among the options is used up; None: there is none."""
    budget = options.get("budget")
    return time.monotonic() + budget if isinstance(budget, (int, float)) and budget > 0 else None


def in_budget(options, deadline):
    """The options with what is left of the budget; raises OUT_OF_TIME where nothing is."""
    if deadline is None:
        return options
    left = deadline - time.monotonic()
    if left <= 0.0:
        raise out_of_time()
    return {**options, "budget": left}


def out_of_time():
    return HexconError("the time budget ran out while the surface was being made, before there was a mesh: allow "
                       "more time, or mesh with larger quads", ErrorCode.OUT_OF_TIME)
