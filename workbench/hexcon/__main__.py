# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 -m hexcon"""
import sys

from hexcon.cli import main

sys.exit(main())
