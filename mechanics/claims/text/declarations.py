"""Lines of a function or model that say nothing of motion, blanked place by place.

function dz = f(t, z, p)        parameter Real J = m*l^2 "inertia";    ->    J = m*l^2
@SMatrix [a b; c d]  ->  [a b; c d]        m = param.m  ->  m = m        view(x, 1:2)  ->  x[1:2]
"""

import re
from collections.abc import Iterator

from mechanics.claims.text.initial import without_begin
from mechanics.program.c.tokens import blanked

HEADER = re.compile(
    r"^[ \t]*(?:(?:encapsulated|partial|@\w+)[ \t]+)*"
    r"(?:function|model|class|block|within)\b[^\n]*(?=\n)",
    re.MULTILINE,
)
FIELDS = re.compile(
    r"^[ \t]*\[[\w ,]+\][ \t]*=[ \t]*(?:deal\()?\w+\{:\}\)?[ \t]*;?[ \t\r]*$", re.MULTILINE
)
"""Parameters, taken out of a list of MATLAB's: [m, g] = param{:}."""
DOCUMENTED = re.compile(r'^[ \t]*(?:"{3}.*?"{3}|"[^"\n]*")[ \t]*$', re.MULTILINE | re.DOTALL)
"""Words on a function, alone on their lines."""
PARTED = re.compile(r"^[ \t]*\(;[\w ,]+\)[ \t]*=[ \t]*\w+[ \t]*$", re.MULTILINE)
"""Parameters, taken out of a record of Julia's by their names: (; m, g) = p."""
RECORD = re.compile(
    r"^[ \t]*(?:Base\.)?(?:@\w+[ \t]+)?(?:mutable[ \t]+)?struct\b.*?^[ \t]*end\b",
    re.MULTILINE | re.DOTALL,
)
"""A kind of record of Julia's: what its fields are, and of what kind."""
DECLARED = re.compile(
    r"^[ \t]*(?:(?:end|endfunction|return|nothing|equation|algorithm)\b[ \t]*\w*[ \t]*;?"
    r"|(?:global|persistent|clear|clc|close|format|load|addpath|disp)\b[^\n=]*"
    r"|(?:(?:(?:final|input|output|flow|discrete)[ \t]+)*(?:parameter|constant|Real)\b[^\n;]*;?"
    r"[ \t]*)+"
    r"|[\w, ()]+=[ \t]*(?:p|params|par)[ \t]*;?)[ \t\r]*$",
    re.MULTILINE,
)
"""Lines of a function or model that say nothing of it."""
MODEL = re.compile(r"^[ \t]*(?:equation|algorithm)\b", re.MULTILINE)
STRING = re.compile(r'"[^"\n]*"')
BLOCK = re.compile(r"/\*.*?\*/", re.DOTALL)
ANNOTATION = re.compile(r"\bannotation[ \t]*\([^;]*;")
BOUND = re.compile(r"(\b[^\W\d]\w*)[ \t]*(\([^;]*?\))?[ \t]*=(?!=)([^;,=]*);")
"""A name, what modifies it, and what it is bound to, at the end of a declaration."""
FORMULA = re.compile(r"(?<![\w.])(?!(?:e|E|true|false)\b)[^\W\d]\w*(?![\w.])")
"""A name in what is bound, which is no number and of no package."""
JULIA = re.compile(
    r"@(?:[SM](?:Matrix|Vector|Array)|views?|inbounds|fastmath)\b|\bSA(?:_F\d\d)?(?=\[)"
    r"|\b[SM](?:Vector|Matrix)(?:\{[^{}\n]*\})?(?=\()|(?<=\w)::[\w{}]+"
)
"""Kinds of arrays."""
LIST = re.compile(r"\b[SM]Vector(?:\{[^{}\n]*\})?\(([^()\[\]\n]*,[^()\[\]\n]*)\)")
"""An array by its entries."""
BRACKETS = re.compile(r"\w\[[ \t]*\d+[ \t]*\]|@[SM]Vector\b|\bSA\[")
"""What Julia has and MATLAB has not: there [a, b] is a column."""
VIEW = re.compile(r"\bview\((\w+),[ \t]*(\w+:\w+)\)")
WHOLE_ROW = re.compile(r"\([ \t]*(\d+)[ \t]*,[ \t]*:[ \t]*\)")
"""An entry of a column at all times: x(1, :)."""
FIELD = re.compile(
    r"(?<![\w.)\]])(?!(?:np|sp|sm|me|ca|cs|numpy|sympy|math|casadi|Math|Modelica)\.)"
    r"[^\W\d]\w*\.(?=[^\W\d_]\w*\b(?![ \t]*\())(?!(?:T|dt|diff)\b)"
)
"""What a parameter is a field of: param.m."""
FILLED = re.compile(
    r"^[ \t]*([^\W\d]\w*)\.([^\W\d]\w*)[ \t]*=[ \t]*"
    r"\d[\d.]*(?:[eE][-+]?\d+)?[ \t]*;?[ \t]*(?:[%#].*)?$",
    re.MULTILINE,
)
"""A record that a script gives a number: param.m = 2;"""
BARE = re.compile(r"(?<![\w.])[^\W\d]\w*\b(?!\.\w)")
"""A name that is no field, and of no record."""
FILLER = "\ue002"
"""What stands for it: no blank, which sets entries of a matrix apart."""
SIZED = re.compile(
    r"(?:^|(?<=;))[ \t]*\w+[ \t]*=[ \t]*(?:zeros|ones|similar)[ \t]*"
    r"\((?:[^()\n;]|\([^()\n;]*\))*\)[ \t]*(?:;|(?=\r?$))"
    r"|^[ \t]*(\w+)[ \t]*=[ \t]*\1(?:'|\(:\))[ \t]*;?[ \t\r]*$"
    r"|^[ \t]*\w+[ \t]*=[ \t]*\([ \t]*1[ \t]*:[ \t]*\d+[ \t]*\)'?[ \t]*;?[ \t\r]*$",
    re.MULTILINE,
)
"""The size of an array."""


