"""What a model of Modelica declares, by one table: what the table has not is not read.

parameter Real l(unit="m", min=0) = 1 "length";    prefixes, a type, attributes, a value, words
flow Real theta;                                   flow is in no row
Real theta(max=0);                                 limits a coordinate
"""

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from mechanics.claims.code.comments import comments, without_comments
from mechanics.claims.kinds import angular
from mechanics.claims.text.initial import assigned_again, definitions_of_begin
from mechanics.errors import SceneError
from mechanics.judge.scene_facts import SceneFacts
from mechanics.scene.unit_names import Dimension, dimension_of_unit
from mechanics.scene.units import rolled

MODEL = re.compile(
    r"^[ \t]*(?:(?:encapsulated|partial)[ \t]+)*(?:model|block|class)[ \t]+\w+", re.MULTILINE
)
EQUATIONS = re.compile(r"^[ \t]*(?:initial[ \t]+)?(?:equation|algorithm)\b", re.MULTILINE)
SECTION = re.compile(r"\b(?:protected|public)\b")
PREFIXES = ("parameter", "constant", "final", "input", "output")
OTHERS = ("flow", "stream", "discrete", "inner", "outer", "replaceable", "redeclare")
"""Words before a type that are not read."""
TYPES = {
    "Angle": "rad", "AngularVelocity": "rad/s", "AngularAcceleration": "rad/s^2",
    **dict.fromkeys(("Length", "Distance", "Position", "Radius", "Height"), "m"),
    "Velocity": "m/s", "Acceleration": "m/s^2", "Mass": "kg", "Time": "s", "Force": "N",
    "Torque": "N*m", "Inertia": "kg*m^2", "MomentOfInertia": "kg*m^2",
    "TranslationalSpringConstant": "N/m", "RotationalSpringConstant": "N*m/rad",
    "TranslationalDampingConstant": "N*s/m", "RotationalDampingConstant": "N*m*s/rad",
    "MechanicalImpedance": "N*s/m", "Damping": "1/s", "Frequency": "1/s",
    "Energy": "J", "Power": "W",
}  # fmt: skip
"""Types of Modelica's library, and their units; each other one but Real is not read."""
WHOLE = ("Integer", "Boolean")
OTHER_UNIT = "the scene's has another unit"
LIBRARY = ("SI", "SIunits", "Units", "Modelica")
HARMLESS = ("start", "fixed", "nominal", "displayUnit", "stateSelect", "quantity", "each")
"""Attributes that change no equation."""
KEPT = re.compile(r"(?:import[ \t]+(?:\w+[ \t]*=[ \t]*)?Modelica\.[\w.*{}, ]+"
                  r"|extends[ \t]+(?:\w+\.)*Icons\.\w+)\Z")  # fmt: skip
"""Statements beside declarations that say nothing of motion."""
TYPE = re.compile(r"type\s+(?P<name>\w+)\s*=\s*Real\s*(?P<attributes>\(.*\))?\s*", re.DOTALL)
"""A type of the model's own."""
WITHIN = re.compile(r"\bwithin\b[^;]*;")
STRING = re.compile(r'"(?:\\.|[^"\\])*"')
COMPONENT = re.compile(
    r"(?!(?:import|extends|type|function|record)\b)\.?(?P<type>[A-Za-z_][\w.]*)"
    r"(?P<size>\s*\[[^\]]*\])?\s+(?P<rest>[A-Za-z_].*)",
    re.DOTALL,
)
DECLARATOR = re.compile(
    r"(?P<name>\w+)\s*(?P<size>\[[^\]]*\])?\s*(?P<attributes>\(.*?\))?\s*"
    r"(?:=(?P<value>.*?))?(?P<words>\ue010\d+\ue011)?\s*(?:annotation\s*\(.*\))?\s*",
    re.DOTALL,
)
ATTRIBUTE = re.compile(r"\s*(?:each\s+|final\s+)*(\w+)\s*=(.*)", re.DOTALL)
NAME = re.compile(r"(?<![\w.\ue010])[A-Za-z_]\w*(?![\w(])(?!\s*\()")
NUMBER = r"\s*(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*"
TERM = re.compile(rf"[-+]?{NUMBER}(?:[*/]{NUMBER})*")
NUMERIC = re.compile(rf"\s*[-+]?{NUMBER}(?:[-+*/]{NUMBER})*")
POSITIVE = re.compile(r"(?:[\w.\s+*/^){},]|(?<![\w.])\()*")
"""A formula without a minus and a call: of what is positive, it is so."""
SPOKEN = frozenset((
    "equation", "algorithm", "initial", "end", "time", "if", "then", "else", "elseif", "for", "in",
    "loop", "when", "elsewhen", "true", "false", "and", "or", "not", "pi", "annotation", "Modelica",
))  # fmt: skip
"""Words of the language in equations."""


