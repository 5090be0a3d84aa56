# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results and stages in words: lists of (heading, sentence), as plain or as rich text."""
import re
from html import escape

from hexcon.stage_words import HEX_STAGES, STAGES, figures_of, hex_stage
from hexcon.topological import is_topological
from hexcon.translation import QT_TRANSLATE_NOOP, translate
from hexcon_native import METHOD_TABLE

from .curved import of_curving
from .fillable import fillable
from .lengths import lengths_of

PILLOWS = {"auto": QT_TRANSLATE_NOOP("HexCon", "automatic"), "never": QT_TRANSLATE_NOOP("HexCon", "none"),
           "1": QT_TRANSLATE_NOOP("HexCon", "one sheet"), "2": QT_TRANSLATE_NOOP("HexCon", "two sheets"),
           "3": QT_TRANSLATE_NOOP("HexCon", "three sheets")}
ORDERS = {1: QT_TRANSLATE_NOOP("HexCon", "first order (C3D8)"),
          2: QT_TRANSLATE_NOOP("HexCon", "second order (C3D20R)")}
MOST_LISTED = 10


def stage(told):
    """(what a stage is called in the window, what is known of the mesh there or ""), of what progress tells."""
    name, _, rest = told.partition(", ")
    template, figures = figures_of(rest)
    said = translate("HexCon", template).format(**figures) if figures else rest
    return translate("HexCon", STAGES[name]) if name in STAGES else name, said


def count(number):
    """1234567 as 1 234 567, with spaces that do not break."""
    return f"{int(number):,}".replace(",", "\u00a0")


def as_text(rows):
    """One line for each row."""
    return "\n".join(f"{heading}: {sentence}" for heading, sentence in rows)


def as_html(rows):
    """The rows as rich text: paragraphs, as a panel is too narrow for columns."""
    return "".join(f"<p style='margin:0 0 5px 0'><b>{escape(heading)}:</b> {escape(sentence)}</p>"
                   for heading, sentence in rows)


def of_surface(surface, facts):
    """Rows for a quads.QuadSurface and objects.quad_surface.facts_of it."""
    can_be = {"yes": True, "no": False}.get(facts["Fillable"])
    even = translate("HexCon", "{quads}, {even}").format(
        quads=count(facts["Quads"]), even=fillable(facts["Quads"], can_be, facts["Embedded"] == "yes"))
    rows = [(translate("HexCon", "Quads"), even),
            (translate("HexCon", "Method"), surface.method),
            (translate("HexCon", "Dual loops"), translate(
                "HexCon", "{loops}, of which {crossing} cross themselves").format(
                    loops=count(facts["Loops"]), crossing=count(facts["SelfCrossings"])))]
    if facts["Embedded"] != "yes":
        rows.append((translate("HexCon", "Crossing itself"), translate(
            "HexCon", "it bounds no solid, so nothing fills it: {found}").format(found=facts["Embedded"])))
    if facts["Genus"] > 0:
        rows.append((translate("HexCon", "Holes through it"), count(facts["Genus"])))
    if facts["Cavities"] > 0:
        rows.append((translate("HexCon", "Cavities"), count(facts["Cavities"])))
    return rows + [(translate("HexCon", "Note"), note) for note in surface.notes]


def of_mesh(mesh):
    """Rows for a mesh that has just been made."""
    report = mesh.report
    rows = [(translate("HexCon", "Surface"),
             translate("HexCon", "{quads} quads, method {method}").format(
                 quads=count(len(mesh.quads)), method=report.get("surface method", "given"))),
            *_size(len(mesh.hexes), mesh.order, len(mesh.points))]
    rows.append((translate("HexCon", "Method"), _made(mesh)))
    rows += _warning(is_topological(mesh))
    rows += _worth(mesh.quality, mesh.certificate)
    rows += of_lengths(lengths_of(mesh.points, mesh.hexes))
    rows += [(translate("HexCon", "Curved edges"), sentence) for sentence in of_curving(report)]
    fit = getattr(getattr(mesh, "surface", None), "fit", None)
    if fit and "curved" not in report:      # which tells of the same, with curved faces
        rows.append((translate("HexCon", "Fit"), fit.words()))
    rows += [(translate("HexCon", "Note"), note) for note in report.get("surface notes", ())]
    rows += [(translate("HexCon", "Tried"), line) for line in (*report.get("surface tries", ()), *report["log"])]
    rows += [(translate("HexCon", "gmsh"), line) for line in report.get("gmsh", ())]
    return rows


