# SPDX-License-Identifier: LGPL-2.1-or-later
"""snappyHexMesh of OpenFOAM on a solid: cells of one size, its edges extracted and snapped to."""
import os
import shutil
import subprocess

import numpy as np

FLATNESS = 0.01     # of triangles, in parts of the cells' size
PADDING = 1.37      # cells between the solid and the end of the box: no plane of cells on one of the solid by chance
HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
CONTROL = """application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 15;"""
SCHEMES = "ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {} interpolationSchemes {} snGradSchemes {}"
BLOCK = """scale 1;
vertices ({corners});
blocks (hex (0 1 2 3 4 5 6 7) ({counts}) simpleGrading (1 1 1));
edges (); boundary (); mergePatchPairs ();"""
FEATURES = "part.stl {{ extractionMethod extractFromSurface; extractFromSurfaceCoeffs {{ includedAngle 150; }} }}"
# OpenFOAM's own defaults (its annotated snappyHexMeshDict), but for the sizes.
SNAPPY = """castellatedMesh true; snap true; addLayers false;
geometry {{ part.stl {{ type triSurfaceMesh; name part; }} }}
castellatedMeshControls {{ maxLocalCells 1000000; maxGlobalCells 2000000; minRefinementCells 0; nCellsBetweenLevels 1;
 features ({{ file "part.eMesh"; level {level}; }}); refinementSurfaces {{ part {{ level (0 0); }} }}
 resolveFeatureAngle 30; refinementRegions {{}} locationInMesh ({inside}); allowFreeStandingZoneFaces true; }}
snapControls {{ nSmoothPatch 3; tolerance 2.0; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10;
 implicitFeatureSnap false; explicitFeatureSnap true; multiRegionFeatureSnap false; }}
addLayersControls {{ relativeSizes true; layers {{}} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1;
 nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
 maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0;
 nLayerIter 50; }}
meshQualityControls {{ maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-13;
 minTetQuality 1e-15; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01;
 minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75; }}
mergeTolerance 1e-6;"""
PROGRAMS = (("blockMesh",), ("surfaceFeatureExtract",), ("snappyHexMesh", "-overwrite"))


def is_installed():
    return all(shutil.which(command[0]) for command in PROGRAMS)


def snappy(shape, size, folder, level=0):
    """{"points", "hexes" (H,8), "others": how many cells are none, "skin" (K,3), "edges" (E,2): points and edges of the
    boundary}. level: how often cells at edges are halved."""
    case = os.path.join(folder, "case")
    shutil.rmtree(case, ignore_errors=True)
    _write_case(shape, size, level, case)
    for command in PROGRAMS:
        subprocess.run([*command, "-case", case], check=True, stdout=subprocess.DEVNULL)
    return _read(case)


def _write_case(shape, size, level, case):
    box, pad = shape.BoundBox, PADDING * size
    low = np.array([box.XMin, box.YMin, box.ZMin]) - pad
    counts = np.ceil((np.array([box.XMax, box.YMax, box.ZMax]) + pad - low) / size).astype(int)
    ends = np.stack([low, low + counts * size])
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    words = {"controlDict": CONTROL, "fvSchemes": SCHEMES, "fvSolution": "",
             "blockMeshDict": BLOCK.format(
                 corners=" ".join("({:.9g} {:.9g} {:.9g})".format(*(ends[b, k] for k, b in enumerate(c)))
                                  for c in corners), counts=" ".join(map(str, counts))),
             "surfaceFeatureExtractDict": FEATURES.format(),
             "snappyHexMeshDict": SNAPPY.format(
                 level=level, inside="{:.9g} {:.9g} {:.9g}".format(*_inside(shape, ends)))}
    for name in ("system", "constant/triSurface"):
        os.makedirs(os.path.join(case, name))
    for name, text in words.items():
        with open(os.path.join(case, "system", name), "w", encoding="ascii") as stream:
            stream.write(HEADER.format(name) + text + "\n")
    _write_stl(shape, FLATNESS * size, os.path.join(case, "constant", "triSurface", "part.stl"))


def _inside(shape, ends):
    """A place in the solid, far from its boundary."""
    from quads_solids import Part, Vector
    places = map(Vector, *np.random.default_rng(1).uniform(*ends, (400, 3)).T.tolist())
    shell = Part.Compound(shape.Shells)
    return max((place for place in places if shape.isInside(place, 1e-9, False)),
               key=lambda place: Part.Vertex(place).distToShape(shell)[0])


def _write_stl(shape, flatness, path):
    points, triangles = shape.tessellate(flatness)
    with open(path, "w", encoding="ascii") as stream:
        stream.write("solid part\n")
        for triangle in triangles:
            corners = [points[k] for k in triangle]
            normal = (corners[1] - corners[0]).cross(corners[2] - corners[0])
            stream.write("facet normal {:.9g} {:.9g} {:.9g}\nouter loop\n".format(*normal))
            stream.writelines("vertex {:.12g} {:.12g} {:.12g}\n".format(*corner) for corner in corners)
            stream.write("endloop\nendfacet\n")
        stream.write("endsolid part\n")


def _read(case):
    import vtk
    from vtk.util import numpy_support as convert
    name = os.path.join(case, "case.foam")
    with open(name, "w", encoding="ascii"):
        pass
    reader = vtk.vtkOpenFOAMReader()
    reader.SetFileName(name)
    reader.DecomposePolyhedraOff()
    reader.Update()
    grid = reader.GetOutput().GetBlock(0)
    kinds = convert.vtk_to_numpy(grid.GetCellTypesArray())
    hexes = [[grid.GetCell(k).GetPointId(m) for m in range(8)] for k in np.flatnonzero(kinds == vtk.VTK_HEXAHEDRON)]
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    surface.Update()
    skin = surface.GetOutput()
    edges = {tuple(sorted((cell.GetPointId(m), cell.GetPointId((m + 1) % cell.GetNumberOfPoints()))))
             for cell in map(skin.GetCell, range(skin.GetNumberOfCells())) for m in range(cell.GetNumberOfPoints())}
    return {"points": convert.vtk_to_numpy(grid.GetPoints().GetData()).astype(float),
            "hexes": np.array(hexes, np.int64).reshape(-1, 8), "others": int((kinds != vtk.VTK_HEXAHEDRON).sum()),
            "skin": convert.vtk_to_numpy(skin.GetPoints().GetData()).astype(float), "edges": np.array(sorted(edges))}