FUNCTIONS = frozenset((
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "sqrt", "exp",
    "log", "log10", "abs", "sign", "min", "max", "mod", "rem", "div", "floor", "ceil", "integer",
    "der", "pre", "noEvent", "smooth", "sample", "initial",
))  # fmt: skip
KNOWN = FUNCTIONS | {"pi", "time", "Real", "Integer", "Boolean"}
"""Names that are known without a declaration: what gives one another meaning is not read."""
PI = ("Modelica.Constants.pi", "acos(-1)", "2*asin(1)", "4*atan(1)")
CLASS = re.compile(
    r"(?<!\bend )\b(?:model|block|class|package|function|record|type|connector|operator)\s+"
    r"(?!function\b|record\b)'?(\w+)"
)
IMPORT = re.compile(r"\bimport\s+(?:(\w+)\s*=\s*)?\.?([\w.]+?)(?:\.(\*|\{[^{}]*\}))?\s*;")
RATE = re.compile(
    r"\bder\s*\(\s*(\w+)\s*\)\s*=\s*(\w+)\s*;|\b(\w+)\s*=\s*der\s*\(\s*(\w+)\s*\)\s*;"
)
"""A name for the rate of another one."""


@dataclass(frozen=True)
class Declared:
    """One declared name.

    Attributes
    ----------
    prefixes : tuple of str
    type, name, size, value, words : str
        Empty for what is not said.
    attributes : dict of str to str
    """

    prefixes: tuple[str, ...]
    type: str
    name: str
    size: str = ""
    value: str = ""
    words: str = ""
    attributes: dict[str, str] = field(default_factory=dict)


def is_model(text: str) -> bool:
    """Whether a text is a model of Modelica."""
    return MODEL.search(text) is not None and EQUATIONS.search(text) is not None


def model_otherwise(facts: SceneFacts, text: str) -> Iterator[str]:
    """What models declare otherwise than the scene, or as nobody reads it, in words."""
    yield from _other_meanings(text)
    models = _models(text)
    parts = {n for n in models if re.search(rf"^[ \t]*{n}[ \t]+\w+[^;\n]*;", text, re.MULTILINE)}
    for title, model in models.items():
        names: dict[str, Declared] = {}
        for one in _declarations(model):
            if isinstance(one, str):
                yield f"'{' '.join(one.split())[:60]}' is not read"
                continue
            names[one.name] = one
            if one.type in parts and one.attributes:
                yield f"what {one.name} changes of {one.type} is not read"
            if one.type not in parts:  # what a part declares is its own
                yield from _otherwise(facts, one, "" if title in parts else one.name)
        yield from _initially(names, model)
        yield from _moving_parameters(names)
        yield from _moved(facts, names.values(), _equations(model))
        for name in dict.fromkeys(NAME.findall(_equations(model))):
            if name not in names and name not in SPOKEN:
                yield f"nothing declares {name}"


