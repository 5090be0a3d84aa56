# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one exception every HexCon fault derives from."""


class HexconError(Exception):
    """A fault with a name, the ids of what is at fault, and words for the user.

    code      one enum member per fault: hexcon_native.ErrorCode for the core,
              hexcon.errors.FaultCode for the programs around it
    elements  offending ids, 0-based, at most 1000 (empty where none apply)
    """

    def __init__(self, message, code, elements=()):
        super().__init__(message)
        self.code = code
        self.elements = [int(e) for e in elements][:1000]
