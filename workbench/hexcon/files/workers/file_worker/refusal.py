# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fault on its way from this process to the caller."""


class Refusal(Exception):
    """`code` is the name of a hexcon.errors.FaultCode member."""

    def __init__(self, code, message, elements=()):
        super().__init__(message)
        self.code = code
        self.elements = [int(e) for e in elements][:1000]
