<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="de">
<context>
    <name>HexCon</name>
    <message>
        <source>HexCon</source>
        <translation>HexCon</translation>
    </message>
    <message>
        <source>Hexahedral meshes that keep a given quad surface, certified</source>
        <translation>Hexaedernetze, die eine gegebene Vierecksoberfläche behalten, zertifiziert</translation>
    </message>
    <message>
        <source>Not checked</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Certify hex mesh</source>
        <translation>Hexaedernetz zertifizieren</translation>
    </message>
    <message>
        <source>Mark the hexes at fault</source>
        <translation>Fehlerhafte Hexaeder markieren</translation>
    </message>
    <message>
        <source>scaled Jacobian</source>
        <translation>skalierte Jacobi-Determinante</translation>
    </message>
    <message>
        <source>HexCon cannot work yet: its native core is missing.</source>
        <translation>HexCon kann noch nicht arbeiten: Sein nativer Kern fehlt.</translation>
    </message>
    <message>
        <source>Run the command</source>
        <translation>Den Befehl</translation>
    </message>
    <message>
        <source>in the folder</source>
        <translation>in diesem Ordner ausführen</translation>
    </message>
    <message>
        <source>and try again.</source>
        <translation>und es erneut versuchen.</translation>
    </message>
    <message>
        <source>Python says: {words}</source>
        <translation>Python meldet: {words}</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>displacement, mm</source>
        <translation>Verschiebung, mm</translation>
    </message>
    <message>
        <source>drawn × {factor}</source>
        <translation>gezeichnet × {factor}</translation>
    </message>
    <message>
        <source>{method} (topology only)</source>
        <translation>{method} (nur Topologie)</translation>
    </message>
    <message>
        <source>How the surface is filled with hexes; the list says what each method is for. Topology only: to look at; no solver must be given such a mesh</source>
        <translation>Wie die Oberfläche mit Hexaedern gefüllt wird; die Liste sagt, wofür jedes Verfahren gut ist. Nur Topologie: zum Ansehen; kein Löser darf ein solches Netz bekommen</translation>
    </message>
    <message>
        <source>Topology only: not for solving</source>
        <translation>Nur Topologie: nicht zum Rechnen</translation>
    </message>
    <message>
        <source>Make a FEM mesh object although some of its Jacobians are zero or negative; the object is marked as topological</source>
        <translation>Ein FEM-Netzobjekt erzeugen, obwohl einige Jacobi-Determinanten null oder negativ sind; das Objekt wird als topologisch gekennzeichnet</translation>
    </message>
    <message>
        <source>A sheet of hexes under the whole surface; automatic lays one where it makes a poor worst hex clearly better</source>
        <translation>Eine Hexaederschicht unter der ganzen Oberfläche; automatisch legt eine, wo sie ein schlechtes schlechtestes Hexaeder deutlich verbessert</translation>
    </message>
    <message>
        <source>At least so many layers of plain hexes under the surface; automatic then tries only methods that lay them</source>
        <translation>Mindestens so viele Lagen einfacher Hexaeder unter der Oberfläche; automatisch versucht dann nur Verfahren, die solche legen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>ohne Grenze</translation>
    </message>
    <message>
        <source>After this time the best mesh found until then is taken</source>
        <translation>Nach dieser Zeit wird das beste bis dahin gefundene Netz genommen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Pillow</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>this method gives topology only: some Jacobians are zero or negative, so CalculiX must not be given its mesh. Choose method cells, or tick "{tick}" to get it anyway</source>
        <translation>dieses Verfahren liefert nur Topologie: Einige Jacobi-Determinanten sind null oder negativ, deshalb darf CalculiX das Netz nicht bekommen. Verfahren Zellen wählen, oder „{tick}“ ankreuzen, um es trotzdem zu bekommen</translation>
    </message>
    <message>
        <source>HexCon help</source>
        <translation>Hilfe zu HexCon</translation>
    </message>
    <message>
        <source>No mesh</source>
        <translation>Kein Netz</translation>
    </message>
    <message>
        <source>Hex mesh</source>
        <translation>Hexaedernetz</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>{name}, {quads} quads</source>
        <translation>{name}, {quads} Vierecke</translation>
    </message>
    <message>
        <source>Mesh anew</source>
        <translation>Neu vernetzen</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>about {count} hexes</source>
        <translation>etwa {count} Hexaeder</translation>
    </message>
    <message>
        <source>the quads changed while they were filled; press Mesh again</source>
        <translation>die Vierecke haben sich geändert, während sie gefüllt wurden; noch einmal auf Vernetzen drücken</translation>
    </message>
    <message>
        <source>How many hexahedra have which scaled Jacobian: 1 is a cube's, 0 or less no solver should be given</source>
        <translation>Wie viele Hexaeder welche skalierte Jacobi-Determinante haben: 1 hat ein Würfel; mit 0 oder weniger sollte kein Löser rechnen</translation>
    </message>
    <message>
        <source>highest bar: {count} hexes</source>
        <translation>höchster Balken: {count} Hexaeder</translation>
    </message>
    <message>
        <source>Not shown</source>
        <translation>Nicht gezeigt</translation>
    </message>
    <message>
        <source>Inspect hex mesh</source>
        <translation>Hexaedernetz untersuchen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>The plane's normal; each hexahedron stays or goes as a whole</source>
        <translation>Die Normale der Ebene; jedes Hexaeder bleibt oder geht als Ganzes</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Layers of hexahedra to take away, from the boundary inwards</source>
        <translation>Lagen von Hexaedern, die vom Rand nach innen weggenommen werden</translation>
    </message>
    <message>
        <source>Draws each hexahedron smaller, so that they stand apart</source>
        <translation>Zeichnet jedes Hexaeder kleiner, so dass sie auseinanderstehen</translation>
    </message>
    <message>
        <source>Peel</source>
        <translation>Schälen</translation>
    </message>
    <message>
        <source>Explode</source>
        <translation>Auseinander</translation>
    </message>
    <message>
        <source>What the method put in, from outside to inside; what has no tick is taken away</source>
        <translation>Was das Verfahren eingesetzt hat, von außen nach innen; was kein Häkchen hat, wird weggenommen</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Hier schneiden</translation>
    </message>
    <message>
        <source>Cut away what hides the chosen hexahedron</source>
        <translation>Wegschneiden, was das gewählte Hexaeder verdeckt</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Schlechteste</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Skalierte Jacobi-Determinante</translation>
    </message>
    <message>
        <source>Not solved</source>
        <translation>Nicht gelöst</translation>
    </message>
    <message>
        <source>Hold, load and solve</source>
        <translation>Halten, belasten und lösen</translation>
    </message>
    <message>
        <source>This mesh has no solid whose faces could be clicked, and no named groups.</source>
        <translation>Dieses Netz hat keinen Körper, dessen Flächen angeklickt werden könnten, und keine benannten Gruppen.</translation>
    </message>
    <message>
        <source>This mesh has no solid: choose its groups by name.</source>
        <translation>Dieses Netz hat keinen Körper: Gruppen nach ihrem Namen wählen.</translation>
    </message>
    <message>
        <source>Click faces of the solid in the 3D view</source>
        <translation>Flächen des Körpers in der 3D-Ansicht anklicken</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Gehalten</translation>
    </message>
    <message>
        <source>Loaded</source>
        <translation>Belastet</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>choose a group</source>
        <translation>Gruppe wählen</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>All of it together, shared evenly by what is loaded</source>
        <translation>Alles zusammen, gleichmäßig auf das Belastete verteilt</translation>
    </message>
    <message>
        <source>along {axis}</source>
        <translation>entlang {axis}</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>no face is held: press Held and click one</source>
        <translation>keine Fläche wird gehalten: auf Gehalten drücken und eine anklicken</translation>
    </message>
    <message>
        <source>no face is loaded: press Loaded and click one</source>
        <translation>keine Fläche wird belastet: auf Belastet drücken und eine anklicken</translation>
    </message>
    <message>
        <source>the mesh is gone</source>
        <translation>das Netz ist nicht mehr da</translation>
    </message>
    <message>
        <source>&lt;b&gt;Solved.&lt;/b&gt; Displacement at most {length:.4g} mm, von Mises stress at most {stress:.4g} MPa. The analysis in the tree has everything; the FEM workbench changes it.</source>
        <translation>&lt;b&gt;Gelöst.&lt;/b&gt; Verschiebung höchstens {length:.4g} mm, Vergleichsspannung nach von Mises höchstens {stress:.4g} MPa. Die Analyse im Baum enthält alles; der Arbeitsbereich FEM ändert sie.</translation>
    </message>
    <message>
        <source>Show dual loops</source>
        <translation>Duale Schleifen zeigen</translation>
    </message>
    <message>
        <source>Pairs of quads</source>
        <translation>Viereckspaare</translation>
    </message>
    <message>
        <source>Every quad with one neighbour as its partner: the paired partition that cells are built on</source>
        <translation>Jedes Viereck mit einem Nachbarn als Partner: die Einteilung in Paare, auf der Zellen stehen</translation>
    </message>
    <message>
        <source>Quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>Kreuzt sich</translation>
    </message>
    <message>
        <source>Choose a loop to draw it thick</source>
        <translation>Eine Schleife wählen, um sie dick zu zeichnen</translation>
    </message>
    <message>
        <source>Meshes ({endings})</source>
        <translation>Netze ({endings})</translation>
    </message>
    <message>
        <source>Hex mesh from solid</source>
        <translation>Hexaedernetz aus Körper</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>at least about {natural} hexes in sweeps and blocks, several times as many where holes and thin walls are smaller than the size; about {count} otherwise</source>
        <translation>mindestens etwa {natural} Hexaeder in Sweeps und Blöcken, ein Mehrfaches davon, wo Löcher und dünne Wände kleiner als die Größe sind; sonst etwa {count}</translation>
    </message>
    <message>
        <source>the solid changed while it was meshed; press Mesh again</source>
        <translation>der Körper hat sich geändert, während er vernetzt wurde; noch einmal auf Vernetzen drücken</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Hold, load and solve ...</source>
        <translation>Halten, belasten und lösen ...</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird beendet</translation>
    </message>
    <message>
        <source>Cancelled. The document is unchanged.</source>
        <translation>Abgebrochen. Das Dokument ist unverändert.</translation>
    </message>
    <message>
        <source>Marked in red</source>
        <translation>Rot markiert</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Python with gmsh (empty: sought)</source>
        <translation>Python mit gmsh (leer: wird gesucht)</translation>
    </message>
    <message>
        <source>CalculiX, ccx (empty: sought)</source>
        <translation>CalculiX, ccx (leer: wird gesucht)</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Defaults of the panels</source>
        <translation>Voreinstellungen der Bedienfelder</translation>
    </message>
    <message>
        <source>Check what is there</source>
        <translation>Prüfen, was da ist</translation>
    </message>
    <message>
        <source>Get gmsh for FreeCAD's Python</source>
        <translation>gmsh für das Python von FreeCAD holen</translation>
    </message>
    <message>
        <source>one per processor</source>
        <translation>einer je Prozessor</translation>
    </message>
    <message>
        <source>Panels begin with what was used last</source>
        <translation>Bedienfelder beginnen mit dem zuletzt Benutzten</translation>
    </message>
    <message>
        <source>HexCon's menu in the FEM workbench too</source>
        <translation>Menü von HexCon auch im Arbeitsbereich FEM</translation>
    </message>
    <message>
        <source>Wanted length of the edges of the hexahedra</source>
        <translation>Gewünschte Kantenlänge der Hexaeder</translation>
    </message>
    <message>
        <source>How the surface is meshed with quads; the list says what each method is for. Automatic takes the first that can be</source>
        <translation>Wie die Oberfläche mit Vierecken vernetzt wird; die Liste sagt, wofür jedes Verfahren gut ist. Automatisch nimmt das erste, das möglich ist</translation>
    </message>
    <message>
        <source>No quads</source>
        <translation>Keine Vierecke</translation>
    </message>
    <message>
        <source>Quad surface</source>
        <translation>Vierecksoberfläche</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Update quads</source>
        <translation>Vierecke erneuern</translation>
    </message>
    <message>
        <source>Make quads</source>
        <translation>Vierecke erzeugen</translation>
    </message>
    <message>
        <source>What the quads were made from is gone; they stay as they are.</source>
        <translation>Woraus die Vierecke gemacht wurden, ist nicht mehr da; sie bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>these hexes are cut out of tetrahedra (method diced): valid, but crooked, and many for what they tell; automatic takes them where no method of natural hexes will do</source>
        <translation>diese Hexaeder sind aus Tetraedern geschnitten (Verfahren gewürfelt): gültig, aber schief, und viele für ihre Aussage; automatisch nimmt sie, wo kein Verfahren für natürliche Hexaeder geht</translation>
    </message>
    <message>
        <source>these hexes are laid round every quad (method cells): valid, but small and very many; automatic takes them where nothing else will do</source>
        <translation>diese Hexaeder liegen um jedes Viereck (Verfahren Zellen): gültig, aber klein und sehr viele; automatisch nimmt sie, wo sonst nichts geht</translation>
    </message>
    <message>
        <source>another size: {size} mm lets small features be taken up</source>
        <translation>eine andere Größe: mit {size} mm können kleine Formelemente aufgenommen werden</translation>
    </message>
    <message>
        <source>another size: half of it lets small features be taken up</source>
        <translation>eine andere Größe: mit der halben können kleine Formelemente aufgenommen werden</translation>
    </message>
    <message>
        <source>the part without, or split at, the features that the notes name (F1 tells how)</source>
        <translation>das Teil ohne die Formelemente, welche die Hinweise nennen, oder dort geteilt (F1 sagt wie)</translation>
    </message>
    <message>
        <source>order 2 (C3D20R): the same hexes bend, and most of the error goes</source>
        <translation>Ordnung 2 (C3D20R): dieselben Hexaeder biegen sich, und der größte Teil des Fehlers geht weg</translation>
    </message>
    <message>
        <source>Before you solve</source>
        <translation>Vor dem Lösen</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Was helfen würde</translation>
    </message>
    <message>
        <source>{edges} edges curved along edges of the solid, {faces} on its faces</source>
        <translation>{edges} Kanten gekrümmt entlang Kanten des Körpers, {faces} auf seinen Flächen</translation>
    </message>
    <message>
        <source>{count} edges inside bend along, so that no hex folds</source>
        <translation>{count} Kanten im Inneren biegen sich mit, so dass sich kein Hexaeder faltet</translation>
    </message>
    <message>
        <source>{count} corners inside moved, so that no hex folds</source>
        <translation>{count} Ecken im Inneren haben sich bewegt, damit sich kein Hexaeder faltet</translation>
    </message>
    <message>
        <source>{count} edges of the boundary found no place on the solid: they are straight</source>
        <translation>{count} Kanten des Randes fanden keinen Platz auf dem Körper: Sie sind gerade</translation>
    </message>
    <message>
        <source>{count} hexes would fold or cross, and keep part of their curvature: {hexes}</source>
        <translation>{count} Hexaeder würden sich falten oder kreuzen und behalten einen Teil ihrer Krümmung: {hexes}</translation>
    </message>
    <message>
        <source>volume {volume:+.2g} of the solid's, area {area:+.2g}; curved faces at most {chord:.3g} off it</source>
        <translation>Volumen {volume:+.2g} gegenüber dem des Körpers, Fläche {area:+.2g}; gekrümmte Flächen höchstens {chord:.3g} von ihm entfernt</translation>
    </message>
    <message>
        <source>{edges} edges curved as the surface's 8-node quads are</source>
        <translation>{edges} Kanten gekrümmt wie die Vierecke mit 8 Knoten der Oberfläche</translation>
    </message>
    <message>
        <source>; {count} hexes would fold, and keep part of their curvature</source>
        <translation>; {count} Hexaeder würden sich falten und behalten einen Teil ihrer Krümmung</translation>
    </message>
    <message>
        <source>hex {number} to {part:.2f}</source>
        <translation>Hexaeder {number} zu {part:.2f}</translation>
    </message>
    <message>
        <source>an odd number: no hex mesh has such a boundary</source>
        <translation>eine ungerade Zahl: Kein Hexaedernetz hat einen solchen Rand</translation>
    </message>
    <message>
        <source>an even number, but a closed path of edges that bounds a surface inside is odd: no hex mesh has such a boundary</source>
        <translation>eine gerade Zahl, aber ein geschlossener Kantenweg, der im Inneren eine Fläche berandet, ist ungerade: Kein Hexaedernetz hat einen solchen Rand</translation>
    </message>
    <message>
        <source>an even number, but the surface is not known to bound a solid</source>
        <translation>eine gerade Zahl, aber es ist nicht bekannt, ob die Oberfläche einen Körper begrenzt</translation>
    </message>
    <message>
        <source>an even number; whether hexes can fill it is not known</source>
        <translation>eine gerade Zahl; ob Hexaeder sie füllen können, ist nicht bekannt</translation>
    </message>
    <message>
        <source>an even number: hexes can fill it</source>
        <translation>eine gerade Zahl: Hexaeder können sie füllen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>one sheet</source>
        <translation>eine Schicht</translation>
    </message>
    <message>
        <source>two sheets</source>
        <translation>zwei Schichten</translation>
    </message>
    <message>
        <source>three sheets</source>
        <translation>drei Schichten</translation>
    </message>
    <message>
        <source>first order (C3D8)</source>
        <translation>erste Ordnung (C3D8)</translation>
    </message>
    <message>
        <source>second order (C3D20R)</source>
        <translation>zweite Ordnung (C3D20R)</translation>
    </message>
    <message>
        <source>{quads}, {even}</source>
        <translation>{quads}, {even}</translation>
    </message>
    <message>
        <source>Dual loops</source>
        <translation>Duale Schleifen</translation>
    </message>
    <message>
        <source>{loops}, of which {crossing} cross themselves</source>
        <translation>{loops}, davon kreuzen sich {crossing} selbst</translation>
    </message>
    <message>
        <source>Crossing itself</source>
        <translation>Kreuzt sich selbst</translation>
    </message>
    <message>
        <source>it bounds no solid, so nothing fills it: {found}</source>
        <translation>sie begrenzt keinen Körper, deshalb füllt sie nichts: {found}</translation>
    </message>
    <message>
        <source>Holes through it</source>
        <translation>Durchgehende Löcher</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Hohlräume</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>{quads} quads, method {method}</source>
        <translation>{quads} Vierecke, Verfahren {method}</translation>
    </message>
    <message>
        <source>Curved edges</source>
        <translation>Gekrümmte Kanten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Passung</translation>
    </message>
    <message>
        <source>Tried</source>
        <translation>Versucht</translation>
    </message>
    <message>
        <source>gmsh</source>
        <translation>gmsh</translation>
    </message>
    <message>
        <source>; {number:.1f} hexes a quad</source>
        <translation>; {number:.1f} Hexaeder je Viereck</translation>
    </message>
    <message>
        <source>Topological</source>
        <translation>Topologisch</translation>
    </message>
    <message>
        <source>topology only: the hexes meet face to face and end in exactly the quads, but some of their Jacobians are zero or negative. Not for solving</source>
        <translation>nur Topologie: Die Hexaeder treffen sich Fläche an Fläche und enden in genau den Vierecken, aber einige ihrer Jacobi-Determinanten sind null oder negativ. Nicht zum Rechnen</translation>
    </message>
    <message>
        <source>Hexes</source>
        <translation>Hexaeder</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>{quads} quads</source>
        <translation>{quads} Vierecke</translation>
    </message>
    <message>
        <source>the mesh keeps no face groups that cover its boundary, so the boundary could not be compared with a surface</source>
        <translation>das Netz hat keine Flächengruppen, die seinen Rand bedecken; deshalb konnte der Rand mit keiner Oberfläche verglichen werden</translation>
    </message>
    <message>
        <source>{count} hexes have curved edges, and were judged with them</source>
        <translation>{count} Hexaeder haben gekrümmte Kanten und wurden mit ihnen beurteilt</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>not positive: {ids}</source>
        <translation>nicht positiv: {ids}</translation>
    </message>
    <message>
        <source>overlapping: {ids}</source>
        <translation>überlappend: {ids}</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>{kept} of {all} hexes, {faces} faces</source>
        <translation>{kept} von {all} Hexaedern, {faces} Flächen</translation>
    </message>
    <message>
        <source>{count} from the boundary to the core</source>
        <translation>{count} vom Rand bis zum Kern</translation>
    </message>
    <message>
        <source>{count} hexes have curved edges; colours and figures are theirs</source>
        <translation>{count} Hexaeder haben gekrümmte Kanten; Farben und Zahlen sind die ihren</translation>
    </message>
    <message>
        <source>{stage}: {count}</source>
        <translation>{stage}: {count}</translation>
    </message>
    <message>
        <source>{quads} quads, {even}</source>
        <translation>{quads} Vierecke, {even}</translation>
    </message>
    <message>
        <source>{count}; crossing themselves: {crossing}</source>
        <translation>{count}; davon sich selbst kreuzend: {crossing}</translation>
    </message>
    <message>
        <source>{count} times</source>
        <translation>{count}-mal</translation>
    </message>
    <message>
        <source>quads {ids}</source>
        <translation>Vierecke {ids}</translation>
    </message>
    <message>
        <source>pairs of quads {ids}</source>
        <translation>Viereckspaare {ids}</translation>
    </message>
    <message>
        <source>the closed path, of {count} edges</source>
        <translation>der geschlossene Weg aus {count} Kanten</translation>
    </message>
    <message>
        <source> and {count} more</source>
        <translation> und {count} weitere</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>shortest {least:.4g}, longest {most:.4g}; the time step of explicit solvers follows the shortest</source>
        <translation>kürzeste {least:.4g}, längste {most:.4g}; der Zeitschritt expliziter Löser richtet sich nach der kürzesten</translation>
    </message>
    <message>
        <source>most {most:.2f}, mean {mean:.2f}</source>
        <translation>größtes {most:.2f}, Mittel {mean:.2f}</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>min {min:.3f}, 5 % {q05:.3f}, mean {mean:.3f}</source>
        <translation>min. {min:.3f}, 5 % {q05:.3f}, Mittel {mean:.3f}</translation>
    </message>
    <message>
        <source>every Jacobian is proved positive</source>
        <translation>jede Jacobi-Determinante ist als positiv bewiesen</translation>
    </message>
    <message>
        <source>the mesh is proper</source>
        <translation>das Netz ist ordentlich</translation>
    </message>
    <message>
        <source>nothing overlaps</source>
        <translation>nichts überlappt</translation>
    </message>
    <message>
        <source>its boundary exact</source>
        <translation>sein Rand genau</translation>
    </message>
    <message>
        <source>certified: </source>
        <translation>zertifiziert: </translation>
    </message>
    <message>
        <source>{count} hexes are not proved positive</source>
        <translation>{count} Hexaeder sind nicht als positiv bewiesen</translation>
    </message>
    <message>
        <source>it is not conforming</source>
        <translation>es ist nicht konform</translation>
    </message>
    <message>
        <source>{count} hexes meet others improperly</source>
        <translation>{count} Hexaeder treffen andere nicht ordentlich</translation>
    </message>
    <message>
        <source>its boundary is not the given one</source>
        <translation>sein Rand ist nicht der gegebene</translation>
    </message>
    <message>
        <source>it overlaps itself: {reason}</source>
        <translation>es überlappt sich selbst: {reason}</translation>
    </message>
    <message>
        <source>whether it overlaps itself could not be told: {reason}</source>
        <translation>ob es sich selbst überlappt, war nicht zu sagen: {reason}</translation>
    </message>
    <message>
        <source>NOT certified: </source>
        <translation>NICHT zertifiziert: </translation>
    </message>
    <message>
        <source>tries the methods for solvers, those of fewest hexes first, until one is certified and good, and takes the best</source>
        <translation>versucht die Verfahren für Löser, die mit den wenigsten Hexaedern zuerst, bis eines zertifiziert und gut ist, und nimmt das beste</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>wie vorgeschlagen</translation>
    </message>
    <message>
        <source>takes hexes that come with the surface: places, improves and proves them</source>
        <translation>nimmt Hexaeder, die mit der Oberfläche kommen: platziert, verbessert und beweist sie</translation>
    </message>
    <message>
        <source>as proposed[, {pillows} pillow]</source>
        <translation>wie vorgeschlagen[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>swept</source>
        <translation>gezogen</translation>
    </message>
    <message>
        <source>sweeps: as many hexes as a cap's quads times rings</source>
        <translation>Sweeps: so viele Hexaeder wie Vierecke einer Deckfläche mal Ringe</translation>
    </message>
    <message>
        <source>swept, {cap quads} cap quads × {rings} rings[, {pillows} pillow]</source>
        <translation>gezogen, {cap quads} Vierecke der Deckfläche × {rings} Ringe[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>sheets</source>
        <translation>Blätter</translation>
    </message>
    <message>
        <source>boxes, polyhedra and mixtures that are no sweep: layers of hexes cut all handles and take one dual loop after the other away, down to a cube or a core</source>
        <translation>Kästen, Polyeder und Mischungen, die kein Sweep sind: Hexaederlagen schneiden alle Henkel auf und nehmen eine duale Schleife nach der anderen weg, bis auf einen Würfel oder einen Kern</translation>
    </message>
    <message>
        <source>{sheets} sheets[, {cuts} of them cuts][, a core of {core quads} quads][, {pillows} pillow]</source>
        <translation>{sheets} Blätter[, davon {cuts} Schnitte][, ein Kern aus {core quads} Vierecken][, {pillows} Polster]</translation>
    </message>
    <message>
        <source>diced</source>
        <translation>gewürfelt</translation>
    </message>
    <message>
        <source>subdivided triangles or quads around any body: tetrahedra inside, each cut into four hexes</source>
        <translation>unterteilte Dreiecke oder Vierecke um einen beliebigen Körper: Tetraeder im Inneren, jedes in vier Hexaeder zerlegt</translation>
    </message>
    <message>
        <source>diced, {coarse triangles} coarse triangles, {coarse quads} coarse quads, {tetrahedra} tetrahedra inside[, {pillows} pillow]</source>
        <translation>gewürfelt, {coarse triangles} grobe Dreiecke, {coarse quads} grobe Vierecke, {tetrahedra} Tetraeder im Inneren[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>kleinste</translation>
    </message>
    <message>
        <source>up to 16 quads around a ball: the smallest filling known, from a table</source>
        <translation>bis zu 16 Vierecke um eine Kugel: die kleinste bekannte Füllung, aus einer Tabelle</translation>
    </message>
    <message>
        <source>smallest[, {pillows} pillow]</source>
        <translation>kleinste[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>shelling</source>
        <translation>Schalen</translation>
    </message>
    <message>
        <source>irregular surfaces of balls, up to some 400 quads: edges rotate in shells under the surface, then as sheets</source>
        <translation>unregelmäßige Oberflächen von Kugeln, bis etwa 400 Vierecke: Kanten drehen sich in Schalen unter der Oberfläche, danach wie Blätter</translation>
    </message>
    <message>
        <source>shelling, {rotations} rotated edges in {shells} shells[, {pillows} pillow]</source>
        <translation>Schalen, {rotations} gedrehte Kanten in {shells} Schalen[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>any body, also with boundary layers: a cell of hexes on each pair of quads, and tetrahedra inside, each cut into four hexes</source>
        <translation>jeder Körper, auch mit Randlagen: eine Zelle aus Hexaedern auf jedem Viereckspaar, und Tetraeder im Inneren, jedes in vier Hexaeder zerlegt</translation>
    </message>
    <message>
        <source>cells, {layers} layers, {tetrahedra} tetrahedra inside[, {pillows} pillow]</source>
        <translation>Zellen, {layers} Lagen, {tetrahedra} Tetraeder im Inneren[, {pillows} Polster]</translation>
    </message>
    <message>
        <source>four-split</source>
        <translation>Vierteilung</translation>
    </message>
    <message>
        <source>layers of hexes under any surface, down to quads that are all split in four</source>
        <translation>Hexaederlagen unter jeder Oberfläche, bis alle Vierecke in vier geteilt sind</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>Pyramide</translation>
    </message>
    <message>
        <source>Carbonera and Shepherd's pyramids, in balls</source>
        <translation>Pyramiden nach Carbonera und Shepherd, in Kugeln</translation>
    </message>
    <message>
        <source>pyramid, alternative</source>
        <translation>Pyramide, andere Art</translation>
    </message>
    <message>
        <source>pyramids under Mitchell's split layers, in balls</source>
        <translation>Pyramiden unter geteilten Lagen nach Mitchell, in Kugeln</translation>
    </message>
    <message>
        <source>pyramid-alt</source>
        <translation>Pyramide, andere Art</translation>
    </message>
    <message>
        <source>geode</source>
        <translation>Geode</translation>
    </message>
    <message>
        <source>Carbonera and Shepherd's Geodes; with tetrahedra inside round holes too</source>
        <translation>Geoden nach Carbonera und Shepherd; mit Tetraedern im Inneren auch um Löcher</translation>
    </message>
    <message>
        <source>geode, alternative</source>
        <translation>Geode, andere Art</translation>
    </message>
    <message>
        <source>Geodes under Mitchell's split layers; with tetrahedra inside round holes too</source>
        <translation>Geoden unter geteilten Lagen nach Mitchell; mit Tetraedern im Inneren auch um Löcher</translation>
    </message>
    <message>
        <source>geode-alt</source>
        <translation>Geode, andere Art</translation>
    </message>
    <message>
        <source>pillowed</source>
        <translation>gepolstert</translation>
    </message>
    <message>
        <source>geode-alt without doublets: two hexes share one face at most</source>
        <translation>Geode, andere Art, ohne Dubletten: Zwei Hexaeder haben höchstens eine Fläche gemeinsam</translation>
    </message>
    <message>
        <source>the first of the others that can be, in the order of what hexes they lead to</source>
        <translation>das erste der anderen, das möglich ist, geordnet danach, zu welchen Hexaedern sie führen</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>Sweep</translation>
    </message>
    <message>
        <source>solids that go from one cap to another: prisms, pipes, frusta, wedges, bent bars</source>
        <translation>Körper, die von einer Deckfläche zur anderen gehen: Prismen, Rohre, Stümpfe, Keile, gebogene Stäbe</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>round solids, and those with three edges at each corner: quads of a few blocks of hexes</source>
        <translation>runde Körper, und solche mit drei Kanten an jeder Ecke: Vierecke weniger Hexaederblöcke</translation>
    </message>
    <message>
        <source>revolved</source>
        <translation>Drehteil</translation>
    </message>
    <message>
        <source>turned parts: bodies of revolution by a full turn, with any profile</source>
        <translation>Drehteile: Körper aus einer vollen Umdrehung mit beliebigem Profil</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>solids whose faces lie across one direction or along it, or are seen from it: plates with bosses, pockets, steps, holes</source>
        <translation>Körper, deren Flächen quer zu einer Richtung oder entlang ihr liegen oder von ihr aus zu sehen sind: Platten mit Augen, Taschen, Stufen, Löchern</translation>
    </message>
    <message>
        <source>layers and boxes</source>
        <translation>Lagen und Kästen</translation>
    </message>
    <message>
        <source>solids of layers but for round holes and bosses across them, each in a box with layers of its own</source>
        <translation>Körper aus Lagen bis auf runde Löcher und Augen quer dazu, jedes in einem Kasten mit eigenen Lagen</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>any solid whose features are not much smaller than the elements: a grid of hexes that takes them up</source>
        <translation>jeder Körper, dessen Formelemente nicht viel kleiner als die Elemente sind: ein Gitter von Hexaedern, das sie aufnimmt</translation>
    </message>
    <message>
        <source>layers and filler</source>
        <translation>Lagen und Füllung</translation>
    </message>
    <message>
        <source>solids of layers and boxes but for rooms, where pipes or bores meet or lie askew, which the constrained methods fill</source>
        <translation>Körper aus Lagen und Kästen bis auf Räume, wo Rohre oder Bohrungen sich treffen oder schief liegen: die füllen Verfahren, die Vierecke erhalten</translation>
    </message>
    <message>
        <source>subdivided quads</source>
        <translation>unterteilte Vierecke</translation>
    </message>
    <message>
        <source>any solid: gmsh's quads and triangles, each cut about its middle</source>
        <translation>jeder Körper: Vierecke und Dreiecke von gmsh, jedes um seine Mitte geteilt</translation>
    </message>
    <message>
        <source>subdivided triangles</source>
        <translation>unterteilte Dreiecke</translation>
    </message>
    <message>
        <source>any solid: gmsh's triangles, each cut into three quads</source>
        <translation>jeder Körper: Dreiecke von gmsh, jedes in drei Vierecke geteilt</translation>
    </message>
    <message>
        <source>blossom</source>
        <translation>Blossom</translation>
    </message>
    <message>
        <source>any solid, by luck: gmsh's triangles, paired to quads; few and even ones</source>
        <translation>jeder Körper, mit Glück: Dreiecke von gmsh, zu Vierecken gepaart; wenige und gleichmäßige</translation>
    </message>
    <message>
        <source>transfinite</source>
        <translation>transfinit</translation>
    </message>
    <message>
        <source>solids whose faces all have four sides: grids</source>
        <translation>Körper, deren Flächen alle vier Seiten haben: Gitter</translation>
    </message>
    <message>
        <source>Surface: starting gmsh</source>
        <translation>Oberfläche: gmsh startet</translation>
    </message>
    <message>
        <source>Surface: reading the solid</source>
        <translation>Oberfläche: Körper wird gelesen</translation>
    </message>
    <message>
        <source>Surface: quads of the cap</source>
        <translation>Oberfläche: Vierecke der Deckfläche</translation>
    </message>
    <message>
        <source>Surface: quads of the walls</source>
        <translation>Oberfläche: Vierecke der Wände</translation>
    </message>
    <message>
        <source>Surface: quads of the blocks' faces</source>
        <translation>Oberfläche: Vierecke der Blockflächen</translation>
    </message>
    <message>
        <source>Surface: quads by gmsh</source>
        <translation>Oberfläche: Vierecke von gmsh</translation>
    </message>
    <message>
        <source>Turned part: quads of half a section</source>
        <translation>Drehteil: Vierecke eines halben Schnitts</translation>
    </message>
    <message>
        <source>Turned part: turning the section</source>
        <translation>Drehteil: Schnitt wird gedreht</translation>
    </message>
    <message>
        <source>Layers: the solid's outlines and levels</source>
        <translation>Lagen: Umrisse und Höhen des Körpers</translation>
    </message>
    <message>
        <source>Grid: the solid's faces, edges and corners</source>
        <translation>Gitter: Flächen, Kanten und Ecken des Körpers</translation>
    </message>
    <message>
        <source>Grid: which cells are inside</source>
        <translation>Gitter: welche Zellen innen liegen</translation>
    </message>
    <message>
        <source>Grid: taking up edges and corners</source>
        <translation>Gitter: Kanten und Ecken werden aufgenommen</translation>
    </message>
    <message>
        <source>Grid: putting layers in</source>
        <translation>Gitter: Lagen werden eingesetzt</translation>
    </message>
    <message>
        <source>Curved edges: places on the solid</source>
        <translation>Gekrümmte Kanten: Orte auf dem Körper</translation>
    </message>
    <message>
        <source>Curved edges: bending what would fold</source>
        <translation>Gekrümmte Kanten: Biegen, was sich falten würde</translation>
    </message>
    <message>
        <source>Curved edges: volume, area and distance from the solid</source>
        <translation>Gekrümmte Kanten: Volumen, Fläche und Abstand vom Körper</translation>
    </message>
    <message>
        <source>Moving all points, which slide on the solid</source>
        <translation>Alle Punkte bewegen, die auf dem Körper gleiten</translation>
    </message>
    <message>
        <source>Smoothing: where the mesh lies on the solid</source>
        <translation>Glätten: wo das Netz auf dem Körper liegt</translation>
    </message>
    <message>
        <source>Surface: distance from the solid</source>
        <translation>Oberfläche: Abstand vom Körper</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Datei wird gelesen</translation>
    </message>
    <message>
        <source>Hexes: evening out the tetrahedra inside</source>
        <translation>Hexaeder: Tetraeder im Inneren werden ausgeglichen</translation>
    </message>
    <message>
        <source>CalculiX solves</source>
        <translation>CalculiX löst</translation>
    </message>
    <message>
        <source>Surface: checking</source>
        <translation>Oberfläche: Prüfung</translation>
    </message>
    <message>
        <source>Surface: which closed paths bound inside</source>
        <translation>Oberfläche: welche geschlossenen Wege innen beranden</translation>
    </message>
    <message>
        <source>Hexes: pairing quads</source>
        <translation>Hexaeder: Vierecke paaren</translation>
    </message>
    <message>
        <source>Hexes: looking for sweeps</source>
        <translation>Hexaeder: Sweeps suchen</translation>
    </message>
    <message>
        <source>Hexes: placing points</source>
        <translation>Hexaeder: Punkte setzen</translation>
    </message>
    <message>
        <source>Hexes: cutting handles</source>
        <translation>Hexaeder: Henkel aufschneiden</translation>
    </message>
    <message>
        <source>Hexes: taking dual loops away</source>
        <translation>Hexaeder: duale Schleifen wegnehmen</translation>
    </message>
    <message>
        <source>Hexes: looking for edges to rotate</source>
        <translation>Hexaeder: drehbare Kanten suchen</translation>
    </message>
    <message>
        <source>Hexes: laying split layers</source>
        <translation>Hexaeder: geteilte Lagen legen</translation>
    </message>
    <message>
        <source>Hexes: closing the inside</source>
        <translation>Hexaeder: Inneres schließen</translation>
    </message>
    <message>
        <source>Hexes: cutting tetrahedra</source>
        <translation>Hexaeder: Tetraeder zerlegen</translation>
    </message>
    <message>
        <source>Hexes: tetrahedra inside</source>
        <translation>Hexaeder: Tetraeder im Inneren</translation>
    </message>
    <message>
        <source>Hexes: measuring</source>
        <translation>Hexaeder: Messen</translation>
    </message>
    <message>
        <source>Hexes: untangling</source>
        <translation>Hexaeder: Entwirren</translation>
    </message>
    <message>
        <source>Hexes: improving the worst</source>
        <translation>Hexaeder: die schlechtesten verbessern</translation>
    </message>
    <message>
        <source>Hexes: moving to another boundary</source>
        <translation>Hexaeder: auf einen anderen Rand bewegen</translation>
    </message>
    <message>
        <source>Certificate: neighbourhoods</source>
        <translation>Zertifikat: Nachbarschaften</translation>
    </message>
    <message>
        <source>Certificate: pairs of hexes</source>
        <translation>Zertifikat: Hexaederpaare</translation>
    </message>
    <message>
        <source>Certificate: Jacobians</source>
        <translation>Zertifikat: Jacobi-Determinanten</translation>
    </message>
    <message>
        <source>Does the surface cross itself?</source>
        <translation>Kreuzt die Oberfläche sich selbst?</translation>
    </message>
    <message>
        <source>boundary layers</source>
        <translation>Randlagen</translation>
    </message>
    <message>
        <source>star inside</source>
        <translation>Stern im Inneren</translation>
    </message>
    <message>
        <source>tetrahedra inside</source>
        <translation>Tetraeder im Inneren</translation>
    </message>
    <message>
        <source>core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Geodes on coarse quads</source>
        <translation>Geoden auf groben Vierecken</translation>
    </message>
    <message>
        <source>pyramids on coarse quads</source>
        <translation>Pyramiden auf groben Vierecken</translation>
    </message>
    <message>
        <source>shells of rotated edges</source>
        <translation>Schalen gedrehter Kanten</translation>
    </message>
    <message>
        <source>sheets inside</source>
        <translation>Blätter im Inneren</translation>
    </message>
    <message>
        <source>paired transition</source>
        <translation>gepaarter Übergang</translation>
    </message>
    <message>
        <source>split layer</source>
        <translation>geteilte Lage</translation>
    </message>
    <message>
        <source>further split layers</source>
        <translation>weitere geteilte Lagen</translation>
    </message>
    <message>
        <source>closure</source>
        <translation>Abschluss</translation>
    </message>
    <message>
        <source>pillows</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>inside of the pillows</source>
        <translation>Inneres der Polster</translation>
    </message>
    <message>
        <source>layers round the boxes</source>
        <translation>Lagen um die Kästen</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Kasten</translation>
    </message>
    <message>
        <source>all hexes</source>
        <translation>alle Hexaeder</translation>
    </message>
    <message>
        <source>{inverted} of {hexes} hexes inverted</source>
        <translation>{inverted} von {hexes} Hexaedern umgestülpt</translation>
    </message>
    <message>
        <source>{hexes} hexes</source>
        <translation>{hexes} Hexaeder</translation>
    </message>
    <message>
        <source>{hexes} hexes, worst scaled Jacobian {worst}</source>
        <translation>{hexes} Hexaeder, schlechteste skalierte Jacobi-Determinante {worst}</translation>
    </message>
</context>
<context>
    <name>HexCon_Check</name>
    <message>
        <source>Certify hex mesh</source>
        <translation>Hexaedernetz zertifizieren</translation>
    </message>
    <message>
        <source>Prove that every hexahedron of the selected FEM mesh is valid, or show those that are not</source>
        <translation>Beweisen, dass jedes Hexaeder des gewählten FEM-Netzes gültig ist, oder zeigen, welche es nicht sind</translation>
    </message>
</context>
<context>
    <name>HexCon_Examples</name>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>Bracket</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Shaft segment</source>
        <translation>Wellenstück</translation>
    </message>
    <message>
        <source>Schneiders' pyramid, 16 quads</source>
        <translation>Schneiders’ Pyramide, 16 Vierecke</translation>
    </message>
    <message>
        <source>Quadrilateral octahedron, 8 quads</source>
        <translation>Vierecks-Oktaeder, 8 Vierecke</translation>
    </message>
    <message>
        <source>Eppstein's cube, 16 quads</source>
        <translation>Eppsteins Würfel, 16 Vierecke</translation>
    </message>
    <message>
        <source>Eppstein's cube, 18 quads</source>
        <translation>Eppsteins Würfel, 18 Vierecke</translation>
    </message>
    <message>
        <source>Eppstein's cube, 20 quads</source>
        <translation>Eppsteins Würfel, 20 Vierecke</translation>
    </message>
    <message>
        <source>Eppstein's cube, 22 quads</source>
        <translation>Eppsteins Würfel, 22 Vierecke</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open a part or a surface of the literature in a document of its own</source>
        <translation>Ein Teil oder eine Oberfläche aus der Literatur in einem eigenen Dokument öffnen</translation>
    </message>
</context>
<context>
    <name>HexCon_Export</name>
    <message>
        <source>Export hex mesh</source>
        <translation>Hexaedernetz exportieren</translation>
    </message>
    <message>
        <source>Write the selected hex mesh, with its face groups, into a file for a solver or another program: CalculiX, Nek5000, SPECFEM3D, Exodus, gmsh, VTK ...</source>
        <translation>Das gewählte Hexaedernetz mit seinen Flächengruppen in eine Datei für einen Löser oder ein anderes Programm schreiben: CalculiX, Nek5000, SPECFEM3D, Exodus, gmsh, VTK ...</translation>
    </message>
</context>
<context>
    <name>HexCon_HexMesh</name>
    <message>
        <source>Hex mesh from quads</source>
        <translation>Hexaedernetz aus Vierecken</translation>
    </message>
    <message>
        <source>Fill the selected quad surface with certified hexahedra whose boundary is exactly its quads</source>
        <translation>Die gewählte Vierecksoberfläche mit zertifizierten Hexaedern füllen, deren Rand genau ihre Vierecke sind</translation>
    </message>
</context>
<context>
    <name>HexCon_Import</name>
    <message>
        <source>Import quad surface</source>
        <translation>Vierecksoberfläche importieren</translation>
    </message>
    <message>
        <source>Read the quads of a mesh file, of gmsh, Abaqus, Nastran, Medit, VTK and other programs</source>
        <translation>Die Vierecke einer Netzdatei von gmsh, Abaqus, Nastran, Medit, VTK und anderen Programmen lesen</translation>
    </message>
</context>
<context>
    <name>HexCon_Inspect</name>
    <message>
        <source>Inspect hex mesh</source>
        <translation>Hexaedernetz untersuchen</translation>
    </message>
    <message>
        <source>Look into the selected FEM mesh: cut it, peel layers off, see the scaled Jacobians and the worst hexahedra</source>
        <translation>In das gewählte FEM-Netz hineinsehen: schneiden, Lagen abschälen, skalierte Jacobi-Determinanten und die schlechtesten Hexaeder sehen</translation>
    </message>
</context>
<context>
    <name>HexCon_IntoAnalysis</name>
    <message>
        <source>Into analysis</source>
        <translation>In die Analyse</translation>
    </message>
    <message>
        <source>Put the selected hex mesh into the active analysis of the FEM workbench, or make one with a CalculiX solver, steel, and constraints to fill in</source>
        <translation>Das gewählte Hexaedernetz in die aktive Analyse des Arbeitsbereichs FEM einfügen, oder eine anlegen, mit CalculiX-Löser, Stahl und auszufüllenden Randbedingungen</translation>
    </message>
</context>
<context>
    <name>HexCon_Loops</name>
    <message>
        <source>Show dual loops</source>
        <translation>Duale Schleifen zeigen</translation>
    </message>
    <message>
        <source>Draw the dual loops of the selected quad surface, or of the boundary of the selected hex mesh, and where they cross themselves</source>
        <translation>Die dualen Schleifen der gewählten Vierecksoberfläche oder des Randes des gewählten Hexaedernetzes zeichnen, und wo sie sich selbst kreuzen</translation>
    </message>
</context>
<context>
    <name>HexCon_MeshSolid</name>
    <message>
        <source>Hex mesh from solid</source>
        <translation>Hexaedernetz aus Körper</translation>
    </message>
    <message>
        <source>Fill the selected solid with certified hexahedra for the FEM workbench: select one object with one solid, or a face of it</source>
        <translation>Den gewählten Körper mit zertifizierten Hexaedern für den Arbeitsbereich FEM füllen: ein Objekt mit einem Körper wählen, oder eine Fläche davon</translation>
    </message>
</context>
<context>
    <name>HexCon_QuadSurface</name>
    <message>
        <source>Quad surface</source>
        <translation>Vierecksoberfläche</translation>
    </message>
    <message>
        <source>Mesh the surface of the selected solid with quads, or take the quads of the selected FEM mesh; see them before they are made</source>
        <translation>Die Oberfläche des gewählten Körpers mit Vierecken vernetzen, oder die Vierecke des gewählten FEM-Netzes nehmen; sie ansehen, bevor sie entstehen</translation>
    </message>
</context>
<context>
    <name>HexCon_Quality</name>
    <message>
        <source>Quality report</source>
        <translation>Qualitätsbericht</translation>
    </message>
    <message>
        <source>An object with the least, 5 % and mean scaled Jacobian of the selected FEM mesh, its worst elements and its certificate; it follows the mesh</source>
        <translation>Ein Objekt mit der kleinsten, der 5-%- und der mittleren skalierten Jacobi-Determinante des gewählten FEM-Netzes, seinen schlechtesten Elementen und seinem Zertifikat; es folgt dem Netz</translation>
    </message>
</context>
<context>
    <name>HexCon_Repair</name>
    <message>
        <source>Repair hex mesh</source>
        <translation>Hexaedernetz reparieren</translation>
    </message>
    <message>
        <source>Another mesh beside the selected one: hexes in reversed node order turned, unused points dropped, inverted hexes untangled; its boundary and groups stay</source>
        <translation>Ein weiteres Netz neben dem gewählten: Hexaeder mit umgekehrter Knotenfolge gewendet, unbenutzte Punkte weggelassen, umgestülpte Hexaeder entwirrt; Rand und Gruppen bleiben</translation>
    </message>
</context>
<context>
    <name>HexCon_Solve</name>
    <message>
        <source>Hold, load and solve</source>
        <translation>Halten, belasten und lösen</translation>
    </message>
    <message>
        <source>Click a face that is held and one that is loaded; CalculiX solves, and the displacements are shown</source>
        <translation>Eine Fläche anklicken, die gehalten wird, und eine, die belastet wird; CalculiX löst, und die Verschiebungen werden gezeigt</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>HexCon</source>
        <translation>HexCon</translation>
    </message>
</context>
</TS>
