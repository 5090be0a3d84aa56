# SPDX-License-Identifier: LGPL-2.1-or-later
"""A linear static analysis through FreeCAD's FEM workbench, without its GUI."""
import os
from contextlib import contextmanager

import numpy as np

from hexcon import disk, freecad_compat
from hexcon.curving.raising import raised
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.convert import from_femmesh, to_femmesh
from hexcon.femmesh.document import insert
from hexcon.femmesh.element_types import chosen_type, default_type, element_type
from hexcon.femmesh.elements import elements_of
from hexcon.topological import is_topological, refuse_topological

from . import constraints as make, frd
from .document_run import in_order_of, kept_for_a_reason, result_object_of, run_deck, staying_in_its_group
from .freecad_deck import correct_loads, name_element_type
from .judging import check_loads
from .loads import force_vector, pressure_value
from .material import material_of
from .result import Result
from .runner import find_ccx


def solve(doc, mesh, solid, *, material=None, fixed=("Face1",), force=None, pressure=None,
          order=None, element=None, workdir=None, timeout=3600, threads=None, allow_topological=False,
          waiting=None):
    """Build an analysis in the document, run ccx, load the results into the document.

    mesh      a hex mesh (it is added as a mesh object), or a document object that holds
              one (FreeCAD moves it from the analysis it was in, if any, to the new one)
    solid     the document object whose faces are named
    material  see material.material_of; None: steel
    fixed     CAD faces held;  force {"Face2": (fx, fy, fz)} total N, spread evenly;
    pressure  {"Face3": MPa}, positive onto the face
    order     1 (C3D8), 2 (C3D20R or C3D20), None: the mesh's own; only for a mesh that is no object. A mesh of order 1
              is curved at order 2 on the solid it was made of; where that cannot be, report["straight edges"] says why
    element   C3D8, C3D8R, C3D20 or C3D20R, of the mesh's order; None: the mesh object's ElementType, else that
              of femmesh.element_types.default_type
    workdir   existing folder for the deck and ccx's files; a new temporary one if None
    timeout   seconds for ccx;  threads  None: all processors
    allow_topological  take a mesh of topology only as well: its results mean nothing
    waiting   function (job, name) -> job(progress)'s result, in which ccx runs; for windows
    Returns a Result. One undo step; on any failure the document is as it was.
    Raises ToolError: FREECAD_MISSING, TOOL_MISSING, TOOL_FAILED with ccx's words,
    TOOL_TIMEOUT, FILE_IO, BAD_OPTION, BAD_MESH, TOPOLOGICAL_MESH.
    """
    refuse_topological(mesh, allow_topological)
    given = force, pressure
    force = _without_zeros(force)
    pressure = {name: pressure_value(name, value) for name, value in (pressure or {}).items()}
    material = material_of(material)
    faces = [[make.face_name(solid, name) for name in group]
             for group in (fixed, force, pressure)]
    if not faces[0]:
        raise ToolError("nothing is held: name at least one fixed face",
                        FaultCode.BAD_OPTION)
    check_loads(*given)
    program = find_ccx(freecad_compat.ccx_preference())
    folder = workdir or disk.new_folder("hexcon-fem-")
    if not os.path.isdir(folder):
        raise ToolError(f"working folder {folder} does not exist", FaultCode.FILE_IO)
    is_object = hasattr(mesh, "FemMesh")
    mesh, straight = (mesh, None) if is_object else raised(mesh, order)
    femmesh = (mesh.FemMesh if is_object else
               to_femmesh(mesh, order, allow_topological=allow_topological))
    setup = _Setup(doc, solid, mesh if is_object else None, femmesh, material)
    setup.topological = is_topological(mesh)
    setup.straight = straight
    setup.element = (element_type(element or chosen_type(mesh), setup.elements.order)
                     or default_type(setup.elements))
    setup.fixed = faces[0]
    setup.force = dict(zip(faces[1], force.values()))
    setup.pressure = dict(zip(faces[2], pressure.values()))
    before = {o.Name for o in doc.Objects}
    with kept_for_a_reason(folder, workdir), freecad_compat.transaction(doc, "Solve hex mesh"), setup.restoring():
        tools = setup.build(folder)
        found, log = run_deck(tools.inp_file_name, setup.mesh, setup.mesh.hex_ids, setup.mesh.node_ids, waiting,
                              ccx=program, timeout=timeout, threads=threads)
        result_object = _load(setup, tools)
        added = [o for o in doc.Objects if o.Name not in before]
    return _result(setup, tools, result_object, added, found, log)


def _without_zeros(force):
    """Forces as arrays (3,); a zero force has no direction and is left out."""
    arrays = {}
    for name, vector in (force or {}).items():
        vector = force_vector(name, vector)
        if vector.any():
            arrays[name] = vector
    return arrays


