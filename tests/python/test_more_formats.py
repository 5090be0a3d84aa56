# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other formats as people's programs write them: the box of deck_texts, 24 quads or 8 hexes, or a refusal by name."""
import meshio
import numpy as np
import pytest
from deck_texts import BOX, GRID, HEXES, OUTER, elements, nodes, with_middles
from quad_figures import volume_of

from hexcon.errors import FaultCode, HexconError
from hexcon.files import read_mesh
from hexcon.meshing import mesh_quad_surface
from hexcon.quads import surface_from_file


def points(form, shift=0):
    return "".join(form.format(*p, n=k + shift) + "\n" for k, p in enumerate(GRID.tolist(), 1))


def rows(form, table=OUTER, shift=1):
    return "".join(form.format(*(row + shift), n=k) + "\n" for k, row in enumerate(table, 1))


def obj(v="v {:g} {:g} {:g}", f="f {} {} {} {}", before="", between="", shift=1):
    return before + points(v) + between + rows(f, shift=shift)


_TEXTURES = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
_PIXELS = OUTER[:, [0, 1, 3, 2]]
_VOXELS = HEXES[:, [0, 1, 3, 2, 4, 5, 7, 6]]
_VTK = "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET "


def legacy(cells, kind, more=""):
    size = cells.shape[1]
    return (_VTK + "UNSTRUCTURED_GRID\nPOINTS 27 double\n" + points("{:g} {:g} {:g}")
            + f"CELLS {len(cells)} {len(cells) * (size + 1)}\n" + rows(f"{size} " + "{} " * size, cells, 0)
            + f"CELL_TYPES {len(cells)}\n" + f"{kind}\n" * len(cells) + more)


def medit(version=2, order="Vertices Quadrilaterals", glue="\n", more=""):
    blocks = {"Vertices": f"Vertices{glue}27\n" + points("{:g} {:g} {:g} 0"),
              "Quadrilaterals": f"Quadrilaterals{glue}24\n" + rows("{} {} {} {} 7")}
    return f"MeshVersionFormatted{glue}{version}\nDimension{glue}3\n" + "".join(blocks[b]
        for b in order.split()) + more + "End\n"


def msh41(physical="", more_nodes="", parametric=0, blocks=None):
    """One surface (tag 1) with all quads, in format 4.1."""
    nodes = f"1 27 1 27\n2 1 {parametric} 27\n" + "".join(f"{k}\n" for k in range(1, 28)) \
        + points("{:.16g} {:.16g} {:.16g}" + " 0.5 0.5" * parametric)
    elements = "1 24 1 24\n2 1 3 24\n" + rows("{n} {} {} {} {}")
    names, tags = physical or ("", "")
    entities = f"$Entities\n0 0 1 0\n1 0 0 0 10 20 30 {tags or '0'} 0\n$EndEntities\n"
    return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + names + entities
            + f"$Nodes\n{nodes}$EndNodes\n$Elements\n{elements}$EndElements\n")


_NAMES = '$PhysicalNames\n2\n2 5 "skin"\n2 6 "all"\n$EndPhysicalNames\n'
_MSH1 = "$NOD\n27\n" + points("{n} {:g} {:g} {:g}") + "$ENDNOD\n$ELM\n24\n" + rows("{n} 3 1 1 4 {} {} {} "
    "{}") + "$ENDELM\n"
_TWICE = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + _NAMES + "$Nodes\n27\n" + points("{n} {:g} {:g} "
    "{:g}") + "$EndNodes\n" \
    "$Elements\n48\n" + rows("{n} 3 2 5 1 {} {} {} {}") + "".join(
        f"{k + 24} 3 2 6 1 {a} {b} {c} {d}\n" for k, (a, b, c, d) in enumerate((OUTER + 1).tolist(),
        1)) + "$EndElements\n"
_BDF = "BEGIN BULK\n" + points("GRID,{n},,{:.4},{:.4},{:.4}") + rows("CQUAD4,{n},1,{},{},{},{}") + "ENDDATA\n"


