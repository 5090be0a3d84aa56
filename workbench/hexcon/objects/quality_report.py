# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "quality report": what is proved and measured of a hex mesh object."""
import numpy as np

from hexcon.judging import words
from hexcon.judging.report import check_mesh, read_mesh_object
from hexcon.window import attach_view

from .parametric import Parametric, fingerprint, is_a, set_changed

PROPERTIES = (
    ("App::PropertyLink", "Mesh", "HexCon", "The FEM mesh of hexes that is judged", None, False),
    ("App::PropertyInteger", "Worst", "HexCon", "How many of the worst elements are listed", 10, False),
    ("App::PropertyInteger", "Hexes", "Result", "Number of hexes", 0, True),
    ("App::PropertyInteger", "Nodes", "Result", "Number of nodes", 0, True),
    ("App::PropertyFloat", "Minimum", "Result", "Worst scaled Jacobian", 0.0, True),
    ("App::PropertyFloat", "FivePercent", "Result", "Scaled Jacobian that 5 % of the hexes fall short of", 0.0, True),
    ("App::PropertyFloat", "Mean", "Result", "Mean scaled Jacobian", 0.0, True),
    ("App::PropertyFloat", "ShortestEdge", "Result", "Length of the shortest edge, which time steps follow", 0.0, True),
    ("App::PropertyFloat", "AspectRatio", "Result", "Longest over shortest edge of a hex, where it is most", 0.0, True),
    ("App::PropertyIntegerList", "WorstElements", "Result", "Numbers of the worst elements, the worst first",
     None, True),
    ("App::PropertyFloatList", "WorstScaledJacobians", "Result", "Their scaled Jacobians", None, True),
    ("App::PropertyBool", "Certified", "Result", "Every Jacobian is proved positive, the mesh is proper and "
     "conforming, its boundary exactly the quads", False, True),
    ("App::PropertyString", "Certificate", "Result", "The judgement in words", "", True),
)


def job_of(mesh_object):
    """(fingerprint, job(progress) -> (CheckReport, FreeCAD's numbers of the hexes)).

    Raises ToolError(BAD_MESH) for a mesh of other elements.
    """
    found = read_mesh_object(mesh_object)
    mark = fingerprint(found.points, found.hexes, found.topological)
    return mark, lambda progress: (check_mesh(found, progress), np.asarray(found.hex_ids))


class QualityReportObject(Parametric):
    """Proxy of a quality report. Saved documents name this class: never rename or move it."""

    Type = "HexCon::QualityReport"
    PROPERTIES = PROPERTIES

    def inputs(self, obj):
        if obj.Mesh is None:
            return None
        mark, job = job_of(obj.Mesh)
        return fingerprint(mark, obj.Worst), job

    def store(self, obj, result):
        report, hex_ids = result
        jacobians = report.quality.scaled_jacobian
        worst = np.argsort(jacobians, kind="stable")[:max(0, obj.Worst)]
        set_changed(obj, {
            "Hexes": report.counts.hexes, "Nodes": report.counts.points, "Minimum": report.quality.min,
            "FivePercent": report.quality.q05, "Mean": report.quality.mean,
            "ShortestEdge": report.lengths.shortest,
            "AspectRatio": float(report.lengths.aspect_ratio.max()),
            "WorstElements": hex_ids[worst].tolist(), "WorstScaledJacobians": jacobians[worst].tolist(),
            "Certified": bool(report.certificate.certified), "Certificate": words.of_certificate(report)})


def is_quality_report(obj):
    """Whether the document object is a quality report."""
    return is_a(obj, QualityReportObject.Type)


def add_quality_report(document, mesh_object, result, mark, worst=10, name="QualityReport"):
    """A report object of job_of's result and fingerprint. No transaction of its own."""
    obj = document.addObject("App::FeaturePython", name)
    QualityReportObject(obj)
    attach_view(obj, "QualityReportView")
    obj.Mesh, obj.Worst = mesh_object, worst
    obj.Proxy.take(obj, result, fingerprint(mark, worst))
    obj.Label = f"Quality of {mesh_object.Label}"
    obj.purgeTouched()
    return obj
