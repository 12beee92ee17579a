# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines the fuzzers' corpora reach: a table by folder, of what `llvm-cov export -summary-only` says of each file.

usage: coverage.py ROOT < summary.json
"""

import json
import os
import sys

#: What hostile bytes are read by and what they are evaluated by. The rest is of other commands.
ROOMS = ("meshes", "fast", "reference", "compare")


def lines_by_folder(summary, root):
    """By folder, of each room and of all: lines, and how many of them are reached."""
    counts = {}
    for file in summary["data"][0]["files"]:
        path = os.path.relpath(file["filename"], root)
        folder = os.path.dirname(path)
        room = path.split(os.sep)[0]
        if room not in ROOMS:
            continue
        lines = file["summary"]["lines"]
        for name in {folder, room}:
            known = counts.get(name, (0, 0))
            counts[name] = (known[0] + lines["count"], known[1] + lines["covered"])
    return counts


def table(counts):
    rows = ["| folder | lines | reached | |", "|---|--:|--:|--:|"]
    for folder in sorted(counts):
        lines, reached = counts[folder]
        name = f"**{folder}**" if folder in ROOMS else folder
        rows.append(f"| {name} | {lines} | {reached} | {100 * reached / lines if lines else 0:.0f} % |")
    return "\n".join(rows)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(table(lines_by_folder(json.load(sys.stdin), os.path.abspath(sys.argv[1]))))


if __name__ == "__main__":
    main()
