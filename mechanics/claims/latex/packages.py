r"""Commands of the packages that people write physics with, as what LaTeX itself has.

    \dv[2]{x}{t} + \qty(\frac{g}{l}) \sin[2](x)    ->    \frac{d^2 x}{d t^2} + \left(...\right) ...

From `physics`, `derivative`, `diffcoeff` and `siunitx`. What is not understood stays as it is, so
that its line is not read, and the message names the command.
"""

import re

from mechanics.claims.latex.token_stream import Pending

BODIES: dict[str, str] = {
    **dict.fromkeys(("vb", "vectorbold"), r"\mathbf{#1}"),
    **dict.fromkeys(("va", "vectorarrow"), r"\vec{#1}"),
    **dict.fromkeys(("vu", "vectorunit"), r"\hat{#1}"),
    **dict.fromkeys(("cross", "crossproduct", "cp"), r"\times"),
    **dict.fromkeys(("vdot", "dotproduct", "dp"), r"\cdot"),
    **dict.fromkeys(("flatfrac",), r"\frac{#1}{#2}"),
    **dict.fromkeys(("abs", "absolutevalue", "vqty"), r"\left|#1\right|"),
    **dict.fromkeys(("pqty",), r"\left(#1\right)"),
    **dict.fromkeys(("bqty",), r"\left[#1\right]"),
    **dict.fromkeys(("Bqty",), r"\left\{#1\right\}"),
    **dict.fromkeys(("eval", "evaluated"), r"\left.#1\right|"),
    **dict.fromkeys(("order",), r"\mathcal{O}(#1)"),
    **dict.fromkeys(("qq", "qqtext"), r"\quad\text{#1}\quad"),
    **dict.fromkeys(("qc", "qcomma"), r",\quad"),
    **{
        f"q{word}": rf"\quad\text{{{word}}}\quad"
        for word in (
            "if", "then", "else", "otherwise", "unless", "given", "using", "assume", "since", "let",
            "for", "all", "and", "or", "as", "in",
        )
    },
    **dict.fromkeys(("pmqty", "spmqty"), r"\begin{pmatrix}#1\end{pmatrix}"),
    **dict.fromkeys(("bmqty", "sbmqty"), r"\begin{bmatrix}#1\end{bmatrix}"),
    **dict.fromkeys(("vmqty", "svmqty", "mdet", "matrixdeterminant"),
                    r"\begin{vmatrix}#1\end{vmatrix}"),
}  # fmt: skip
"""Of a command with its arguments in braces; a star behind it changes nothing that is said."""
ROUND, SQUARE, BRACES, BARS = ("(", ")"), ("[", "]"), ("{", "}"), ("|", "|")
QUANTITY = {
    ROUND: BODIES["pqty"], SQUARE: BODIES["bqty"], BRACES: BODIES["Bqty"], BARS: BODIES["vqty"],
}  # fmt: skip
MATRIX = {
    ROUND: BODIES["pmqty"], SQUARE: BODIES["bmqty"], BARS: BODIES["vmqty"],
    BRACES: r"\begin{matrix}#1\end{matrix}",
}  # fmt: skip
BY_BRACKET = {
    "qty": QUANTITY, "quantity": QUANTITY,
    "mqty": MATRIX, "matrixquantity": MATRIX, "smqty": MATRIX,
}  # fmt: skip
"""Of a command whose meaning the bracket behind it gives."""
DERIVATIVES: dict[str, str] = {
    **dict.fromkeys(("dv", "derivative", "odv", "deriv", "diff"), "d"),
    **dict.fromkeys(("pdv", "pderivative", "partialderivative", "pderiv", "pdiff", "diffp"),
                    r"\partial"),
}  # fmt: skip
OPERATORS = frozenset(("dv", "derivative", "pdv", "pderivative", "partialderivative"))
"""Derivatives of which one argument is what it is by: \\dv{t} is d/dt."""
MIXED = frozenset(("pdv", "pderivative", "partialderivative"))
"""Of which a third argument is a second one that it is by."""
DIFFERENTIALS = frozenset(("dd", "differential", "odif"))
WITH_POWERS = frozenset((
    "sin", "cos", "tan", "csc", "sec", "cot", "sinh", "cosh", "tanh", "exp", "log", "ln",
))  # fmt: skip
POWER = re.compile(r"\[\s*(\d)\s*\](?=\()")
SIZES = frozenset((r"\big", r"\Big", r"\bigg", r"\Bigg"))
NUMBER = re.compile(r"\s*[-+]?[\d.,]+(?:[eE][-+]?\d+)?\s*")
"""As siunitx has it: \\qty{9.81}{m/s^2} is no bracket."""