def small(card, *fields):
    return f"{card:8}" + "".join(f"{field:>8}" for field in fields) + "\n"


def long_grid(number, place):
    x, y, z = (f"{value:>16.9E}" for value in place)
    return f"GRID*   {number:>16}{'':16}{x}{y}\n*       {z}\n"


_SMALL = "".join(small("GRID", k, "", *(f"{x:.1f}" for x in p)) for k, p in enumerate(GRID.tolist(), 1))
_SMALL_QUADS = "".join(small("CQUAD4", k, 1 + k % 2, *row) for k, row in enumerate((OUTER + 1).tolist(), 1))
_LONG = "".join(long_grid(k, p) for k, p in enumerate(GRID.tolist(), 1))
_HEXA = "".join(small("CHEXA", k, 1, *row[:6]) + small("", *row[6:]) for k, row in enumerate((HEXES + 1).tolist(), 1))

# name of the file: text; each is the surface of 24 quads
SURFACES = {
    "plain.obj": obj(), "uv.obj": obj(f="f {}/1 {}/2 {}/3 {}/4", between=_TEXTURES),
    "normals.obj": obj(f="f {}//1 {}//1 {}//1 {}//1", between="vn 0 0 1\n"),
    "all.obj": obj(f="f {}/1/1 {}/2/1 {}/3/1 {}/4/1", between=_TEXTURES + "vn 0 0 1\n", before="mtllib a.mtl\no "
        "box\ng\nusemtl m\ns 1\n"),
    "colours.obj": obj(v="v {:g} {:g} {:g} 0.5 0.2 0.1"), "w.obj": obj(v="v {:g} {:g} {:g} 1.0"),
    "negative.obj": obj(shift=-27), "continued.obj": obj(f="f {} {} \\\n {} {}"),
    "crlf.obj": obj().replace("\n", "\r\n"), "comments.obj": obj(f="f {} {} {} {} # a quad", before="# made\n\n"),
    "sep.mesh": medit(), "one_line.mesh": medit(glue=" "), "v3.mesh": medit(3), "v1.mesh": medit(1),
    "quads_first.mesh": medit(order="Quadrilaterals Vertices"),
    "keywords.mesh": medit(more="Edges\n1\n1 2 3\nCorners 2\n1 2\nRidges\n1\n1\nRequiredVertices 1 1\nTriangles 0\n"),
    "edges2.mesh": medit(more="EdgesP2\n1\n1 3 2 5\n"), "pixels.vtk": legacy(_PIXELS, 8), "quads.vtk": legacy(OUTER, 9),
    "polygons.vtk": _VTK + "POLYDATA\nPOINTS 27 double\n" + points("{:g} {:g} {:g}") + "POLYGONS 24 120\n"
                    + rows("4 {} {} {} {}", shift=0),
    "s41.msh": msh41(), "groups41.msh": msh41((_NAMES, "2 5 "
                                                       "6")), "parametric.msh": msh41(parametric=1), "v1.msh": _MSH1,
    "twice.msh": _TWICE, "free.bdf": _BDF, "small.bdf": _SMALL + _SMALL_QUADS, "long.nas": _LONG + _SMALL_QUADS,
    "exponents.bdf": _BDF.replace("10.0", "1.+1").replace("20.0", "2.0D1"),
    "plain.off": "OFF\n27 24 0\n" + points("{:g} {:g} {:g}") + rows("4 {} {} {} {}", shift=0),
    "colour.off": "COFF\n# a comment\n27 24 0\n" + points("{:g} {:g} {:g} 255 0 0 255") + rows("4 {} {} {} {} 9 9 9",
        shift=0),
    "plain.ply": "ply\nformat ascii 1.0\nelement vertex 27\nproperty double x\nproperty double y\nproperty double z\n"
                 "element face 24\n"
                 "property list uchar int vertex_indices\nend_header\n" + points("{:g} {:g} {:g}") + rows("4 {} {} "
                 "{} {}", shift=0)}


