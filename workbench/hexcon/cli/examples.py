# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon example: the surfaces of the literature, listed, written, filled with hexes and drawn."""
from ..errors import FaultCode, ToolError
from ..examples import ABOUT, example as example_surface, example_names
from ..files import WRITERS, check_method_for
from ..files.surfaces import SURFACE_ENDINGS, write_surface
from ..meshing import mesh_quad_surface
from ..quads.figures import face_doublets, flat_corners
from ..topological import BY_OPTION
from .commands import check_outputs, filling, write_mesh


def example(options):
    """hexcon example [NAME [-o OUT] [--gallery FOLDER] [--method M]]"""
    _check(options)
    if options.name is None:
        listed = [_facts(name, example_surface(name)) for name in example_names()]
        return {"examples": listed}, [_line(facts) for facts in listed]
    surface = example_surface(options.name)
    mesh = None if options.method is None else mesh_quad_surface(surface, **filling(options))
    if mesh is not None:
        facts, lines = write_mesh(mesh, options)
    else:
        facts, lines = _write(surface, options)
    if options.gallery:
        facts["pictures"] = _draw(surface, mesh, options)
        lines += [f"written       {path}" for path in facts["pictures"]]
    return facts, lines


def _check(options):
    """Raise BAD_OPTION for options that do not go together, and what writing would raise."""
    if options.name is None and (options.output or options.gallery or options.method):
        raise ToolError(f"which example? Name one of {', '.join(example_names())}", FaultCode.BAD_OPTION)
    if options.method is None and (options.order != 1 or options.layers or options.allow_uncertified):
        raise ToolError("--order, --layers and --allow-uncertified are about hexes: give --method as well",
                        FaultCode.BAD_OPTION)
    if options.method and not options.output and not options.gallery:
        raise ToolError("the hexes would be lost: give -o or --gallery", FaultCode.BAD_OPTION)
    check_outputs(options, SURFACE_ENDINGS if options.method is None else WRITERS)
    check_method_for(options.output, options.method, options.allow_topological, BY_OPTION)


def _write(surface, options):
    for path in options.output:
        write_surface(surface, path)
    facts = dict(_facts(options.name, surface), written=options.output)
    return facts, [_line(facts), *(f"written       {path}" for path in options.output)]


def _draw(surface, mesh, options):
    from ..pictures import gallery
    return gallery.stages(surface, mesh, options.gallery, name=options.name)


def _facts(name, surface):
    return {"name": name, "quads": len(surface.quads), "points": len(surface.points), "about": ABOUT[name],
            "face_doublets": face_doublets(surface.quads).tolist(),
            "flat_corners": flat_corners(surface.points, surface.quads).tolist()}


def _line(facts):
    return (f"{facts['name']:13} {facts['quads']} quads, {facts['points']} points; {facts['about']}; "
            f"{_count(facts['face_doublets'], 'face doublet')}, {_count(facts['flat_corners'], 'flat corner')}")


def _count(things, name):
    return f"{len(things) or 'no'} {name}{'' if len(things) == 1 else 's'}"
