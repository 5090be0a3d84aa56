# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each command does. Every function returns (facts for --json, lines for people)."""
import os

import numpy as np

import hexcon_native

from ..calculix import solve_inp, static_deck
from ..calculix.judging import check_loads
from ..errors import FaultCode, ToolError
from ..examples import example
from ..files import WRITERS, check_method_for, ending_of, read_mesh, shown, write
from ..files.lengths import UNITS
from ..files.solid_choice import SolidChoice
from ..judging.curved import curved_hexes, of_curving
from ..judging.fillable import fillable
from ..judging.lengths import lengths_of
from ..judging.repair import repair_mesh, reversed_hexes
from ..judging.report import check_mesh
from ..meshing import mesh_quad_surface, mesh_solid
from ..quads import surface_from_file
from ..quads.solids import CAD_ENDINGS
from ..smoothing import smooth as smooth_mesh
from ..topological import BY_OPTION, MEANING, is_topological, refuse_topological_method

SOLID_ENDINGS = (*CAD_ENDINGS, ".fcstd")
UNITLESS_ENDINGS = (".brep", ".brp")     # of solids
EXAMPLE = "example:"  # what an input starts with that is no file but an example's name


def _certificate_line(certificate, curved=False):
    if certificate is None:
        return "certificate   not checked"
    if certificate.certified:
        sag = ", but perhaps within the sag of curved boundary edges" if curved else ""
        return f"certificate   every Jacobian proved positive, proper, boundary exact, nothing overlaps{sag}"
    return (f"certificate   NOT certified: conforming {certificate.conforming}, proper "
            f"{certificate.proper}, boundary exact {certificate.boundary_exact}, "
            f"{len(certificate.nonpositive)} hexes not proved positive{_overlap(certificate)}")


def _unembedded(report):
    told = "NO" if report.embedded is False else "not told"
    return f"{told}: {report.embedding_reason} ({_pairs(report.crossings)})"


def _overlap(certificate):
    return "" if certificate.embedded else f"; not proved free of overlaps: {certificate.embedding_reason}"


def _quality_line(quality):
    if quality is None:
        return "quality       not checked"
    return (f"quality       scaled Jacobian min {quality.min:.4f}, 5 % {quality.q05:.4f}, mean "
            f"{quality.mean:.4f}")


def _lengths_line(lengths):
    figures = lengths.as_dict()["aspect_ratio"]
    return (f"edges         shortest {lengths.shortest:.6g} (hex {lengths.shortest_hex}), longest "
            f"{lengths.longest:.6g}; aspect ratio at most {figures['max']:.3f} (hex {figures['max_hex']}), mean "
            f"{figures['mean']:.3f}")


def pairing_option(pairing):
    """The keyword for the core: none for the default, as only topological methods take it."""
    return {} if pairing == "all" else {"pairing": pairing}


def _surface_input(argument, options):
    """The quad surface that an argument names: a file's, or example:NAME."""
    if argument.startswith(EXAMPLE):
        return example(argument[len(EXAMPLE):])
    return surface_from_file(argument, merge_tolerance=options.merge_tolerance, scale=options.scale, unit=options.unit)


def _read(options):
    """The hex mesh of a file."""
    return read_mesh(options.input, scale=options.scale, unit=options.unit)


def filling(options):
    """The options of mesh_quad_surface among the command line's."""
    return {"method": options.method, "order": options.order, "layers": options.layers,
            "pillow": options.pillow, "timeout": options.timeout, "budget": options.budget,
            "allow_uncertified": options.allow_uncertified, "allow_topological": options.allow_topological,
            **pairing_option(options.pairing)}


def _chosen(path, options):
    """The solid of a file that the options choose."""
    if options.unit is not None and ending_of(path) not in UNITLESS_ENDINGS:
        raise ToolError(f"{path} says what unit its lengths are in: leave --unit, or take --scale",
                        FaultCode.BAD_OPTION)
    scale = options.scale * (1.0 if options.unit is None else UNITS[options.unit])
    return SolidChoice(path, options.object_name, options.solid_number, scale)


