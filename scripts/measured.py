# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the blocks of docs/measured.md from the result files of `make measured`.

python3 scripts/measured.py [--results output]

A block stands between lines that hold "begin NAME" and "end NAME" and begins with when it was measured and on how many
processors. One whose result file is missing stays as it is. Nothing is typed here: figures are those of the files.
"""
import argparse
import datetime
import json
import os
import re
import statistics
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PAGE = os.path.join(ROOT, "docs", "measured.md")


def verbatim(lines):
    """As the measuring program printed it."""
    return ["```", *(line.rstrip() for line in lines if line.strip()), "```"]


def csg_rows(lines):
    """One row for each fifty seeds, and what became of the parts that are not certified."""
    found = sorted((json.loads(line) for line in lines if line.strip()), key=lambda one: one["seed"])
    table = ["| seeds | certified | quads | hexes a quad | min; mean (medians) | least of all "
             "| seconds (median, most) |", "|---|---|---|---|---|---|---|"]
    for first in sorted({one["seed"] // 50 * 50 for one in found}):
        table.append(_csg_row([one for one in found if one["seed"] // 50 * 50 == first]))
    failures = [f"- seed {one['seed']}: {one['code']}, {one.get('message', '')[:160]}" for one in found
                if one["code"] != "CERTIFIED"]
    return table + (["", *failures] if failures else [])


def _csg_row(parts):
    good = [one for one in parts if one["code"] == "CERTIFIED"]
    row = [f"{parts[0]['seed']} to {parts[-1]['seed']}", f"{len(good)} of {len(parts)}"]
    if good:
        quads, rates = [one["quads"] for one in good], [one["hexes"] / one["quads"] for one in good]
        seconds = [one["seconds"] for one in parts]
        row += [f"{min(quads)} to {max(quads)}",
                f"{min(rates):.1f} to {max(rates):.1f}, median {statistics.median(rates):.1f}",
                "; ".join(f"{statistics.median(one[name] for one in good):.2f}" for name in ("min", "mean")),
                f"{min(one['min'] for one in good):.3f}",
                f"{statistics.median(seconds):.0f}, {max(seconds):.0f}"]
    else:
        row += ["-"] * 5
    return "| " + " | ".join(row) + " |"


FEM_COLUMNS = ("C3D8 nodes", "C3D8", "C3D10 1", "C3D20 nodes", "C3D20 straight", "C3D20", "C3D20R", "C3D10 2")


def fem_rows(lines):
    """One row for each mesh of a body: nodes at either order, and errors of compliance and of stress in percent."""
    table = ["| body, load | mesh: hexes; least, mean | nodes | C3D8 | C3D10 | nodes | C3D20, straight edges "
             "| C3D20 | C3D20R | C3D10 |", "|---|---|---|---|---|---|---|---|---|---|"]
    for found in map(json.loads, filter(None, lines)):
        for row in found["rows"]:
            cells = [f"{found['body']}, {'bending' if found['bending'] else 'stocky'}",
                     "{mesh}: {hexes}; {min:.2f}, {mean:.2f}".format(**row),
                     *(_fem_cell(row, name) for name in FEM_COLUMNS)]
            table.append("| " + " | ".join(cells) + " |")
    return table


def _fem_cell(row, name):
    if name.endswith(" nodes"):
        return str(row[name.removesuffix(" nodes")]["nodes"])
    found = row[name]
    return "refused" if "fault" in found else "{:+.1f}; {:.0f}".format(100 * found["compliance"], 100 * found["stress"])


def mesher_rows(lines):
    """One row for each mesh of a body."""
    table = ["| body | mesher | cells | hexes | not positive | least, mean | farthest point, in sizes | edges captured "
             "| processor seconds |", "|---|---|---|---|---|---|---|---|---|"]
    for found in map(json.loads, filter(None, lines)):
        for row in found["rows"]:
            table.append("| {} | {} | {} | {:.0f} % | {} | {:.2f}, {:.2f} | {:.1g} | {:.0f} % | {:.1f} |".format(
                found["body"], row["mesher"], row["cells"], 100 * row["hexes"] / row["cells"], row["bad"], row["min"],
                row["mean"], row["off"], 100 * row["edges"], row["seconds"]))
    return table


BLOCKS = {"bench": ("bench.txt", verbatim), "parts": ("parts.txt", verbatim), "csg": ("csg.jsonl", csg_rows),
          "compare": ("compare.txt", verbatim), "optimizer": ("optimizer.txt", verbatim),
          **{name: (name + ".jsonl", fem_rows) for name in ("fem_grid", "fem_round", "fem_machined")},
          "convergence": ("convergence.txt", verbatim),
          "meshers": ("meshers.jsonl", mesher_rows)}
"""name: result file, and what makes the block's lines of the file's."""


def block_date(path):
    """When a result file was measured, and on how many processors."""
    day = datetime.date.fromtimestamp(os.path.getmtime(path)).isoformat()
    return f"{day}, {os.cpu_count()} processors."


def block(path, make):
    """Lines of a block, its date first."""
    with open(path, encoding="utf-8") as stream:
        return [block_date(path), "", *make(stream.read().splitlines())]


def with_block(text, name, lines, page=PAGE):
    """The text of a page with other lines in one block."""
    made = "".join(line + "\n" for line in lines)
    text, count = re.subn(rf"(<!-- begin {name} -->\n).*?(<!-- end {name} -->)",
                          lambda found: found[1] + made + found[2], text, flags=re.DOTALL)
    if count != 1:
        raise SystemExit(f"{page}: there are {count} blocks {name}, not one")
    return text


def renewed(text, results):
    """The page with the blocks whose result files are there."""
    for name, (file, make) in BLOCKS.items():
        path = os.path.join(results, file)
        if os.path.isfile(path) and os.path.getsize(path):
            text = with_block(text, name, block(path, make))
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", default=os.path.join(ROOT, "output"))
    results = parser.parse_args().results
    with open(PAGE, encoding="utf-8") as stream:
        text = stream.read()
    with open(PAGE, "w", encoding="utf-8") as stream:
        stream.write(renewed(text, results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
