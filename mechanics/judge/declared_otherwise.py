"""What a text or code declares of names, and the scene has otherwise.

#define G -9.81              the scene's g is positive
parameter Real l = m;        the scene's l and m have different units
double f(int theta)          the scene's theta is a real number
"""

import re
from collections.abc import Callable, Iterator, Sequence

from sympy import Pow, Symbol

from mechanics.claims.code.translation.cpp_functions import with_plain_types
from mechanics.claims.statement import Statement
from mechanics.judge.modelica import is_model, model_otherwise
from mechanics.judge.phrases import GIVEN
from mechanics.judge.scene_facts import SceneFacts
from mechanics.judge.types_of_numbers import units_of_types
from mechanics.scene.unit_names import Dimension, dimension_of_unit

DEFINED = re.compile(
    r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+\(?([^\n()]*)\)?[ \t\r]*$", re.MULTILINE
)
INITIAL = re.compile(r"(?<=[\s,:])(\w+)[({]\s*(-[\d.]+(?:[eE][-+]?\d+)?)\s*[)}]")
"""What a constructor begins with: P() : g(-9.81)."""
ALIAS = re.compile(
    r"(?:^|[\n,;:$&]|\\q?quad\b|\\[,;:! ]|\b(?:with|where|and|let|if|set|double|float|Real)\b)"
    r"[ \t]*"
    r"\\?(?P<name>[A-Za-z]\w*)[ \t]*:?=[ \t]*\\?(?P<other>[A-Za-z]\w*)[ \t]*(?=$|[\n,;.$])"
)
"""A name that is another one."""
SHAPES = (
    ("theta", "\u03b8\u03d1"), ("phi", "\u03c6\u03d5"), ("rho", "\u03c1\u03f1"),
    ("epsilon", "\u03b5\u03f5"), ("kappa", "\u03ba\u03f0"), ("sigma", "\u03c3\u03c2"),
)  # fmt: skip
"""Letters of two shapes, which are read as one name."""
LASTING = re.compile(r"\b(?:const|constexpr)\b[^;{}()]*;")
"""Of C++: what no line changes."""
NAMED = re.compile(r"\w+(?=\s*[={(]|\s+\(?0)")
"""What it names."""
KINDS = r"(?:int|long|short|signed|unsigned|char|bool|boolean|byte|word|u?int\w*_t)"
INTEGER = re.compile(rf"\b{KINDS}[ \t]+(?P<name>\w+)[ \t]*(?=[,;)\[])")
COUNTER = r"\bfor\s*\(\s*(?:\w+\s+)?{0}\s*=|\[\s*{0}\b"
"""Of a loop, or the place of an entry."""


def declared_otherwise(facts: SceneFacts, text: str) -> Iterator[str]:
    """What a text declares otherwise, in words."""
    yield from _outside(facts, text)
    yield from _aliases(facts, text)
    yield from _shapes(facts, text)
    if is_model(text):
        yield from model_otherwise(facts, text)


def declared_in_code(
    facts: SceneFacts, source: str, statements: Sequence[Statement]
) -> Iterator[str]:
    """What code declares otherwise, in words.

    Zero is an example of what is positive, no damping, but of what statements divide by, and of a
    constant: no line of such code has another value.
    """
    lasting = [m[0] for m in (*LASTING.finditer(source), *DEFINED.finditer(source))]
    names = (name for one in lasting for name in NAMED.findall(one))
    fixed = {facts.own_name(name) for name in names}

    def no_zero(symbol: Symbol) -> bool:
        return symbol.name in fixed or _divide(statements, symbol)

    yield from _outside(facts, _assignments(source), no_zero)
    yield from _integers(facts, source)
    for name, unit in units_of_types(source, {*(m.name for m in facts.known), *facts.names}):
        yield f"the text declares {name} in {unit}, which is no coherent unit of the SI"
    yield from _aliases(facts, "\n".join(m[0] for m in LASTING.finditer(source)))


def _aliases(facts: SceneFacts, text: str) -> Iterator[str]:
    """Names that are set to one of another unit."""
    for said in ALIAS.finditer(text):
        pair = [facts.own_name(said[key]) for key in ("name", "other")]
        one, other = (_dimension(facts, name) for name in pair)
        if one is not None and other is not None and one != other:
            yield f"the text has {said['name']} = {said['other']}, which differ in their units"


def _shapes(facts: SceneFacts, text: str) -> Iterator[str]:
    """Names of the scene that a text writes in two shapes: they may be two."""
    for name, letters in SHAPES:
        if not any(re.fullmatch(rf"{name}(?:_?\d)?", own) for own in facts.names):
            continue
        pairs = ((rf"\\{name}(?![A-Za-z])", rf"\\var{name}(?![A-Za-z])"), tuple(letters))
        if any(all(re.search(shape, text) for shape in pair) for pair in pairs):
            yield f"the text has {name} in two shapes, which are read as one name"


def _dimension(facts: SceneFacts, name: str) -> Dimension | None:
    unit = facts.unit(name)
    return dimension_of_unit(unit, "") if unit else None


def _integers(facts: SceneFacts, text: str) -> Iterator[str]:
    """Quantities of the scene that are declared as integers."""
    known = {match.name for match in facts.known} | facts.names
    text = with_plain_types(text)
    for said in INTEGER.finditer(text):
        if said["name"] in known and not re.search(COUNTER.format(said["name"]), text):
            yield f"{said['name']} is declared as an integer, the scene's is a real number"


def _assignments(source: str) -> str:
    """Code; a name that changes, as that of a sum, is no parameter in it."""
    text = INITIAL.sub(r"; \1 = \2 ;", DEFINED.sub(r"\1 = \2", source))
    every = re.findall(r"(?<![\w.])(\w+)[ \t]*(?:[-+*/.]?=(?!=)|\+\+|--)", text)
    changed = {name for name in every if every.count(name) > 1}
    return re.sub(r"(?<![\w.])(\w+)(?=[ \t]*=)", lambda m: "" if m[1] in changed else m[0], text)


def _divide(statements: Sequence[Statement], symbol: Symbol) -> bool:
    """Whether statements divide by what is zero with a symbol."""
    sides = [side for s in statements if s.row is not None for side in s.row.sides]
    powers = {power for side in sides for power in side.atoms(Pow) if power.has(symbol)}
    return any(p.exp.is_negative and p.base.subs(symbol, 0) == 0 for p in powers)


def _outside(
    facts: SceneFacts, text: str, no_zero: Callable[[Symbol], bool] = lambda symbol: True
) -> Iterator[str]:
    """Values that a text gives parameters, and that the scene's cannot have."""
    for said in GIVEN.finditer(text):
        symbol = facts.parameters.get(facts.own(said))
        number = float(re.sub(r"\s", "", said["number"].replace("\u2212", "-")))
        if symbol is None or number > 0 or (number == 0 and not symbol.is_positive):
            continue
        if number == 0 and not no_zero(symbol):
            continue
        if symbol.is_positive or symbol.is_nonnegative:
            value = f"{said['name']} = {said['number']}"
            yield f"the text has {value}, the scene's {symbol.name} is positive"