@pytest.mark.parametrize("name", SURFACES)
def test_surfaces(tmp_path, name):
    (tmp_path / name).write_bytes(SURFACES[name].encode("ascii"))
    surface = surface_from_file(tmp_path / name)
    assert len(surface.quads) == 24 and len(surface.points) == 26
    assert np.isclose(volume_of(surface.points, surface.quads), 6000)
    groups = {"twice.msh": {"skin", "all"}, "groups41.msh": {"skin", "all"}, "small.bdf": {"PID 1", "PID 2"},
              "long.nas": {"PID 1", "PID 2"}, "v1.msh": {"physical 1"}}
    assert set(surface.quad_groups) == groups.get(name, set())


# name of the file: text; each is the mesh of 8 hexes
MESHES = {
    "voxels.vtk": legacy(_VOXELS, 11), "hexes.vtk": legacy(HEXES, 12), "small.bdf": _SMALL + _HEXA,
    "structured.vtk": _VTK + "STRUCTURED_GRID\nDIMENSIONS 3 3 3\nPOINTS 27 double\n" + points("{:g} {:g} {:g}"),
    "rectilinear.vtk": _VTK + "RECTILINEAR_GRID\nDIMENSIONS 3 3 3\nX_COORDINATES 3 double\n0 5 10\n"
                              "Y_COORDINATES 3 double\n"
                              "0 10 20\nZ_COORDINATES 3 double\n0 15 30\n",
    "image.vtk": _VTK + "STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 5 10 15\n",
    "hexes.mesh": "MeshVersionFormatted 2 Dimension 3 Vertices 27\n" + points("{:g} {:g} {:g} 0") + "Hexahedra 8\n"
                  + rows("{} {} {} {} {} {} {} {} 1", HEXES) + "End"}


@pytest.mark.parametrize("name", MESHES)
def test_meshes(tmp_path, name):
    (tmp_path / name).write_bytes(MESHES[name].encode("ascii"))
    found = read_mesh(tmp_path / name)
    assert len(found.hexes) == 8 and np.isclose(volume_of(found.points, found.quads), 6000)


def test_twenty_nodes_of_nastran(tmp_path):
    """CHEXA with middle nodes: bottom, uprights, top; the middles lie between their corners."""
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)]
    corners = GRID[HEXES[0]]
    places = np.vstack([corners, [corners[[a, b]].mean(axis=0) for a, b in edges]])
    text = "".join(f"GRID,{k},,{x},{y},{z}\n" for k, (x, y, z) in enumerate(places.tolist(), 1))
    text += "CHEXA,1,1," + ",".join(map(str, range(1, 7))) + "\n,".join(["", "7,8,9,10,11,12,13,14",
        "15,16,17,18,19,20"]) + "\n"
    (tmp_path / "h.bdf").write_text(text, encoding="ascii")
    found = read_mesh(tmp_path / "h.bdf")
    ends = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    for k, (a, b) in enumerate(ends):
        middle = found.points[found.hexes[0, [a, b]]].mean(axis=0)
        assert np.allclose(found.points[found.hexes[0, 8 + k]], middle)


_WHOLE = {"ascii.vtk": legacy(HEXES, 12, "CELL_DATA 8\nSCALARS part int 1\nLOOKUP_TABLE default\n" + "1\n" * 8
                              + "POINT_DATA 27\nVECTORS moved float\n" + "0 0 1\n" * 27),
          "polygons.vtk": SURFACES["polygons.vtk"], "rectilinear.vtk": _VTK + "RECTILINEAR_GRID\nDIMENSIONS 3 3 3\n"
          "X_COORDINATES 3 double\n0 5 10\nY_COORDINATES 3 double\n0 10 20\nZ_COORDINATES 3 double\n0 15 30\n"}


