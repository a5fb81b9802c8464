r"""What of a text in LaTeX is left to be read, as TeX takes it: token by token.

\frac{a}{b} c    ->    \frac    {    a    }    {    b    }    c
"""

import re
from dataclasses import dataclass

from mechanics.claims.place import Refused

TOKEN = re.compile(r"\\(?:[A-Za-z@]+|.)|[{}\n]|[^\\{}\n]+|.", re.DOTALL)


@dataclass
class Pending:
    """What is left to be read, last token first; each with its place in the person's text."""

    tokens: list[tuple[str, int]]
    lines: int = 0

    @staticmethod
    def of(text: str) -> "Pending":
        """All of a text."""
        found = Pending([])
        found.push(text, 0, 1)
        return found

    def push(self, text: str, at: int, step: int = 0) -> None:
        """Put text in front of what is left; all of it has the place of what it stands for."""
        self.tokens += [(m[0], at + step * m.start()) for m in TOKEN.finditer(text)][::-1]

    def skip(self) -> None:
        """Pass over blanks; ends of lines are counted, so that no line moves."""
        while self.tokens and not self.tokens[-1][0].strip():
            self.lines += self.tokens.pop()[0].count("\n")
        if self.tokens:
            token, at = self.tokens[-1]
            bare = token.lstrip()
            self.tokens[-1] = (bare, at + len(token) - len(bare))

    def peek(self) -> str:
        """The first character of what comes."""
        return self.tokens[-1][0][:1] if self.tokens else ""

    def character(self) -> str:
        """Take one character, or a command."""
        token, at = self.tokens.pop()
        if token[0] == "\\" or len(token) == 1:
            return token
        self.tokens.append((token[1:], at + 1))
        return token[0]

    def until(self, end: str, at: int) -> str:
        """Take what stands before a bracket or text that ends it at this level, and that."""
        depth, found = 0, ""
        while self.tokens:
            token, place = self.tokens.pop()
            here = token.find(end) if depth == 0 and token[0] != "\\" else -1
            if here >= 0:
                found += token[:here]
                if rest := token[here + len(end) :]:
                    self.tokens.append((rest, place + here + len(end)))
                self.lines += found.count("\n")
                return found.replace("\n", " ")
            depth += (token == "{") - (token == "}")
            found += token
        raise Refused(at, f"{end!r} is missing behind this")

    def inside(self, opens: str, closes: str, at: int) -> str:
        """Take what stands in a bracket that was opened, others of its kind in it, and its end."""
        found = self.until(closes, at)
        while opens != closes and _open(found, opens) > _open(found, closes):
            found += closes + self.until(closes, at)
        return found

    def argument(self, at: int, command: str) -> str:
        """Take what stands in braces, or one token."""
        self.skip()
        if self.peek() in ("", "}"):
            raise Refused(at, f"an argument of {command} is missing")
        first = self.character()
        return self.until("}", at) if first == "{" else first

    def option(self, at: int) -> str | None:
        """Take what stands in square brackets, if any."""
        self.skip()
        if self.peek() != "[":
            return None
        self.character()
        return self.until("]", at)


def _open(text: str, bracket: str) -> int:
    """How often a bracket stands in a text outside of braces."""
    depth = count = 0
    for match in TOKEN.finditer(text):
        depth += (match[0] == "{") - (match[0] == "}")
        count += match[0].count(bracket) if depth == 0 and match[0][0] != "\\" else 0
    return count
