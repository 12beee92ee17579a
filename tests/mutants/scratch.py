# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of the sources in which mutants are built, so that nobody's own files are touched."""

import hashlib
import os
import re
import shutil
import subprocess
from pathlib import Path

from checks import MachineFailed

#: What answers: a result holds for these sources only. What checks: a survivor is tried again when they have changed.
ANSWERING = ("meshes", "fast", "reference")
CHECKING = ("compare", "tests", "simulate", "simbody", "bindings")


class CannotBuild(Exception):
    """The sources do not compile."""


#: What compilers and linkers write where the sources are at fault,
_OF_SOURCES = re.compile(r"^\S+:\d+:(\d+:)? (fatal )?error: |undefined reference to |multiple definition of ", re.MULTILINE)
#: and what is written where the machine is.
_OF_MACHINE = re.compile(r"No space left on device|Killed signal|Cannot allocate memory|out of memory|virtual memory exhausted")


def is_of_sources(output):
    """Whether a build that failed with this output did so for its sources, as it would on every machine."""
    return bool(_OF_SOURCES.search(output)) and not _OF_MACHINE.search(output)


class Scratch:
    """The copy in `folder`/source, built in `folder`/build."""

    def __init__(self, root, folder):
        self._root = Path(root)
        self._folder = Path(folder)
        self.source = self._folder / "source"
        self.build_folder = self._folder / "build"

    def refresh(self):
        """Makes the copy what the sources are now, touching only files that differ."""
        listed = subprocess.run(
            ["git", "-C", str(self._root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            check=True,
            capture_output=True,
        ).stdout
        files = {name for name in listed.decode().split("\0") if name and (self._root / name).is_file()}
        for there in [path for path in self.source.rglob("*") if path.is_file() and not path.is_symlink()]:
            if there.relative_to(self.source).as_posix() not in files:
                there.unlink()
        for name in files:
            content = (self._root / name).read_bytes()
            copy = self.source / name
            if copy.is_file() and copy.read_bytes() == content:
                continue
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(content)
            copy.chmod((self._root / name).stat().st_mode & 0o777)
        # Real surfaces, where `./run` has fetched them: of programs built here, and of tests.
        for link in (self._folder / "cgal-demo", self.source / "build" / "cgal-demo"):
            if not link.is_symlink() and not link.exists():
                link.parent.mkdir(parents=True, exist_ok=True)
                link.symlink_to(os.path.relpath(self._root / "build" / "cgal-demo", link.parent))

    def digest(self, folders):
        """A hash of all files in these folders of the copy."""
        digest = hashlib.sha256()
        for folder in folders:
            for path in sorted((self.source / folder).rglob("*")):
                # Of what makes mutants only what asks about them.
                if path.is_file() and (path.parent.name != "mutants" or path.name == "checks.py"):
                    digest.update(path.relative_to(self.source).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
        return digest.hexdigest()[:16]

    def configure(self):
        """As `./run test` does, but that a mutant may have warnings. Where there is ccache, what is put back is not
        compiled again; it keeps nothing that precompiled headers take part in."""
        command = ["cmake", "-S", self.source, "-B", self.build_folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        command += ["-DPCM_UNITY_BUILD=ON", "-DPCM_BENCH_PEERS=OFF", "-DPCM_BUILD_TESTS=ON", "-DPCM_LONG_TESTS=OFF"]
        launcher, without_precompiled = ("ccache", "ON") if shutil.which("ccache") else ("", "OFF")
        command += [f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}", f"-DCMAKE_DISABLE_PRECOMPILE_HEADERS={without_precompiled}"]
        self._run([*command, "-DPCM_WARNINGS_AS_ERRORS=OFF"])

    def build(self, targets, jobs):
        """Builds these targets, or all."""
        command = ["cmake", "--build", self.build_folder, "-j", str(jobs)]
        self._run(command + (["--target", *targets] if targets is not None else []))

    def read(self, file):
        return (self.source / file).read_text(encoding="utf-8")

    def write(self, file, text):
        (self.source / file).write_text(text, encoding="utf-8")

    def _run(self, command):
        ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace")
        if ended.returncode != 0:
            # Results are kept beside the sources: wherever the copy is, they name its files alike.
            said = (ended.stdout[-4000:] + ended.stderr[-2000:]).replace(f"{self.source}/", "")
            raise (CannotBuild if is_of_sources(ended.stdout + ended.stderr) else MachineFailed)(said)
