# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: hexcon mesh | check | info | example | solve.

Exit status: 0 done; 1 a fault (its words on standard error); 2 wrong usage; 3 `check` found the
mesh not certified; 130 interrupted.
"""
import json
import sys

from hexcon_native.errors import HexconError

from . import in_freecad
from .arguments import parse

EXIT_DONE, EXIT_FAULT, EXIT_NOT_CERTIFIED, EXIT_INTERRUPTED = 0, 1, 3, 130

__all__ = ["main"]


def main(arguments=None):
    """Run one command; returns the exit status."""
    arguments = sys.argv[1:] if arguments is None else arguments
    options = parse(arguments)
    paths = [options.input, *(getattr(options, "output", None) or [])]
    if in_freecad.needs_freecad(paths) and not in_freecad.can_import_freecad():
        status = in_freecad.rerun(arguments)
        if status is not None:
            return status
    try:
        facts, lines = options.run(options)
    except HexconError as fault:
        _tell_fault(fault, options.json)
        return EXIT_FAULT
    except KeyboardInterrupt:
        print("hexcon: interrupted; nothing was written", file=sys.stderr)
        return EXIT_INTERRUPTED
    if options.json:
        print(json.dumps(facts))
    else:
        print("\n".join(lines))
    failed = options.command == "check" and not facts["certified"]
    return EXIT_NOT_CERTIFIED if failed else EXIT_DONE


def _tell_fault(fault, as_json):
    if as_json:
        print(json.dumps({"error": str(fault), "code": fault.code.name,
                          "elements": fault.elements}))
        return
    print(f"hexcon: {fault} [{fault.code.name}]", file=sys.stderr)
    if fault.elements:
        shown = ", ".join(map(str, fault.elements[:20]))
        more = f" and {len(fault.elements) - 20} more" if len(fault.elements) > 20 else ""
        print(f"hexcon: ids: {shown}{more}", file=sys.stderr)