@pytest.mark.parametrize("name", (*_WHOLE, "binary.vtk", "binary_51.vtk", "xml.vtu", "ascii.ply", "binary.ply"))
def test_a_file_for_vtk_that_is_cut_short(tmp_path, name):
    """Told as such, with the section and the place, before VTK dies of it or leaves out what is missing."""
    path = tmp_path / name
    if name in _WHOLE:
        whole = _WHOLE[name].rstrip().encode("ascii")
    elif name.endswith("ply"):
        quads = [("quad", OUTER.astype(np.int32))]
        meshio.Mesh(GRID, quads).write(path, binary=name.startswith("binary"))
        whole = path.read_bytes().rstrip(b"\n" if name == "ascii.ply" else b"")
    else:
        mesh = meshio.Mesh(GRID, [("hexahedron", HEXES)], cell_data={"part": [np.arange(8)]})
        mesh.write(path, **{"binary.vtk": {"file_format": "vtk42", "binary": True},
                            "binary_51.vtk": {"file_format": "vtk", "binary": True}}.get(name, {}))
        whole = path.read_bytes().rstrip(b"\n" if name == "xml.vtu" else b"")
    path.write_bytes(whole)
    read = surface_from_file if name.endswith(("polygons.vtk", "ply")) else read_mesh
    read(path)
    for part in (0.6, 0.999):
        path.write_bytes(whole[:int(part * len(whole)) - 1])
        with pytest.raises(HexconError) as caught:
            read(path)
        assert "cut short" in str(caught.value) and "byte" in str(caught.value) and name in str(caught.value)
        assert caught.value.code is FaultCode.FILE_FORMAT


# name of the file: (text, code, words)
REFUSED = {
    "ngon.obj": (obj() + "f 1 2 3 6 5\n", FaultCode.FILE_FORMAT, ("5-gon", "line 52")),
    "far.obj": (obj() + "f 1 2 3 99\n", None, ()), "curve.obj": (obj() + "surf 0 1 0 1 1 2\n", FaultCode.FILE_FORMAT,
        ("line 52",)),
    "before.obj": (obj(between="f -28 -1 -2 -3\n"), FaultCode.FILE_FORMAT, ("-28", "line 28")),
    "word.obj": (obj(v="v {:g} {:g} x"), FaultCode.FILE_FORMAT, ("line 1",)), "empty.obj": ("# nothing\n",
        FaultCode.FILE_FORMAT, ()),
    "strange.mesh": (medit(more="Blobs\n1\n2\n"), FaultCode.FILE_FORMAT, ("Blobs",)),
    "short.mesh": (medit().replace("Quadrilaterals\n24", "Quadrilaterals\n240"), FaultCode.FILE_FORMAT,
                   ("Quadrilaterals",)),
    "penta.vtk": (_VTK + "POLYDATA\nPOINTS 5 double\n0 0 0 1 0 0 2 1 0 1 2 0 0 1 0\nPOLYGONS 1 6\n5 0 1 2 3 4\n",
                  FaultCode.FILE_FORMAT,
                  ("5-gon",)),
    "model.stl": ("solid a\nfacet normal 0 0 1\nendsolid a\n", FaultCode.NOT_ALL_QUAD, ("STL", "triangles")),
    "penta.off": ("OFF\n5 1 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n", FaultCode.FILE_FORMAT, ("5-gon",
        "line 8")),
    "system.bdf": (_BDF.replace("GRID,1,,", "GRID,1,7,"), FaultCode.FILE_FORMAT, ("coordinate system 7", "line 2")),
    "lost.bdf": (_BDF.replace("CQUAD4,3,1,", "CQUAD4,3,1,99"), FaultCode.FILE_FORMAT, ("99",)),
    "cut.msh": (msh41()[:400], FaultCode.FILE_FORMAT, ()), "order3.msh": (msh41().replace("2 1 3 24", "2 1 36 24"),
        FaultCode.FILE_FORMAT, ()),
    "twice.obj": (obj() + "f {} {} {} {}\n".format(*(OUTER[3] + 1)), "NON_MANIFOLD_EDGE or NOT_CLOSED", ("there "
        "twice",)),
    "bow.obj": (obj().replace("f {} {} {} {}\n".format(*(OUTER[3] + 1)), "f {0} {1} {3} {2}\n".format(*(OUTER[3] +
        1))), "NOT_CLOSED",
                ("bow-ties",)),
    "flat.obj": (obj().replace("f {} {} {} {}\n".format(*(OUTER[3] + 1)), "f {0} {1} {2} {2}\n".format(*(OUTER[3] +
        1))), None,
                 ("one corner twice",)),
    "hole.obj": (obj().replace("f {} {} {} {}\n".format(*(OUTER[3] + 1)), ""), "NOT_CLOSED", ("4 edges are open",
        "hole"))}