def _mesh_input(options):
    """Mesh of the input, solid or surface."""
    kept = filling(options)
    if ending_of(options.input) in SOLID_ENDINGS:
        if options.size is None:
            raise ToolError("a solid needs --size, the wanted edge length in mm",
                            FaultCode.BAD_OPTION)
        return mesh_solid(_chosen(options.input, options), options.size, surface_method=options.surface_method,
                          local_sizes=options.local_sizes, per_turn=options.per_turn,
                          volume_error=options.volume_error / 100.0, **kept)
    return mesh_quad_surface(_surface_input(options.input, options), **kept)


def _facts(mesh):
    return {"method": mesh.method, "order": mesh.order, "points": len(mesh.points),
            "hexes": len(mesh.hexes), "quads": len(mesh.quads),
            "topological": is_topological(mesh), "quality": _as_dict(mesh.quality),
            "lengths": lengths_of(mesh.points, mesh.hexes).as_dict(), "certificate": _as_dict(mesh.certificate),
            "report": dict(mesh.report)}


def _as_dict(found):
    """Plain numbers of a Quality or Certificate; None of what was not checked."""
    return None if found is None else found.as_dict()


def _made_of(mesh):
    """What the method counts, in words."""
    told = mesh.report
    if mesh.method == "swept":
        return f"{told['cap quads']:.0f} cap quads x {told['rings']:.0f} rings"
    counts = [f"{told[name]:.0f} {words}" for name, words in
              (("sheets", "sheets"), ("rotations", "rotated edges"), ("shells", "shells"),
               ("layers", "layers"), ("pairs", "pairs of quads"),
               ("coarse triangles", "coarse triangles"), ("coarse quads", "coarse quads"),
               ("tetrahedra", "tetrahedra")) if name in told]
    if told.get("core quads"):
        counts.append(f"a core of {told['core quads']:.0f} quads")
    share = f"{len(mesh.hexes) / len(mesh.surface.quads):.1f} hexes a quad"
    return f"{', '.join(counts)}; {share}" if counts else share


def _mesh_lines(mesh):
    lines = [f"surface       {len(mesh.quads)} quads, method {mesh.surface.method}"]
    lines += [f"              {note}" for note in mesh.report["surface notes"]]
    if mesh.surface.fit and "curved" not in mesh.report:     # which tells of the same, with curved faces
        lines.append(f"fit           {mesh.surface.fit.words()}")
    lines += [f"mesh          {len(mesh.hexes)} hexes, {len(mesh.points)} points, order "
              f"{mesh.order}, method {mesh.method}: {_made_of(mesh)}",
              *(f"tried         {line}" for line in (*mesh.report.get("surface tries", ()), *mesh.report["log"])),
              _quality_line(mesh.quality), _lengths_line(lengths_of(mesh.points, mesh.hexes)),
              _certificate_line(mesh.certificate, len(curved_hexes(mesh.points, mesh.hexes)) > 0),
              *(f"curved        {sentence}" for sentence in of_curving(mesh.report))]
    if is_topological(mesh):
        lines.append(f"topological   {MEANING}")
    return lines


def check_outputs(options, known):
    """Raise what writing options.output would, known being its endings: before the work, not after it."""
    for path in options.output:
        if ending_of(path) not in known:
            raise ToolError(f"cannot write {path}: one of {', '.join(shown(sorted(known)))} is possible",
                            FaultCode.FILE_FORMAT)
        if not os.path.isdir(os.path.dirname(os.path.abspath(path))):
            raise ToolError(f"cannot write {path}: its folder does not exist", FaultCode.FILE_IO)
        if os.path.exists(path) and os.path.exists(options.input) \
                and os.path.samefile(path, options.input):
            raise ToolError(f"{path} is the input: it would be lost", FaultCode.BAD_OPTION)


def element_option(path, element):
    """The keyword of files.write, of files that name element types."""
    return {"element": element} if element and ending_of(path) == ".inp" else {}


def mesh(options):
    """hexcon mesh IN -o OUT"""
    check_outputs(options, WRITERS)
    check_method_for(options.output, options.method, options.allow_topological, BY_OPTION)
    return write_mesh(_mesh_input(options), options)