def _made(mesh):
    """What the method counts, and hexes for each quad of the surface."""
    method = METHOD_TABLE.get(mesh.method)
    made = told(translate("HexCon", method.told), mesh.report) if method else mesh.method
    return made + translate("HexCon", "; {number:.1f} hexes a quad").format(
        number=len(mesh.hexes) / len(mesh.quads))


def told(template, report):
    """A method's account of its figures (hexcon_native.Method.told): what is in [] is left out where one is 0."""
    def optional(match):
        figures = re.findall(r"{(.+?)}", match[1])
        return match[1] if all(report.get(figure) for figure in figures) else ""
    sentence = re.sub(r"\[(.+?)\]", optional, template)
    return re.sub(r"{(.+?)}", lambda figure: count(report[figure[1]]), sentence)


def _warning(topological):
    """What a mesh of topology only is not good for; nothing of other meshes."""
    if not topological:
        return []
    return [(translate("HexCon", "Topological"), translate(
        "HexCon", "topology only: the hexes meet face to face and end in exactly the quads, but "
        "some of their Jacobians are zero or negative. Not for solving"))]


def _size(hexes, order, nodes):
    return [(translate("HexCon", "Hexes"),
             f"{count(hexes)}, {translate('HexCon', ORDERS[order])}"),
            (translate("HexCon", "Nodes"), count(nodes))]


def of_check(report):
    """Rows for an actions.CheckReport."""
    counts = report.counts
    rows = [*_size(counts.hexes, counts.order, counts.points),
            (translate("HexCon", "Boundary"),
             translate("HexCon", "{quads} quads").format(quads=count(counts.quads))),
            *_warning(report.topological),
            *_worth(report.quality, report.certificate, report.surface_known),
            *of_lengths(report.lengths)]
    if not report.surface_known:
        rows.append((translate("HexCon", "Note"), translate(
            "HexCon", "the mesh keeps no face groups that cover its boundary, so the boundary "
            "could not be compared with a surface")))
    if not report.straight:
        rows.append((translate("HexCon", "Note"), translate(
            "HexCon", "{count} hexes have curved edges, and were judged with them").format(
                count=count(len(report.curved)))))
    if report.nonpositive:
        rows.append((translate("HexCon", "Elements"),
                     translate("HexCon", "not positive: {ids}").format(ids=_listed(report.nonpositive))))
    if report.overlapping:
        rows.append((translate("HexCon", "Elements"),
                     translate("HexCon", "overlapping: {ids}").format(ids=_listed(report.overlapping))))
    return rows


def of_opening(mesh, kept, faces):
    """Rows for an InspectedMesh of which kept (H,) hexes are left and so many faces drawn."""
    rows = [(translate("HexCon", "Shown"), translate("HexCon", "{kept} of {all} hexes, {faces} faces").format(
                kept=count(kept.sum()), all=count(len(kept)), faces=count(faces))),
            (translate("HexCon", "Layers"), translate("HexCon", "{count} from the boundary to the core").format(
                count=count(mesh.thickness))),
            (translate("HexCon", "Scaled Jacobian"), _quality(mesh.quality))]
    if mesh.curved:
        rows.append((translate("HexCon", "Note"), translate(
            "HexCon", "{count} hexes have curved edges; colours and figures are theirs").format(
                count=count(mesh.curved))))
    return rows


def stage_of_hexes(name, hexes):
    """What a stage that put hexes in is called, and how many."""
    kind, number = hex_stage(name)
    said = translate("HexCon", HEX_STAGES[kind]) if kind in HEX_STAGES else kind
    if number:
        said = f"{said} {number}"
    return translate("HexCon", "{stage}: {count}").format(stage=said, count=count(hexes))


def of_loops(looped):
    """Rows for a LoopedSurface."""
    facts, crossing = looped.facts, sum(len(loop.crossings) > 0 for loop in looped.loops)
    even = fillable(facts.n, facts.fillable, facts.embedded)
    return [(translate("HexCon", "Surface"), translate("HexCon", "{quads} quads, {even}").format(
                quads=count(facts.n), even=even)),
            (translate("HexCon", "Dual loops"), translate("HexCon", "{count}; crossing themselves: {crossing}")
                .format(count=count(len(looped.loops)), crossing=count(crossing)))]


