# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A campaign: one mutant after the other is built and checked, and what became of it is written down at once."""

import hashlib
import json
import os
import time
from dataclasses import asdict

from checks import Checks, Finding
from draw import ROOMS, Draw
from hand_picked import PICKED, PLANTED
from mutant import by_hand
from scratch import ANSWERING, CHECKING, CannotBuild, Scratch

#: What can become of a mutant.
CAUGHT, SURVIVED, NO_PROGRAM = "caught", "survived", "not a program"


class Refused(Exception):
    """The campaign cannot begin or go on, and why."""


class Results:
    """A file of JSON lines, one for each mutant that was checked; a later line takes the place of an earlier one."""

    def __init__(self, path):
        self._path = path
        self._lines = {}
        if path.exists():
            for line in path.read_text(encoding="utf-8").splitlines():
                try:
                    entry = json.loads(line)
                except json.JSONDecodeError:
                    continue  # cut off when a run was killed
                self._lines[entry["id"]] = entry

    def get(self, id):
        return self._lines.get(id)

    def all(self):
        return list(self._lines.values())

    def add(self, entry):
        self._lines[entry["id"]] = entry
        self._path.parent.mkdir(parents=True, exist_ok=True)
        torn = self._path.exists() and not self._path.read_bytes()[-1:] in (b"", b"\n")
        with open(self._path, "a", encoding="utf-8") as file:
            file.write(("\n" if torn else "") + json.dumps(entry) + "\n")
            file.flush()
            os.fsync(file.fileno())


def picked_mutants(read, rooms=ROOMS):
    """Those chosen by hand: in the order of their list, but headers, which many files include, last."""
    in_rooms = [picked for picked in PICKED if picked[0].split("/")[0] in rooms]
    in_rooms.sort(key=lambda picked: picked[0].endswith(".h"))
    return [by_hand(file, *rest, read(file)) for file, *rest in in_rooms]


def planted_mutant(read, room):
    file, before, after, why = PLANTED[room]
    return by_hand(file, before, after, why, read(file))


def refuse_no_program_by_hand(mutant, entry):
    """One that is drawn is replaced by the next; one chosen by hand that compiles no more is to be written anew."""
    if mutant.kind == "by hand" and entry["state"] == NO_PROGRAM:
        raise Refused(
            f"hand_picked.py: {mutant.file} does not compile with {mutant.after!r} in place of {mutant.before!r} "
            f"({mutant.why}):\n{entry['message']}"
        )


def digest_of(text):
    """By which it is told whether a file is as it was."""
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def is_of_text(entry, text):
    """Whether a result is of a file that is what it was."""
    return entry.get("text") == digest_of(text)