class _Setup:
    """The objects of one analysis, and the way back."""

    def __init__(self, doc, solid, mesh_object, femmesh, material):
        self.doc, self.solid, self.material = doc, solid, material
        self.mesh_object, self.femmesh, self.topological, self.straight = mesh_object, femmesh, False, None
        self.fixed, self.force, self.pressure, self.notes = [], {}, {}, []
        self.mesh = from_femmesh(femmesh)
        self._fill_faces()
        self.elements = elements_of(self.mesh)

    def _fill_faces(self):
        """Where the mesh has no face groups, ask the CAD faces which quads lie on them."""
        if self.mesh.quads is not None:
            return
        elements = elements_of(self.mesh)
        self.mesh.quads = elements.quads[:, :4]
        self.mesh.face_of_quad = np.zeros(len(elements.quads), np.int64)
        for number, face in enumerate(freecad_compat.fem_shape_of(self.solid).Faces, 1):
            on_face = np.isin(self.mesh.node_ids, self.femmesh.getNodesByFace(face))
            inside = on_face[self.mesh.quads].all(axis=1)
            self.mesh.face_of_quad[inside & (self.mesh.face_of_quad == 0)] = number

    @contextmanager
    def restoring(self):
        """Put a given mesh object back as it was if anything fails inside."""
        given = self.mesh_object
        groups = set(given.FemMesh.Groups) if given is not None else set()
        with staying_in_its_group(given):
            try:
                yield
            except BaseException:
                if given is not None:
                    _remove_groups(given, groups)
                raise

    def build(self, folder):
        """Make every object and write the deck; returns FreeCAD's ccx tools."""
        objects = freecad_compat.fem_module("ObjectsFem")
        doc = self.doc
        if self.mesh_object is None:
            self.mesh_object = insert(doc, self.femmesh, self.solid, "HexMesh",
                                      self.topological)
        analysis = objects.makeAnalysis(doc, "Analysis")
        solver = freecad_compat.make_ccx_solver(doc)
        card = objects.makeMaterialSolid(doc, "Material")
        card.Material = self.material.card()
        for member in [solver, card, *self._constraints(), self.mesh_object]:
            analysis.addObject(member)
        doc.recompute()
        tools = freecad_compat.fem_module("femtools.ccxtools").FemToolsCcx(analysis, solver)
        tools.update_objects()
        tools.setup_working_dir(folder)
        complaint = tools.check_prerequisites()
        if complaint:
            raise ToolError(f"FreeCAD's FEM refuses the analysis: {complaint.strip()}",
                            FaultCode.TOOL_FAILED)
        tools.write_inp_file()
        self._check_deck(tools.inp_file_name)
        return tools

    def _constraints(self):
        fixed = make.make_fixed(self.doc, self.solid, self.fixed)
        made, to_find = [fixed], [(fixed, self.fixed)]
        for name, value in self.pressure.items():
            made.append(make.make_pressure(self.doc, self.solid, name, value))
            to_find.append((made[-1], [name]))
        for name, vector in self.force.items():
            constraint, _ = make.make_force(self.doc, self.solid, name, vector)
            made.append(constraint)
        self.notes += make.ensure_nodes(self.mesh_object, self.mesh, self.elements,
                                        self.solid, to_find)
        return made

    def _check_deck(self, path):
        if not path or not os.path.exists(path):
            raise ToolError("FreeCAD wrote no CalculiX deck; its report view says why",
                            FaultCode.TOOL_FAILED)
        notes, self.force_sum = correct_loads(
            path, self.elements, self.force, self.pressure,
            self.mesh.node_ids, self.mesh.hex_ids)
        self.notes += notes
        name_element_type(path, self.element)


def _remove_groups(mesh_object, kept):
    """Take every mesh group but the kept ids out of the object's FemMesh."""
    added = set(mesh_object.FemMesh.Groups) - kept
    if added:
        femmesh = mesh_object.FemMesh.copy()
        for group in added:
            femmesh.removeGroup(group)
        mesh_object.FemMesh = femmesh


def _load(setup, tools):
    """Results into the document through FreeCAD; returns the result object."""
    tools.load_results()
    return result_object_of(tools.analysis)


def _result(setup, tools, result_object, added, found, log):
    """Arrays of ccx's results in the mesh's node order."""
    displacements, stress = in_order_of(setup.mesh.node_ids, found)
    inp = tools.inp_file_name
    return Result(result_object, added, displacements, stress, frd.von_mises(stress), inp,
                  os.path.splitext(inp)[0] + ".frd", log,
                  {"notes": setup.notes, "force_sum": setup.force_sum.tolist(),
                   **({"straight edges": setup.straight} if setup.straight else {})})
