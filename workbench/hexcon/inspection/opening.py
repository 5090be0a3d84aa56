# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hex mesh to look into, and what is left to see of it when it is opened."""
from dataclasses import dataclass

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.hexahedron import FACES, FACES_8
from hexcon.femmesh.second_order import curved_edges

from .cutting import AXES, behind_plane, centres_of
from .faces import bare_faces, neighbours
from .peeling import layers
from .stages import ALL, stage_of_hex


class InspectedMesh:
    """What has to be known of a hex mesh before it can be opened any way.

    points (P,3), hexes (H,8) their corners, nodes (H,8|20) what is drawn, hex_ids (H,) the elements' own numbers,
    quality hexcon_native.Quality, curved: so many hexes of order 2 have edges that are not straight,
    centres (H,3), across (H,6) of faces.neighbours, layer (H,) of peeling.layers,
    stages [(name, hexes)] from outside to inside, stage (H,) rows in them
    """

    def __init__(self, found, stages=()):
        """found   mesh-like: .points, .hexes (H,8|20) in VTK order, .hex_ids (else: rows)
        stages  [(name, hexes)] of stages.counts_of; where they are of another mesh, or none, all hexes are one"""
        self.points = np.ascontiguousarray(found.points, float)
        self.nodes = np.ascontiguousarray(found.hexes, np.int64)
        self.hexes = np.ascontiguousarray(self.nodes[:, :8])
        self.hex_ids = np.asarray(getattr(found, "hex_ids", np.arange(len(self.hexes))))
        self.quality = hexcon_native.quality(self.points, found.hexes)
        self.curved = int(curved_edges(self.points, np.asarray(found.hexes)).any(axis=1).sum())
        self.centres = centres_of(self.points, self.hexes)
        self.across = neighbours(self.hexes, len(self.points))
        self.layer = layers(self.hexes, self.across, len(self.points))
        self.stages, self.stage = list(stages), stage_of_hex(stages, self.hex_ids)
        if self.stage is None:
            self.stages, self.stage = [(ALL, len(self.hexes))], np.zeros(len(self.hexes), np.int64)

    @property
    def scaled_jacobian(self):
        """(H,)"""
        return self.quality.scaled_jacobian

    @property
    def thickness(self):
        """The number of layers."""
        return int(self.layer.max(initial=0))

    def is_of_stage(self, name):
        """(H,) bool. Raises ToolError BAD_OPTION if there is no such stage."""
        names = [name for name, _ in self.stages]
        if name not in names:
            raise ToolError(f"the mesh has no stage {name!r}; it has {', '.join(names)}", FaultCode.BAD_OPTION)
        return self.stage == names.index(name)

    def reach(self, axis):
        """(lowest, highest) offset of a centre along the axis, mm: cuts between them divide the mesh."""
        along = self.centres @ normal_of(axis)
        return float(along.min()), float(along.max())

    def row_of(self, element):
        """The row of an element's number. Raises ToolError BAD_OPTION if there is none."""
        rows = np.flatnonzero(self.hex_ids == element)
        if not len(rows):
            raise ToolError(f"the mesh has no hex number {element}", FaultCode.BAD_OPTION)
        return int(rows[0])


def normal_of(axis):
    """(3,) unit vector of "x", "y", "z" or of a vector. Raises ToolError BAD_OPTION."""
    try:
        normal = np.array(AXES.get(axis) if isinstance(axis, str) else axis, float)
        length = np.linalg.norm(normal)
        if normal.shape == (3,) and 0 < length < np.inf:
            return normal / length
    except (TypeError, ValueError):
        pass
    raise ToolError(f"axis {axis!r}: \"x\", \"y\", \"z\" or a vector is possible", FaultCode.BAD_OPTION)


@dataclass(frozen=True)
class Opening:
    """How a mesh is opened.

    axis    None: no cut; "x", "y", "z" or a vector: normal of the cutting plane
    offset  mm from the origin to the plane along the axis; None: the middle of the mesh. Hexes
            whose centres lie further up the axis are taken away
    flip    those further down are
    peel    layers of hexes to take away, from the boundary inwards
    hidden  names of stages to take away, as boundary layers or cells
    shrink  0 to 0.9: each hex drawn smaller by this part, towards its centre, so that they stand apart
    """

    axis: object = None
    offset: object = None
    flip: bool = False
    peel: int = 0
    shrink: float = 0.0
    hidden: tuple = ()

    def __post_init__(self):
        if self.axis is not None:
            normal_of(self.axis)
        if self.offset is not None and not np.isfinite(self.offset):
            raise ToolError(f"offset {self.offset!r}: a finite number of mm is needed", FaultCode.BAD_OPTION)
        if not self.peel >= 0:
            raise ToolError(f"peel {self.peel!r}: 0 layers or more are possible", FaultCode.BAD_OPTION)
        if not 0.0 <= self.shrink <= 0.9:
            raise ToolError(f"shrink {self.shrink!r}: 0 to 0.9 is possible", FaultCode.BAD_OPTION)

    def keep(self, mesh):
        """(H,) bool: the hexes of the InspectedMesh that stay, each whole."""
        kept = mesh.layer > self.peel if self.peel else np.ones(len(mesh.hexes), bool)
        for name in self.hidden:
            kept &= ~mesh.is_of_stage(name)
        if self.axis is not None:
            normal = normal_of(self.axis)
            offset = sum(mesh.reach(self.axis)) / 2 if self.offset is None else self.offset
            kept &= behind_plane(mesh.centres, offset * normal, -normal if self.flip else normal)
        return kept

    def drawn(self, mesh, keep):
        """(points (p,3), faces (q,4|8), hex_of_face (q,)): the faces to draw of the kept hexes, see tessellation.

        The bare ones; of hexes that stand apart every face of those with a bare face and of their
        neighbours, as behind them no gap leads far.
        """
        rows, sides = bare_faces(mesh.across, keep)
        count = mesh.nodes.shape[1]
        nodes = FACES if count == 8 else FACES_8
        if not self.shrink:
            return mesh.points, mesh.nodes[rows[:, None], nodes[sides]], rows
        near = mesh.across[np.unique(rows)]
        seen = np.zeros(len(mesh.hexes), bool)
        seen[rows] = True
        seen[near[near >= 0]] = True
        seen = np.flatnonzero(seen & keep)
        places = mesh.points[mesh.nodes[seen]]
        places += self.shrink * (mesh.centres[seen, None] - places)
        faces = (count * np.arange(len(seen))[:, None, None] + nodes).reshape(-1, nodes.shape[1])
        return places.reshape(-1, 3), faces, np.repeat(seen, 6)