PACKAGES = frozenset((*BODIES, *BY_BRACKET, *DERIVATIVES, *DIFFERENTIALS))
USES = re.compile(
    rf"\\(?:(?:{'|'.join(sorted(PACKAGES))})(?![A-Za-z@])|(?:{'|'.join(sorted(WITH_POWERS))})\[)"
)  # fmt: skip


def written_out(token: str, text: Pending, at: int) -> str | None:
    r"""What LaTeX itself has for a command of a package, its arguments taken from the text.

    Parameters
    ----------
    token : str
        The command, with its backslash.
    text : Pending
        What follows the command.
    at : int
        Where the command stands.

    Returns
    -------
    str or None
        None where it is no such command, or its arguments are none that are known: they stay.

    Raises
    ------
    Refused
        Where a bracket is not closed.
    """
    name = token[1:]
    if name in BODIES:
        return _body(token, text, at)
    if name in BY_BRACKET:
        return _by_bracket(BY_BRACKET[name], text, at)
    if name in DERIVATIVES:
        return _derivative(token, text, at)
    return _differential(text, at) if name in DIFFERENTIALS else None


def power_of(text: Pending) -> str:
    r"""The power behind a function, as LaTeX itself has it: the square of ``\sin[2](x)``."""
    power = POWER.match(text.tokens[-1][0]) if text.tokens else None
    if power is None:
        return ""
    chunk, place = text.tokens.pop()
    text.tokens.append((chunk[power.end() :], place + power.end()))
    return f"^{{{power[1]}}}"


def _body(token: str, text: Pending, at: int) -> str | None:
    body = BODIES[token[1:]]
    number = body.count("#")
    if number == 0:
        return body
    _pass_over(text)
    if not (text.peek() in ("{", "\\") or text.peek().isalpha()):
        return None
    for i in range(number):
        body = body.replace(f"#{i + 1}", text.argument(at, token))
    return body


def _by_bracket(bodies: dict[tuple[str, str], str], text: Pending, at: int) -> str | None:
    _pass_over(text)
    for (opens, closes), body in bodies.items():
        if text.peek() != opens:
            continue
        text.character()
        inner = text.inside(opens, closes, at)
        if text.peek() == "{" and NUMBER.fullmatch(inner):
            text.push(f"{opens}{inner}{closes}", at)
            return None
        return body.replace("#1", inner)
    return None


def _derivative(token: str, text: Pending, at: int) -> str | None:
    name = token[1:]
    mark, most = DERIVATIVES[name], 3 if name in MIXED else 2
    while text.peek() in ("*", "/", "!"):
        text.character()
    option = text.option(at)
    given: list[str] = []
    while len(given) < most and _next(text) == "{":
        given.append(text.argument(at, token))
    by = [part.strip() for part in ",".join(given[1:] or given).split(",")]
    order = (option or "1").strip()
    short = len(given) == 1 and name in OPERATORS
    plain = order in "123456789" and (len(by) == 1 or order == "1")
    if not plain or not (short or len(given) > 1):
        behind = "".join(f"{{{one}}}" for one in given)
        text.push(behind if option is None else f"[{option}]{behind}", at)
        return None
    of, power = "" if short else given[0], "" if order == "1" else f"^{order}"
    above = power if len(by) == 1 else f"^{len(by)}"
    below = " ".join(f"{mark} {one}{power}" for one in by)
    return rf"\frac{{{mark}{above} {_one(of)}}}{{{below}}}"


def _differential(text: Pending, at: int) -> str:
    option = text.option(at)
    power = f"^{option}" if option else ""
    if _next(text) != "{":
        return f"d{power} "
    return f"d{power} {_one(text.argument(at, 'dd'))}"


def _one(argument: str) -> str:
    """An argument as one factor."""
    return f"{{{argument}}}" if re.search(r"[-+\u2212]", argument) else argument


def _next(text: Pending) -> str:
    text.skip()
    return text.peek()


def _pass_over(text: Pending) -> None:
    r"""Take a star or a size: ``\qty*\Big(``."""
    while _next(text) == "*" or (text.tokens and text.tokens[-1][0] in SIZES):
        text.character()
