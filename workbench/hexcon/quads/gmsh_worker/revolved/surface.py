# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `revolved`: bodies of revolution by a full turn, quads of half a section turned round their axis."""
import numpy as np

from ..cad_fit import volume_and_area
from ..cap import mesh_cap
from ..outline import Outline, least_count
from ..smooth import evenness
from ..spacing import STATIONS, spacing_of
from .axis import Axis, axis_of
from .bands import bands_of
from .core import with_cores
from .half_section import half_section
from .loops import Loops
from .turned import Turned

MOST_VOLUME = 0.01      # part by which the volume may differ from the CAD's: chords cut round faces
OF_SECTION = 0.4        # of that the section may take, the number round the rest
REFINEMENTS = 4
STRAIGHT = 1e-6         # radians
AROUND = 24             # angles at which local sizes are asked for
SMALLER = 0.999         # of the size: what is smaller is wanted
ALONG = 64              # points of a rim that tell which face is where
FEWEST_ROUND = 8


def revolved_surface(solid, size, link, sizes):
    """Quads on the solid and hexes inside.

    sizes: SizeField by place, at most `size`
    Returns a dict of points (V,3), quads (n,4), faces (n,), hexes (H,8), joined and notes. Raises WorkerFault
    NOT_REVOLVED with the reason.
    """
    link.progress("section", 0.0)
    axis, carriers = axis_of(solid)
    bands = bands_of(solid, axis, carriers)
    axis = _from_meridian(solid, axis, bands)
    section, cores = with_cores(half_section(solid, axis, bands, carriers))
    loops, volume = Loops(section), solid.exact_volume
    cap, off = _section_mesh(loops, cores, volume, axis, sizes, link)
    step = 8 if any(core.pointed for core in cores) else 4
    around = _number_round(solid, axis, loops, sizes, off, step)
    link.progress("turn", 0.5)
    for left in reversed(range(REFINEMENTS + 1)):   # of the discs, too, which the section does not know
        body = _turned(axis, loops, cores, cap, around)
        off = volume_and_area(body.points[body.quads])[0] / volume - 1.0
        if abs(off) <= MOST_VOLUME or not left:
            break
        around = step * (int(around * np.sqrt(abs(off) / MOST_VOLUME) / step) + 1)
    faces = _faces(solid, axis, bands, body)
    return {"points": body.points, "quads": body.quads, "faces": faces, "hexes": body.hexes,
            "joined": {f: band.faces for band in bands for f in band.faces if len(band.faces) > 1},
            "notes": _notes(solid, axis, cap, cores, around, off, size, faces)}


def _from_meridian(solid, axis, bands):
    """The axis with angle 0 where the first meridian edge is, so that edges between halves of a face are mesh edges."""
    for edge in (e for band in bands for e in band.meridians):
        points = solid.edge_points(edge, np.linspace(0.0, 1.0, 5))
        radius = axis.flat(points)[0][:, 0]
        if radius.max() > 10 * solid.tolerance:
            return Axis.through(axis.origin, axis.direction, points[int(np.argmax(radius))])
    return axis


def _section_mesh(loops, cores, volume, axis, sizes, link):
    """(CapMesh of the section, part by which the volume of its polygon turned round is off)."""
    least = [np.array([least_count(c.turning, len(loop) == 1) if c.turning > STRAIGHT else 1 for _, c in loop])
             for loop in loops.loops]
    for _ in range(REFINEMENTS):
        cap = mesh_cap(_outline(loops, axis, sizes, least), link, "section")
        off = loops.volume(cap.shares, cores) / volume - 1.0
        finer = 1.02 * np.sqrt(abs(off) / (OF_SECTION * MOST_VOLUME))
        if finer <= 1.02:
            break
        least = [np.where([c.turning > STRAIGHT for _, c in loop], np.ceil(finer * counts).astype(int), few)
                 for loop, counts, few in zip(loops.loops, cap.counts, least)]
    return cap, off


def _outline(loops, axis, sizes, least):
    desired, turn, direction, spacing = [], [], [], []
    for loop in loops.loops:
        desired.append(np.array([c.length / sizes.size for _, c in loop]))
        if not sizes.even:
            spacing.append([spacing_of(sizes, _round(axis, c)) for _, c in loop])
            desired[-1] = np.array([own.wanted for own in spacing[-1]])
        out = np.array([c.tangent() for _, c in loop])
        into = np.array([c.tangent(at_end=True) for _, c in loop[-1:] + loop[:-1]])
        heading, before = (np.arctan2(d[:, 1], d[:, 0]) for d in (out, into))
        turn.append((heading - before + np.pi) % (2 * np.pi) - np.pi)
        direction.append(heading)
    return Outline(desired, least, turn, direction, loops.place, loops.place, sizes.size, spacing or None)


