"""Variables of a file of C as arguments of functions that use them, or call one that does.

    static float x, v;                        void step(float u, float *x, float *v)
    void step(float u) { x += v*dt; }   ->    { x[0] += v[0]*dt; }

A function is judged for all that they may hold when it is called: what they begin with is not used.
Those that no function changes are numbers, all others arrays of one entry.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from mechanics.claims.brackets import closing, depth
from mechanics.errors import InputError
from mechanics.program.c.tokens import blanked

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fF]?"
DECLARATOR = rf"\w+(?:\s*\[\s*\d+\s*\])?(?:\s*=\s*(?:{NUMBER}|\{{[^{{}};]*\}}))?"
DECLARED = re.compile(
    r"(?<![\w.])(?:(?:static|extern)\s+)*(?:double|float)\s+"
    rf"(?P<declarators>{DECLARATOR}(?:\s*,\s*{DECLARATOR})*)\s*;"
)
SIZE = re.compile(r"(?<![\w.])extern\s+(?:const\s+)?(?:int|size_t|unsigned)\s+(\w+)\s*;")
HEAD = re.compile(r"\b(\w+)\s*\(([^(){};]*)\)\s*\{")
STATEMENTS = frozenset(("if", "while", "for", "switch"))
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
    declarations = [m for m in DECLARED.finditer(text) if depth(text, m.start()) == 0]
    arrays = _variables(declarations)
    if not arrays or not functions or len({f.name for f in functions}) < len(functions):
        return _sized(text)
    bodies = {f.name: text[slice(*f.body)] for f in functions}
    heads = "\n".join(text[slice(*f.head)] for f in functions)
    inside = "\n".join(bodies.values())
    if any(_declared(inside, n) or re.search(rf"\b{n}\b", heads) for n in arrays):
        return text
    calls = {name: {n for n in bodies if _calls(body, n)} for name, body in bodies.items()}
    tops = [name for name in bodies if all(name not in callees for callees in calls.values())]
    if function is None and len(tops) > 1:
        raise InputError(
            f"{', '.join(tops)} share variables of the file: --function (function=) says which"
            " is meant"
        )
    uses = _through_calls({k: {n for n in arrays if _used(b, n)} for k, b in bodies.items()}, calls)
    writes = _through_calls(
        {k: {n for n in arrays if _changed(b, n)} for k, b in bodies.items()}, calls
    )
    changed = set().union(*writes.values())
    passed = {name: [n for n in arrays if n in uses[name]] for name in bodies}
    parts, at = [], 0
    for f in functions:
        added = [
            f"{'const ' * (n not in writes[f.name])}double {'*' * (n in changed or arrays[n])}{n}"
            for n in passed[f.name]
        ]
        head = text[slice(*f.head)].strip()
        head = "" if head == "void" else head
        parts += [text[at : f.head[0]], ", ".join(filter(None, (head, *added)))]
        body = bodies[f.name]
        for n in passed[f.name]:
            if n in changed and not arrays[n]:
                body = re.sub(_use(n), f"{n}[0]", body)
        parts += [text[f.head[1] : f.body[0]], _with_arguments(body, passed)]
        at = f.body[1]
    text = "".join((*parts, text[at:]))
    for match in declarations:
        text = text.replace(match[0], blanked(match[0]), 1)
    return _sized(text)


def _variables(declarations: Iterable[re.Match[str]]) -> dict[str, bool]:
    """Names that are declared, and whether each is an array."""
    arrays: dict[str, bool] = {}
    for match in declarations:
        for declarator in re.sub(r"\{[^{}]*\}", "0", match["declarators"]).split(","):
            arrays[re.findall(r"\w+", declarator)[0]] = "[" in declarator
    return arrays


def _through_calls(
    own: Mapping[str, set[str]], calls: Mapping[str, set[str]]
) -> dict[str, set[str]]:
    """What functions have themselves, and by the functions that they call."""
    total = {name: {*some} for name, some in own.items()}
    for _ in calls:
        for name, callees in calls.items():
            total[name] |= set().union(*(total[callee] for callee in callees))
    return total


def _use(name: str) -> str:
    """Where a variable is used, and no member of that name."""
    return rf"(?<![\w.])(?<!->)\b{name}\b(?!\s*\()"


def _used(body: str, name: str) -> bool:
    return re.search(_use(name), body) is not None


def _changed(body: str, name: str) -> bool:
    return re.search(CHANGED.format(name, _use(name)), body) is not None


def _calls(body: str, name: str) -> bool:
    return re.search(rf"(?<![\w.])\b{name}\s*\(", body) is not None


def _declared(bodies: str, name: str) -> bool:
    """Whether a block declares the name again."""
    kinds = r"(?:double|float|int|long|short|char|unsigned|signed|bool|size_t|auto|\w+_t)"
    return re.search(rf"\b{kinds}\b[^;(){{}}]*?(?<![\w.=]){name}\b", bodies) is not None


def _functions(text: str) -> list[_Function]:
    """Functions that a file defines, in order."""
    functions = []
    for match in HEAD.finditer(text):
        if match[1] in STATEMENTS or depth(text, match.start()):
            continue
        body = match.end(), closing(text, match.end() - 1)
        functions.append(_Function(match[1], match.span(2), body))
    return functions


def _with_arguments(body: str, passed: Mapping[str, Sequence[str]]) -> str:
    """A body whose calls pass these on."""
    for name, own in passed.items():
        at = 0
        while own and (call := re.compile(rf"(?<![\w.])\b{name}\s*\(").search(body, at)):
            end = closing(body, call.end() - 1, "()") - 1
            arguments = ", ".join(filter(None, (body[call.end() : end].strip(), *own)))
            body = f"{body[: call.end()]}{arguments}{body[end:]}"
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
