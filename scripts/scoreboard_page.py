# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/scoreboard.md and its picture from the results of scoreboard.py: medians by class, every surface, failures."""
import os
import re
import statistics

from measured import ROOT, block_date, with_block

PAGE = os.path.join(ROOT, "docs", "scoreboard.md")
PICTURE = os.path.join(ROOT, "docs", "scoreboard.png")
CLASSES = (("balls", lambda one: one["genus"] == 0 and one["cavities"] == 0),
           ("genus 1 to 10", lambda one: 1 <= one["genus"] <= 10 and one["cavities"] == 0),
           ("cavities, or genus above 10", lambda one: one["cavities"] > 0 or one["genus"] > 10))
DIGITS = 4      # of the public figures
A_QUAD, TIMES, MEAN = 3.0, 1.5, 0.75     # what is natural: see is_natural


def _median(values, form="{:.2f}"):
    values = list(values)
    return form.format(statistics.median(values)) if values else "-"


def _share(part, whole):
    part, whole = list(part), list(whole)
    return f"{len(part)} of {len(whole)}"


def class_rows(found):
    """Medians of each class of bodies."""
    rows = ["| bodies | certified | of these natural | hexes a quad | hexes beside the public mesh's "
            "| minimum; 5 %; mean | public: minimum; mean | minimum at least the public one "
            "| processor seconds (median, most) |",
            "|---|---|---|---|---|---|---|---|---|"]
    for name, belongs in (*CLASSES, ("all", lambda one: True)):
        members = [one for one in found if belongs(one)]
        if members:
            rows.append(_class_row(name, members))
    return rows


def _class_row(name, members):
    good = [one for one in members if one["code"] == "CERTIFIED"]
    beside = [one for one in good if "witness" in one]
    cells = [name, _share(good, members), _share(filter(is_natural, good), good),
             _median(one["hexes"] / one["quads"] for one in good),
             _median((one["hexes"] / one["witness"]["hexes"] for one in beside), "{:.2f} times"),
             "; ".join(_median(one[key] for one in good) for key in ("min", "q05", "mean")),
             "; ".join(_median(one["witness"][key] for one in beside) for key in ("min", "mean")),
             _share((one for one in beside if round(one["min"], DIGITS) >= one["witness"]["min"]), beside),
             f"{_median((one['seconds'] for one in members), '{:.0f}')}, {max(one['seconds'] for one in members):.0f}"]
    return "| " + " | ".join(cells) + " |"


def is_natural(one):
    """At most A_QUAD hexes a quad, or TIMES as many as the public mesh has, and a mean scaled Jacobian of MEAN up."""
    most = max(A_QUAD * one["quads"], TIMES * one["witness"]["hexes"] if "witness" in one else 0)
    return one["hexes"] <= most and one["mean"] >= MEAN


def surface_rows(found):
    """One row for each surface, by class and size."""
    rows = ["| surface | quads | genus | method | hexes | a quad | min; 5 %; mean | seconds | public: hexes "
            "| min; mean |",
            "|---|---|---|---|---|---|---|---|---|---|"]
    for one in sorted(found, key=lambda one: (one["genus"], one["quads"], one["name"])):
        cells = [one["name"], str(one["quads"]), str(one["genus"])]
        if one["code"] == "CERTIFIED":
            cells += [one["method"], str(one["hexes"]), f"{one['hexes'] / one['quads']:.1f}",
                      f"{one['min']:.2f}; {one['q05']:.2f}; {one['mean']:.2f}"]
        else:
            cells += [f"{one['code']}", "-", "-", "-"]
        public = one.get("witness")
        cells.append(f"{one['seconds']:.0f}")
        cells += [str(public["hexes"]), f"{public['min']:.2f}; {public['mean']:.2f}"] if public else ["-", "-"]
        rows.append("| " + " | ".join(cells) + " |")
    return rows


def failure_rows(found):
    """What was said of the surfaces that are not certified."""
    return [f"- {one['name']}: {one['code']}, {re.sub(r'[^ -~]+|[<>|]', ' ', one['message'])[:200]}" for one in found
            if one["code"] != "CERTIFIED"] or ["None."]


def draw(found, path):
    """Hexes a quad and worst hex against the public mesh's: a point a surface, on the diagonal where both agree."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    beside = [one for one in found if one["code"] == "CERTIFIED" and "witness" in one]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.6))
    for name, belongs in CLASSES:
        members = [one for one in beside if belongs(one)]
        if not members:
            continue
        left.scatter([one["witness"]["hexes"] / one["quads"] for one in members],
                     [one["hexes"] / one["quads"] for one in members], s=18, label=f"{name} ({len(members)})")
        right.scatter([max(0.0, one["witness"]["min"]) for one in members], [one["min"] for one in members], s=18)
    for axes, ends, what in ((left, (0.3, 200), "hexes a quad"), (right, (0, 1), "minimum scaled Jacobian")):
        axes.plot(ends, ends, color="0.7", linewidth=1, zorder=0)
        axes.set(xlabel=f"public mesh: {what}", ylabel=f"HexCon: {what}", xlim=ends, ylim=ends)
        axes.set_aspect("equal")
    left.set(xscale="log", yscale="log")
    left.legend(loc="upper left", fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=80, metadata={"Software": None})
    pyplot.close(figure)


def repository_rows(found):
    names = sorted({one["repository"] for one in found if "repository" in one}, key=str.lower)
    return [", ".join(f"[{name}](https://github.com/{name})" for name in names) + "."] if names else ["Not named."]


def write_page(found, result, page=PAGE, picture=PICTURE):
    """Renew the blocks of the page, and its picture; found: results, of which result is the file."""
    limits = ", ".join(f"{limit:g}" for limit in sorted({one["limit"] for one in found}))
    head = [f"{block_date(result)} {len(found)} surfaces; a budget of {limits} s of processor time each, one thread.",
            ""]
    with open(page, encoding="utf-8") as stream:
        text = stream.read()
    for name, lines in (("classes", head + class_rows(found)), ("surfaces", surface_rows(found)),
                        ("failures", failure_rows(found)), ("repositories", repository_rows(found))):
        text = with_block(text, name, lines, page)
    draw(found, picture)
    with open(page, "w", encoding="utf-8") as stream:
        stream.write(text)