@pytest.mark.parametrize("name", REFUSED)
def test_refused_in_words(tmp_path, name):
    text, code, words = REFUSED[name]
    (tmp_path / name).write_text(text, encoding="ascii")
    with pytest.raises(HexconError) as caught:
        surface_from_file(tmp_path / name)
    assert all(word in str(caught.value) for word in (name, *words)), caught.value
    assert code is None or caught.value.code is code or caught.value.code.name in str(code), caught.value.code


def loose(apart):
    """The box in quads that share no points; those of each are moved by up to apart."""
    moved = GRID[OUTER] + np.random.default_rng(3).uniform(-apart, apart, (24, 4, 3)) / 4
    return meshio.Mesh(moved.reshape(-1, 3), [("quad", np.arange(96).reshape(-1, 4))])


@pytest.mark.parametrize("apart, advice", ((1e-4, "1e-03"), (1e-2, "1e-01")))
def test_seams(tmp_path, apart, advice):
    """Within 1e-7 of the diagonal they are merged and told; farther, the refusal says how far, and what would do."""
    loose(1e-7).write(tmp_path / "near.obj")
    surface = surface_from_file(tmp_path / "near.obj")
    assert len(surface.points) == 26 and any("70 points merged" in note for note in surface.notes)
    loose(apart).write(tmp_path / "far.vtk")
    with pytest.raises(HexconError, match=f"96 edges are open.*apart: try --merge-tolerance {advice}") as caught:
        surface_from_file(tmp_path / "far.vtk")
    assert caught.value.code.name == "NOT_CLOSED"
    surface = surface_from_file(tmp_path / "far.vtk", merge_tolerance=float(advice))
    assert len(surface.points) == 26 and np.isclose(volume_of(surface.points, surface.quads), 6000, rtol=1e-2)
    with pytest.raises(HexconError, match="would merge corners"):
        surface_from_file(tmp_path / "far.vtk", merge_tolerance=6.0)


def test_units_and_scale(tmp_path):
    (tmp_path / "m.obj").write_text(obj(), encoding="ascii")
    (tmp_path / "m.inp").write_text(BOX, encoding="ascii")
    surface = surface_from_file(tmp_path / "m.obj", unit="inch")
    assert np.isclose(volume_of(surface.points, surface.quads), 6000 * 25.4 ** 3) and any("25.4" in n
        for n in surface.notes)
    mesh = read_mesh(tmp_path / "m.inp", scale=0.5)
    assert np.isclose(volume_of(mesh.points, mesh.quads), 750)
    small = surface_from_file(tmp_path / "m.obj", scale=1e-6)
    assert any("metres" in note for note in small.notes)
    large = surface_from_file(tmp_path / "m.obj", unit="m", scale=10)
    assert any("micrometres" in note for note in large.notes)


UNV_HEAD = "    -1\n   164\n{:10d}{:20}{:10d}\n  {:.17E}  1.0  1.0\n  273.15\n    -1\n"


def unv(units="", system="", kind=94, nodes=OUTER, groups="", cs=1, places=GRID):
    text = units + system + "    -1\n  2411\n"
    text += "".join(f"{k:10d}{cs:10d}         1        11\n{x:25.16E}{y:25.16E}{z:25.16E}\n" for k, (x, y, z) in
                    enumerate(places.tolist(), 1))
    text += "    -1\n    -1\n  2412\n"
    for k, row in enumerate((nodes + 1).tolist(), 1):
        text += f"{k:10d}{kind:10d}         1         1         7{len(row):10d}\n" + "".join(f"{n:10d}"
        for n in row) + "\n"
    return text + "    -1\n" + groups