def write_mesh(made, options):
    """Write a mesh to options.output; returns (facts, lines) of it."""
    for path in options.output:
        write(made, path, allow_topological=options.allow_topological, **element_option(path, options.element_type))
    return (dict(_facts(made), written=options.output),
            [*_mesh_lines(made), *(f"written       {path}" for path in options.output)])


def check(options):
    """hexcon check MESH [--surface QUADS]"""
    found = _read(options)
    surface = _match_surface(found.points, _surface_input(options.surface, options)) if options.surface else None
    return _judged(found, surface)


def repair(options):
    """hexcon repair MESH -o OUT: its middle nodes, if it has any, come to lie in the middles of the edges."""
    check_outputs(options, WRITERS)
    found = _read(options)
    before, count, order = check_mesh(found), len(found.hexes), found.order
    done = repair_mesh(found, pillow=options.pillow, merge_tolerance=options.merge_tolerance)
    for path in options.output:
        write(done.mesh, path, order=order)
    facts, lines = _judged(done.mesh, None)
    bad = len(before.certificate.nonpositive)
    was = "certified" if before.certified else f"not certified, {bad} hexes not proved positive"
    return (dict(facts, pillows=done.pillows, turned=len(done.turned), written=options.output,
                 before={"certified": before.certified, "nonpositive": len(before.certificate.nonpositive),
                         "quality": before.quality.as_dict()}),
            [f"before        {count} hexes, {was}; {_quality_line(before.quality).split(None, 1)[1]}",
             f"repaired      {len(done.mesh.hexes)} hexes for {count}, {done.pillows} pillows", *lines,
             *(f"written       {path}" for path in options.output)])


def _judged(found, surface):
    """Facts and lines about a mesh that was read, and whether it is certified."""
    report = check_mesh(found, surface=surface)
    certificate, quality, curved = report.certificate, report.quality, report.curved
    lines = [f"mesh          {len(found.hexes)} hexes, {len(found.points)} points, order "
             f"{found.order}, {len(found.quads)} boundary quads", _quality_line(quality),
             _lengths_line(report.lengths), _certificate_line(certificate, len(curved) > 0)]
    lines += _deck_lines(found)
    turned = reversed_hexes(found.points, found.hexes) if len(certificate.nonpositive) else ()
    if len(turned):
        which = f"all {len(turned)} hexes are" if len(turned) == len(found.hexes) else f"hexes {_ids(turned)} are"
        lines.append(f"reversed      {which} inverted: their node order is reversed; `hexcon repair` turns them")
    for name, ids in (("not positive", certificate.nonpositive),
                      ("improper", certificate.improper), ("curved", curved)):
        if len(ids):
            lines.append(f"{name:13} hexes {_ids(ids)}")
    if len(certificate.crossings):
        lines.append(f"overlapping   {_pairs(certificate.crossings)}")
    return ({"points": len(found.points), "hexes": len(found.hexes), "order": found.order,
             "quads": len(found.quads), "quality": quality.as_dict(), "lengths": report.lengths.as_dict(),
             "groups": _group_sizes(found), "certificate": certificate.as_dict(), "curved": curved[:1000],
             "reversed": len(turned), "notes": getattr(found, "notes", []),
             "elements_in_file": getattr(found, "counts", {}),
             "certified": report.certified}, lines)


def _group_sizes(found):
    """{name: {"quads": n} or {"nodes": n}} of what a surface or a mesh names, CAD faces first."""
    faces, counts = np.unique(found.face_of_quad[found.face_of_quad > 0], return_counts=True)
    return {**{f"Face{face}": {"quads": int(count)} for face, count in zip(faces.tolist(), counts.tolist())},
            **{name: {"nodes": len(rows)} for name, rows in getattr(found, "node_groups", {}).items()},
            **{name: {"quads": len(rows)} for name, rows in getattr(found, "quad_groups", {}).items()}}


def _group_lines(found):
    told = [f"{name} ({count} {what})" for name, held in _group_sizes(found).items() for what, count in held.items()]
    return [f"groups        {', '.join(told[:50])}{' ...' if len(told) > 50 else ''}"] * bool(told)


