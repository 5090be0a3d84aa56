# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's settings, in FreeCAD's parameters where FreeCAD is; without it, their defaults."""
import sys

GROUP = "User parameter:BaseApp/Preferences/Mod/HexCon"
# name: default; its type is the parameter's
DEFAULTS = {
    "GmshPython": "",       # interpreter that can import gmsh; "": sought
    "Threads": 0,           # 0: one per processor
    "SurfaceMethod": "auto",
    "Method": "auto",
    "Order": 1,
    "Remember": True,       # panels begin with what was used last: the three above
    "Force": 1000.0,        # N, of the last analysis
    "Folder": "",           # of the last import or export
    "ExportFormat": "",     # hexcon.files.formats.Format.name of the last export
    "FemMenu": True,        # HexCon's menu in the FEM workbench too
}


def _group():
    app = sys.modules.get("FreeCAD")
    return app.ParamGet(GROUP) if app is not None and hasattr(app, "ParamGet") else None


def value(name):
    """The setting of that name, one of DEFAULTS."""
    default, group = DEFAULTS[name], _group()
    if group is None:
        return default
    if isinstance(default, bool):
        return group.GetBool(name, default)
    read = {int: group.GetInt, float: group.GetFloat, str: group.GetString}[type(default)]
    return read(name, default)


def set_value(name, new):
    """Keep a setting; needs FreeCAD."""
    default, group = DEFAULTS[name], _group()
    if isinstance(default, bool):
        group.SetBool(name, bool(new))
    elif isinstance(default, int):
        group.SetInt(name, int(new))
    elif isinstance(default, float):
        group.SetFloat(name, float(new))
    else:
        group.SetString(name, str(new))
