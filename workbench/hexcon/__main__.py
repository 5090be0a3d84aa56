# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -P -m hexcon; or this file as a program, as bin/hexcon runs it."""
import signal
import sys

if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
    signal.signal(signal.SIGINT, signal.SIG_DFL)    # while modules load there is nothing to clean up, nor to explain

from hexcon.cli import program  # noqa: E402

sys.exit(program())
