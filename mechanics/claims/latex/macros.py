r"""Commands of the person's own, put in before a text is read.

    \newcommand{\rate}[1]{\dot{#1}} ... \rate{x}    ->    \dot{x}        \let\phi\varphi

What TeX expands is expanded here, with limits. Definitions are blanked, and no line moves. One that
is not understood is refused where its command is used.
"""

import re
import unicodedata
from dataclasses import dataclass, field

from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.latex.comments import without_hidden
from mechanics.claims.latex.packages import PACKAGES, USES, WITH_POWERS, power_of, written_out
from mechanics.claims.latex.token_stream import Pending
from mechanics.claims.names import GREEK
from mechanics.claims.place import LARGEST_TEXT, Refused, refusal

DEFINES = re.compile(
    r"\\(?:(?:new|renew|provide|Declare(?:Robust|Math))(?:command|environment|Operator)|"
    r"[gex]?def|let|(?:New|Renew|Provide|Declare)DocumentCommand|DeclarePairedDelimiter|csname|catcode|math(?:code|chardef)|chardef)"
    r"(?![A-Za-z@])"
)
COMMANDS = frozenset(("newcommand", "renewcommand", "providecommand", "DeclareRobustCommand"))
UNREAD = frozenset((
    "edef", "xdef", "NewDocumentCommand", "RenewDocumentCommand", "ProvideDocumentCommand",
    "DeclareDocumentCommand", "DeclarePairedDelimiter",
))  # fmt: skip
OTHERS = frozenset((
    "def", "gdef", "let", "DeclareMathOperator", "newenvironment", "renewenvironment",
))  # fmt: skip
UNSAFE = frozenset(
    (
        "csname",
        "catcode",
        "expandafter",
        "futurelet",
        "scantokens",
        "mathcode",
        "mathchardef",
        "chardef",
    )
)
TAKES = {"frac": 2, "dfrac": 2, "tfrac": 2, "cfrac": 2, "sqrt": 1}
"""Commands of which a single command may be an argument."""

PRINTED = re.compile("[\u210b\u2112\U0001d434-\U0001d467\U0001d49c-\U0001d503]")
"""Letters as they are printed: a script or italic L."""
MOST_EXPANSIONS = 2000
LONGEST = 2 * LARGEST_TEXT
"""Characters that are put in, in all."""


@dataclass(frozen=True)
class Macro:
    r"""What a command stands for.

    Attributes
    ----------
    body : str
        With ``#1`` to ``#9``.
    arguments : int
    default : str or None
        Of the first argument.
    final : bool
        Whether the body is not expanded further: that of ``\let\a\b``.
    between : tuple of str
        What stands before and behind each argument of one that is made by ``\\def``.
    unread : str
        By what it is defined, where that is not understood.
    """

    body: str = ""
    arguments: int = 0
    default: str | None = None
    final: bool = False
    between: tuple[str, ...] = ()
    unread: str = ""


def expanded(text: str, origin: str) -> str:
    """The text with every command of the person's own put in.

    Raises
    ------
    InputError
        Where that cannot be, by line and column.
    """
    if len(text) > LARGEST_TEXT:
        return text
    text = PRINTED.sub(_letter, text)
    if not DEFINES.search(text) and not USES.search(text):
        return text
    try:
        return _Expansion().of(without_hidden(text))
    except Refused as reason:
        raise refusal(text, reason, origin) from None


def _letter(match: re.Match[str]) -> str:
    letter, name = unicodedata.normalize("NFKD", match[0]), unicodedata.name(match[0], "")
    if not letter.isascii():
        return match[0]
    return rf"\mathcal{{{letter}}}" if "SCRIPT CAPITAL" in name else letter


