# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""C++ as tokens, as far as drawing faults needs it: a file is not parsed, only cut up."""

import re
from dataclasses import dataclass
from functools import lru_cache

_TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"(?P<mark>[^()\\\s]*)\(.*?\)(?P=mark)")
  | (?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
  | (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<number>0[xX][0-9a-fA-F.']*(?:[pP][+-]?[0-9]+)?[uUlLfF]*|\.?[0-9](?:[eE][+-]|[0-9a-zA-Z.'])*)
  | (?P<word>[A-Za-z_][A-Za-z0-9_]*)
  | (?P<mark_of_operation><<=|>>=|<=>|->\*|\.\.\.|[-+*/%&|^=!<>]=|&&|\|\||\+\+|--|->|::|<<|[-+*/%&|^~!=<>?:;,.(){}\[\]])
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)

#: What holds at compile time or is compiled out of a release build: no run could notice a fault there.
_UNSEEN = {"assert", "static_assert"}


@dataclass(frozen=True)
class Token:
    kind: str  # number, word or sign
    text: str
    offset: int
    spaced: bool  # white space on both sides

    @property
    def end(self):
        return self.offset + len(self.text)


def _is_space(text, at):
    return at < 0 or at >= len(text) or text[at].isspace()


def _closing(tokens, opening, open_text, close_text):
    """The index of the token that closes the bracket at `opening`."""
    depth = 0
    for i in range(opening, len(tokens)):
        if tokens[i].text == open_text:
            depth += 1
        elif tokens[i].text == close_text:
            depth -= 1
            if depth == 0:
                return i
    return len(tokens) - 1


def _seen(tokens):
    """Without assertions and [[attributes]]."""
    kept = []
    i = 0
    while i < len(tokens):
        following = tokens[i + 1].text if i + 1 < len(tokens) else ""
        if tokens[i].text in _UNSEEN and following == "(":
            i = _closing(tokens, i + 1, "(", ")") + 1
        elif tokens[i].text == "[" and following == "[":
            i = _closing(tokens, i, "[", "]") + 1
        else:
            kept.append(tokens[i])
            i += 1
    return kept


@lru_cache(maxsize=None)
def tokens_of(text):
    """Numbers, words and signs of a file, in its order. Left out: comments, strings, directives, assertions."""
    tokens = []
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup
        if kind in ("comment", "raw", "text", "directive", "mark"):
            continue
        if kind == "mark_of_operation":
            kind = "sign"
        spaced = _is_space(text, match.start() - 1) and _is_space(text, match.end())
        tokens.append(Token(kind, match.group(), match.start(), spaced))
    return _seen(tokens)
