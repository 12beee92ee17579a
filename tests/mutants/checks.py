# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The checks that a mutant has to pass, and what each says of it."""

import csv
import os
import re
import resource
import shutil
import signal
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

#: The test programs of a room; in `fast` first the one that most faults show in, else the quickest first.
TEST_PROGRAMS = {
    "fast": [
        "fast/test_fast_tracking",
        "fast/test_fast_scene",
        "fast/test_fast_predicates",
        "fast/test_fast_against_twin",
        "fast/test_clipped_against_twin",
        "fast/test_fast_engine",
    ],
    "reference": ["reference/test_reference_oracle", "reference/test_brute_twin", "reference/test_clipped_twin"],
}
#: Numbers of poses of `pcm verify`, one run after the other, unless others are asked for.
LADDER = (500, 4000, 20160)
SEED = 1
#: The names of checks, the cheapest first.
CHECKS = ("tests", "verify", "suite")

_MOST_MEMORY = 12 << 30
#: A mutant may take so many times what the unaltered program takes, and so many seconds more: of processor time, which
#: other work on the machine does not touch; waiting, as in a deadlock, ten times as long.
_TIMES, _SECONDS_MORE = 3, 10


@dataclass
class Finding:
    """What a check found. `by` is empty where the mutant passed."""

    by: str = ""  # the test's name, or what engine and oracle disagree about
    seconds: float = 0.0
    poses: int = 0  # of verify: how many the run had that caught it, or the longest that it passed
    disagreements: int = 0  # and at how many of them
    kinds: dict = field(default_factory=dict)  # by what they disagree about


class MachineFailed(Exception):
    """The machine, not the mutant, ended a program, so that nothing is known of the mutant."""


@dataclass
class Ended:
    """A program that has ended."""

    status: int
    output: str
    seconds: float  # of a processor
    ran_out_of_time: bool


def _limits(seconds):
    def set_limits():
        os.setpgrp()
        resource.setrlimit(resource.RLIMIT_AS, (_MOST_MEMORY, _MOST_MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if seconds is not None:
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))

    return set_limits


