# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a deck loads anything: ccx solves one that does not, and its zeros look like an answer."""
import re

from hexcon.errors import FaultCode, ToolError

_LOADS = ("*CLOAD", "*DLOAD", "*DSLOAD", "*TEMPERATURE", "*CFLUX", "*DFLUX", "*FILM", "*RADIATE")
# What may load a static step in a way that is not looked at, or is no static step at all.
_OTHERS = ("*INCLUDE", "*INITIAL CONDITIONS", "*PRE-TENSION SECTION", "*CONTACT PAIR",
           "*COUPLED TEMPERATURE-DISPLACEMENT", "*UNCOUPLED TEMPERATURE-DISPLACEMENT", "*HEAT TRANSFER",
           "*FREQUENCY", "*BUCKLE", "*DYNAMIC", "*MODAL DYNAMIC", "*STEADY STATE DYNAMICS", "*VISCO", "*GREEN",
           "*SUBSTRUCTURE GENERATE", "*ELECTROMAGNETICS", "*CFD", "*COMPLEX FREQUENCY", "*SENSITIVITY",
           "*CRACK PROPAGATION")
_OTHER = re.compile(rf"(?im)^\*(?:{'|'.join(re.escape(card[1:]) for card in _OTHERS)})\b")


def check_deck(text):
    """Raise ToolError BAD_OPTION for a deck of static steps whose loads are all zero, or that has none.

    Loads are forces, pressures, fluxes and temperatures that are not zero, and displacements that a step prescribes by
    a value. One search of the deck, and linear in what comes after the first *STEP.
    """
    step = re.search(r"(?im)^\*STEP\b", text)
    if step is None or _OTHER.search(text):
        return
    given = []
    for card in re.split(r"(?m)^(?=\*[^*])", re.sub(r"(?m)^\*\*.*\n?", "", text[step.start():])):
        head, _, data = card.partition("\n")
        keyword = head.split(",")[0].strip().upper()
        if keyword == "*BOUNDARY" and any(len(row.split(",")) > 3 and row.split(",")[3].strip()
                                          for row in data.splitlines()):
            return
        if keyword in _LOADS:
            if any(_is_load(row.split(","), keyword) for row in data.splitlines()):
                return
            given.append(keyword)
    what = f"its {', '.join(dict.fromkeys(given))} are all zero, or empty" if given else "it has none"
    raise ToolError(f"the deck loads nothing: {what}, so that nothing would move. The nodes of a loaded face may not "
                    "have been found: see that the mesh lies on the solid", FaultCode.BAD_OPTION)


def _is_load(row, keyword):
    """Whether a data row has a number that is not zero where loads stand."""
    for word in row[1 if keyword == "*TEMPERATURE" else 2:]:
        try:
            if float(word) != 0.0:
                return True
        except ValueError:
            continue
    return False
