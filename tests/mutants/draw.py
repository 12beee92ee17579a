# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutants drawn by chance, the same for the same seed and sources; where a file changes, its own are drawn anew.

The sources are formatted, and that is relied on: an operator between two operands has spaces on both sides, a sign, a
reference or a template's bracket has not.
"""

import hashlib
import math
import re
from functools import lru_cache
from itertools import islice
from pathlib import Path

from mutant import Mutant
from tokens import tokens_of

ROOMS = ("fast", "reference")

_ARITHMETIC = {
    "+": ["-"],
    "-": ["+"],
    "*": ["/"],
    "/": ["*"],
    "+=": ["-="],
    "-=": ["+="],
    "*=": ["/="],
    "/=": ["*="],
    "%": ["/"],
}
_COMPARISONS = {
    "<": ["<=", ">"],
    "<=": ["<", ">="],
    ">": [">=", "<"],
    ">=": [">", "<="],
    "==": ["!="],
    "!=": ["=="],
}
_LOGIC = {"&&": ["||"], "||": ["&&"], "&": ["|"], "|": ["&"], "^": ["|"], "&=": ["|="], "|=": ["&="]}

#: Calls and names that are easily taken for one another.
_EXCHANGED = {}
for _one, _other in [
    ("min", "max"),
    ("least", "greatest"),
    ("cwiseMin", "cwiseMax"),
    ("minCoeff", "maxCoeff"),
    ("low", "high"),
    ("lower", "upper"),
    ("front", "back"),
    ("any_of", "all_of"),
    ("inf", "sup"),
    ("floor", "ceil"),
    ("lower_bound", "upper_bound"),
    ("turned", "turned_back"),
    ("before", "after"),
]:
    _EXCHANGED[_one] = _other
    _EXCHANGED[_other] = _one
_SIDES = {"E": "F", "F": "E"}

#: Functions of one argument that may be forgotten.
_FORGOTTEN = {"abs", "opposite", "other", "absolute", "sqrt", "normalized", "cwiseAbs", "transpose"}

#: In a statement: nothing that a run could notice is lost with it.
_WITHOUT_EFFECT = ("= default", "= delete", ".reserve(", "++work.", "++posed.work.")

_BEFORE_A_SIGN = {"(", ",", "=", "return", "?", ":", "{", "[", "&&", "||", "+=", "-="}
_INTEGER = re.compile(r"([0-9]+)([uUlL]*)$")
_NO_PLAIN_STATEMENT = set(
    "return using struct class enum template namespace static const constexpr inline friend public private explicit "
    "case default else if for while do extern virtual typedef auto".split()
)


def _number_after(token):
    """Another number: the next integer, or twice or half as much."""
    integer = _INTEGER.match(token.text)
    if integer:
        value = int(integer.group(1))
        others = [str(value + 1) + integer.group(2)]
        if value > 0:
            others.append(str(value - 1) + integer.group(2))
        return others
    if token.text.lower().startswith("0x") and "p" not in token.text.lower():
        return []  # bits of a hash or of a mask
    if not token.text[-1].isdigit() and token.text[-1] not in "fF.":
        return []
    if not re.search("[1-9a-fA-F]", token.text.lower().removeprefix("0x").split("p")[0].rstrip("fF.")):
        return ["1.0"]  # twice or half as much would be the same
    return [f"(2 * {token.text})", f"({token.text} / 2)"]


def _statement_end(tokens, first):
    """The index of the `;` that ends the plain statement beginning at `first`, or None where it is none."""
    if tokens[first].kind != "word" or tokens[first].text in _NO_PLAIN_STATEMENT:
        return None
    depth = 0
    called = False
    for i in range(first, len(tokens)):
        text = tokens[i].text
        if text in "{}":
            return None
        if text in "([":
            depth += 1
            called = called or text == "("
        elif text in ")]":
            depth -= 1
        elif text == ";" and depth == 0:
            return i if called or i == first + 1 else None
        # Two words in a row declare something.
        elif depth == 0 and tokens[i].kind == "word" and i > first and tokens[i - 1].kind == "word":
            return None
        if depth < 0:
            return None
    return None


@lru_cache(maxsize=None)
def sites_in(text):
    """All faults that may be drawn in a text: of each kind a list of (offset, before, after)."""
    tokens = tokens_of(text)
    found = {}

    def add(kind, offset, before, after):
        found.setdefault(kind, []).append((offset, before, after))

    brackets = []  # that are open
    for i, token in enumerate(tokens):
        previous = tokens[i - 1] if i > 0 else None
        following = tokens[i + 1] if i + 1 < len(tokens) else None
        if token.kind == "sign" and token.spaced:
            for kind, table in (("arithmetic", _ARITHMETIC), ("comparison", _COMPARISONS), ("logic", _LOGIC)):
                for other in table.get(token.text, []):
                    add(kind, token.offset, token.text, other)
        elif token.text in ("-", "!", "~") and previous is not None and previous.text in _BEFORE_A_SIGN:
            add("sign", token.offset, token.text, "")
        elif token.kind == "number" and following is not None and following.text != ">":  # no template's
            for other in _number_after(token):
                add("constant", token.offset, token.text, other)
        elif token.kind == "word" and following is not None:
            if token.text in ("true", "false"):
                add("constant", token.offset, token.text, "false" if token.text == "true" else "true")
            elif token.text in _SIDES and [t.text for t in tokens[max(i - 2, 0) : i]] == ["Side", "::"]:
                add("side", token.offset, token.text, _SIDES[token.text])
            elif token.text in _EXCHANGED and previous is not None and previous.text in (".", "::", "=", "(", ","):
                add("call", token.offset, token.text, _EXCHANGED[token.text])
            elif token.text in _FORGOTTEN and following.text == "(" and previous is not None:
                if previous.text == "." and tokens[i + 2].text == ")":
                    add("call", previous.offset, text[previous.offset : tokens[i + 2].end], "")
                elif previous.text == "::" and tokens[i - 2].text == "std":
                    start = tokens[i - 2].offset
                    add("call", start, text[start : token.end], "")
                elif previous.text not in (".", "::", "->") and previous.kind != "word" and previous.text not in "*&>":
                    add("call", token.offset, token.text, "")
        if token.text in ("(", "[", "{"):
            brackets.append(token.text)
        elif token.text in (")", "]", "}") and brackets:
            brackets.pop()
        if token.text in ("{", "}", ";") and following is not None and (not brackets or brackets[-1] == "{"):
            end = _statement_end(tokens, i + 1)
            if end is not None:
                start = following.offset
                before = text[start : tokens[end].end]
                if "\n" not in before and not any(word in before for word in _WITHOUT_EFFECT):
                    add("statement", start, before, ";")
    return found


def sources_of(root, room):
    """The room's files that are drawn from, in a fixed order, with slashes."""
    root = Path(root)
    files = [path for path in (root / room).rglob("*") if path.suffix in (".h", ".cpp")]
    return sorted(path.relative_to(root).as_posix() for path in files)