@dataclass
class _Expansion:
    known: dict[str, Macro] = field(default_factory=dict)
    count: int = 0
    length: int = 0
    depth: int = 0

    def of(self, text: str) -> str:
        self.input = Pending.of(text)
        out: list[str] = []
        while self.input.tokens:
            token, at = self.input.tokens.pop()
            self.depth += (token == "{") - (token == "}")
            out.append(self._one(token, at) if token[0] == "\\" else token)
            out.append("\n" * self.input.lines)
            self.input.lines = 0
        return "".join(out)

    def _one(self, token: str, at: int) -> str:
        """What a command leaves in the text; what it stands for is read next."""
        name = token[1:]
        if name in self.known:
            return self._put_in(token, self.known[name], at)
        if name in UNSAFE:
            raise Refused(at, f"{token} is not supported: write the equations without it")
        if name in COMMANDS | UNREAD | OTHERS:
            if self.depth > 0:
                raise Refused(at, f"{token} in braces or an environment: put it in front")
            self._define(name, at)
            return ""
        if name in ("begin", "end"):
            return self._environment(token, at)
        if name in ("begingroup", "bgroup", "endgroup", "egroup"):
            self.depth += 1 if name.startswith("b") else -1
        if name in PACKAGES:
            body = written_out(token, self.input, at)
            self._counted(len(body or ""), token, at)
            if body is not None:
                self._push(body, at)
                return ""
        if name in WITH_POWERS:
            return token + power_of(self.input)
        if name in TAKES:
            self._in_braces(TAKES[name])
            return token + " " * self.input.peek().isalnum()  # the blank of \\frac gL is read
        return token

    def _environment(self, token: str, at: int) -> str:
        self.input.skip()
        if self.input.peek() != "{":
            return token
        self.input.character()
        name = self.input.until("}", at)
        if name != "document":
            self.depth += 1 if token == r"\begin" else -1
        macro = self.known.get(f"{token[1:]} {name}")
        return f"{token}{{{name}}}" if macro is None else self._put_in(token, macro, at)

    def _put_in(self, token: str, macro: Macro, at: int) -> str:
        if macro.unread:
            raise Refused(at, f"{token} is defined by \\{macro.unread}, which is not read here")
        if macro.final:
            return macro.body
        given: list[str] = []
        if macro.default is not None:
            option = self.input.option(at)
            given.append(macro.default if option is None else option)
        if macro.between[:1] not in ((), ("",)):
            self.input.until(macro.between[0], at)
        while len(given) < macro.arguments:
            end = macro.between[len(given) + 1] if macro.between else ""
            given.append(self.input.until(end, at) if end else self.input.argument(at, token))
        longest = max(map(len, given), default=0)
        self._counted(len(macro.body) + macro.body.count("#") * longest, token, at)
        self._push(re.sub(r"#([1-9])", lambda m: _of(given, m[1], token, at), macro.body), at)
        return ""

    def _counted(self, length: int, token: str, at: int) -> None:
        self.count += 1
        self.length += length
        if self.count > MOST_EXPANSIONS or self.length > LONGEST:
            raise Refused(at, f"{token} expands too far: write out what it stands for")

    def _push(self, body: str, at: int) -> None:
        # What was two words stays two.
        before = " " if body[:1].isalnum() else ""
        after = " " if body[-1:].isalnum() else ""
        self.input.push(before + body + after, at)

    def _in_braces(self, arguments: int) -> None:
        r"""Put braces around a command that is an argument: ``\frac\a\b``."""
        held: list[tuple[str, int]] = []
        for _ in range(arguments):
            self.input.skip()
            if self.input.peek() in ("", "}", "["):
                break
            at = self.input.tokens[-1][1]
            token = self.input.character()
            if token == "{":
                held.append((f"{{{self.input.until('}', at)}}}", at))
            else:
                held.append((f"{{{token}}}" if token[1:] in self.known else token, at))
        for text, at in reversed(held):
            self.input.push(text, at)

    def _define(self, command: str, at: int) -> None:
        source = self.input
        if source.peek() == "*":
            source.character()
        if command in ("newenvironment", "renewenvironment"):
            self._define_environment(command, at)
            return
        name = self._name(at, command)
        if command in UNREAD:
            self.known[name] = Macro(unread=command)
        elif command == "let":
            self._let(name, at)
        elif command == "DeclareMathOperator":
            words = source.argument(at, f"\\{command}")
            self.known[name] = Macro(rf"\operatorname{{{words}}}")
        elif command in COMMANDS:
            number, default = self._number(command, at), source.option(at)
            body = source.argument(at, f"\\{command}")
            if command != "providecommand" or not (name in self.known or _printed(name)):
                self.known[name] = Macro(body, number, default)
        else:
            self._def(name, at)

    def _number(self, command: str, at: int) -> int:
        number = self.input.option(at)
        if number is not None and not re.fullmatch(r"\s*[0-9]\s*", number):
            raise Refused(at, f"\\{command}: {number[:20]!r} is no number of arguments")
        return int(number or 0)

    def _define_environment(self, command: str, at: int) -> None:
        name = self.input.argument(at, f"\\{command}")
        number, default = self._number(command, at), self.input.option(at)
        opening = self.input.argument(at, f"\\{command}")
        self.known[f"begin {name}"] = Macro(opening, number, default)
        self.known[f"end {name}"] = Macro(self.input.argument(at, f"\\{command}"))

    def _name(self, at: int, command: str) -> str:
        name = self.input.argument(at, f"\\{command}").strip()
        if not re.fullmatch(r"\\(?:[A-Za-z@]+|[^A-Za-z@\s])", name):
            raise Refused(at, f"\\{command}: {name[:20]!r} is no command")
        return name[1:]

    def _let(self, name: str, at: int) -> None:
        self.input.skip()
        if self.input.peek() == "=":
            self.input.character()
        meaning = self.input.argument(at, "\\let")
        if not re.fullmatch(r"\\(?:[A-Za-z@]+|.)|[^\\]", meaning, re.DOTALL):
            raise Refused(at, f"\\let: {meaning[:20]!r} is no command")
        known = self.known.get(meaning[1:]) if meaning[0] == "\\" else None
        # It keeps its meaning, whatever the other command is made later.
        self.known[name] = known or Macro(meaning, final=True)

    def _def(self, name: str, at: int) -> None:
        parameters = ""
        while self.input.tokens and self.input.peek() != "{":
            parameters += self.input.tokens.pop()[0]
        body = self.input.argument(at, "\\def")
        between = tuple(part.strip() for part in re.split(r"#[1-9]", parameters))
        self.known[name] = Macro(body, len(between) - 1, between=between)


def _of(given: list[str], number: str, token: str, at: int) -> str:
    if int(number) > len(given):
        raise Refused(at, f"{token} has no argument #{number}")
    return given[int(number) - 1]


def _printed(name: str) -> bool:
    """Whether LaTeX itself has such a command."""
    return name in FUNCTIONS or name.removeprefix("var") in GREEK or name in TAKES