def _deck_lines(found):
    """What else is in the file, where its reader knows: nothing that a solver would see is certified in part."""
    counts = getattr(found, "counts", {})
    told = ", ".join(f"{count} {kind}" for kind, count in counts.items())
    lines = [f"in the file   {told}: {len(found.hexes)} of {sum(counts.values())} elements are hexes, and "
             f"judged"] * bool(counts)
    return [*lines, *_group_lines(found), *(f"note          {note}" for note in getattr(found, "notes", ()))]


def _pairs(pairs):
    """Pairs of quads in words, no more than a line takes."""
    shown = ", ".join(f"{a} and {b}" for a, b in pairs[:10].tolist())
    return f"boundary quads {shown}{' ...' if len(pairs) > 10 else ''}"


def _match_surface(points, surface):
    """The surface's quads in the mesh's numbering: files number points as they like.

    Points are the same where they agree to 1e-9 of the extent, which text files keep.
    """
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
    held = vtkPoints()
    held.SetData(numpy_to_vtk(np.ascontiguousarray(points)))
    data = vtkPolyData()
    data.SetPoints(held)
    locator = vtkStaticPointLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    ids = np.array([locator.FindClosestPoint(point) for point in surface.points.tolist()])
    far = np.linalg.norm(points[ids] - surface.points, axis=1)
    strangers = np.flatnonzero(far > 1e-9 * np.linalg.norm(np.ptp(points, axis=0)))
    if len(strangers):
        raise ToolError(f"{len(strangers)} points of the surface (listed) are no points of the "
                        "mesh", FaultCode.FILE_FORMAT, strangers)
    return ids[surface.quads]


def smooth(options):
    """hexcon smooth MESH SOLID [-o OUT]"""
    check_outputs(options, WRITERS)
    given = _read(options)
    found = smooth_mesh(given, _chosen(options.solid, options), order=given.order, tolerance=options.tolerance,
                        keep=options.keep, timeout=options.timeout)
    for path in options.output:
        write(found, path)
    corners, edges, faces, _ = np.bincount(found.dimension[np.unique(found.quads)], minlength=4).tolist()
    off = float(found.off.max())
    kept = [f"kept          {len(found.kept)} points that lie on nothing: {_ids(found.kept)}"] * bool(len(found.kept))
    after = _quality_line(found.quality) if found.improved else "quality       no better mesh was found: it stays so"
    lines = [f"mesh          {len(found.hexes)} hexes, {len(found.points)} points, {len(found.quads)} boundary quads",
             f"boundary      {corners} points at corners of the solid, {edges} on edges, {faces} on faces; up to "
             f"{off:.3g} off before",
             *(f"              {note}" for note in found.notes), *kept,
             _quality_line(found.before).replace("quality", "before ", 1), after,
             _lengths_line(lengths_of(found.points, found.hexes)),
             _certificate_line(found.certificate, "curved" in found.report),
             *(f"curved        {sentence}" for sentence in of_curving(found.report)),
             *(f"written       {path}" for path in options.output)]
    return ({"points": len(found.points), "hexes": len(found.hexes), "quads": len(found.quads),
             "improved": found.improved, "before": found.before.as_dict(), "quality": found.quality.as_dict(),
             "at_corners": corners, "on_edges": edges, "on_faces": faces, "off": off,
             "kept": found.kept[:1000].tolist(), "notes": found.notes, "certificate": found.certificate.as_dict(),
             "certified": bool(found.certificate.certified), "written": options.output}, lines)


def _ids(ids):
    return f"{', '.join(map(str, ids[:20]))}{' ...' if len(ids) > 20 else ''}"


