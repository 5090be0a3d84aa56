# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results and stages in words: lists of (heading, sentence), as text or as a table."""
from html import escape

import FreeCAD

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# The stages that gmsh's worker and the core report; others are shown under their own name.
STAGES = {
    "start": QT_TRANSLATE_NOOP("HexCon", "Surface: starting gmsh"),
    "load": QT_TRANSLATE_NOOP("HexCon", "Surface: reading the solid"),
    "cap": QT_TRANSLATE_NOOP("HexCon", "Surface: quads of the cap"),
    "walls": QT_TRANSLATE_NOOP("HexCon", "Surface: quads of the walls"),
    "mesh": QT_TRANSLATE_NOOP("HexCon", "Surface: quads by gmsh"),
    "check": QT_TRANSLATE_NOOP("HexCon", "Surface: distance from the solid"),
    "sweep recognition": QT_TRANSLATE_NOOP("HexCon", "Hexes: looking for sweeps"),
    "placement": QT_TRANSLATE_NOOP("HexCon", "Hexes: placing points"),
    "optimisation": QT_TRANSLATE_NOOP("HexCon", "Hexes: improving the worst"),
    "certificate: links": QT_TRANSLATE_NOOP("HexCon", "Certificate: neighbourhoods"),
    "certificate: pairs": QT_TRANSLATE_NOOP("HexCon", "Certificate: pairs of hexes"),
    "certificate: Jacobians": QT_TRANSLATE_NOOP("HexCon", "Certificate: Jacobians"),
}
ORDERS = {1: QT_TRANSLATE_NOOP("HexCon", "first order (C3D8)"),
          2: QT_TRANSLATE_NOOP("HexCon", "second order (C3D20)")}
MOST_LISTED = 10


def stage(name):
    """What a stage is called in the window."""
    return translate("HexCon", STAGES[name]) if name in STAGES else name


def count(number):
    """1234567 as 1 234 567, with spaces that do not break."""
    return f"{int(number):,}".replace(",", "\u00a0")


def as_text(rows):
    """One line for each row."""
    return "\n".join(f"{heading}: {sentence}" for heading, sentence in rows)


def as_table(rows):
    """The rows as rich text."""
    cells = "".join(f"<tr><td style='padding-right:8px'><b>{escape(heading)}</b></td>"
                    f"<td>{escape(sentence)}</td></tr>" for heading, sentence in rows)
    return f"<table>{cells}</table>"


def of_mesh(mesh):
    """Rows for a mesh that has just been made."""
    rows = [(translate("HexCon", "Surface"),
             translate("HexCon", "{quads} quads, method {method}").format(
                 quads=count(len(mesh.quads)), method=mesh.report.get("surface method", "given"))),
            (translate("HexCon", "Hexes"), _hexes(mesh)),
            (translate("HexCon", "Nodes"), count(len(mesh.points))),
            *_worth(mesh.quality, mesh.certificate)]
    rows += [(translate("HexCon", "Note"), note) for note in mesh.report.get("surface notes", ())]
    return rows


def _hexes(mesh):
    sentence = f"{count(len(mesh.hexes))}, {translate('HexCon', ORDERS[mesh.order])}"
    if mesh.report.get("rings"):
        sentence += translate("HexCon", ": {cap} cap quads \u00d7 {rings} rings").format(
            cap=count(mesh.report["cap quads"]), rings=count(mesh.report["rings"]))
    return sentence


def of_check(report):
    """Rows for an actions.CheckReport."""
    counts = report.counts
    rows = [(translate("HexCon", "Hexes"),
             f"{count(counts.hexes)}, {translate('HexCon', ORDERS[counts.order])}"),
            (translate("HexCon", "Nodes"), count(counts.points)),
            (translate("HexCon", "Boundary"),
             translate("HexCon", "{quads} quads").format(quads=count(counts.quads))),
            *_worth(report.quality, report.certificate)]
    if not report.surface_known:
        rows.append((translate("HexCon", "Note"), translate(
            "HexCon", "the mesh keeps no face groups that cover its boundary, so the boundary "
            "could not be compared with a surface")))
    if not report.straight:
        rows.append((translate("HexCon", "Note"), translate(
            "HexCon", "some edges are curved; hexes are judged by their corners, so nothing is "
            "proved of the curved elements")))
    if report.nonpositive:
        rows.append((translate("HexCon", "Elements"), _listed(report.nonpositive)))
    return rows


def _listed(ids):
    listed = ", ".join(str(i) for i in ids[:MOST_LISTED])
    if len(ids) > MOST_LISTED:
        listed += translate("HexCon", " and {count} more").format(count=len(ids) - MOST_LISTED)
    return translate("HexCon", "not positive: {ids}").format(ids=listed)


def _worth(quality, certificate):
    return [(translate("HexCon", "Scaled Jacobian"),
             translate("HexCon", "min {min:.3f}, 5 % {q05:.3f}, mean {mean:.3f}").format(
                 min=quality.min, q05=quality.q05, mean=quality.mean)),
            (translate("HexCon", "Certificate"), _certificate(certificate))]


def _certificate(certificate):
    if certificate.certified:
        return translate("HexCon", "certified: every Jacobian is proved positive, the mesh is "
                         "proper, its boundary exact")
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
    return translate("HexCon", "NOT certified: ") + "; ".join(faults)