RETURNED = re.compile(r"^[ \t]*return(?=[ \t]*[\[(\w])(?![ \t]+\w+[ \t]*;?[ \t]*$)", re.MULTILINE)
"""Before what a function gives back."""
MACRO = re.compile(r"^[ \t]*@\w+\b[^\n~]*$", re.MULTILINE)
OPERATOR = re.compile(
    r"\b(\w+)[ \t]*=[ \t]*(?:Differential\([ \t]*t[ \t]*\)|(\w+)\^2)(?=[ \t;]*$|;)", re.MULTILINE
)
"""Of ModelingToolkit: D = Differential(t); D2 = D^2."""
LISTED = re.compile(r"(\b\w+[ \t]*=[ \t]*\[)([^\[\]~]*~[^\[\]]*)\]")


BODY = re.compile(
    r"^[ \t]*function\b[ \t]*(?:\w+[ \t]*=[ \t]*)?[\w.!]+[ \t]*\(([^)\n]*)\)"
    r"(.*?)(?=^[ \t]*function\b|\Z)",
    re.MULTILINE | re.DOTALL,
)
"""A function of MATLAB or Julia: its arguments, and what follows."""
LEFT = re.compile(
    r"^[ \t]*return\b[^\n]*$(?!(?:\s|[%#][^\n]*$)*(?:end\b|endfunction\b|else|\Z))", re.MULTILINE
)
"""Where a function ends though more stands behind it."""


OPENED = re.compile(r"^[ \t]*[%#]\{[ \t\r]*$(?!.*^[ \t]*[%#]\}[ \t\r]*$)", re.MULTILINE | re.DOTALL)
"""A comment of MATLAB's over lines that nothing ends."""
MADE = re.compile(
    r"(?:^|(?<=;))[ \t]*(?P<name>\w+)[ \t]*=[ \t]*(?:zeros|ones|similar)[ \t]*\(", re.MULTILINE
)
"""Where an array is made, whatever its entries have been."""


def without_effect(text: str) -> Iterator[tuple[int, str]]:
    """Places of a text of functions where what is computed is lost, and why.

    ``du = [a, b]`` in a function of du gives the name to another array, ``du .= [a, b]`` does not.
    """
    if opened := OPENED.search(text):
        yield opened.start(), "this comment is not closed: close it, or remove it"
    for made in MADE.finditer(text):
        entry = re.compile(rf"(?<![\w.]){made['name']}[(\[][^=\n]*[)\]][ \t]*\.?=(?!=)")
        if entry.search(text, 0, made.start("name")):
            yield made.start("name"), f"{made['name']} is made anew: what it held is lost"
    for function in BODY.finditer(text):
        for one in LEFT.finditer(function[2]):
            yield function.start(2) + one.start(), "the function ends here: remove what follows"
        name = re.split(r"[,:;=\s]", function[1].strip())[0]
        new = name and re.search(
            rf"^[ \t]*{name}[ \t]*=[ \t]*(?:@\w+|SA)?[ \t]*\[", function[2], re.M
        )
        if new and not re.search(rf"^[ \t]*(?:return[ \t]+)?{name}[ \t]*$", function[2], re.M):
            words = (
                f"{name} is another array from here on, which the caller does not see: {name} .="
            )
            yield function.start(2) + new.start(), words


