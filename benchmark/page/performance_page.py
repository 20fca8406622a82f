# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/performance.md, from the record of benchmark/performance."""

from page import plot, targets
from page.measurements import Measurements, bytes_per_vertex, is_sphere, poisson_ratio, title
from page.tables import count, extent, grouped, seconds, table

STAGES = ["setup", "exactness", "assembly", "factorization", "eigenvectors", "reconstruction",
          "certificate"]
DEFAULT = "native, float"
SPECTRUM = "ten eigenvalues of D"


def target_table(m):
    return table(["target", "wanted", "worst", "met"],
                 [[statement, wanted, shown.partition(", best")[0], verdict]
                  for statement, wanted, shown, verdict in (target.verdict(m)[1] for target in targets.TARGETS)])


def met(m):
    verdicts = [target.verdict(m)[0] for target in targets.TARGETS]
    return (f"{verdicts.count(True)} of {len(verdicts) - verdicts.count(None)} targets are met, of "
            f"{len(verdicts)} in all. The worst mesh counts.")


def exponent_table(m):
    """Of time and memory in the number of vertices, on spheres from 131k faces on."""
    slopes = {model: [m.sphere_exponent("transform", model, lambda row, key=key: row[key], 100_000)
                      for key in ("seconds", "bytes")]
              for model in dict.fromkeys(row["model"] for row in m.measured("transform"))}
    return table(["model", "time", "memory"], [[model, *(f"{slope:.2f}" for slope in own)]
                                               for model, own in slopes.items() if None not in own])


def original_table(m):
    """The implementation of 2011, as quoted, and ours."""
    rows = []
    for row in sorted(m.measured("transform", "native, double"), key=lambda row: row["faces"]):
        old = targets.ORIGINAL_2011.get(row["faces"])
        if old and is_sphere(row["mesh"]):
            rows.append([f"{row['faces']:,}", f"{old[0]:g} s, {old[1]} MB",
                         f"{seconds(row['seconds'])} s, {row['bytes'] / 1e6:.0f} MB",
                         f"{old[0] / row['seconds']:.0f}, {1e6 * old[1] / row['bytes']:.1f}"])
    return table(["faces", "2011", "now", "ratios"], rows)


def strength_table(m):
    """Without and with a bound on lengths."""
    lines = []
    for name, bound in (("strength", "none"), ("bounded", "2")):
        for (amplitude,), rows in sorted(grouped(m.measured(name), "amplitude").items()):
            lines.append([f"{amplitude:g}", bound, extent(map(poisson_ratio, rows), ".1f"),
                          extent([row["factorizations"] for row in rows], ".0f"),
                          str(count(rows, lambda row: row["fault"] != "none"))])
    return table(["amplitude", "bound", "time / P", "factorizations", "refused"], lines)


def thread_table(m):
    return table(["what", "speedup"], [
        [what, extent(row["wall_1"] / row["wall_2"] for row in rows)]
        for (what,), rows in grouped(m.measured("threads"), "model").items()])


def blocks(rows):
    m = Measurements(rows)
    return {"machine": next((row["machine"] for row in rows if "machine" in row), ""),
            "met": met(m), "targets": target_table(m), "exponents": exponent_table(m),
            "original": original_table(m), "strengths": strength_table(m), "threads": thread_table(m)}


def costs(m):
    """mesh -> what -> multiples of P"""
    found = {"first transformation": m.measured("transform", DEFAULT),
             "later step of a flow": m.measured("flow", DEFAULT), SPECTRUM: m.measured("spectrum", "D")}
    return {title(mesh): row for mesh, _, _ in m.meshes() if (row := {
        what: poisson_ratio(some) for what, rows in found.items() for some in rows if some["mesh"] == mesh})}


def stages(m):
    """mesh -> stage -> percent"""
    return {title(mesh): {stage: round(100 * row.get(f"{stage}_share", 0)) for stage in STAGES}
            for mesh, _, _ in m.meshes() for row in m.measured("transform", DEFAULT, mesh)}


def factors(m):
    """mesh -> model -> multiples of the scalar factorization"""
    return {title(mesh): {row["model"]: row["again"] / row["poisson_again"] for row in rows}
            for mesh, _, _ in m.meshes() if (rows := m.measured("factor", mesh=mesh))}


def roofline(m):
    """mesh -> stage -> percent of the bandwidth of one thread"""
    return {title(mesh): {row["model"]: 100 * row["bytes"] / row["seconds"] / row["bandwidth"] for row in rows}
            for mesh, _, _ in m.meshes() if (rows := m.measured("roofline", mesh=mesh))}


def by_faces(m, value):
    """model -> (faces, value), on spheres; P is the yardstick"""
    lines = {}
    for row in m.measured("poisson") + m.measured("transform"):
        if is_sphere(row["mesh"]):
            name = "P" if row["table"] == "poisson" else row["model"]
            lines.setdefault(name, []).append((row["faces"], value(row)))
    return lines


def figures(rows):
    m, first = Measurements(rows), "First transformation of a bumpy sphere: "
    drawn = {
        "time": plot.curves(by_faces(m, lambda row: row["seconds"]), "faces", "seconds", first + "time"),
        "memory": plot.curves(by_faces(m, bytes_per_vertex), "faces", "bytes per vertex", first + "peak memory"),
        "costs": plot.dots(costs(m), "multiples of P", "Costs, by mesh"),
        "stages": plot.bars(stages(m), "Percent of a first transformation, by mesh"),
        "factors": plot.dots(factors(m), "multiples of CHOLMOD's scalar factorization",
                             "Numeric factorization, by mesh"),
        "roofline": plot.dots(roofline(m), "percent of the bandwidth of one thread",
                              "What has to be read and written, per second, by mesh")}
    return {f"performance_{name}.svg": svg for name, svg in drawn.items()}
