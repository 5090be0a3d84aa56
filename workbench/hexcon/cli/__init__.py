# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: hexcon mesh | check | repair | smooth | info | example | solve.

Exit status: 0 done; 1 a fault (its words on standard error); 2 wrong usage; 3 the mesh that `check`, `repair` or
`smooth` tells of is not certified; 129, 130, 143 ended by SIGHUP, SIGINT, SIGTERM; 141 nobody read the answer to its
end.
"""
import json

from hexcon_native.errors import HexconError

from . import in_freecad, terminal
from .arguments import parse, settle_order
from .terminal import complain, say

EXIT_DONE, EXIT_FAULT, EXIT_NOT_CERTIFIED = 0, terminal.EXIT_FAULT, 3

__all__ = ["main", "program"]


def program(arguments=None):
    """The whole program: main, with its streams and signals; returns the exit status."""
    return terminal.run(lambda: main(arguments), "hexcon")


def main(arguments=None):
    """Run one command; returns the exit status. Raises KeyboardInterrupt."""
    options = parse(arguments)
    try:
        settle_order(options)
        solid, outputs = getattr(options, "solid", None), getattr(options, "output", None)
        paths = [options.input, *([solid] if solid else []), *(outputs or [])]
        if in_freecad.needs_freecad(paths) and not in_freecad.can_import_freecad():
            status = in_freecad.rerun(arguments)
            if status is not None:
                return status
        facts, lines = options.run(options)
    except HexconError as fault:
        _tell_fault(fault, options.json)
        return EXIT_FAULT
    say(json.dumps(facts) if options.json else "\n".join(lines))
    failed = options.command in ("check", "repair", "smooth") and not facts["certified"]
    return EXIT_NOT_CERTIFIED if failed else EXIT_DONE


def _tell_fault(fault, as_json):
    code = getattr(fault.code, "name", None)
    if as_json:
        say(json.dumps({"error": str(fault), "code": code, "elements": fault.elements}))
        return
    complain(f"hexcon: {fault} [{code}]")
    if fault.elements:
        shown = ", ".join(map(str, fault.elements[:20]))
        more = f" and {len(fault.elements) - 20} more" if len(fault.elements) > 20 else ""
        complain(f"hexcon: ids: {shown}{more}")