def operators(text: str) -> dict[str, int]:
    """Names of derivatives by the time that a text in Julia defines, and their orders."""
    found: dict[str, int] = {}
    for match in OPERATOR.finditer(text):
        of = match[2]
        if of is None or of in found:
            found[match[1]] = 1 if of is None else 2
    return found


def has_columns(text: str) -> bool:
    """Whether ``[a, b]`` is a column, as in Julia."""
    return HEADER.search(text) is not None and BRACKETS.search(text) is not None


def without_declarations(text: str) -> str:
    """The text of a function or model with blanks for its head, its end and what it declares."""
    if HEADER.search(text):
        text = LIST.sub(lambda m: f"[{m[1]}]".rjust(len(m[0])), text)
        text = JULIA.sub(_blank, text)
        text = PARTED.sub(_blank, DOCUMENTED.sub(_blank, text)).replace(" .= ", "  = ")
    text = RECORD.sub(_blank, text)
    text = FIELDS.sub(_blank, text)
    text = RETURNED.sub(_blank, SIZED.sub(_blank, text))
    if "~" in text:
        for lines in (MACRO, OPERATOR):
            text = lines.sub(_blank, text)
        text = LISTED.sub(lambda m: f"{' ' * len(m[1])}{m[2]} ", text)
    if not HEADER.search(text):
        return _without_owner(text)
    text = HEADER.sub(_blank, text)
    if MODEL.search(text):
        text = _model(text)
    text = VIEW.sub(lambda m: f"{m[1]}[{m[2]}]".ljust(len(m[0])), text)
    text = WHOLE_ROW.sub(lambda m: f"({m[1]})".ljust(len(m[0])), text)
    text = DECLARED.sub(_blank, text)
    return FIELD.sub(lambda m: FILLER * len(m[0]), text)


def _without_owner(text: str) -> str:
    """A script with the fields of its one record of numbers, which no other name is, as names."""
    filled = [(m[1], m[2]) for m in FILLED.finditer(text)]
    if len({owner for owner, _ in filled}) != 1:
        return text
    code = re.sub(r"[%#].*", "", text)
    bare = {m[0] for m in BARE.finditer(code)}
    owner = filled[0][0]
    fields = set(re.findall(rf"(?<![\w.]){owner}\.(\w+)", code))
    if bare & fields or owner in bare:
        return text
    return re.sub(rf"(?<![\w.]){owner}\.(?=[^\W\d])", lambda m: FILLER * len(m[0]), text)


def _blank(match: re.Match[str]) -> str:
    return blanked(match[0])


def _model(text: str) -> str:
    """A Modelica model with its equations, and what it declares as a formula."""
    for words in (STRING, BLOCK, ANNOTATION):
        text = words.sub(_blank, text)
    text = without_begin(text)
    start = MODEL.search(text)
    head = text[: start.start()] if start else ""
    return re.sub(r"[^;]*(?:;|\Z)", _declared, head) + text[len(head) :]


def _declared(statement: re.Match[str]) -> str:
    """A declaration as the formula that it binds a name to; blanks where it binds none."""
    blank = blanked(statement[0])
    bounds = BOUND.finditer(statement[0])
    before = ((one, statement[0][: one.start()]) for one in bounds)
    # Inside of brackets, as start = pi/4 is, it modifies a name.
    bound = next((one for one, left in before if left.count("(") == left.count(")")), None)
    if bound is None or not FORMULA.search(bound[3]):
        return blank
    named, modified = bound.end(1), bound.end(2) if bound[2] else bound.end(1)
    kept = statement[0][bound.start() : named] + blank[named:modified]
    kept += statement[0][modified : bound.end()]
    return blank[: bound.start()] + kept + blank[bound.end() :]
