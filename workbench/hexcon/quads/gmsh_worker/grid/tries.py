# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method grid: sizes and features are tried until hexes come out that are certified and good."""
import time
from dataclasses import dataclass

import hexcon_native as hn

from ..fault import WorkerFault
from ..size_field import SizeField
from .captured import NotCaptured
from .cells_to_split import LEVELS
from .features import EVERY_EDGE, SMOOTH, Cad, Features
from .overlay import GOOD, LONGEST, Work, few, finished, overlay
from .quad_count import quad_count_words
from .too_small import too_small

THIN = 0.45             # smaller parts of the size are tried only where nothing else came out
DRAFTS = 2              # with folded hexes that are worked on, where nothing else came out
BUDGET, TIMES = 15_000, 4.0     # hexes looked at in all tries, or so many times those of the first
# Of the time limit, in processor time: no try is begun then; nor, where there is a mesh, then; the last one is ended.
SHARE, SHARE_OF_BETTER, MOST = 0.15, 0.1, 0.5


@dataclass(frozen=True)
class Try:
    """factor: of the size; smooth: see Features; slivers: faces too narrow for it are left out; levels: how often cells
    are split in two where the solid is narrower than they are."""

    factor: float
    smooth: float = SMOOTH
    slivers: bool = False
    levels: int = 0

    def __str__(self):
        return f"{self.factor:g} of the size" + (", every edge" if self.smooth < 0.0 else "") + \
            (", without slivers" if self.slivers else "") + \
            (f", narrow places split {self.levels} times" if self.levels else "")


TRIES = (Try(1.0, EVERY_EDGE), Try(1.0), Try(1.0, EVERY_EDGE, levels=1), Try(1.0, levels=1), Try(0.8, EVERY_EDGE),
         Try(1.0, slivers=True), Try(0.8), Try(0.8, slivers=True), Try(0.64), Try(0.5, slivers=True), Try(0.4),
         Try(0.3))


def grid_surface(solid, size, link, timeout, sizes=None, care=0):
    """Quads on the solid and hexes inside, of a grid laid over it.

    timeout: seconds for all of the surface, of which others may need a part
    sizes: the SizeField wanted; None: of one size
    care: above 0 another size was tried before, and all of TRIES with it: it is refused at once
    Returns a dict of points (V,3), quads (n,4), faces (n,), hexes (H,8) and notes. Raises WorkerFault NOT_GRIDDED.
    """
    if care:
        raise WorkerFault("NOT_GRIDDED", "a grid was tried at larger sizes, down to parts of this one")
    sizes = SizeField(size) if sizes is None else sizes
    link.progress("features", 0.0)
    link.patience = MOST * timeout
    if not link.risk("grid"):
        raise WorkerFault("NOT_GRIDDED", f"not done in {MOST:g} of the time limit: more time, or a larger size, may do")
    tries = _Tries(Cad(solid, size), size, link, timeout, sizes)
    tries.run()
    if tries.best is None:
        tries.finish_drafts()
    sharp = tries.features_of(SMOOTH, frozenset())
    small, faces = too_small(sharp, size)
    tries.faults += [small] if small else []
    if tries.best is None:
        raise WorkerFault("NOT_GRIDDED", "; ".join(tries.faults), faces)
    if sizes.least < size / 2 ** LEVELS / LONGEST:
        tries.faults.append(f"cells are split {LEVELS} times at most: sizes below {size / 2 ** LEVELS:.3g} are not "
                            "reached")
    counted = quad_count_words(len(tries.best[0].mesh.quads), sharp, size, sizes)
    return _surface(*tries.best, tries.faults + ([counted] if counted else []))


class _Tries:
    """best: (Overlay, Try) that may be handed on, or None; drafts: [(Overlay, Try)] with folded hexes; faults: words.
    """

    def __init__(self, cad, size, link, timeout, sizes):
        self.cad, self.size, self.link, self.timeout, self.sizes = cad, size, link, timeout, sizes
        self.begun, self.work, self.limit = time.process_time(), Work(), BUDGET
        self.best, self.drafts, self.faults = None, [], []
        self._known = {}

    def run(self):
        for number, one in enumerate(TRIES):
            if self._is_over(one):
                break
            features = self._features(one)
            if features is None:
                continue
            try:
                found = overlay(features, self.size * one.factor, self.work, self._reporting(number), one.levels,
                                self.sizes, self.best is not None)
            except (NotCaptured, ValueError, hn.HexconError) as fault:
                self.faults.append(f"{one}: {fault}")
                continue
            finally:
                self.limit = max(self.limit, TIMES * self.work.hexes) if number == 0 else self.limit
            self._keep(found, one)
            if found.good and found.quality.min > GOOD:
                break
            self.faults.append(f"{one}: {_shortcomings(found)}")

    def finish_drafts(self):
        """The best of those with folded hexes, with all passes that there are."""
        for draft, one in sorted(self.drafts, key=lambda d: d[0].rank, reverse=True)[:DRAFTS]:
            if self._is_late(SHARE) or draft.folded > few(draft.mesh):
                return
            self._keep(finished(draft, self.size * one.factor, self._reporting(len(TRIES) - 1)), one)
            if self.best is not None:
                return

    def _keep(self, found, one):
        if not found.good:
            self.drafts += [(found, one)] if found.folded else []
        elif self.best is None or found.rank > self.best[0].rank:
            self.best = found, one
            self.link.keep(_surface(found, one, self.faults))

    def _is_over(self, one):
        return self._is_late(SHARE if self.best is None else SHARE_OF_BETTER) or self.work.hexes > self.limit or \
            (self.best is not None and one.factor < THIN)

    def _is_late(self, share):
        return time.process_time() - self.begun > share * self.timeout

    def _reporting(self, number):
        return lambda stage, fraction: self.link.progress(stage, (number + fraction) / len(TRIES))

    def _features(self, one):
        """Features of a try, or None where they are those of another."""
        sharp = self.features_of(SMOOTH, frozenset())
        soft = frozenset(sharp.slivers(self.size * one.factor)) if one.slivers else frozenset()
        found = self.features_of(one.smooth, soft)
        same = (one.slivers and not soft) or (one.smooth < 0.0 and len(found.curves) == len(sharp.curves))
        return None if same else found

    def features_of(self, smooth, soft):
        if (smooth, soft) not in self._known:
            self._known[smooth, soft] = Features(self.cad, smooth, soft)
        return self._known[smooth, soft]


def _shortcomings(found):
    proof = found.certificate
    words = [f"least scaled Jacobian {found.quality.min:.3f}"]
    if len(proof.nonpositive):
        words.append(f"{len(proof.nonpositive)} hexes not positive")
    if not proof.proper:
        words.append("hexes meet improperly")
    if not proof.embedded:
        words.append(f"{len(proof.crossings)} pairs of quads cross" if len(proof.crossings) else proof.embedding_reason)
    return ", ".join(words + found.kept.faults)


def _surface(found, one, faults):
    mesh, features = found.mesh, found.features
    notes = [f"grid: {len(mesh.hexes)} hexes at {one}; edges within {found.kept.chord:.2f} of their size",
             *(f"grid: {fault}" for fault in faults)]
    left_out = sorted(features.edges[e].tag for e in features.soft)
    if left_out:
        notes.append(f"grid: edges without mesh edges of their own: {', '.join(f'Edge{e}' for e in left_out[:20])}")
    joined = {f: patch.faces for patch in features.patches for f in patch.faces}
    return {"points": found.points, "quads": mesh.quads, "faces": found.faces, "hexes": mesh.hexes, "notes": notes,
            "joined": joined}
