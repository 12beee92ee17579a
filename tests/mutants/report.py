# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of the mutants, as Markdown and as CSV."""

import csv

from checks import CHECKS


def caught_first_by(entry):
    """The name of the first check that caught it, or what became of it otherwise."""
    for name in CHECKS:
        if entry["checks"].get(name, {}).get("by"):
            return name
    return entry["state"]


def _poses(entry):
    verify = entry["checks"].get("verify")
    return verify["poses"] if verify and verify["by"] else None


def _origin(entry):
    return "by hand" if entry["kind"] == "by hand" else "drawn"


def _row(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def _table(head, rows):
    return "\n".join([_row(head), "|---|" + "--:|" * (len(head) - 1), *map(_row, rows)]) + "\n"


def summary_table(entries):
    """By room and origin: how many, and which check caught them first."""
    groups = sorted({(entry["room"], _origin(entry)) for entry in entries})
    head = ["mutants", "programs", *(f"caught by {name}" for name in CHECKS), "survived", "not a program"]
    rows = []
    for room, origin in groups:
        of_group = [e for e in entries if (e["room"], _origin(e)) == (room, origin)]
        first = [caught_first_by(entry) for entry in of_group]
        rows.append(
            [f"{room}, {origin}", len(first) - first.count("not a program"), *map(first.count, CHECKS)]
            + [first.count("survived"), first.count("not a program")]
        )
    return _table(head, rows)


def verify_table(entries):
    """Of those that `pcm verify` was asked about: how many it caught, by the number of poses of the run."""
    asked = [entry for entry in entries if "verify" in entry["checks"]]
    lengths = sorted({_poses(entry) for entry in asked if _poses(entry) is not None})
    rows = []
    for room in sorted({entry["room"] for entry in asked}):
        poses = [_poses(entry) for entry in asked if entry["room"] == room]
        rows.append([room, len(poses), *map(poses.count, lengths), poses.count(None)])
    return _table(["room", "asked", *(f"caught in {n} poses" for n in lengths), "passed"], rows)


def _what(found):
    if not found:
        return "not asked"
    if not found["by"]:
        return "passed" + (f" {found['poses']} poses" if found.get("poses") else "")
    if found.get("disagreements"):
        return f"{found['by']} ({found['disagreements']} of {found['poses']} poses)"
    return found["by"] + (f" ({found['poses']} poses)" if found.get("poses") else "")


def _code(text):
    """As Markdown, around the fault where it is too long."""
    at, most = max(text.find("«") - 40, 0), 120
    if len(text) > most:
        text = ("..." if at > 0 else "") + text[at : at + most] + ("..." if at + most < len(text) else "")
    return "`" + text.replace("|", "\\|") + "`"


def mutants_table(entries):
    """One line a mutant, with the source's own as `code`, the fault between «»."""
    rows = []
    for entry in sorted(entries, key=lambda e: (e["room"], e["kind"] != "by hand", e["file"], e["line"])):
        fault = f"{entry['why'] or entry['kind']}: {_code(entry['code'])}"
        rows.append([f"{entry['file']}:{entry['line']}", fault, *(_what(entry["checks"].get(name)) for name in CHECKS)])
    return _table(["where", "fault", *CHECKS], rows).replace("--:|", "---|")


def markdown(entries):
    """All tables."""
    programs = [entry for entry in entries if entry["state"] != "not a program"]
    survivors = [entry for entry in entries if entry["state"] == "survived"]
    parts = ["# Mutants\n", summary_table(entries), "## Caught by `pcm verify`\n", verify_table(programs)]
    parts += ["## Survivors\n", mutants_table(survivors), "## All\n", mutants_table(programs)]
    return "\n".join(parts)


def write(entries, folder):
    """mutants.md and mutants.csv."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "mutants.md").write_text(markdown(entries), encoding="utf-8")
    with open(folder / "mutants.csv", "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        head = ["id", "room", "file", "line", "kind", "why", "before", "after", "state"]
        columns = ("by", "poses", "disagreements", "seconds")
        rows.writerow(head + [f"{name} {column}" for name in CHECKS for column in columns])
        for entry in entries:
            found = [entry["checks"].get(name, {}) for name in CHECKS]
            cells = [one.get(column, "") for one in found for column in columns]
            rows.writerow([entry[column] for column in head] + cells)
