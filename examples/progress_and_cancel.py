# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watch long work, cancel it, or give it so many seconds."""
import hexcon
import hexcon_native as hn

surface = hexcon.example("eppstein-20")
stages = []


def show(stage, fraction):
    """Called now and then: "name", or "name, what is known of the mesh"."""
    name = stage.partition(",")[0]
    if name not in stages:
        stages.append(name)
        print(f"{fraction:5.0%}  {hn.STAGES[name]}")


mesh = hn.mesh(surface.points, surface.quads, "cells", progress=show)
print(f"done: {mesh}")

try:
    hn.mesh(surface.points, surface.quads, "cells", progress=lambda stage, fraction: not stage.startswith("optim"))
except hn.HexconError as fault:
    print(f"cancelled: {fault.code.name}")

mesh = hn.mesh(surface.points, surface.quads, "auto", budget=30)
print(f"within 30 seconds: {mesh.method}, {mesh.certificate}")
