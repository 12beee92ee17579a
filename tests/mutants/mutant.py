# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mutant: one small fault in one source file."""

import hashlib
from dataclasses import dataclass


class BadMutant(Exception):
    """The text that a mutant replaces is not there, or not there alone."""


@dataclass(frozen=True)
class Mutant:
    """`before`, at `offset` of the file's text, is replaced by `after`."""

    room: str  # fast or reference
    file: str  # below the root, with slashes
    offset: int
    before: str
    after: str
    kind: str  # of fault: an operator's name, or `by hand`
    why: str = ""  # of one chosen by hand: what it breaks
    place: str = ""  # of one that is drawn: where it stands, told so that lines elsewhere may change

    @property
    def id(self):
        """The same for the same fault in the same place, wherever that has moved to in the file."""
        digest = hashlib.sha256("\0".join([self.file, self.place, self.before, self.after]).encode())
        return digest.hexdigest()[:10]

    def applied_to(self, text):
        """The file's text with the fault in it."""
        end = self.offset + len(self.before)
        if text[self.offset : end] != self.before:
            raise BadMutant(f"{self.file} does not have {self.before!r} at {self.offset}")
        return text[: self.offset] + self.after + text[end:]

    def line_in(self, text):
        """The number, from 1, of the line in which it begins."""
        return text.count("\n", 0, self.offset) + 1

    def shown_in(self, text):
        """The line that it stands in, the fault between «»."""
        begin, after = text.rfind("\n", 0, self.offset) + 1, self.offset + len(self.before)
        end = text.find("\n", after) if "\n" in text[after:] else len(text)
        return " ".join(f"{text[begin : self.offset]}«{self.before} → {self.after}»{text[after:end]}".split())


def by_hand(file, before, after, why, text):
    """A mutant given by the text it replaces, which must occur exactly once."""
    if text.count(before) != 1:
        raise BadMutant(f"{file} has {text.count(before)} times, not once: {before}")
    if before == after:
        raise BadMutant(f"{file}: nothing is changed: {before}")
    return Mutant(file.split("/")[0], file, text.index(before), before, after, "by hand", why)
