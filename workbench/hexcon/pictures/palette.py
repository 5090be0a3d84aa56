# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of meshes, in pictures and in the window. Numpy alone: the drawing programs import it from their folder."""
import numpy as np


def _colours(*words):
    return np.array([[int(word[k:k + 2], 16) for k in (0, 2, 4)] for word in words]) / 255


# Scaled Jacobians 0 to 1: low quality warm, good quality cool; below 0 (inverted) one colour of its own
QUALITY = _colours("A50026", "DE3F2E", "F88E52", "FED485", "F6F6C8", "B7DDD8", "74ADD1", "4575B4")
INVERTED = _colours("50005A")

# Okabe and Ito's colours: told apart without full colour vision, too. First those of the stages.
STAGE_COLOURS = _colours("E69F00", "56B4E9", "009E73", "CC79A7", "D55E00", "0072B2", "F0E442")
LOOP_COLOURS = _colours("0072B2", "D55E00", "009E73", "CC79A7", "E69F00", "56B4E9")
PAIR_COLOURS = _colours("8DD3C7", "FFFFB3", "BEBADA", "FB8072", "80B1D3", "FDB462", "B3DE69", "FCCDE5",
                        "BC80BD", "CCEBC5", "FFED6F", "D9D9D9")
PLAIN = np.array([0.93, 0.93, 0.91])          # a quad that means nothing in itself
DARK = np.array([0.10, 0.11, 0.13])           # marks


def quality_colours(scaled_jacobian):
    """(k,3) colours of scaled Jacobians (k,)."""
    values = np.asarray(scaled_jacobian, float)
    stops = np.linspace(0.0, 1.0, len(QUALITY))
    colours = np.column_stack([np.interp(values, stops, channel) for channel in QUALITY.T])
    colours[values < 0.0] = INVERTED[0]
    return colours


def loop_colours(count):
    """(count,3) colours of dual loops, in turn."""
    return LOOP_COLOURS[np.arange(count) % len(LOOP_COLOURS)]
