# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts public packages of a stated version below one folder. Nothing is installed on the machine."""
import os
import pathlib
import shutil
import subprocess

MIRROR = os.environ.get("DEBIAN_MIRROR", "http://deb.debian.org/debian")
SUITES = {12: "bookworm", 13: "trixie"}
TRIPLET = "x86_64-linux-gnu"


def run(command, log, **options):
    with open(log, "w") as out:
        done = subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, **options)
    if done.returncode:
        lines = [line for line in open(log).read().splitlines() if line.strip()]
        raise RuntimeError("%s: %s" % (command[0], lines[-1] if lines else "exit code %d" % done.returncode))


class Debian:
    """A release of Debian, of which packages are unpacked into a folder with everything that they need, the C library
    too: so programs of a release run on another one, started by their own dynamic linker."""

    def __init__(self, folder, release):
        self.base = pathlib.Path(folder) / ("debian%d" % release)
        self.release = release

    def apt(self, *arguments):
        lists, cache = self.base / "lists", self.base / "cache"
        sources = self.base / "sources.list"
        options = ["Acquire::Retries=3", "Acquire::Languages=none", "Debug::NoLocking=1", "APT::Sandbox::User=",
                   "Dir::Etc::sourcelist=%s" % sources, "Dir::Etc::sourceparts=/dev/null",
                   "Dir::Etc::preferences=/dev/null", "Dir::Etc::preferencesparts=/dev/null",
                   "Dir::State::status=/dev/null", "Dir::State::lists=%s" % lists, "Dir::Cache=%s" % cache]
        if not sources.exists():
            (lists / "partial").mkdir(parents=True, exist_ok=True)
            (cache / "archives" / "partial").mkdir(parents=True, exist_ok=True)
            sources.write_text("deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] %s %s main\n" % (
                MIRROR, SUITES[self.release]))
            self.apt("update")
        run(["apt-get", "--quiet=2"] + [word for o in options for word in ("-o", o)] + list(arguments),
            self.base / "apt.log")

    def unpack(self, name, packages):
        """The root folder with these packages, each given as NAME=VERSION."""
        root = self.base / name
        complete = root / ".complete"
        if not complete.exists():
            shutil.rmtree(root, ignore_errors=True)
            archives = self.base / "cache" / "archives"
            self.base.mkdir(parents=True, exist_ok=True)
            for deb in archives.glob("*.deb"):
                deb.unlink()
            self.apt("install", "--download-only", "--no-install-recommends", "--yes", *packages)
            root.mkdir()
            # The C library first: its links /lib and /lib64 are those of a system with one /usr.
            for place in ("bin", "lib", "lib64", "sbin"):
                (root / "usr" / place).mkdir(parents=True)
                (root / place).symlink_to("usr/" + place)
            for deb in sorted(archives.glob("*.deb")):
                tar = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", str(deb)], stdout=subprocess.PIPE)
                subprocess.run(["tar", "--extract", "--keep-directory-symlink", "--no-same-owner", "-C", str(root)],
                               stdin=tar.stdout, check=True)
                deb.unlink()
            complete.touch()
        return root


def started_by_own_linker(root, program, *arguments):
    """The command that runs a program of an unpacked Debian, and its environment."""
    root = pathlib.Path(root)
    libraries = [root / "usr/lib" / TRIPLET] + [root / "usr/lib" / TRIPLET / n for n in ("blas", "lapack", "pulseaudio")]
    libraries += [root / "usr/lib", root / "usr/lib" / TRIPLET / "meshlab"]
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "LD_"))}
    environment.update(PYTHONHOME=str(root / "usr"), PYTHONPATH=str(root / "usr/lib/python3/dist-packages"),
                       PYTHONDONTWRITEBYTECODE="1", LC_ALL="C.UTF-8", QT_QPA_PLATFORM="offscreen",
                       QT_PLUGIN_PATH=str(root / "usr/lib" / TRIPLET / "qt5/plugins"), OMP_NUM_THREADS="1",
                       XDG_RUNTIME_DIR="/tmp", HOME=str(root / "home"))
    (root / "home").mkdir(exist_ok=True)
    return ([str(root / "lib64/ld-linux-x86-64.so.2"), "--library-path", ":".join(map(str, libraries)),
             str(root / program)] + [str(a) for a in arguments], environment)


def npm(folder, packages):
    """The folder that has node_modules with these packages, each given as NAME@VERSION."""
    place = pathlib.Path(folder) / "npm" / "+".join(p.replace("/", "_") for p in packages)
    if not (place / ".complete").exists():
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--ignore-scripts", "--no-save"] + packages,
            place / "npm.log", cwd=place)
        (place / ".complete").touch()
    return place