class Campaign:
    """`names` of checks; with `all_checks` each of them is asked of every mutant, otherwise until one has caught it.
    `ladder`: numbers of poses of verify. `results`: the file that what is found is read from and added to; `commit`: of
    the sources. `again`: survivors are asked once more what they passed."""

    def __init__(self, root, folder, results, commit, names, all_checks, ladder, again, jobs, say):
        self._folder, self._names, self._all_checks, self._ladder = folder, names, all_checks, ladder
        self._commit, self._again, self._jobs, self._say = commit, again, jobs, say
        self._scratch = Scratch(root, folder)
        self._results = Results(results)
        self._checks = {}  # by room: each has the times of its own programs
        self._answering = self._checking = ""

    def prepare(self, rooms):
        """The copy, built and checked without any fault, then with one that every check has to notice."""
        self._say("copying the sources and building them")
        self._scratch.refresh()
        self._answering, self._checking = self._scratch.digest(ANSWERING), self._scratch.digest(CHECKING)
        self._scratch.configure()
        for room in rooms:
            known = self._read_unaltered().get(self._key_of_unaltered(room), {})
            checks = self._checks[room] = Checks(self._scratch.build_folder, self._build, self._ladder, known)
            new = [name for name in self._names if not set(checks.commands(name, room)) <= set(known)]
            if new:
                self._check_unaltered(room, new)
                self._check_planted(room, new)
                self._keep_unaltered(room)

    def _build(self, targets):
        self._scratch.build(targets, self._jobs)

    def _key_of_unaltered(self, room):
        return " ".join([room, self._answering, self._checking])

    def _read_unaltered(self):
        path = self._folder / "unaltered.json"
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}

    def _keep_unaltered(self, room):
        passed = self._read_unaltered()
        passed[self._key_of_unaltered(room)] = self._checks[room].measured()
        (self._folder / "unaltered.json").write_text(json.dumps(passed, indent=1), encoding="utf-8")

    def _check_unaltered(self, room, names):
        for name in names:
            finding = self._checks[room].check(name, room, measure=True)
            self._say(f"{room}: {name} of the sources as they are: {finding.by or 'passed'}, {finding.seconds:.0f} s")
            if finding.by:
                raise Refused(f"the sources as they are fail {name} ({finding.by}): nothing can be told of mutants")

    def _check_planted(self, room, names):
        mutant = planted_mutant(self._scratch.read, room)
        entry = self._try(mutant, names, all_checks=True, found_before={})
        missed = [name for name in names if not entry["checks"].get(name, {}).get("by")]
        self._say(f"{room}: a planted fault: {entry['state']}")
        if entry["state"] != CAUGHT or missed:
            raise Refused(f"a planted fault in {room} is not noticed by {', '.join(missed) or 'any check'}")

    def _is_as_it_was(self, mutant, entry):
        return is_of_text(entry, self._scratch.read(mutant.file))

    def _holds(self, found):
        """Whether what a check found need not be asked again."""
        return bool(found["by"]) or not self._again or found.get("sources") == self._sources()

    def _found_before(self, mutant):
        """What checks have found of it, while its file is what it was; where survivors are asked again, only what caught
        it, and what it passed with the same sources and checks."""
        entry = self._results.get(mutant.id)
        if entry is None or not self._is_as_it_was(mutant, entry):
            return {}
        return {name: found for name, found in entry["checks"].items() if self._holds(found)}

    def _sources(self):
        return f"{self._answering} {self._checking}"

    def _is_known(self, mutant):
        """Whether nothing would be learnt by trying it again."""
        entry = self._results.get(mutant.id)
        if entry is None or not self._is_as_it_was(mutant, entry):
            return False
        if entry["state"] == NO_PROGRAM:
            return mutant.kind != "by hand" and not self._again
        found = self._found_before(mutant)
        if any(one["by"] for one in found.values()) and not self._all_checks:
            return True
        checks = self._checks[mutant.room]
        return all(name in found and checks.is_enough(name, found[name]) for name in self._names)

    def run(self, rooms, drawn, seed, picked):
        """Those chosen by hand in these rooms, if they are wanted, then `drawn` programs of each room."""
        if picked:
            for room in rooms:
                for mutant in picked_mutants(self._scratch.read, [room]):
                    self._visit(mutant)
        draws = {room: iter(Draw(self._scratch.source, room, seed)) for room in rooms}
        programs = {room: 0 for room in rooms}
        while draws:
            # In turns, so that a campaign that is cut short has seen both rooms.
            for room in list(draws):
                mutant = next(draws[room], None) if programs[room] < drawn else None
                if mutant is None:
                    del draws[room]
                    continue
                entry = self._visit(mutant)
                programs[room] += entry["state"] != NO_PROGRAM

    def _visit(self, mutant):
        if self._is_known(mutant):
            return self._results.get(mutant.id)
        begin = time.monotonic()
        entry = self._try(mutant, self._names, self._all_checks, self._found_before(mutant))
        entry["clock_seconds"] = round(time.monotonic() - begin, 1)
        refuse_no_program_by_hand(mutant, entry)
        self._results.add(entry)
        by = ", ".join(f"{name}: {found['by'] or 'passed'}" for name, found in entry["checks"].items())
        self._say(f"{entry['state']:<13} {entry['file']}:{entry['line']} {mutant.kind}  {by}")
        return entry

    def _try(self, mutant, names, all_checks, found_before):
        """Builds and checks one mutant, and puts the file back. What was found before is not looked for again."""
        text = self._scratch.read(mutant.file)
        checks = self._checks[mutant.room]
        entry = {
            "id": mutant.id,
            "room": mutant.room,
            "file": mutant.file,
            "line": mutant.line_in(text),
            "kind": mutant.kind,
            "why": mutant.why,
            "before": mutant.before,
            "after": mutant.after,
            "state": NO_PROGRAM,
            "checks": dict(found_before),
            "text": digest_of(text),
        }
        if found_before:
            entry["state"] = CAUGHT if any(found["by"] for found in found_before.values()) else SURVIVED
        try:
            self._scratch.write(mutant.file, mutant.applied_to(text))
            for name in names:
                found = found_before.get(name)
                if found and checks.is_enough(name, found):
                    continue
                finding = checks.check(name, mutant.room, passed=found)
                entry["checks"][name] = asdict(finding) | {"sources": self._sources(), "commit": self._commit}
                entry["state"] = CAUGHT if finding.by or entry["state"] == CAUGHT else SURVIVED
                if finding.by and not all_checks:
                    break
        except CannotBuild as error:
            if entry["checks"]:
                # One that is only no program together with what a later check is made of.
                entry["checks"][name] = asdict(Finding("does not compile"))
                entry["state"] = CAUGHT
            else:
                entry["message"] = str(error)[-400:]
        finally:
            self._scratch.write(mutant.file, text)
        return entry
