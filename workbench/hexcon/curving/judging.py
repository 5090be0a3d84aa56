# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh whose middle nodes have moved is judged again, as far as it was before."""
import hexcon_native


def judge_again(mesh, progress=None):
    """Certificate, quality and the report's figures of a hexcon_native.Mesh as it is now, where it had them."""
    if mesh.certificate is not None:
        mesh.certificate = hexcon_native.certify(mesh.points, mesh.hexes, mesh.quads, progress=progress)
    if mesh.quality is not None:
        mesh.quality = hexcon_native.quality(mesh.points, mesh.hexes)
        mesh.report["quality"] = mesh.quality.as_dict()
