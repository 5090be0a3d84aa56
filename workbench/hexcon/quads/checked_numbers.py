# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that are numbers."""
import math

from hexcon.errors import FaultCode, ToolError


def check_number(name, value, at_least_zero=False):
    """Raise BAD_OPTION unless an option is a finite number above zero, or of at least zero."""
    try:
        good = math.isfinite(float(value)) and (float(value) > 0.0 or at_least_zero and float(value) == 0.0)
    except (TypeError, ValueError):
        good = False
    if not good:
        least = "of at least zero" if at_least_zero else "above zero"
        raise ToolError(f"{name} must be a finite number {least}, not {value!r}", FaultCode.BAD_OPTION)
