# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of the literature, small and hard: how many hexes fill them, and how good they can be."""
import hexcon
import hexcon_native as hn

for name in hexcon.example_names()[:4]:
    surface = hexcon.example(name)
    facts = hn.check_surface(surface.points, surface.quads)
    print(f"{name:12s} {facts.n:2d} quads, {facts.loops}")
    for method in ("smallest", "cells"):
        try:
            mesh = hn.mesh(surface.points, surface.quads, method, pillow="never")   # fewest hexes are looked for
            print(f"    {method:9s} {len(mesh.hexes):4d} hexes, {mesh.certificate}, worst {mesh.quality.min:.2f}")
        except hn.HexconError as fault:
            print(f"    {method:9s} {fault.code.name}: {str(fault)[:90]}")
