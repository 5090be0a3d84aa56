# SPDX-License-Identifier: LGPL-2.1-or-later
"""gmsh's mesh of a solid's faces as arrays: without edges that are left out, its elements cut about their middles."""
import gmsh
import numpy as np

from .fault import WorkerFault


class CoarseMesh:
    """Points and elements of the current gmsh model.

    points   (V,3) float64
    home     (V,2) int: dimension and tag of the CAD entity that each point lies on
    corners  {3: (t,3), 4: (n,4)} rows of points of triangles and of quads
    faces    {3: (t,), 4: (n,)} the CAD face of each
    Raises WorkerFault TOOL_FAILED where a face has no elements.
    """

    def __init__(self, solid):
        self._solid = solid
        tags, xyz, _ = gmsh.model.mesh.getNodes()
        self.points = np.array(xyz).reshape(-1, 3)
        self._row = np.full(int(tags.max(initial=0)) + 1, -1)
        self._row[np.asarray(tags, int)] = np.arange(len(tags))
        self.home = np.zeros((len(tags), 2), int)
        for dim, tag in gmsh.model.getEntities():
            self.home[self._nodes(dim, tag)[0]] = dim, tag
        self.corners, self.faces = {}, {}
        for count, kind in ((3, 2), (4, 3)):
            rows = [self._row[np.asarray(gmsh.model.mesh.getElementsByType(kind, f)[1], int)].reshape(-1, count)
                    for f in solid.faces]
            self.corners[count] = np.concatenate(rows)
            self.faces[count] = np.repeat(solid.faces, [len(r) for r in rows])
        bare = set(solid.faces).difference(*self.faces.values())
        if bare:        # a small ball, without a word
            raise WorkerFault("TOOL_FAILED", f"gmsh left Face{min(bare)} without elements", sorted(bare))
        self._leave_out()

    def _nodes(self, dim, tag):
        """(rows of points inside a CAD entity, their parameters)."""
        tags, _, parameters = gmsh.model.mesh.getNodes(dim, tag)
        return self._row[np.asarray(tags, int)], parameters

    def _leave_out(self):
        """The points on edges that are left out become one, and elements between them go."""
        stands_for = np.arange(len(self.points))
        for edge, vertex in self._solid.left_out.items():
            ends = [t for _, t in gmsh.model.getBoundary([(1, edge)], oriented=False)]
            for entity in ((1, edge), *((0, v) for v in ends)):
                stands_for[self._nodes(*entity)[0]] = self._nodes(0, vertex)[0]
        for count, rows in self.corners.items():
            rows = stands_for[rows]
            whole = (np.diff(np.sort(rows, axis=1), axis=1) > 0).all(axis=1)
            self.corners[count], self.faces[count] = rows[whole], self.faces[count][whole]

    def cut(self):
        """Cut every element about its middle into quads: three of a triangle, four of a quad. Linear (expected)."""
        edges, edge_home, sides = self._edges()
        middles = self.points[edges].mean(axis=1)
        for edge in self._solid.edges:
            where, points = self._halves(edge, edges)
            middles[where], edge_home[where] = points, (1, edge)
        made = [(self.points, self.home), (middles, edge_home)]
        first, middle_of_edge = len(self.points) + len(edges), len(self.points)
        quads, faces = [], []
        for count, rows in self.corners.items():
            side = middle_of_edge + sides[count]
            centre = np.repeat(first + np.arange(len(rows)), count).reshape(-1, count)
            quads.append(np.stack([rows, side, centre, np.roll(side, 1, axis=1)], axis=-1).reshape(-1, 4))
            faces.append(np.repeat(self.faces[count], count))
            made.append((middles[sides[count]].mean(axis=1), _on_faces(self.faces[count])))
            first += len(rows)
        self.points, self.home = (np.concatenate(part) for part in zip(*made))
        self.corners = {3: np.zeros((0, 3), int), 4: np.concatenate(quads)}
        self.faces = {3: np.zeros(0, int), 4: np.concatenate(faces)}

    def _edges(self):
        """(edges (m,2), home of each as inside a face (m,2), {3: (t,3), 4: (n,4)} the edge after each corner)."""
        pairs = [np.sort(np.stack([rows, np.roll(rows, -1, axis=1)], -1).reshape(-1, 2), axis=1)
                 for rows in self.corners.values()]
        edges, first, inverse = np.unique(np.concatenate(pairs), axis=0, return_index=True, return_inverse=True)
        faces = np.concatenate([np.repeat(self.faces[count], count) for count in self.corners])
        ends = np.cumsum([len(p) for p in pairs])[:-1]
        sides = {count: part.reshape(-1, count) for count, part in zip(self.corners, np.split(inverse.ravel(), ends))}
        return edges, _on_faces(faces[first]), sides

    def _halves(self, edge, edges):
        """(rows of edges that lie along a CAD edge, the points (k,3) half way along its arc)."""
        inside, parameters = self._nodes(1, edge)
        order = np.argsort(parameters)
        ends = [self._nodes(0, v)[0] for v in self._solid.ends[edge]]
        chain = np.concatenate([ends[0], inside[order], ends[1]])
        at = np.concatenate([[0.0], self._solid.fractions(edge, np.asarray(parameters)[order]), [1.0]])
        steps = np.sort(np.stack([chain[:-1], chain[1:]], axis=-1), axis=1)
        keys, wanted = edges @ [len(self.points), 1], steps @ np.array([len(self.points), 1])
        where = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        found = keys[where] == wanted
        return where[found], self._solid.edge_points(edge, (at[1:] + at[:-1])[found] / 2)

    def on_cad(self):
        """Move every point on to the CAD entity that it lies on."""
        order = np.lexsort(self.home.T[::-1])
        homes, first = np.unique(self.home[order], axis=0, return_index=True)
        for (dim, tag), rows in zip(homes.tolist(), np.split(order, first[1:])):
            if dim == 2 or (dim == 1 and tag in self._solid.ends):
                self.points[rows] = self._solid.project(dim, tag, self.points[rows])


def _on_faces(tags):
    return np.stack([np.full(len(tags), 2), tags], axis=-1)