def info(options):
    """hexcon info SURFACE"""
    surface = _surface_input(options.input, options)
    report = hexcon_native.check_surface(surface.points, surface.quads)
    crossing = int(np.count_nonzero(report.loops.self_crossings))
    center = ("none" if report.star_center is None
              else "(" + ", ".join(f"{c:.6g}" for c in report.star_center) + ")")
    facts = report.as_dict()
    facts["notes"], facts["groups"] = surface.notes, _group_sizes(surface)
    return facts, [
        f"surface       {report.n} quads ({'even' if report.even else 'ODD'}), {report.points} "
        f"points, {report.components} component(s), genus {report.genus}, {report.cavities} cavities",
        f"loops         {len(report.loops)}, {crossing} of them cross themselves "
        f"({int(report.loops.self_crossings.sum())} crossings)",
        f"colouring     {'black and white' if report.bipartite else 'impossible: an odd cycle'}",
        f"embedded      {'yes: it crosses and touches itself nowhere' if report.embedded else _unembedded(report)}",
        f"quads         {fillable(report.n, report.fillable, report.embedded)}",
        f"orientation   {'outward' if report.oriented else 'inward, or some shells are (meshing turns them)'}",
        f"shape         {'convex' if report.convex else 'not convex'}, star centre {center}, "
        + ("no volume: it bounds no solid" if report.volume is None else f"volume {report.volume:.6g}"),
        *_group_lines(surface),
        *(f"note          {note}" for note in surface.notes)]


def _by_face(loads):
    """{"Face2": load}; two loads of one kind on a face would not be what was meant."""
    by_face = dict(loads)
    if len({name.upper() for name in by_face}) < len(loads):
        raise ToolError("a face is given two loads of one kind; add them up", FaultCode.BAD_OPTION)
    return by_face


def _mesh_to_solve(options, is_solid):
    """The mesh made or read, fit to be solved.

    A file does not keep the mark of a topological mesh, and CalculiX may solve one in silence: so
    a hex that is not proved positive is refused, whoever made it.
    """
    if is_solid:
        refuse_topological_method(options.method, options.allow_topological, BY_OPTION)
        return _mesh_input(options)
    read = _read(options)
    if options.allow_topological or options.allow_uncertified:
        return read
    bad = hexcon_native.certify(read.points, read.hexes, read.quads).nonpositive
    if len(bad):
        raise ToolError(f"{len(bad)} hexes of {options.input} (listed) have Jacobians that are not "
                        "proved positive, so CalculiX must not be given it (`hexcon check` tells "
                        "more); repair it, mesh again by method cells, or give "
                        "--allow-uncertified to solve it anyway", FaultCode.BAD_MESH, bad)
    return read


def solve(options):
    """hexcon solve IN --fixed FaceN --force FaceN=fx,fy,fz"""
    check_outputs(options, {".vtu", ".vtk", ".png"})
    force, pressure = _by_face(options.force), _by_face(options.pressure)
    check_loads(force, pressure)
    # a document without --size is taken for its hex mesh
    is_solid = ending_of(options.input) in SOLID_ENDINGS and not (
        ending_of(options.input) == ".fcstd" and options.size is None)
    made = _mesh_to_solve(options, is_solid)
    deck = static_deck(made, {"young": options.young, "poisson": options.poisson},
                       options.fixed, force, pressure, element=options.element_type,
                       allow_topological=options.allow_topological)
    result = solve_inp(deck, timeout=options.ccx_timeout, nodes=np.unique(made.hexes) + 1)
    displacements = np.zeros((len(made.points), 3))
    displacements[result.node_ids - 1] = result.displacements
    stress = np.zeros(len(made.points))
    stress[result.node_ids - 1] = result.von_mises
    for path in options.output:
        _write_result(made, path, displacements, stress)
    facts = {"hexes": len(made.hexes), "points": len(made.points), "order": made.order,
             "topological": is_topological(made),
             "max_displacement": result.max_displacement,
             "max_von_mises": float(stress.max()), "written": options.output}
    lines = [f"solved        {len(made.hexes)} hexes, {len(made.points)} points, order "
             f"{made.order}",
             f"deflection    {result.max_displacement:.6g} mm at most",
             f"von Mises     {stress.max():.6g} MPa at most"]
    notes = [] if is_solid else [f"note          {note}" for note in made.notes]
    return facts, [*(_mesh_lines(made) if is_solid else []), *notes, *lines,
                   *(f"written       {path}" for path in options.output)]


def _write_result(made, path, displacements, stress):
    if ending_of(path) == ".png":
        from ..pictures import render
        render(made, path, displacements=displacements)
    else:
        write(made, path, point_data={"displacement": displacements, "von_mises": stress})
