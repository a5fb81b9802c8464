"""Variables of a file of C as arguments of functions that use them, or call one that does.

    static float x, v;                        void step(float u, float *x, float *v)
    void step(float u) { x += v*dt; }   ->    { x[0] += v[0]*dt; }

A function is judged for all that they may hold when it is called: what they begin with is not used.
Those that no function changes are numbers, all others arrays of one entry.
"""

import re
from dataclasses import dataclass

from mechanics.errors import InputError
from mechanics.program.c.tokens import blanked

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fF]?"
ONE = rf"\w+(?:\s*\[\s*\d+\s*\])?(?:\s*=\s*(?:{NUMBER}|\{{[^{{}};]*\}}))?"
DECLARED = re.compile(
    rf"(?<![\w.])(?:(?:static|extern)\s+)*(?:double|float)\s+(?P<ones>{ONE}(?:\s*,\s*{ONE})*)\s*;"
)
SIZE = re.compile(r"(?<![\w.])extern\s+(?:const\s+)?(?:int|size_t|unsigned)\s+(\w+)\s*;")
HEAD = re.compile(r"\b(\w+)\s*\(([^(){};]*)\)\s*\{")
WORDS = frozenset(("if", "while", "for", "switch"))
CHANGED = r"(?:&|\+\+|--)\s*{0}\b|{1}\s*(?:\[[^]]*\]\s*)?(?:[-+*/]?=(?!=)|\+\+|--)"


@dataclass(frozen=True)
class _Function:
    name: str
    head: tuple[int, int]
    body: tuple[int, int]


def with_globals(text: str, function: str | None = None) -> str:
    """The text, without comments, with its variables as arguments; as it is where it is not plain.

    Parameters
    ----------
    text : str
    function : str, optional
        Which is asked for.

    Raises
    ------
    InputError
        Where none is, and several are called by no other one: what only reads a variable or sets
        it to a number looks like a wrong formula.
    """
    functions = _functions(text)
    outside = [m for m in DECLARED.finditer(text) if _depth(text, m.start()) == 0]
    names: dict[str, bool] = {}  # whether it is an array
    for match in outside:
        inner = re.sub(r"\{[^{}]*\}", "0", match["ones"])
        for one in inner.split(","):
            names[re.findall(r"\w+", one)[0]] = "[" in one
    if not names or not functions or len({f.name for f in functions}) < len(functions):
        return _sized(text)
    uses = {f.name: {n for n in names if _used(text[slice(*f.body)], n)} for f in functions}
    inside = "\n".join(text[slice(*f.body)] for f in functions)
    heads = "\n".join(text[slice(*f.head)] for f in functions)
    if any(_declared(inside, n) or re.search(rf"\b{n}\b", heads) for n in names):
        return text
    writes = {
        f.name: {n for n in names if re.search(CHANGED.format(n, _use(n)), text[slice(*f.body)])}
        for f in functions
    }
    calls = {
        f.name: {o.name for o in functions if _calls(text[slice(*f.body)], o.name)}
        for f in functions
    }
    tops = [f.name for f in functions if all(f.name not in calls[o.name] for o in functions)]
    if function is None and len(tops) > 1:
        raise InputError(
            f"{', '.join(tops)} share variables of the file: --function (function=) says which"
            " is meant"
        )
    for _ in functions:
        for name, others in calls.items():
            uses[name] |= {n for other in others for n in uses[other]}
            writes[name] |= {n for other in others for n in writes[other]}
    changed = {n for own in writes.values() for n in own}
    pieces, at = [], 0
    for f in functions:
        own = [n for n in names if n in uses[f.name]]
        heads_of = [
            f"{'const ' * (n not in writes[f.name])}double {'*' * (n in changed or names[n])}{n}"
            for n in own
        ]
        given = text[slice(*f.head)].strip()
        given = "" if given == "void" else given
        pieces += [text[at : f.head[0]], ", ".join(filter(None, (given, *heads_of)))]
        pieces += [text[f.head[1] : f.body[0]]]
        body = text[slice(*f.body)]
        for n in own:
            if n in changed and not names[n]:
                body = re.sub(_use(n), f"{n}[0]", body)
        passed = {one.name: [n for n in names if n in uses[one.name]] for one in functions}
        pieces.append(_called(body, passed))
        at = f.body[1]
    done = "".join((*pieces, text[at:]))
    for match in outside:
        done = done.replace(match[0], blanked(match[0]), 1)
    return _sized(done)


def _use(name: str) -> str:
    """Where a variable is used, and no member of that name."""
    return rf"(?<![\w.])(?<!->)\b{name}\b(?!\s*\()"


def _used(body: str, name: str) -> bool:
    return re.search(_use(name), body) is not None


def _calls(body: str, name: str) -> bool:
    return re.search(rf"(?<![\w.])\b{name}\s*\(", body) is not None


def _declared(bodies: str, name: str) -> bool:
    """Whether a block declares the name again."""
    kinds = r"(?:double|float|int|long|short|char|unsigned|signed|bool|size_t|auto|\w+_t)"
    return re.search(rf"\b{kinds}\b[^;(){{}}]*?(?<![\w.=]){name}\b", bodies) is not None


def _functions(text: str) -> list[_Function]:
    """Functions that a file defines, in order."""
    found = []
    for match in HEAD.finditer(text):
        if match[1] in WORDS or _depth(text, match.start()):
            continue
        depth, end = 1, match.end()
        while depth and end < len(text):
            depth += (text[end] == "{") - (text[end] == "}")
            end += 1
        found.append(_Function(match[1], match.span(2), (match.end(), end)))
    return found


def _called(body: str, passed: dict[str, list[str]]) -> str:
    """A body whose calls pass these on."""
    for name, own in passed.items():
        at = 0
        while own and (call := re.compile(rf"(?<![\w.])\b{name}\s*\(").search(body, at)):
            depth, end = 1, call.end()
            while depth and end < len(body):
                depth += (body[end] == "(") - (body[end] == ")")
                end += 1
            given = body[call.end() : end - 1]
            more = ", ".join(filter(None, (given.strip(), *own)))
            body = f"{body[: call.end()]}{more}{body[end - 1 :]}"
            at = call.end()
    return body


def _sized(text: str) -> str:
    """The text without integers of other files that only say how many entries arguments have."""
    for match in SIZE.finditer(text):
        bracket = rf"\[\s*{match[1]}\s*\]"
        rest = text.replace(match[0], blanked(match[0]), 1)
        heads = re.sub(rf"(?<=\w)\s*{bracket}(?=\s*[,)])", lambda m: blanked(m[0]), rest)
        if not re.search(rf"\b{match[1]}\b", heads):
            text = re.sub(rf"(?<=\w)\s*{bracket}(?=\s*[,)])", "[]", rest)
    return text


def _depth(text: str, at: int) -> int:
    return text.count("{", 0, at) - text.count("}", 0, at)