def _round(axis, curve):
    """[(n,3)] stations of a curve at several angles."""
    flat = curve.at(STATIONS)
    return [axis.place(flat, angle) for angle in 2 * np.pi * np.arange(AROUND) / AROUND]


def _number_round(solid, axis, loops, sizes, off, step):
    """A multiple of step: from the mean radius of the faces, as local sizes want it, and more where chords would cut
    too much.

    off: what the section has of the volume's fault already; where that is all that there may be, no number helps
    """
    moment = np.zeros(2)
    for face in solid.faces:
        area = solid.area(face)
        moment += area, area * _mean_radius(solid, axis, face)
    wanted = 2 * np.pi * moment[1] / moment[0] / sizes.size
    if not sizes.even:
        curves = [c for loop in loops.loops for _, c in loop if c.band >= 0]
        local = [2 * np.pi * c.at(STATIONS)[:, 0] / (size := sizes(places)) * (size < SMALLER * sizes.size)
                 for c in curves for places in _round(axis, c)]
        wanted = max(wanted, float(np.max(local)))
    count = step * max(int(np.rint(wanted / step)), int(np.ceil(FEWEST_ROUND / step)))
    while abs(off) < MOST_VOLUME < abs((1.0 + off) * np.sin(2 * np.pi / count) / (2 * np.pi / count) - 1.0):
        count += step
    return count


def _mean_radius(solid, axis, face):
    """Of the face's outline: rims and meridians."""
    radii = [axis.flat(solid.edge_points(e, np.linspace(0.0, 1.0, 5)))[0][:, 0].mean() for e in solid.boundary[face]]
    return float(np.mean(radii)) if radii else 0.0


def _turned(axis, loops, cores, cap, around):
    starts, ends, bands, line_ids, first = [], [], [], {}, 0
    for loop, counts in zip(loops.loops, cap.counts):
        total = int(counts.sum())
        ids = first + np.arange(total + 1)
        ids[-1] = first
        for (number, curve), a, b in zip(loop, np.cumsum(counts) - counts, np.cumsum(counts)):
            chain = ids[a:b + 1]
            if curve.band < 0:
                line_ids[number] = chain if curve.tangent()[1] > 0 else chain[::-1]
                continue
            starts.append(chain[:-1])
            ends.append(chain[1:])
            bands.append(np.full(len(chain) - 1, curve.band))
        first += total
    piles = [(core, line_ids[core.line], core.low.band, core.high.band) for core in cores]
    return Turned(axis, around, cap.points, cap.quads, tuple(map(np.concatenate, (starts, ends, bands))), piles)


def _faces(solid, axis, bands, body):
    """(n,) CAD face of each quad: of a band of several the one that is at its middle."""
    faces = np.array([band.faces[0] for band in bands])[body.bands]
    for number, band in enumerate(bands):
        if len(band.faces) == 1:
            continue
        own = np.flatnonzero(body.bands == number)
        arcs = [_angles(solid, axis, f) for f in band.faces]
        if all(len(arc) for arc in arcs):
            here = body.middles[own][:, None]
            gaps = [np.abs((here - arc + np.pi) % (2 * np.pi) - np.pi).min(axis=1) for arc in arcs]
        else:       # parts of a ball without a rim
            middles = body.points[body.quads[own]].mean(axis=1)
            gaps = [np.linalg.norm(solid.project(2, f, middles) - middles, axis=1) for f in band.faces]
        faces[own] = np.array(band.faces)[np.argmin(np.round(gaps, 9), axis=0)]
    return faces


def _angles(solid, axis, face):
    """Angles along the face's rims."""
    found = []
    for edge in solid.boundary[face]:
        flat, angle = axis.flat(solid.edge_points(edge, (np.arange(ALONG) + 0.5) / ALONG))
        if np.ptp(flat, axis=0).max() <= solid.tolerance:
            found.append(angle)
    return np.concatenate(found) if found else np.empty(0)


def _notes(solid, axis, cap, cores, around, off, size, faces):
    (low, mean), aspect = cap.quality(), 1.0 / float(evenness(cap.points, cap.quads).min())
    notes = [f"revolved about {axis.word}: {len(cap.quads)} quads of half a section ({cap.name}, scaled Jacobian "
             f"{low:.3f} to mean {mean:.3f}, edges of a quad up to 1 to {aspect:.1f}) x {around} round"
             + (f", {len(cores)} cores of discs" if cores else "") + f"; volume {100 * off:+.2f} %"]
    wanted = solid.exact_area / size ** 2
    if len(faces) > 2.0 * wanted:
        notes.append(f"revolved: {len(faces)} quads where the size asks for {wanted:.0f}: chords are to cut no more "
                     f"than {100 * MOST_VOLUME:g} % of the volume, and short edges of the section have one each")
    lost = sorted(set(solid.faces) - set(faces.tolist()))
    if lost:
        notes.append(f"revolved: too small for quads of their own: {', '.join(f'Face{f}' for f in lost[:20])}")
    return notes