def _moving_parameters(declared: Mapping[str, Declared]) -> Iterator[str]:
    """Parameters whose values are made of something else than numbers and parameters."""
    still = {n for n, one in declared.items() if {"parameter", "constant"} & {*one.prefixes}}
    for name in sorted(still):
        for other in dict.fromkeys(NAME.findall(declared[name].value)):
            if other not in still and other not in SPOKEN - {"time"}:
                yield f"'{name} = {declared[name].value}': {other} is no parameter, so {name} moves"


def _other_meanings(text: str) -> Iterator[str]:
    """What gives a name that is known another meaning."""
    code = STRING.sub(" ", without_comments(text, ".mo"))
    for name in CLASS.findall(code):
        if name in KNOWN or name in LIBRARY:
            yield f"{name} has another meaning here, which is not read"
    for alias, path, rest in IMPORT.findall(code):
        *places, last = path.split(".")
        pairs = [(alias or last, last)]
        if rest:
            places.append(last)
            parts = [part.split("=") for part in rest.strip("{}").split(",")]
            pairs = [(part[0].strip(), part[-1].strip()) for part in parts]
        library = places[:1] == ["Modelica"]
        for name, meaning in pairs:
            if (name in KNOWN and not (library and name == meaning)) or (
                name == "*" and not library
            ):
                yield f"{name} of {path} has another meaning here, which is not read"


def _moved(facts: SceneFacts, declared: Iterable[Declared], equations: str) -> Iterator[str]:
    """What declarations say of names that equations give values, and of rates."""
    orders: dict[str, tuple[str, int]] = {own: (own, 0) for own in facts.coordinates}
    pairs = [(m[1] or m[4], m[2] or m[3]) for m in RATE.finditer(equations)]
    for _ in pairs:
        for name, rate in pairs:
            first, order = orders.get(facts.own_name(name), ("", 0))
            if first:
                orders.setdefault(facts.own_name(rate), (first, order + 1))
    for one in declared:
        own = facts.own_name(one.name)
        if one.name in KNOWN:
            number = math.pi if one.value in PI else _number(one.value)
            if one.name != "pi" or number is None or abs(number - math.pi) > 1e-9:
                yield f"{one.name} has another meaning here, which is not read"
        rate = rf"\bder\s*\(\s*{one.name}\s*\)"
        if own in facts.parameters and re.search(rate, equations):
            yield f"the text has der({one.name}), the scene's {own} does not change"
        given = rf"{rate}|(?:^|;|\bequation\b)\s*{one.name}\s*:?=(?!=)"
        if one.value and not {"parameter", "constant"} & {*one.prefixes} and (
            own in facts.coordinates or own in facts.inputs or re.search(given, equations)
        ):  # fmt: skip
            yield f"'{one.name} = {one.value}' is one more equation: it is not read"
        first, order = orders.get(own, ("", 0))
        unit = one.attributes.get("unit", "") or TYPES.get(one.type.split(".")[-1], "")
        if order and unit and (mine := _dimension(facts, first)) is not None:
            seconds = dimension_of_unit("s", "") or ()
            rate_of = tuple(a - order * b for a, b in zip(mine, seconds, strict=True))
            yield from _unit_of(one, unit, rate_of)


def model_words(text: str) -> Iterator[str]:
    """What models say in words: of their names, and besides."""
    rest = text
    for one in (one for model in _models(text).values() for one in _declarations(model)):
        if isinstance(one, Declared) and one.words:
            rest = rest.replace(f'"{one.words}"', "", 1)
            yield f"{one.name} is the {one.words.removeprefix('the ')}"
    yield from comments(re.sub(r'\b(?:unit|displayUnit|quantity)\s*=\s*"[^"]*"', "", rest), ".mo")


def _models(text: str) -> dict[str, str]:
    """The models of a text by their names, each from its head to the next one's."""
    heads = list(MODEL.finditer(text))
    ends = [*(head.start() for head in heads[1:]), len(text)]
    return {head[0].split()[-1]: text[head.start() : end]
            for head, end in zip(heads, ends, strict=True)}  # fmt: skip