def run(command, allowed=None, env=None, cwd=None):
    """Runs a program, for at most `allowed` seconds of processor time, its own children's apart. One that is killed
    from outside, as where the machine has no memory left, raises MachineFailed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(
        [str(word) for word in command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        env=env,
        cwd=cwd,
        preexec_fn=_limits(allowed),
    )
    stuck = False
    try:
        output, _ = process.communicate(timeout=None if allowed is None else 10 * allowed)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        stuck = True
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        raise
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    out_of_time = stuck or process.returncode == -signal.SIGXCPU
    if process.returncode == -signal.SIGKILL and not stuck:
        raise MachineFailed(f"{command[0]} was killed from outside after {seconds:.0f} s of processor time")
    return Ended(process.returncode, output, seconds, out_of_time)


def failed_test(ended):
    """Of the output of a program of GoogleTest: the test that failed first, or in which the program ended."""
    failed = re.search(r"^\[  FAILED  \] ([\w./]+)", ended.output, re.MULTILINE)
    begun = re.findall(r"^\[ RUN      \] ([\w./]+)", ended.output, re.MULTILINE)
    last = begun[-1] if begun else "before its first test"
    if ended.ran_out_of_time:
        return f"time limit in {last}"
    if ended.status < 0:
        return f"{signal.Signals(-ended.status).name} in {last}"
    return failed.group(1) if failed else f"status {ended.status} in {last}"


def failed_of_suite(ended):
    """Of the output of ctest: the first test that it lists as failed."""
    failed = re.search(r"^\s*\d+ - (\S+) \((.+)\)$", ended.output, re.MULTILINE)
    return failed.group(1) if failed else f"status {ended.status}"


def disagreements_by_kind(table):
    """Of the CSV table of `pcm verify --out`: at how many poses engine and oracle disagree about what, by its name."""
    kinds = {}
    with open(table, newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            for column, value in row.items():
                name = re.fullmatch(r"(.+) disagreements", column or "")
                if name and value.isdigit() and int(value) > 0:
                    kinds[name.group(1)] = kinds.get(name.group(1), 0) + int(value)
    return kinds


def verdict(output):
    """Of the last line of `pcm verify`: how many poses, at how many of them engine and oracle disagree."""
    found = re.search(r"^.*: (\d+) poses.*, (\d+) disagreements.*$", output, re.MULTILINE)
    return (int(found.group(1)), int(found.group(2)), found.group(0)) if found else None


class Checks:
    """The checks in one build folder. `build` makes the targets of a list there, of None all: a program is built when it
    is asked, since one before it may already have caught the mutant. `allowed` has the seconds of each command, once they
    were measured; `ladder` the numbers of poses of verify."""

    def __init__(self, folder, build, ladder=LADDER, allowed=None):
        self._folder = Path(folder)
        self._build = build
        self._ladder = ladder
        self._allowed = dict(allowed or {})
        self._env = dict(os.environ, MALLOC_PERTURB_="165", GLIBC_TUNABLES="glibc.malloc.tcache_count=0")

    def commands(self, name, room):
        """What is run for a check, by name: what has to be known to set its limits."""
        if name == "tests":
            return TEST_PROGRAMS[room]
        return [f"verify {poses}" for poses in self._ladder] if name == "verify" else ["suite"]

    def measured(self):
        """Seconds allowed, by command, as far as `check` was called with the unaltered sources."""
        return dict(self._allowed)

    def check(self, name, room, measure=False, passed=None):
        """One check; with `measure` it is the unaltered sources', whose time sets the limits. `passed` is what it found
        before where the mutant passed."""
        if name == "verify":
            return self._verify(measure, passed["poses"] if passed else 0)
        return {"tests": self._tests, "suite": self._suite}[name](room, measure)

    def is_enough(self, name, found):
        """Whether a check that found this would find nothing more."""
        return bool(found["by"]) or name != "verify" or found["poses"] >= max(self._ladder)

    def _run(self, key, command, measure, **options):
        ended = run(command, None if measure else self._allowed[key], **options)
        if measure:
            self._allowed[key] = int(_TIMES * ended.seconds) + _SECONDS_MORE
        return ended

    def _tests(self, room, measure):
        seconds = 0.0
        for program in TEST_PROGRAMS[room]:
            self._build([program.split("/")[-1]])
            command = [self._folder / "tests" / program, "--gtest_fail_fast", "--gtest_color=no"]
            ended = self._run(program, command, measure, env=self._env, cwd=self._folder)
            seconds += ended.seconds
            if ended.status != 0:
                return Finding(failed_test(ended), seconds)
        return Finding("", seconds)

    def _verify(self, measure, passed):
        seconds = 0.0
        out = self._folder / "mutant_verified"
        self._build(["pcm"])
        for poses in self._ladder:
            if poses <= passed:
                continue
            shutil.rmtree(out, ignore_errors=True)
            command = [self._folder / "pcm", "verify", "--poses", poses, "--seed", SEED, "--mode", "all", "--out", out]
            ended = self._run(f"verify {poses}", command, measure, env=self._env)
            seconds += ended.seconds
            if ended.status == 0:
                continue
            if ended.ran_out_of_time:
                return Finding("time limit", seconds, poses)
            if ended.status < 0:
                return Finding(signal.Signals(-ended.status).name, seconds, poses)
            said = verdict(ended.output)
            if said is None:
                last_line = (ended.output.strip().splitlines() or ["ended without a word"])[-1]
                return Finding(last_line[:200], seconds, poses)
            table = out / "verification.csv"
            kinds = disagreements_by_kind(table) if table.exists() else {}
            if said[1] == 0:
                return Finding("measure of accuracy", seconds, said[0], 0, kinds)
            first = max(kinds, key=kinds.get) if kinds else "disagreement"
            return Finding(first, seconds, said[0], said[1], kinds)
        return Finding("", seconds, max(self._ladder))

    def _suite(self, room, measure):
        del room
        self._build(None)
        # But those of the mutants themselves, which want their texts where they were.
        command = ["ctest", "--test-dir", self._folder, "-LE", "long", "-E", r"^Mutants\.", "--stop-on-failure"]
        command += ["-j", os.cpu_count() or 1]
        ended = self._run("suite", command, measure, env=self._env)
        return Finding("" if ended.status == 0 else failed_of_suite(ended), ended.seconds)
