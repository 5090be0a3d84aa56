# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshio package, for writing."""
from hexcon.errors import FaultCode, ToolError


def import_meshio(path):
    """The meshio package. Raises ToolError(TOOL_MISSING)."""
    try:
        import meshio
    except ImportError as error:
        raise ToolError(f"{path} needs the Python package meshio (Debian: apt install "
                        "python3-meshio)", FaultCode.TOOL_MISSING) from error
    return meshio