def _equations(text: str) -> str:
    """What stands behind the declarations, without words."""
    code = STRING.sub(" ", without_comments(text, ".mo"))
    start = EQUATIONS.search(code)
    inside = code[start.start() :] if start else ""
    return re.sub(r"\bend\s+\w+|\bannotation\s*\(.*?\)\s*;", " ", inside, flags=re.DOTALL)


def _initially(declared: Mapping[str, Declared], text: str) -> Iterator[str]:
    """What sections say of a name otherwise than once, or that nobody reads."""
    open_ones = [
        one.name
        for one in declared.values()
        if "parameter" in one.prefixes and one.attributes.get("fixed") == "false"
    ]
    code = STRING.sub(" ", without_comments(text, ".mo"))
    for name in assigned_again(code):
        yield f"an algorithm assigns {name} more than once, which is not read"
    for kind, statement in definitions_of_begin(code):
        name = re.split(r":?=", statement)[0].strip()
        if name in open_ones:
            open_ones.remove(name)
        else:
            yield f"'{statement[:60]}' of the initial {kind} is not read"
    for name in open_ones:
        yield f"fixed = false of {name} is not read: nothing says what it is"


def _declarations(text: str) -> Iterator["Declared | str"]:
    """Declarations, and statements that are none."""
    strings: list[str] = []

    def kept(match: re.Match[str]) -> str:
        strings.append(match[0][1:-1])
        return f"\ue010{len(strings) - 1}\ue011"

    code = STRING.sub(kept, WITHIN.sub(" ", without_comments(text, ".mo")))
    head, start = MODEL.search(code), EQUATIONS.search(code)
    if head is None:
        return
    stop = start.start() if start else len(re.sub(r"\bend\s+\w+\s*;?\s*\Z", "", code))
    body = re.sub(r"\A\s*\ue010\d+\ue011", "", code[head.end() : stop])
    own: dict[str, dict[str, str]] = {"Real": {}}
    for statement in _split(SECTION.sub(" ", body), ";"):
        words = statement.strip()
        if not words or words.startswith("annotation") or KEPT.match(words):
            continue
        if made := TYPE.fullmatch(words):
            own[made["name"]] = _attributes(made["attributes"], strings)
            continue
        prefixes = []
        while (first := words.split(None, 1)) and first[0] in (*PREFIXES, *OTHERS):
            prefixes.append(first[0])
            words = first[1] if len(first) > 1 else ""
        whole = COMPONENT.fullmatch(words)
        parts = _split(whole["rest"], ",") if whole else []
        found = [m for part in parts if (m := DECLARATOR.fullmatch(part.strip()))]
        if whole is None or len(found) < len(parts):
            yield re.sub("\ue010\\d+\ue011", "...", statement)
            continue
        for part in found:
            kind = "Real" if whole["type"] in own else whole["type"]
            attributes = own.get(whole["type"], {}) | _attributes(part["attributes"], strings)
            yield Declared(
                tuple(prefixes), kind, part["name"],
                (whole["size"] or part["size"] or "").strip(), (part["value"] or "").strip(),
                _text(part["words"] or "", strings), attributes,
            )  # fmt: skip


def _attributes(inside: str | None, strings: list[str]) -> dict[str, str]:
    """What modifies a name, by attribute; what is none stands for itself."""
    parts = [part for part in _split((inside or "()")[1:-1], ",") if part.strip()]
    pairs = [(ATTRIBUTE.fullmatch(part), part) for part in parts]
    return {m[1] if m else part.strip(): _text(m[2], strings) if m else "" for m, part in pairs}


def _text(words: str, strings: list[str]) -> str:
    return re.sub("\ue010(\\d+)\ue011", lambda m: strings[int(m[1])], words).strip()


