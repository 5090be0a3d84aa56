# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rooms of the package hexcon: who may import whom. A room imports what stands before it, and nothing after."""
import ast
import pathlib

import pytest

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "workbench" / "hexcon"

# From below: a line is a floor, and rooms of one floor do not know each other. Modules of the top folder that are not
# named stand on the ground, with nothing but each other.
FLOORS = (
    ("femmesh", "tetrahedra"),
    ("files",),
    ("quads",),
    ("curving",),
    ("calculix", "examples", "inspection", "judging", "meshing", "smoothing"),
    ("pictures",),
    ("objects",),
    ("document",),
    ("gui", "cli"),
    ("batch",),
    ("__init__", "__main__"),
)
GROUND = 0
FLOOR = {room: number for number, rooms in enumerate(FLOORS, 1) for room in rooms}
NAMES_THE_WINDOW = "hexcon.window"      # by strings, for importlib


def modules():
    """name: path of every module of the package, "hexcon" itself included."""
    found = {}
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


MODULES = modules()


def imported(name, path):
    """(module of hexcon, line) for every import in a file, inside functions too."""
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"), str(path))):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = ".".join([*package[:len(package) - node.level + 1], *filter(None, [node.module])]) if node.level \
                else node.module
            names = [full if (full := f"{base}.{alias.name}") in MODULES else base for alias in node.names]
        else:
            continue
        yield from ((one, node.lineno) for one in names if one.split(".")[0] == "hexcon")


def room_of(module):
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else "__init__"


def floor_of(room):
    return FLOOR.get(room, GROUND)


def faults(name, path):
    room = room_of(name)
    for target, line in imported(name, path):
        other = room_of(target)
        if other == room or floor_of(other) == floor_of(room) == GROUND:
            continue
        if floor_of(other) >= floor_of(room):
            yield f"{name}, line {line}: {room} imports {target}"


def test_nothing_imports_upwards():
    assert [fault for name, path in sorted(MODULES.items()) for fault in faults(name, path)] == []


def test_all_folders_have_their_floor():
    folders = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    assert folders <= set(FLOOR) and {room for room in FLOOR} <= folders | {path.stem for path in PACKAGE.glob("*.py")}


def test_ground_has_no_circle():
    """Modules of the top folder, in which each may import those before it."""
    waiting = {name: {target for target, _ in imported(name, path) if target != name}
               for name, path in MODULES.items() if floor_of(room_of(name)) == GROUND}
    while waiting:
        free = {name for name, wanted in waiting.items() if not wanted & set(waiting)}
        assert free, f"circle among {sorted(waiting)}"
        waiting = {name: wanted for name, wanted in waiting.items() if name not in free}


def test_imports_by_string():
    """importlib and __import__ with a name of hexcon: in one place alone."""
    found = [name for name, path in MODULES.items() for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
             if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in MODULES
             and "." in node.value and name != NAMES_THE_WINDOW and floor_of(room_of(name)) < FLOOR["gui"]]
    assert found == []


@pytest.mark.parametrize("text,wrong", [
    ("from hexcon.gui import views", True), ("def f():\n    from ..document import making_hexes", True),
    ("import hexcon", True), ("from ..inspection.stages import counts_of", False), ("from . import parametric", False),
    ("from hexcon import errors, window", False), ("from hexcon import pictures", False), ("from .. import cli", True)])
def test_the_test_finds(tmp_path, text, wrong):
    path = tmp_path / "probe.py"
    path.write_text(text, encoding="utf-8")
    assert bool(list(faults("hexcon.objects.probe", path))) == wrong


SAVED = ("objects.quad_surface.QuadSurfaceObject", "objects.hex_mesh.HexMeshObject",
         "objects.quality_report.QualityReportObject", "femmesh.document.HexMesh", "gui.views.QuadSurfaceView",
         "gui.views.HexMeshView", "gui.views.QualityReportView")


@pytest.mark.parametrize("name", SAVED)
def test_names_in_saved_documents(name):
    """FreeCAD imports them by these names when it opens a document."""
    module, _, wanted = f"hexcon.{name}".rpartition(".")
    tree = ast.parse(MODULES[module].read_text(encoding="utf-8"))
    assert wanted in {node.name for node in tree.body if isinstance(node, ast.ClassDef)}


MACROS = """CheckReport EXAMPLES check_mesh_object default_size hide_inside hide_loops import_quad_surface
    inspect_mesh_object into_analysis load_and_solve loops_of_object make_hex_mesh make_quad_surface make_quality_report
    mark_hexes mesh_solid_object open_example show_displacement show_inside show_loops update_hex_mesh
    update_quad_surface zoom_to_hex""".split()


def test_names_in_macros():
    tree = ast.parse(MODULES["hexcon.gui.actions"].read_text(encoding="utf-8"))
    given = {alias.asname or alias.name for node in tree.body if isinstance(node, ast.ImportFrom)
             for alias in node.names}
    assert given >= set(MACROS)