def group(name, members, kind=8, dataset=2467):
    lines = [f"{kind:10d}{m:10d}         0         0" for m in members]
    return f"    -1\n  {dataset}\n" + f"{1:10d}" + f"{0:10d}" * 6 + f"{len(members):10d}\n{name}\n" + "\n".join(
        "".join(lines[k:k + 2]) for k in range(0, len(lines), 2)) + "\n    -1\n"


_SYSTEM = "    -1\n  2420\n         1\npart\n         5{:10d}         0\nCS5\n" \
    "  0. 1. 0.\n  -1. 0. 0.\n  0. 0. 1.\n  100. 0. 0.\n    -1\n"
_SMESH = "    -1\n  2420\n         1\nSMESH_Mesh\n         1         0         0\nGlobal\n" \
    "  1. 0. 0.\n  0. 1. 0.\n  0. 0. 1.\n  0. 0. 0.\n    -1\n"
_METRES = UNV_HEAD.format(1, "SI: Meter (newton)", 2, 1.0)
_AROUND = with_middles(OUTER)

def old_unv(dataset):
    """Nodes of 15 (a line each) or 781, elements of 780, as programs before 2411 write them."""
    places = {15: "{k:10d}         1         0        11{x:13.5E}{y:13.5E}{z:13.5E}\n",
              781: "{k:10d}         1         1        11\n{x:25.16E}{y:25.16E}{z:25.16E}\n"}[dataset]
    text = f"    -1\n{dataset:6d}\n" + "".join(places.format(k=k, x=x, y=y, z=z)
                                              for k, (x, y, z) in enumerate(GRID.tolist(), 1))
    text += "    -1\n    -1\n   780\n"
    for k, row in enumerate((OUTER + 1).tolist(), 1):
        text += f"{k:10d}" + "".join(f"{n:10d}" for n in (94, 1, 1, 1, 1, 7, 4)) + "\n" + "".join(
            f"{n:10d}" for n in row) + "\n"
    return text + "    -1\n"


# name: (text, volume, groups)
UNV = {
    "nodes of dataset 15, elements of 780": (old_unv(15), 6000, {}),
    "nodes of dataset 781, elements of 780": (old_unv(781), 6000, {}),
    "kind 94": (unv(), 6000, {}), "kind 44": (unv(kind=44), 6000, {}), "kind 54": (unv(kind=54), 6000, {}),
    "kind 64": (unv(kind=64), 6000, {}), "kind 74": (unv(kind=74), 6000, {}), "kind 84": (unv(kind=84), 6000, {}),
    "8 nodes round": (unv(kind=95, nodes=_AROUND[1][:, [0, 4, 1, 5, 2, 6, 3, 7]], places=_AROUND[0]), 6000, {}),
    "groups 2467": (unv(groups=group("in let", [1, 2])), 6000, {"in let": 2}),
    "groups 2477": (unv(groups=group("inlet", [1, 2, 3], dataset=2477)), 6000, {"inlet": 3}),
    "groups of SMESH": (unv(kind=44, groups=group("Face1", [1, 2])), 6000, {}),
    "metres": (unv(_METRES, places=GRID / 1000), 6000, {}), "mm": (unv(UNV_HEAD.format(5, "mm", 2, 1000.0)), 6000, {}),
    "inches": (unv(UNV_HEAD.format(7, "IN: Inch", 2, 39.37007874015748)), 6000 * 25.4 ** 3, {}),
    "metres that SMESH writes": (unv(_METRES, _SMESH), 6000, {}),
    "a turned system": (unv(system=_SYSTEM.format(0), cs=5), 6000, {})}