def _split(text: str, sign: str) -> list[str]:
    """Parts between a sign outside of brackets."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if character == sign and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return parts


def _otherwise(facts: SceneFacts, one: Declared, name: str) -> Iterator[str]:
    """What a declaration says otherwise of one name, which may be none of the scene's."""
    own = facts.own_name(name)
    known, moves = own in facts.names, own in {*facts.coordinates, *facts.inputs}
    declared = f"the text declares {one.name}"
    for prefix in one.prefixes:
        if prefix in OTHERS:
            yield f"{declared} as {prefix}, which is not read"
        elif own in facts.coordinates and prefix in ("parameter", "constant", "input"):
            yield f"{declared} as {prefix}, the scene's moves"
        elif own in facts.parameters and prefix == "input":
            yield f"{declared} as input, the scene's is a parameter"
    if known and one.size:
        yield f"{declared} as an array, the scene's is a number"
    unit = one.attributes.get("unit", "") or TYPES.get(one.attributes.get("quantity", ""), "")
    if known and one.type in WHOLE:
        yield f"{one.name} is declared as an integer, the scene's is a real number"
    elif one.type not in ("Real", *WHOLE):
        *path, last = one.type.split(".")
        if last not in TYPES or path[:1] not in ([name] for name in LIBRARY):
            yield f"{declared} as {one.type}, which is not read"
        unit = unit or TYPES.get(last, "")
    if unit:
        yield from _unit_of(one, unit, _dimension(facts, own))
    yield from _values(facts, own, one, moves)


def _values(facts: SceneFacts, own: str, one: Declared, moves: bool) -> Iterator[str]:
    """What limits a name, or gives it a value that the scene's cannot have."""
    for name, value in one.attributes.items():
        number = _number(value)
        if name in ("min", "max"):
            fixed = not moves and {*one.prefixes} & {"parameter", "constant"}
            free = fixed and name == "min" and number is not None and number <= 0
            if not free:
                yield f"the text limits {one.name}: {name} = {value}"
        elif name != "unit" and name not in HARMLESS:
            yield f"'{name}' of {one.name} is not read"
    symbol = facts.parameters.get(own)
    for value in (one.value, one.attributes.get("start", "") if symbol is not None else ""):
        number = _number(value)
        if number is None:
            plain = re.sub(r"(?<=\d)[eE]-(?=\d)|\b(?:sqrt|abs|exp)(?=\()", "", value)
            if symbol is not None and value and not POSITIVE.fullmatch(plain):
                yield f"'{one.name} = {value}' is not read: write a number"
            continue
        if moves:
            yield f"the text has {one.name} = {value}, the scene's moves"
        elif symbol is not None and number < 0 and (symbol.is_positive or symbol.is_nonnegative):
            yield f"the text has {one.name} = {value}, the scene's {symbol.name} is positive"


def _number(text: str) -> float | None:
    """What a sum of products of numbers is; None for any other."""
    if not NUMERIC.fullmatch(text):
        return None
    total = 0.0
    for term in TERM.findall(text):
        first, *rest = re.split(r"([*/])", term)
        value = float("".join(first.split()))
        for sign, factor in zip(rest[::2], rest[1::2], strict=True):
            value = value * float(factor) if sign == "*" else value / (float(factor) or math.inf)
        total += value
    return total


def _unit_of(one: Declared, unit: str, mine: Dimension | None) -> Iterator[str]:
    """What a unit says otherwise than a dimension, if that is known."""
    powers = re.sub(r"(?<=[A-Za-z])(?=-?\d)", "^", unit.replace(".", "*"))
    below = re.sub(r"/\(([^()]*)\)", lambda m: f"/{m[1].replace('*', '/')}", powers)
    try:
        dimension = dimension_of_unit(below, "")
    except SceneError:
        yield f"the text declares {one.name} in {unit}, which is no coherent unit of the SI"
        return
    if mine is not None and dimension != mine:
        yield f"the text declares {one.name} in {unit}, {OTHER_UNIT}"


def _dimension(facts: SceneFacts, own: str) -> Dimension | None:
    if own in facts.coordinates:
        turns = facts.coordinates[own] in angular(facts.scene) | rolled(facts.scene)
        if facts.scene.rotations and not turns:
            return None
        return dimension_of_unit("rad" if turns else "m", "")
    unit = facts.unit(own)
    return dimension_of_unit(unit, "") if unit else None
