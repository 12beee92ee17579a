# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does anything notice a small fault? Builds mutants of the engine and of the oracle, one at a time, and checks them.

A copy of the sources is built in build/mutants. What became of each mutant is added to tests/mutants/results.jsonl as
soon as it is known, and holds until its file changes; a run goes on from there. Those chosen by hand come first, then
those drawn.
"""

import argparse
import os
import signal
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # nothing of ours among the sources

import report
from campaign import Campaign, Refused, Results, is_of_text, picked_mutants
from checks import CHECKS, LADDER, MachineFailed
from draw import ROOMS, Draw, first_drawn
from hand_picked import PICKED
from mutant import BadMutant, by_hand
from scratch import CannotBuild

ROOT = Path(__file__).resolve().parents[2]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawn", nargs="?", type=count_or_none, default=200, help="how many to draw in each room (default 200)")
    parser.add_argument("--rooms", default=",".join(ROOMS), help="fast, reference or both (default)")
    parser.add_argument("--seed", type=int, default=1, help="of the draw (default 1)")
    parser.add_argument("--checks", default=",".join(CHECKS), help="some of tests, verify, suite (default all)")
    parser.add_argument("--all-checks", action="store_true", help="also ask the others when one check has caught it")
    ladder = ",".join(map(str, LADDER))
    of_verify = "of the runs of verify, one after the other (default %(default)s)"
    parser.add_argument("--poses", type=counts, default=ladder, help=of_verify)
    parser.add_argument("--again", action="store_true", help="ask survivors once more, where sources or checks changed")
    parser.add_argument("--no-picked", action="store_true", help="leave out those chosen by hand")
    parser.add_argument("--jobs", type=count, default=os.cpu_count() or 1, help="of the build")
    parser.add_argument("--folder", type=Path, default=ROOT / "build" / "mutants", help="default: build/mutants")
    results = ROOT / "tests" / "mutants" / "results.jsonl"
    parser.add_argument("--results", type=Path, default=results, help="default: tests/mutants/results.jsonl")
    parser.add_argument("--list", action="store_true", help="only print the mutants")
    parser.add_argument("--report", action="store_true", help="only write the tables of what is known so far")
    return parser.parse_args()


def count(text, least=1):
    """A whole number, not below the least one."""
    if not text.isascii() or not text.isdigit() or int(text) < least:
        raise argparse.ArgumentTypeError(f"{text!r} is no whole number from {least} on")
    return int(text)


def count_or_none(text):
    return count(text, least=0)


def counts(text):
    """Whole numbers with commas between them, in their order."""
    return tuple(sorted(count(one) for one in text.split(",")))


def one_of_each(text, allowed, what):
    names = text.split(",")
    for name in names:
        if name not in allowed:
            raise Refused(f"{what} {name} is none of {', '.join(allowed)}")
    return [name for name in allowed if name in names]


def read(file):
    return (ROOT / file).read_text(encoding="utf-8")


def still_holds(entry, possible):
    """Whether a result is of a mutant that the sources still allow, of a file that is what it was."""
    return entry["id"] in possible and is_of_text(entry, read(entry["file"]))


def possible_mutants(rooms):
    """All that the sources as they are allow, by id."""
    drawn = [mutant for room in rooms for mutant in Draw(ROOT, room, seed=0)]
    picked = [one for one in PICKED if one[0].split("/")[0] in rooms and read(one[0]).count(one[1]) == 1]
    return {mutant.id: mutant for mutant in drawn + [by_hand(file, *rest, read(file)) for file, *rest in picked]}


def print_mutants(options, rooms):
    mutants = [] if options.no_picked else picked_mutants(read, rooms)
    for room in rooms:
        mutants += first_drawn(ROOT, room, options.seed, options.drawn)
    for mutant in mutants:
        text = read(mutant.file)
        print(f"{mutant.file}:{mutant.line_in(text)}: {mutant.why or mutant.kind}: {mutant.shown_in(text)}")


def commit():
    """That of the sources; what is found changes none."""
    git = ["git", "-C", str(ROOT)]
    name = subprocess.run([*git, "rev-parse", "--short=7", "HEAD"], check=True, capture_output=True, text=True).stdout
    found = ":(exclude)tests/mutants/results.jsonl"
    changed = subprocess.run([*git, "diff", "--quiet", "HEAD", "--", ".", found], check=False)
    return name.strip() + ("-dirty" if changed.returncode else "")


def say(line):
    print(line, flush=True)


def main():
    options = arguments()
    rooms = one_of_each(options.rooms, ROOMS, "room")
    names = one_of_each(options.checks, CHECKS, "check")
    if options.list:
        print_mutants(options, rooms)
        return 0
    if not options.report:
        of_checks = (names, options.all_checks, options.poses, options.again)
        campaign = Campaign(ROOT, options.folder, options.results, commit(), *of_checks, options.jobs, say)
        campaign.prepare(rooms)
        campaign.run(rooms, options.drawn, options.seed, not options.no_picked)
    possible = possible_mutants(rooms)
    entries = [
        entry | {"code": possible[entry["id"]].shown_in(read(entry["file"]))}
        for entry in Results(options.results).all()
        if still_holds(entry, possible)
    ]
    report.write(entries, options.folder)
    print(report.summary_table(entries))
    survivors = sum(entry["state"] == "survived" for entry in entries)
    print(f"{survivors} survivors; tables: {options.folder}/mutants.md, mutants.csv")
    return 1 if survivors else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Refused, BadMutant, CannotBuild, MachineFailed) as error:
        print(f"mutants: {error}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("mutants: interrupted; the same command goes on from here", file=sys.stderr)
        sys.exit(128 + signal.SIGINT)
