# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option pillow of hexcon_native.mesh where it is text: on the command line, in documents, in the window."""
import hexcon_native

MOST_OFFERED = 3
CHOICES = (*hexcon_native.PILLOWS, *(str(sheets) for sheets in range(1, MOST_OFFERED + 1)))

HELP = ("sheets of hexes under the whole surface, each as many hexes as there are quads: auto, one where the worst hex "
        "is poor and becomes clearly better; never; or so many (default auto)")


def pillow_of(text):
    """As hexcon_native.mesh takes it: a number of sheets, or what is none as it is."""
    return int(text) if str(text).isdecimal() else text
