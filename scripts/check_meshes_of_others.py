#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fetches the meshes that packages of Debian 12 and of npm ship, runs the program's default call on them, and prints
tables of the kinds of answers: by package, and why files were refused.

    scripts/check_meshes_of_others.py PROGRAM FOLDER [-j N] [--time-limit SECONDS] [--package NAME]...

The packages, in stated versions, are unpacked into FOLDER, unless they are there; nothing is installed. The exit code
is 0 if each file is answered or refused for a reason, within the time, and each curve is certified.
"""
import argparse
import collections
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

from check_meshes import CERTIFIED, EXTENSIONS, print_table, run

DEBIAN = {
    "assimp-testmodels": "5.2.5~ds0-1",
    "cura": "4.13.0-1",
    "freecad-common": "0.20.2+dfsg1-4+deb12u1",
    "geomview": "1.9.5-4+b1",
    "gmsh-doc": "4.8.4+ds2-3",
    "netgen-doc": "6.2.2006+really6.2.1905+dfsg-5.1",
    "octave-matgeom": "1.2.3-3",
}
NPM = {"stl-models": "0.12.0"}


def download_from_debian(name, version, work):
    """The path of the package's archive. Without package lists, or with old ones, they are fetched into `work`."""
    lists, cache = os.path.join(work, "lists"), os.path.join(work, "cache")
    os.makedirs(os.path.join(lists, "partial"), exist_ok=True)
    os.makedirs(os.path.join(cache, "archives", "partial"), exist_ok=True)
    own = ["-o", f"Dir::State::lists={lists}", "-o", f"Dir::Cache={cache}", "-o", "Acquire::Languages=none"]
    apt_get = ["apt-get", "-q=2", "-o", "Acquire::Retries=3", "-o", "APT::Sandbox::User="]
    wanted = ["download", f"{name}={version}"]
    if subprocess.run(apt_get + wanted, cwd=work, stderr=subprocess.DEVNULL, check=False).returncode != 0:
        if not os.listdir(os.path.join(lists, "partial")) and len(os.listdir(lists)) == 1:
            subprocess.run(apt_get + own + ["update"], check=True)
        subprocess.run(apt_get + own + wanted, cwd=work, check=True)
    return next(os.path.join(work, n) for n in os.listdir(work) if n.startswith(name + "_"))


def is_mesh(path):
    name = path.lower()
    return (name[:-3] if name.endswith(".gz") else name).endswith(EXTENSIONS)


def keep_meshes(source, target):
    """Copies the meshes below a folder to files beside each other. The folder `target` appears when it is complete."""
    os.makedirs(target + ".part", exist_ok=True)
    for folder, _, names in os.walk(source):
        for name in names:
            path = os.path.join(folder, name)
            if is_mesh(name) and os.path.isfile(path):
                flat = os.path.relpath(path, source).replace(os.sep, "__").replace(" ", "_")
                shutil.copyfile(path, os.path.join(target + ".part", flat))
    os.rename(target + ".part", target)


def fetch(folder, packages):
    """Folders of meshes by the names and versions of packages."""
    folders = {}
    with tempfile.TemporaryDirectory() as work:
        for name in packages:
            version = DEBIAN.get(name) or NPM[name]
            target = os.path.join(folder, f"{name}_{version}")
            folders[f"{name} {version}"] = target
            if os.path.isdir(target):
                continue
            unpacked = os.path.join(work, "unpacked_" + name)
            os.mkdir(unpacked)
            if name in DEBIAN:
                archive = download_from_debian(name, version, work)
                subprocess.run(["dpkg-deb", "--extract", archive, unpacked], check=True)
            else:
                packed = subprocess.run(["npm", "pack", "--silent", f"{name}@{version}"], cwd=work, check=True,
                                        stdout=subprocess.PIPE, text=True).stdout.split()[-1]
                with tarfile.open(os.path.join(work, packed)) as archive:
                    archive.extractall(unpacked)
            keep_meshes(unpacked, target)
    return folders


def reason(line):
    """Why a file was refused, without its name and numbers."""
    text = line["error"]
    if text.startswith(line["file"] + ": "):
        text = text[len(line["file"]) + 2:]
    text = re.sub(r'"[^"]*"', '"..."', re.split(r";|, and ", text)[0])
    return re.sub(r"\d[\d.]*(e[-+]?\d+)?", "N", text)[:90]


def answer(line):
    if line["status"] != "ok":
        return "refused" if line["kind"] == "input" else line["kind"]
    if not line["constrictions"]:
        return "empty"
    return "certified" if all(c["certificate"] in CERTIFIED for c in line["constrictions"]) else "not certified"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("-j", type=int, default=1)
    parser.add_argument("--time-limit", type=int, default=600)
    parser.add_argument("--package", action="append", choices=[*DEBIAN, *NPM], help="all, if none is given")
    arguments = parser.parse_args()

    os.makedirs(arguments.folder, exist_ok=True)
    folders = fetch(arguments.folder, arguments.package or [*DEBIAN, *NPM])
    files = {package: sorted(os.path.join(path, n) for n in os.listdir(path)) for package, path in folders.items()}
    names = sorted((name for paths in files.values() for name in paths), key=lambda n: (os.path.getsize(n), n))
    lines = run(arguments.program, names, arguments.j, arguments.time_limit)

    kinds = ["certified", "empty", "refused"]
    others = {answer(lines[n]) if n in lines else "no line" for n in names} - set(kinds)
    kinds += sorted(others)
    rows, reasons = [], collections.defaultdict(list)
    for package, paths in files.items():
        counts = collections.Counter(answer(lines[n]) if n in lines else "no line" for n in paths)
        answered = [lines[n] for n in paths if n in lines and lines[n]["status"] == "ok"]
        repaired = sum(any(repair != "triangulated" for repair in line["mesh"]["repairs"]) for line in answered)
        curves = sum(len(line["constrictions"]) for line in answered)
        rows.append([package, len(paths), *(counts[kind] for kind in kinds), repaired, curves])
        for name in paths:
            if name in lines and lines[name]["status"] != "ok":
                reasons[reason(lines[name])].append(os.path.basename(name))
    rows.append(["together", *(sum(row[i] for row in rows) for i in range(1, len(rows[0])))])
    print_table(["package", "files", *kinds, "repaired", "curves"], rows)
    print_table(["refused because", "files"], [
        [text, len(found)] for text, found in sorted(reasons.items(), key=lambda item: (-len(item[1]), item[0]))])
    for name in names:
        if name not in lines or answer(lines[name]) in others:
            print(f"{name}: {lines[name].get('error', answer(lines[name])) if name in lines else 'no line'}")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