def times(number):
    """How often something happens, in a table."""
    return translate("HexCon", "{count} times").format(count=count(number)) if number else "\u2013"


def of_quads(rows):
    """Quads by their numbers in the surface object, which count from 1."""
    return translate("HexCon", "quads {ids}").format(ids=_listed([row + 1 for row in rows]))


def of_pairs(rows):
    """Pairs of quads that cross or touch, pair after pair; the same twice: one that is folded."""
    pairs = list(dict.fromkeys(zip(rows[::2], rows[1::2])))
    return translate("HexCon", "pairs of quads {ids}").format(
        ids=_listed([f"{a + 1}\u2013{b + 1}" for a, b in pairs]))


def of_path(edges):
    """A closed path of edges that is at fault."""
    return translate("HexCon", "the closed path, of {count} edges").format(count=count(edges))


def of_certificate(report):
    """The judgement of an actions.CheckReport in one sentence."""
    return _certificate(report.certificate, report.surface_known)


def _listed(ids):
    """The first of some numbers, and how many more there are."""
    listed = ", ".join(str(i) for i in ids[:MOST_LISTED])
    if len(ids) > MOST_LISTED:
        listed += translate("HexCon", " and {count} more").format(count=len(ids) - MOST_LISTED)
    return listed


def _worth(quality, certificate, surface_known=True):
    return [(translate("HexCon", "Scaled Jacobian"), _quality(quality)),
            (translate("HexCon", "Certificate"),
             _certificate(certificate, surface_known))]


def of_lengths(lengths):
    """Rows for a Lengths."""
    edges = translate("HexCon", "shortest\u00a0{least:.4g}, longest\u00a0{most:.4g}; the time step of explicit solvers "
                      "follows the shortest").format(least=lengths.shortest, most=lengths.longest)
    aspect = translate("HexCon", "most\u00a0{most:.2f}, mean\u00a0{mean:.2f}").format(
        most=lengths.aspect_ratio.max(), mean=lengths.aspect_ratio.mean())
    return [(translate("HexCon", "Edges"), edges), (translate("HexCon", "Aspect ratio"), aspect)]


def _quality(quality):
    if quality is None:
        return translate("HexCon", "not checked")
    # figures stay beside their names where the panel breaks the line
    return translate("HexCon", "min\u00a0{min:.3f}, 5\u00a0%\u00a0{q05:.3f}, "
                     "mean\u00a0{mean:.3f}").format(
        min=quality.min, q05=quality.q05, mean=quality.mean)


def _certificate(certificate, surface_known):
    if certificate is None:
        return translate("HexCon", "not checked")
    if certificate.certified:
        proofs = [translate("HexCon", "every Jacobian is proved positive"),
                  translate("HexCon", "the mesh is proper"),
                  translate("HexCon", "nothing overlaps")]
        if surface_known:
            proofs.append(translate("HexCon", "its boundary exact"))
        # the word alone must not promise more than is proved
        return (translate("HexCon", "certified: ") if surface_known else "") + ", ".join(proofs)
    faults = []
    if len(certificate.nonpositive):
        faults.append(translate("HexCon", "{count} hexes are not proved positive").format(
            count=count(len(certificate.nonpositive))))
    if not certificate.conforming:
        faults.append(translate("HexCon", "it is not conforming"))
    if not certificate.proper:
        faults.append(translate("HexCon", "{count} hexes meet others improperly").format(
            count=count(len(certificate.improper))))
    if not certificate.boundary_exact:
        faults.append(translate("HexCon", "its boundary is not the given one"))
    if certificate.embedded is False:
        faults.append(translate("HexCon", "it overlaps itself: {reason}").format(reason=certificate.embedding_reason))
    elif certificate.embedded is None and certificate.boundary_exact:
        faults.append(translate("HexCon", "whether it overlaps itself could not be told: {reason}").format(
            reason=certificate.embedding_reason))
    return translate("HexCon", "NOT certified: ") + "; ".join(faults)