def places_in(text, offsets):
    """Of each offset: its line, how many lines like that come before, and how far along the line it is; however far the
    line is indented."""
    places, like_it = {}, {}
    line_begins = 0
    wanted = sorted(set(offsets))
    at = 0
    for line in text.splitlines(keepends=True):
        stripped = line.strip()
        begin = line_begins + len(line) - len(line.lstrip())
        nth = like_it[stripped] = like_it.get(stripped, -1) + 1
        while at < len(wanted) and wanted[at] < line_begins + len(line):
            places[wanted[at]] = f"{stripped}\0{nth}\0{wanted[at] - begin}"
            at += 1
        line_begins += len(line)
    return places


def _uniform(*words):
    """Between 0 and 1, by a hash: the same in every version of Python."""
    digest = hashlib.sha256("\0".join(words).encode()).digest()
    return (int.from_bytes(digest[:6], "big") + 0.5) / 2**48


class Draw:
    """Draws one mutant after the other: a file by how much code it has, then a kind of fault, then a place.

    Each possible mutant has a weight, by which it is drawn first, and a waiting time of that rate, by chance (P.
    Efraimidis, P. Spirakis, Weighted random sampling with a reservoir, Inf. Process. Lett. 97 (2006)): all come in the
    order of their times, and what changes in one file puts off or brings forward none of another.
    """

    def __init__(self, root, room, seed):
        waiting = []
        for file in sources_of(root, room):
            text = (Path(root) / file).read_text(encoding="utf-8")
            sites = sites_in(text)
            places = places_in(text, (offset for of_kind in sites.values() for offset, _, _ in of_kind))
            size = len(tokens_of(text))
            for kind, of_kind in sites.items():
                rate = size / (len(sites) * len(of_kind))
                for offset, before, after in of_kind:
                    mutant = Mutant(room, file, offset, before, after, kind, place=places[offset])
                    time = -math.log(_uniform(str(seed), file, mutant.place, before, after)) / rate
                    waiting.append((time, mutant.id, mutant))
        self._drawn = [mutant for _, _, mutant in sorted(waiting, key=lambda one: one[:2])]

    def possible(self):
        """How many there are."""
        return len(self._drawn)

    def __iter__(self):
        return iter(self._drawn)


def first_drawn(root, room, seed, number):
    """The first of those that a campaign would draw, programs or not."""
    return list(islice(Draw(root, room, seed), number))
