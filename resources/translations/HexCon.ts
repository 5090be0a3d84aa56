<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1">
<context>
    <name>HexCon</name>
    <message>
        <source>HexCon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexahedral meshes that keep a given quad surface, certified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certify hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the hexes at fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scaled Jacobian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HexCon cannot work yet: its native core is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python says: {words}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>displacement, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn × {factor}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{method} (topology only)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the surface is filled with hexes; the list says what each method is for. Topology only: to look at; no solver must be given such a mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Topology only: not for solving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a FEM mesh object although some of its Jacobians are zero or negative; the object is marked as topological</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sheet of hexes under the whole surface; automatic lays one where it makes a poor worst hex clearly better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least so many layers of plain hexes under the surface; automatic then tries only methods that lay them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After this time the best mesh found until then is taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pillow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this method gives topology only: some Jacobians are zero or negative, so CalculiX must not be given its mesh. Choose method cells, or tick "{tick}" to get it anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HexCon help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name}, {quads} quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {count} hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the quads changed while they were filled; press Mesh again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many hexahedra have which scaled Jacobian: 1 is a cube's, 0 or less no solver should be given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highest bar: {count} hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspect hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plane's normal; each hexahedron stays or goes as a whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers of hexahedra to take away, from the boundary inwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws each hexahedron smaller, so that they stand apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the method put in, from outside to inside; what has no tick is taken away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away what hides the chosen hexahedron</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold, load and solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This mesh has no solid whose faces could be clicked, and no named groups.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This mesh has no solid: choose its groups by name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click faces of the solid in the 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it together, shared evenly by what is loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along {axis}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no face is held: press Held and click one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no face is loaded: press Loaded and click one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mesh is gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Solved.&lt;/b&gt; Displacement at most {length:.4g} mm, von Mises stress at most {stress:.4g} MPa. The analysis in the tree has everything; the FEM workbench changes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show dual loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs of quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every quad with one neighbour as its partner: the paired partition that cells are built on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a loop to draw it thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes ({endings})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hex mesh from solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least about {natural} hexes in sweeps and blocks, several times as many where holes and thin walls are smaller than the size; about {count} otherwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solid changed while it was meshed; press Mesh again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold, load and solve ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. The document is unchanged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked in red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Python with gmsh (empty: sought)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CalculiX, ccx (empty: sought)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Defaults of the panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check what is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Get gmsh for FreeCAD's Python</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one per processor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels begin with what was used last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HexCon's menu in the FEM workbench too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wanted length of the edges of the hexahedra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the surface is meshed with quads; the list says what each method is for. Automatic takes the first that can be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quad surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the quads were made from is gone; they stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these hexes are cut out of tetrahedra (method diced): valid, but crooked, and many for what they tell; automatic takes them where no method of natural hexes will do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these hexes are laid round every quad (method cells): valid, but small and very many; automatic takes them where nothing else will do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another size: {size} mm lets small features be taken up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another size: half of it lets small features be taken up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the part without, or split at, the features that the notes name (F1 tells how)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order 2 (C3D20R): the same hexes bend, and most of the error goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} edges curved along edges of the solid, {faces} on its faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} edges inside bend along, so that no hex folds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} corners inside moved, so that no hex folds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} edges of the boundary found no place on the solid: they are straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} hexes would fold or cross, and keep part of their curvature: {hexes}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volume {volume:+.2g} of the solid's, area {area:+.2g}; curved faces at most {chord:.3g} off it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{edges} edges curved as the surface's 8-node quads are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {count} hexes would fold, and keep part of their curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hex {number} to {part:.2f}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an odd number: no hex mesh has such a boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an even number, but a closed path of edges that bounds a surface inside is odd: no hex mesh has such a boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an even number, but the surface is not known to bound a solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an even number; whether hexes can fill it is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an even number: hexes can fill it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first order (C3D8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second order (C3D20R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quads}, {even}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dual loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{loops}, of which {crossing} cross themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crossing itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it bounds no solid, so nothing fills it: {found}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holes through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quads} quads, method {method}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tried</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gmsh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {number:.1f} hexes a quad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Topological</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>topology only: the hexes meet face to face and end in exactly the quads, but some of their Jacobians are zero or negative. Not for solving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quads} quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mesh keeps no face groups that cover its boundary, so the boundary could not be compared with a surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} hexes have curved edges, and were judged with them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not positive: {ids}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overlapping: {ids}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{kept} of {all} hexes, {faces} faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} from the boundary to the core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} hexes have curved edges; colours and figures are theirs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{stage}: {count}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{quads} quads, {even}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count}; crossing themselves: {crossing}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quads {ids}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pairs of quads {ids}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the closed path, of {count} edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and {count} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shortest {least:.4g}, longest {most:.4g}; the time step of explicit solvers follows the shortest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>most {most:.2f}, mean {mean:.2f}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min {min:.3f}, 5 % {q05:.3f}, mean {mean:.3f}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every Jacobian is proved positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mesh is proper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing overlaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its boundary exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certified: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} hexes are not proved positive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not conforming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} hexes meet others improperly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its boundary is not the given one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it overlaps itself: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whether it overlaps itself could not be told: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT certified: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tries the methods for solvers, those of fewest hexes first, until one is certified and good, and takes the best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes hexes that come with the surface: places, improves and proves them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as proposed[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweeps: as many hexes as a cap's quads times rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swept, {cap quads} cap quads × {rings} rings[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boxes, polyhedra and mixtures that are no sweep: layers of hexes cut all handles and take one dual loop after the other away, down to a cube or a core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sheets} sheets[, {cuts} of them cuts][, a core of {core quads} quads][, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>subdivided triangles or quads around any body: tetrahedra inside, each cut into four hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diced, {coarse triangles} coarse triangles, {coarse quads} coarse quads, {tetrahedra} tetrahedra inside[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to 16 quads around a ball: the smallest filling known, from a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irregular surfaces of balls, up to some 400 quads: edges rotate in shells under the surface, then as sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shelling, {rotations} rotated edges in {shells} shells[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any body, also with boundary layers: a cell of hexes on each pair of quads, and tetrahedra inside, each cut into four hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cells, {layers} layers, {tetrahedra} tetrahedra inside[, {pillows} pillow]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>four-split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers of hexes under any surface, down to quads that are all split in four</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carbonera and Shepherd's pyramids, in balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyramid, alternative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyramids under Mitchell's split layers, in balls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyramid-alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carbonera and Shepherd's Geodes; with tetrahedra inside round holes too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geode, alternative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geodes under Mitchell's split layers; with tetrahedra inside round holes too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geode-alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pillowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geode-alt without doublets: two hexes share one face at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first of the others that can be, in the order of what hexes they lead to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solids that go from one cap to another: prisms, pipes, frusta, wedges, bent bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round solids, and those with three edges at each corner: quads of a few blocks of hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned parts: bodies of revolution by a full turn, with any profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solids whose faces lie across one direction or along it, or are seen from it: plates with bosses, pockets, steps, holes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers and boxes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solids of layers but for round holes and bosses across them, each in a box with layers of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any solid whose features are not much smaller than the elements: a grid of hexes that takes them up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers and filler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solids of layers and boxes but for rooms, where pipes or bores meet or lie askew, which the constrained methods fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>subdivided quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any solid: gmsh's quads and triangles, each cut about its middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>subdivided triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any solid: gmsh's triangles, each cut into three quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blossom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any solid, by luck: gmsh's triangles, paired to quads; few and even ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>transfinite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solids whose faces all have four sides: grids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: starting gmsh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: reading the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: quads of the cap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: quads of the walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: quads of the blocks' faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: quads by gmsh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned part: quads of half a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned part: turning the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers: the solid's outlines and levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid: the solid's faces, edges and corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid: which cells are inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid: taking up edges and corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid: putting layers in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved edges: places on the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved edges: bending what would fold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved edges: volume, area and distance from the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving all points, which slide on the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing: where the mesh lies on the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: distance from the solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: evening out the tetrahedra inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CalculiX solves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: checking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: which closed paths bound inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: pairing quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: looking for sweeps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: placing points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: cutting handles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: taking dual loops away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: looking for edges to rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: laying split layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: closing the inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: cutting tetrahedra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: tetrahedra inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: untangling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: improving the worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hexes: moving to another boundary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate: neighbourhoods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate: pairs of hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate: Jacobians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does the surface cross itself?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boundary layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>star inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tetrahedra inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>core</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geodes on coarse quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyramids on coarse quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shells of rotated edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sheets inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired transition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>split layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>further split layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pillows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside of the pillows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers round the boxes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{inverted} of {hexes} hexes inverted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{hexes} hexes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{hexes} hexes, worst scaled Jacobian {worst}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Check</name>
    <message>
        <source>Certify hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prove that every hexahedron of the selected FEM mesh is valid, or show those that are not</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Examples</name>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bracket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Schneiders' pyramid, 16 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quadrilateral octahedron, 8 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eppstein's cube, 16 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eppstein's cube, 18 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eppstein's cube, 20 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eppstein's cube, 22 quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a part or a surface of the literature in a document of its own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Export</name>
    <message>
        <source>Export hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the selected hex mesh, with its face groups, into a file for a solver or another program: CalculiX, Nek5000, SPECFEM3D, Exodus, gmsh, VTK ...</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_HexMesh</name>
    <message>
        <source>Hex mesh from quads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the selected quad surface with certified hexahedra whose boundary is exactly its quads</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Import</name>
    <message>
        <source>Import quad surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the quads of a mesh file, of gmsh, Abaqus, Nastran, Medit, VTK and other programs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Inspect</name>
    <message>
        <source>Inspect hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look into the selected FEM mesh: cut it, peel layers off, see the scaled Jacobians and the worst hexahedra</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_IntoAnalysis</name>
    <message>
        <source>Into analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the selected hex mesh into the active analysis of the FEM workbench, or make one with a CalculiX solver, steel, and constraints to fill in</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Loops</name>
    <message>
        <source>Show dual loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the dual loops of the selected quad surface, or of the boundary of the selected hex mesh, and where they cross themselves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_MeshSolid</name>
    <message>
        <source>Hex mesh from solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill the selected solid with certified hexahedra for the FEM workbench: select one object with one solid, or a face of it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_QuadSurface</name>
    <message>
        <source>Quad surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh the surface of the selected solid with quads, or take the quads of the selected FEM mesh; see them before they are made</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Quality</name>
    <message>
        <source>Quality report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An object with the least, 5 % and mean scaled Jacobian of the selected FEM mesh, its worst elements and its certificate; it follows the mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Repair</name>
    <message>
        <source>Repair hex mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another mesh beside the selected one: hexes in reversed node order turned, unused points dropped, inverted hexes untangled; its boundary and groups stay</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HexCon_Solve</name>
    <message>
        <source>Hold, load and solve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a face that is held and one that is loaded; CalculiX solves, and the displacements are shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>HexCon</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
