# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of elements of Abaqus and CalculiX, and what each is for a mesh.

Abaqus 2016, Elements Guide, and CalculiX 2.20, section 6.2: a name is a family, the number of nodes, and letters for
integration, degrees of freedom and coupling, which do not change the shape.
"""
import re

# family -> {number of nodes: kind, by meshio's names}
_SOLID = {4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron", 10: "tetra10", 13: "pyramid13", 15: "wedge15",
          18: "wedge18", 20: "hexahedron20", 27: "hexahedron27"}
_FLAT = {3: "triangle", 4: "quad", 6: "triangle6", 8: "quad8", 9: "quad9"}
_FAMILIES = (
    (re.compile(r"^(?:A?C3D|AC3D|DC3D|DCC3D|FC3D|EC3D|Q3D|F3D(?=8)|SC|CSS|CCL3D|DCCF3D|EMC3D)(\d+)[A-Z]*$"), _SOLID),
    (re.compile(r"^(?:S|DS|CPS|CPE|CPEG|CPES|CAX|CGAX|CAXA|M3D|SFM3D|R3D|DC2D|DCC2D|DCAX|DCCAX|AC2D|ACAX|ACIN3D|F3D|EC2D|"
                r"US|CCL)([34689])[A-Z]*5?$"), _FLAT),
    (re.compile(r"^STRI(3)$"), _FLAT), (re.compile(r"^STRI(6)5$"), _FLAT),
)
# Lines, points and what joins nodes: no part of a body's mesh. (A number of nodes is not needed to pass them over.)
_NO_BODY = re.compile(r"^(?:T2D|T3D|C1D|B2|B3|PIPE|ELBOW|FRAME|SPRING|DASHPOT|MASS|ROTARYI|HEATCAP|GAP|"
                      r"DGAP|CONN|JOINT|DCOUP|"
                      r"DISTRIBUTING|SAX|MAX|R2D|RAX|RB|RBE|DC1D|DCC1D|AC1D|ACIN2D|ACINAX|LS|ITS|PSI|DRAG|FP|MGAX|SFMAX|SFMGAX|"
                      r"DSAX|ASI|D$|DI|DASHPOTA|SPRINGA|WARP|CAPACITANCE|F2D|FAX|FPC|M2D|DTEMP|IRS|ISL|ITT|PC3D|PD3D)")


def kind_of(name):
    """(kind by meshio's names, number of nodes); (None, 0) for what is no part of a body. Raises ValueError for a
    name that is not known, which may be part of it."""
    name = name.strip().upper()
    for pattern, kinds in _FAMILIES:
        match = pattern.match(name)
        if match:
            nodes = int(match.group(1))
            if nodes in kinds:
                return kinds[nodes], nodes
    if _NO_BODY.match(name):
        return None, 0
    raise ValueError(name)
