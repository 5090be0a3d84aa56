# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex meshes for a folder of parts: one line a part, a summary, and no failure stops the rest."""
import os
import time
import traceback

from hexcon_native import check_options

from .chatter import chatter_to
from .cli import terminal
from .cli.arguments import add_hexes, add_surface, settle_order
from .cli.commands import SOLID_ENDINGS, element_option, pairing_option
from .cli.terminal import complain, say
from .errors import FaultCode, HexconError, ToolError
from .files import SOLVER_ENDINGS, WRITERS, check_method_for, shown, write
from .meshing import mesh_solid
from .topological import BY_OPTION, is_topological

EXIT_DONE, EXIT_SOME_FAILED, EXIT_USAGE = 0, 1, 2


def parts_in(folder):
    """Paths of the solids in a folder, sorted by name."""
    names = sorted(n for n in os.listdir(folder)
                   if os.path.splitext(n)[1].lower() in SOLID_ENDINGS)
    return [os.path.join(folder, n) for n in names]


def results_of(parts, out, endings):
    """Paths to write for each part: its name with each ending. Parts that differ in their own
    ending alone keep it: box.step and box.brep give box.step.inp and box.brep.inp."""
    names = [os.path.basename(path) for path in parts]
    stems = [os.path.splitext(name)[0] for name in names]
    return [[os.path.join(out, (stem if stems.count(stem) == 1 else name) + ending)
             for ending in endings] for name, stem in zip(names, stems)]


def mesh_part(path, results, size, *, allow_topological=False, element=None, **options):
    """Mesh one part and write it to each of results; returns (done, the line that tells of it).

    allow_topological: as files.write; element: the type of element that .inp names; options: as meshing.mesh_solid.
    Any exception but an interrupt becomes a line: a batch goes on.
    """
    name = os.path.basename(path)
    started = time.monotonic()
    try:
        if any(os.path.exists(result) and os.path.samefile(path, result) for result in results):
            raise ToolError("the result would overwrite the part; give another --out",
                            FaultCode.BAD_OPTION)
        with chatter_to():
            mesh = mesh_solid(path, size, **options)
            for result in results:
                write(mesh, result, allow_topological=allow_topological, **element_option(result, element))
    except HexconError as fault:
        return False, f"FAILED {name}: {' '.join(str(fault).split())} [{fault.code.name}]"
    except Exception as fault:  # a defect of ours must not cost the other parts
        traceback.print_exc()
        return False, f"FAILED {name}: {type(fault).__name__}: {' '.join(str(fault).split())}"
    return True, (f"ok     {name}: {len(mesh.hexes)} hexes, {mesh.method}, {mesh.surface.method} "
                  f"surface, {_worth(mesh)}, {time.monotonic() - started:.1f} s")


def _worth(mesh):
    """Quality and proof in words, of a mesh that may not have been checked."""
    if is_topological(mesh):
        proof = "topological (not for solving)"
    elif mesh.certificate is None:
        proof = "not checked"
    else:
        proof = "certified" if mesh.certificate.certified else "NOT certified"
    if mesh.quality is None:
        return f"scaled Jacobian not checked, {proof}"
    return f"scaled Jacobian min {mesh.quality.min:.3f} mean {mesh.quality.mean:.3f}, {proof}"


def mesh_folder(folder, out, size, endings=(".inp",), tell=print, **options):
    """Mesh every solid in a folder into another; returns (number done, number failed).

    endings  formats to write, of files.WRITERS
    tell     called with each line
    options  as mesh_part
    Raises ToolError(FILE_IO) where the folder of results cannot be made.
    """
    try:
        os.makedirs(out, exist_ok=True)
    except OSError as fault:
        raise ToolError(f"cannot make {out}: {fault.strerror}", FaultCode.FILE_IO) from fault
    done = failed = 0
    parts = parts_in(folder)
    for path, results in zip(parts, results_of(parts, out, endings)):
        good, line = mesh_part(path, results, size, **options)
        done, failed = done + good, failed + (not good)
        tell(line)
    tell(f"{done} done, {failed} failed of {done + failed} parts in {folder}; results in {out}")
    return done, failed


def _parser():
    parser = terminal.Parser(
        prog="mesh_folder", description="Hex meshes for every solid in a folder.",
        epilog="exit status: 0 all done; 1 a part failed, or there was none; 2 wrong usage; 129, 130, 143 ended by "
               "SIGHUP, SIGINT, SIGTERM; 141 nobody read the lines to their end")
    parser.add_argument("folder")
    parser.add_argument("--out", help="where results go (default: FOLDER/hexcon)")
    parser.add_argument("--size", type=float, required=True, help="wanted edge length, mm")
    parser.add_argument("--write", action="append", choices=sorted(shown(WRITERS)),
        help="a format; may be given several times (default .inp)")
    add_surface(parser)
    add_hexes(parser)
    parser.add_argument("--allow-topological", action="store_true",
                        help=f"write a mesh of topology only even to {', '.join(shown(SOLVER_ENDINGS))}")
    return parser


def program(arguments=None):
    """The batch as a program, with its streams and signals; returns the exit status."""
    return terminal.run(lambda: main(arguments), "mesh_folder")


def main(arguments=None):
    """The batch; returns the exit status. Raises KeyboardInterrupt."""
    options = _parser().parse_args(arguments)
    if not os.path.isdir(options.folder):
        complain(f"mesh_folder: there is no folder {options.folder}")
        return EXIT_USAGE
    try:
        settle_order(options)
        endings = tuple(options.write or (".inp",))
        check_options(options.method, order=options.order, layers=options.layers, pillow=options.pillow)
        # the name is no part's: what counts are the endings
        check_method_for([f"x{ending}" for ending in endings], options.method,
                         options.allow_topological, BY_OPTION)
        done, failed = mesh_folder(
            options.folder, options.out or os.path.join(options.folder, "hexcon"), options.size,
            endings, say,
            element=options.element_type, order=options.order, surface_method=options.surface_method,
            method=options.method,
            local_sizes=options.local_sizes, per_turn=options.per_turn,
            volume_error=options.volume_error / 100.0,
            layers=options.layers, pillow=options.pillow, allow_topological=options.allow_topological,
            **pairing_option(options.pairing))
    except HexconError as fault:
        complain(f"mesh_folder: {fault}")
        return EXIT_USAGE
    return EXIT_DONE if done and not failed else EXIT_SOME_FAILED
