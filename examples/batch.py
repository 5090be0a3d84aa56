# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every part of a folder, none of whose failures stops the rest: python3 batch.py [FOLDER [SIZE]]

resources/batch/mesh_folder.py does the same in FreeCADCmd and writes .FCStd too.
"""
import os
import sys
import tempfile

from hexcon.batch import mesh_folder

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
folder, size = (sys.argv[1:] + [None, None])[:2]
with tempfile.TemporaryDirectory() as out:
    done = mesh_folder(folder or os.path.join(ROOT, "resources", "examples"), out, float(size or 10), (".inp", ".vtu"))
    print("written:", ", ".join(sorted(os.listdir(out))))
    print("answer:", done)
