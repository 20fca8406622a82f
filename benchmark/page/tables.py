# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The tables of doc/performance.md, in Markdown."""

from page import targets
from page.measurements import bytes_per_vertex, exponent, is_sphere, poisson_ratio, title

STAGES = ["setup", "exactness", "assembly", "factorization", "eigenvectors", "reconstruction",
          "certificate"]


def table(header, rows):
    """The first column is of words, the others are of numbers."""
    lines = [header, ["---"] + ["--:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def seconds(value):
    return f"{value:.4f}" if value < 0.1 else f"{value:.3f}" if value < 10 else f"{value:.1f}"


def number(row, key, form="{:.2f}"):
    return form.format(row[key]) if row.get(key) is not None else ""


def left_out(row, columns):
    return [row["model"], "left out: " + row["left_out"]] + [""] * (columns - 2)


def target_table(m):
    """(table, number of targets met, number measured)"""
    verdicts = [target.verdict(m) for target in targets.TARGETS]
    text = table(["target", "wanted", "measured: worst (mesh), best", ""],
                 [cells for _, cells in verdicts])
    return text, sum(met is True for met, _ in verdicts), sum(met is not None
                                                              for met, _ in verdicts)


def transform_table(m, mesh):
    header = ["model", "seconds", "/ P", "bytes/vertex", "factorizations", "solves", "iterations",
              "difference", *STAGES]
    rows = []
    for row in m.rows("poisson", mesh=mesh) + m.rows("transform", mesh=mesh):
        if "left_out" in row:
            rows.append(left_out(row, len(header)))
            continue
        model = "P: " + row["model"] if row["table"] == "poisson" else row["model"]
        stages = [100 * row.get(f"{stage}_share", 0) for stage in STAGES]
        rows.append([model, seconds(row["seconds"]), f"{poisson_ratio(row):.2f}",
                     f"{bytes_per_vertex(row):.0f}",
                     *(number(row, key, "{}") for key in ("factorizations", "solves", "iterations")),
                     number(row, "difference", "{:.0e}"),
                     *(f"{share:.1f} %" if any(stages) else "" for share in stages)])
    return table(header, rows)


def cost_table(m):
    """Microseconds per vertex of P and of the stages of *native, float*: a row a mesh."""
    lines = []
    for mesh, faces, vertices in m.meshes():
        row = m.row("transform", "native, float", mesh)
        if row is None:
            continue
        cost = 1e6 * row["seconds"] / vertices
        stages = [row.get(f"{stage}_share", 0) * cost for stage in STAGES]
        lines.append([title(mesh), f"{faces:,}", f"{1e6 * row['poisson'] / vertices:.2f}",
                      *(f"{part:.2f}" for part in (cost, *stages))])
    return table(["mesh", "faces", "P", "whole", *STAGES], lines)


def strength_table(m, name="strength"):
    """A row a mesh: time / P, factorizations and solves for each amplitude, and with a bound what
    is kept of rho; * refused."""
    rows = m.measured(name)
    amplitudes = sorted({row["amplitude"] for row in rows})
    kept = ["kept"] if any("kept" in row for row in rows) else []
    header = ["mesh", "faces", *(f"{what}, {a:g}" for a in amplitudes
                                 for what in ("/ P", "factorizations", "solves", *kept))]
    lines = []
    for mesh, faces, _ in m.meshes():
        found = {row["amplitude"]: row for row in rows if row["mesh"] == mesh}
        if not found:
            continue
        lines.append([mesh, f"{faces:,}"])
        for a in amplitudes:
            row = found[a]
            lines[-1] += [f"{poisson_ratio(row):.1f}" + ("" if row["fault"] == "none" else " *"),
                          f"{row['factorizations']}", f"{row['solves']}",
                          *(f"{row[key]:.2f}" for key in kept)]
    return table(header, lines) if lines else "Not measured."


def factor_table(m, mesh):
    header = ["model", "ordering", "symbolic", "numeric", "again", "/ scalar", "solve",
              "/ scalar", "bytes/vertex", "residual"]
    rows = []
    for row in m.rows("factor", mesh=mesh):
        if "left_out" in row:
            rows.append(left_out(row, len(header)))
            continue
        rows.append([row["model"],
                     *(seconds(row[key]) for key in ("ordering", "symbolic", "numeric", "again")),
                     f"{row['again'] / row['poisson_again']:.2f}", seconds(row["solve"]),
                     f"{row['solve'] / row['poisson_solve']:.2f}", f"{bytes_per_vertex(row):.0f}",
                     number(row, "residual", "{:.0e}")])
    return table(header, rows)


def exponent_table(m):
    """Of time and memory in the number of vertices, on spheres."""
    models = {row["model"]: None for row in m.measured("poisson") + m.measured("transform")}
    rows = []
    for model in models:
        found = [row for row in m.measured("poisson", model) + m.measured("transform", model)
                 if is_sphere(row["mesh"])]
        cells = []
        for key in ("seconds", "bytes"):
            for least in (0, 100_000, 500_000):
                part = [row for row in found if row["faces"] >= least]
                slope = exponent([row["vertices"] for row in part], [row[key] for row in part])
                cells.append("" if slope is None else f"{slope:.2f}")
        rows.append([model, *cells])
    ranges = ["all", "from 131k", "from 0.5M"]
    return table(["model", *(f"{what}, {r}" for what in ("time", "memory") for r in ranges)], rows)


def original_table(m):
    """The implementation of 2011, as quoted, and ours."""
    rows = []
    for row in sorted(m.measured("transform", "native, double"), key=lambda row: row["faces"]):
        old = targets.ORIGINAL_2011.get(row["faces"])
        if not old or not is_sphere(row["mesh"]):
            continue
        ours = (row["seconds"], row["bytes"] / 1e6)
        rows.append([f"{row['faces']:,}", f"{old[0]:g} s", seconds(ours[0]) + " s",
                     f"{old[0] / ours[0]:.0f}", f"{old[1]} MB", f"{ours[1]:.0f} MB",
                     f"{old[1] / ours[1]:.1f}"])
    return table(["faces", "time then", "now", "ratio", "memory then", "now", "ratio"], rows)


def flow_table(m):
    rows = [[row["mesh"], row["model"], number(row, "tau", "{:g}"), seconds(row["seconds"]),
             f"{poisson_ratio(row):.2f}", number(row, "factorizations"),
             number(row, "iterations", "{:.1f}")]
            for row in m.measured("flow")]
    return table(["mesh", "model", "tau", "seconds", "/ P", "factorizations", "iterations"],
                 rows) if rows else "Not measured."


def spectrum_table(m):
    rows = [[row["mesh"], row["model"], seconds(row["seconds"]), f"{poisson_ratio(row):.1f}",
             number(row, "restarts", "{}"), "yes" if row["complete"] else "no"]
            for row in m.measured("spectrum")]
    return table(["mesh", "operator", "seconds", "/ P", "restarts", "complete"],
                 rows) if rows else "Not measured."


def thread_table(m):
    rows = [[row["mesh"], row["model"], seconds(row["wall_1"]), seconds(row["wall_2"]),
             f"{row['wall_1'] / row['wall_2']:.2f}"] for row in m.measured("threads")]
    return table(["mesh", "what", "one thread", "two threads", "speedup"],
                 rows) if rows else "Not measured."
