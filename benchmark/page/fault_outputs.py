# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Outputs that cannot be written, odd names, and a locale with a decimal comma."""

import os
import shutil
import subprocess

from page.fault_bench import OLD, RHO, Check, others

NOBODY = 65534
LOCALES = ("de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8")


def refused(check, bench, output, how, **options):
    """Exit 5 with a reason that names the output."""
    code, message = bench.run(*bench.spin(output), **options)
    check.ended(f"exit {code}")
    check.expect(code == 5 and str(output) in message, f"{how}: exit {code}: {message}")


def full_disk(bench):
    """/dev/full, for the mesh, the report and the table; and a full file system, if it may be
    made."""
    check, folder = Check("full disk"), bench.new_folder("full")
    (folder / "output.ply").symlink_to("/dev/full")
    refused(check, bench, folder / "output.ply", "/dev/full")
    code, message = bench.run(*bench.spin(folder / "other.ply"), "--json", "/dev/full")
    check.ended(f"exit {code}")
    check.expect(code == 5, f"report to /dev/full: exit {code}: {message}")
    with open("/dev/full", "wb") as full:
        done = subprocess.run([bench.program, "info", bench.mesh], stdout=full,
                              stderr=subprocess.DEVNULL, check=False)
    check.ended(f"exit {done.returncode}")
    check.expect(done.returncode == 5, f"table to /dev/full: exit {done.returncode}")
    disk = bench.new_folder("disk")
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk],
                             stderr=subprocess.DEVNULL, check=False).returncode == 0
    if not mounted:
        return check.row("no file system could be mounted")
    try:
        (disk / "output.ply").write_bytes(OLD)
        refused(check, bench, disk / "output.ply", "64 kB")
        check.expect((disk / "output.ply").read_bytes() == OLD, "64 kB: the old output is gone")
        check.expect(not others(disk, "output.ply"), f"64 kB: left {others(disk)}")
    finally:
        subprocess.run(["umount", disk], check=True)
    return check.row()


def unwritable(bench):
    """Folders that are absent, no folders or read only, and a folder as output."""
    check, folder = Check("output that cannot be written"), bench.new_folder("unwritable")
    refused(check, bench, folder / "absent" / "output.ply", "absent folder")
    refused(check, bench, bench.mesh / "output.ply", "a file as folder")
    (folder / "is_a_folder.ply").mkdir()
    refused(check, bench, folder / "is_a_folder.ply", "a folder as file")
    refused(check, bench, folder / ("n" * 300 + ".ply"), "a name of 300 letters")
    closed = bench.new_folder("closed")
    (closed / "output.ply").write_bytes(OLD)
    closed.chmod(0o555)
    options = {"user": NOBODY} if os.geteuid() == 0 else {}
    refused(check, bench, closed / "output.ply", "read-only folder", **options)
    refused(check, bench, closed / "new.ply", "read-only folder", **options)
    closed.chmod(0o755)
    check.expect((closed / "output.ply").read_bytes() == OLD, "the old output is gone")
    check.expect(others(closed) == ["output.ply"], f"left {others(closed)}")
    return check.row()


def closed_pipe(bench):
    """A reader that is gone before the table, or standard output that is closed."""
    check = Check("closed pipe")
    for how, shell in (("reader gone", '"$1" info "$2" | true; exit ${PIPESTATUS[0]}'),
                       ("closed output", '"$1" info "$2" >&-'),
                       ("closed errors", '"$1" info "$2" 2>&- >/dev/null'),
                       ("no input", '"$1" info - </dev/null')):
        done = subprocess.run(["bash", "-c", shell, "bash", bench.program, bench.mesh],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        check.ended(f"{how}: exit {done.returncode}")
        check.expect(done.returncode in {"no input": (3,), "closed errors": (0,)}.get(how, (0, 5)),
                     f"{how}: exit {done.returncode}")
    return check.row()


def output_is_input(bench):
    """The mesh is replaced by the result if there is one, and stays if there is none."""
    check = Check("output equal to input")
    folder = bench.new_folder("same")
    mesh = folder / "mesh.ply"
    for way in ("path", "link"):
        shutil.copy(bench.mesh, mesh)
        output = mesh
        if way == "link":
            output = folder / "link.ply"
            output.symlink_to(mesh.name)
        code, message = bench.run(*bench.spin(output, mesh))
        check.ended(f"exit {code}")
        check.expect(code == 0 and mesh.read_bytes() == bench.reference, f"{way}: {message}")
    shutil.copy(bench.mesh, mesh)
    code, _ = bench.run(*bench.spin(mesh, mesh), "--limit", "closure=1e-12")
    check.ended(f"exit {code}")
    check.expect(code == 1 and mesh.read_bytes() == bench.mesh.read_bytes(), f"exit {code}")
    check.expect(not others(folder, "mesh.ply", "link.ply"), f"left {others(folder)}")
    return check.row()


def odd_names(bench):
    """Names and paths that are long, with spaces, quotes, line ends, other alphabets, no UTF-8."""
    check, folder = Check("odd names"), bench.new_folder("names")
    names = [b"with spaces", "Fl\u00e4che \u66f2\u9762 \U0001f43b".encode(), b"quote'\"s",
             b"line\nend", b"not utf-8 \xff\xfe", b"%s%n", b"n" * 250,
             b"/".join([b"d" * 100] * 9) + b"/deep"]
    for name in names:
        base = os.path.join(os.fsencode(folder), name)
        os.makedirs(os.path.dirname(base), exist_ok=True)
        shutil.copy(bench.mesh, base + b".ply")
        code, message = bench.run("spin", base + b".ply", *RHO, "-o", base + b".obj", "--json",
                                  base + b".js", env={**os.environ, "LC_ALL": "C"})
        check.ended(f"exit {code}")
        check.expect(code == 0 and os.path.exists(base + b".obj"), f"{name}: {code}: {message}")
    return check.row()


def decimal_comma(bench):
    """The same output in a locale with a decimal comma, read from and written to text."""
    check = Check("locale with a decimal comma")
    known = subprocess.run(["locale", "-a"], stdout=subprocess.PIPE, text=True, check=True).stdout
    folder = os.environ.get("LOCPATH", "")
    names = [name for name in LOCALES
             if name in known.split() or folder and os.path.isdir(os.path.join(folder, name))]
    if not names:
        return check.row("left out: no such locale is installed")
    text = bench.folder / "text.off"
    bench.run(*bench.spin(text))
    results = []
    for locale in ("C", names[0]):
        output = bench.folder / f"text_{locale}.obj"
        code, message = bench.run(*bench.spin(output, text), env={**os.environ, "LC_ALL": locale})
        check.ended(f"exit {code}")
        check.expect(code == 0, f"{locale}: {message}")
        results.append(output.read_bytes() if output.exists() else b"")
    check.expect(results[0] == results[1], f"{names[0]} gives another output")
    return check.row(names[0])
