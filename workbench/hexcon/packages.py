# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python packages that FreeCAD's own Python lacks, put where its Addon Manager puts them, by pip."""
import importlib
import importlib.util
import os
import sys

from hexcon import child, freecad_compat, gmsh_process, interpreter
from hexcon.errors import FaultCode, ToolError

SECONDS = 1800      # gmsh and SciPy are some 100 MB


def missing():
    """Names of what gmsh's processes need and this FreeCAD cannot import."""
    importlib.invalidate_caches()
    return [name for name in gmsh_process.NEEDED if importlib.util.find_spec(name) is None]


def install(progress=None):
    """Get what is missing; then gmsh is sought anew. progress: callable (stage, fraction); what it raises ends it.

    Raises ToolError: TOOL_MISSING, TOOL_FAILED (pip's words), TOOL_TIMEOUT, FREECAD_MISSING.
    """
    python, folder, names = interpreter.python(), freecad_compat.packages_folder(), missing()
    if names:
        command = [python, "-m", "pip", "install", "--disable-pip-version-check", "--no-input", "--target", folder]
        # a distribution's pip would refuse, as if the folder were the system's
        environment = child.python_environment(python, PIP_BREAK_SYSTEM_PACKAGES="1")
        ended = child.run([*command, *names], "pip", environment=environment, timeout=SECONDS,
                          look=progress and (lambda: progress("start", 0.0)))
        if ended.status != 0:
            raise ToolError(f"pip ({python} -m pip) could not install {', '.join(names)}: {ended.last_words(3)}",
                            FaultCode.TOOL_FAILED)
        if os.path.isdir(folder) and folder not in sys.path:
            sys.path.append(folder)
    gmsh_process.forget_gmsh_python()
