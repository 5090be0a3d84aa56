# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of more than one file begin with."""
import pytest


@pytest.fixture(scope="module")
def gmsh_running():
    """gmsh as the worker has it, with an empty model."""
    import gmsh
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.add("solid")
    yield
    gmsh.finalize()


@pytest.fixture
def features(tmp_path):
    """callable(build, size): grid Features of the one solid that build(gmsh.model.occ) leaves; smooth: as Features."""
    import gmsh

    from hexcon.quads.gmsh_worker import cad
    from hexcon.quads.gmsh_worker.grid.features import Cad, Features

    def make(build, size, **smooth):
        gmsh.model.add("made")
        build(gmsh.model.occ)
        gmsh.model.occ.synchronize()
        path = str(tmp_path / "solid.brep")
        gmsh.write(path)
        gmsh.clear()
        return Features(Cad(cad.load(path), size), **smooth)
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    yield make
    gmsh.finalize()
