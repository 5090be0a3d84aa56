# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker may use at most: the caller's clock is not the only one. gmsh's workers keep to these too."""
import os
import signal

try:
    import resource
except ImportError:     # not on Windows, where the caller's clock alone ends this process
    resource = None

GRACE = 30      # seconds after which this process ends itself, should the caller have been killed


def machine_memory():
    """Bytes that this machine has; a large number where it does not say."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):
        return 1 << 62


def keep_to(seconds, memory=None):
    """Limit processor time (s), address space and what is written (bytes, at most the machine's memory); no core is
    dumped. A lower limit that is there already stays."""
    seconds = min(int(seconds), 10 ** 8)    # more is no limit, and no number for the system
    memory = min(memory or machine_memory(), machine_memory())
    if hasattr(signal, "alarm"):
        signal.alarm(seconds + GRACE)
    if resource is None:
        return
    for name, most in (("RLIMIT_CPU", seconds + 1), ("RLIMIT_AS", memory), ("RLIMIT_FSIZE", memory),
                       ("RLIMIT_CORE", 0)):
        try:
            given = resource.getrlimit(getattr(resource, name))
            most = min([most, *(limit for limit in given if limit != resource.RLIM_INFINITY)])
            resource.setrlimit(getattr(resource, name), (most, given[1]))
        except (AttributeError, OSError, ValueError):   # a system without this limit
            pass
