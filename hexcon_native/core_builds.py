# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which build of the core this system loads: one made here, beside this file, or else the release's for this system.

A release has a folder for each system below `built`; the package's search path ends with this system's.
"""
import os
import platform
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
BUILT = os.path.join(HERE, "built")
_SYSTEMS = {"win32": "windows", "darwin": "macos"}
_MACHINES = {"amd64": "x86_64", "arm64": "aarch64"}
LEAST_PYTHON = (3, 11)


def system_name():
    """As folders of `built` are called, "linux-x86_64"; for a Python of 32 bits, which needs another, "...-32bit"."""
    machine = platform.machine().lower()
    bits = "" if sys.maxsize > 2**32 else "-32bit"
    return f"{_SYSTEMS.get(sys.platform, sys.platform)}-{_MACHINES.get(machine, machine)}{bits}"


def folder():
    """Where a release has this system's core; it need not be there."""
    return os.path.join(BUILT, system_name())


def found():
    """Names of the cores that are there: "built here", and the systems of a release."""
    here = ["built here"] if any(name.startswith("_core.") for name in os.listdir(HERE)) else []
    return here + sorted(os.listdir(BUILT) if os.path.isdir(BUILT) else [])


def what_is_missing(fault):
    """Words for an import of the core that failed: what was looked for, what is there, what to do."""
    there = found()
    words = [f"HexCon's native core is missing or does not load ({fault})."]
    if sys.version_info < LEAST_PYTHON:
        words.append("It needs Python {}.{} or newer; this is {}.{}.".format(*LEAST_PYTHON, *sys.version_info[:2]))
    words.append(f"This system is {system_name()}; of cores there "
                 + (f"are: {', '.join(there)}." if there else "is none."))
    if "built here" in there:
        words.append("One that was built here comes first: where it is of another system, remove it.")
    words.append("Build it with `make build` in HexCon's folder, for which a C compiler is needed.")
    return " ".join(words)