@pytest.mark.parametrize("name", UNV)
def test_universal_files(tmp_path, name):
    text, volume, groups = UNV[name]
    (tmp_path / "m.unv").write_text(text, encoding="ascii")
    surface = surface_from_file(tmp_path / "m.unv")
    assert len(surface.quads) == 24 and np.isclose(volume_of(surface.points, surface.quads), volume)
    assert {name: len(rows) for name, rows in surface.quad_groups.items()} == groups
    if name == "a turned system":
        assert np.allclose(surface.points.min(axis=0), (80, 0, 0)) and np.allclose(surface.points.max(axis=0), (100,
        10, 30))
    if name == "groups of SMESH":
        assert surface.face_of_quad.tolist()[:3] == [1, 1, 0]
    assert ("metres" in name or name in ("inches", "a turned system")) == any("convert" in n or "SMESH" in n
        for n in surface.notes)


@pytest.mark.parametrize("text, words", (
    (unv(kind=77), ("kind 77", "line")), (unv(nodes=OUTER + 90), ("not defined",)), (unv(kind=95), ("kind 95", "4 "
        "nodes")),
    (unv()[:-20], ("cut short",)), (unv() + "    -1\n    71\n         1\n    -1\n", ("dataset 71",))))
def test_universal_files_refused(tmp_path, text, words):
    (tmp_path / "m.unv").write_text(text, encoding="ascii")
    with pytest.raises(HexconError) as caught:
        surface_from_file(tmp_path / "m.unv")
    assert all(word in str(caught.value) for word in ("m.unv", *words)), caught.value


def test_curved_edges_of_given_quads_come_back(tmp_path):
    """Middle nodes of 8-node quads, moved off their edges: at order 2 the hexes have them, and are certified."""
    places, rows = with_middles(OUTER)
    places[27:] += [0.2, 0.1, -0.15]
    (tmp_path / "curved.inp").write_text(nodes(places) + elements(rows, "S8"), encoding="ascii")
    surface = surface_from_file(tmp_path / "curved.inp")
    mesh = mesh_quad_surface(surface, order=2)
    assert {tuple(place) for place in surface.middles[1].tolist()} <= {tuple(p) for p in mesh.points.tolist()}
    kept = {tuple(place) for place in mesh.points.round(9).tolist()}
    assert {tuple(place) for place in places[np.unique(rows)].round(9).tolist()} <= kept
    assert mesh.certificate.certified and mesh.report["curved as given"] == {"edges": 48, "reduced": 0}


def test_every_ending_is_in_the_table_of_formats():
    from hexcon.files import READERS, WRITERS
    from hexcon.files.formats import FORMATS
    listed = [ending for row in FORMATS for ending in row.endings]
    assert len(listed) == len(set(listed)) and set(listed) == set(READERS) | set(WRITERS)
    for row in FORMATS:
        assert bool(row.read) == any(ending in READERS for ending in row.endings), row.name
        surfaces_only = row.name in ("Wavefront", "Medit")
        assert bool(row.written) == (any(ending in WRITERS for ending in row.endings) or surfaces_only), row.name


@pytest.mark.parametrize("seed", range(5))
def test_damaged_text_is_refused_by_its_name(tmp_path, seed):
    """Pieces cut out, doubled, changed to numbers and words of all kinds: read, or a fault that names the file."""
    rng = np.random.default_rng(seed)
    own = [(name, text) for name, text in {**SURFACES, **MESHES}.items()
           if name.rsplit(".")[-1] in ("obj", "mesh", "bdf", "nas", "off")]
    own += [("m.unv", text) for text, _, _ in UNV.values()] + [("m.inp", BOX)]
    for _ in range(60):
        name, text = own[rng.integers(len(own))]
        start = int(rng.integers(len(text)))
        end = start + int(rng.choice([0, 1, 3, 40]))
        pieces = ("", text[:start][-30:], "-1", "1e400", "nan", str(10 ** 30), "x", ",,", "*", "\n", " 0 ")
        piece = pieces[rng.integers(len(pieces))]
        path = tmp_path / f"m.{name.rsplit('.')[-1]}"
        path.write_text(text[:start] + piece + (text[end:] if rng.random() < 0.9 else ""), encoding="ascii")
        for read in (surface_from_file, read_mesh):
            try:
                read(path)
            except HexconError as fault:
                assert path.name in str(fault)
