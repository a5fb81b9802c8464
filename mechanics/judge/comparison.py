r"""A sentence beside the scene: a table of what sentences say, and how the scene has that.

where $l$ is half the length of the rod      a convention: half-length of l
where $m$ is the mass of the carriage        against the scene, whose m is the pendulum's
The rod is massless.                         against the scene, whose rod has an inertia
where $m$ is the mass of the rod,            as the scene has it
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sympy import Expr

from mechanics.claims.declared_conventions import Declared, read_declared
from mechanics.errors import MechanicsError
from mechanics.judge import phrases as p
from mechanics.judge.counting import (
    convention_of,
    counted_from,
    direction,
    elongation,
    every_angle,
    from_equilibrium,
    input_with_minus,
    kind_of_angle,
    name_of,
    only_words,
    places,
    sense,
    slope,
    value_at_pi,
    vertical_sense,
    zero_in_line,
)
from mechanics.judge.geometry_facts import (
    about_centre,
    has_rod_twice_as_long,
    moves_with_time,
    other_shape,
)
from mechanics.judge.outcome import Outcome, Said, Unsettled
from mechanics.judge.scene_facts import RATIOS, SceneFacts
from mechanics.judge.sentences import bare
from mechanics.scene import Gravity, Particle, RigidBody
from mechanics.scene.loads import Force, Spring, Torque
from mechanics.scene.symbols import TIME
from mechanics.scene.unit_names import dimension_of_unit
from mechanics.symbolic import is_zero

HEADS = (
    (r"inertia", "kg*m^2"), (r"mass", "kg"), (r"stiffness|spring constant", "N/m"),
    (r"length|radius|diameter|distance|height|width", "m"), (r"torque|moment|couple", "N*m"),
    (r"force|weight", "N"), (r"acceleration|gravity", "m/s^2"),
    (r"(?<!angular )(?:speed|velocity)", "m/s"),
)  # fmt: skip
"""First nouns of what a name is, and their units."""
SCALE = re.compile(r"\b(?:per|constant|coefficient|ratio|number|factor|arm|density|unit)\b", re.I)
TORSION = re.compile(r"\b(?:torsion(?:al)?|rotational)\b", re.IGNORECASE)
JOINT = re.compile(r"\b(?:hinge|pivot|pin|joint|bearing)\b", re.IGNORECASE)
LINKED = re.compile(r"\u27e8\w+\u27e9 ?(?:is|are|be|being|denote|mean|stand|:)")
BEHIND_HEAD = re.compile(r"\b(?:of|on|at|in|from|to|about)\b")
OTHER_UNIT = re.compile(rf"(?<![^\W\d_])(?:{p.OTHER_UNIT})(?![^\W\d_])|°", re.IGNORECASE)
WHOSE = re.compile(r"\bof (?:the )?(?:\w+ )?(\w+)(?: (?:along|about|at|on|in|from|to|with)\b|$)")


@dataclass(frozen=True)
class Comparison:
    """A sentence beside the scene.

    Attributes
    ----------
    conventions : tuple of Declared
        How it counts, where the scene counts otherwise.
    against : tuple of str
        What it says that the scene has otherwise, in words.
    unsettled : tuple of str
        What makes statements others than those that are read, in words.
    rest : str
        Of it what nothing compares.
    """

    conventions: tuple[Declared, ...]
    against: tuple[str, ...]
    unsettled: tuple[str, ...]
    rest: str


def compared(facts: SceneFacts, sentence: str) -> Comparison:
    """A sentence with marks, beside the scene."""
    sentence = _with_the_angle(facts, sentence)
    conventions: list[Declared] = []
    against: list[str] = []
    unsettled: list[str] = []
    rest = list(sentence)
    for found, spans in _found(facts, sentence):
        if found is None:
            continue
        if isinstance(found, tuple):
            conventions += found
        elif isinstance(found, Unsettled):
            unsettled.append(found.words)
        elif found:
            against.append(found)
        for start, end in spans:
            rest[start:end] = " " * (end - start)
    left = "".join(rest)
    moving = facts.coordinates.keys() | facts.inputs
    more = [
        one[1] for one in p.NAMED.finditer(left)
        if facts.own_name(one[1]) in moving and not _only_denoted(left, one.start())
    ]  # fmt: skip
    if conventions and more:  # "phi_1 and phi_2 are measured from ...": of both, or of none
        unsettled.append(f"what the text says of {more[0]} beside that is not read")
    return Comparison(
        tuple(dict.fromkeys(conventions)), tuple(dict.fromkeys(against)), tuple(unsettled), left,
    )  # fmt: skip


def _with_the_angle(facts: SceneFacts, sentence: str) -> str:
    """A sentence that names no coordinate, with the name of the only angle of a scene."""
    named = any(facts.own_name(one[1]) in facts.coordinates for one in p.NAMED.finditer(sentence))
    if named or len(facts.angles) != 1:
        return sentence
    return p.THE_ANGLE.sub(f"\u27e8{facts.angles[0].symbol.name}\u27e9", sentence, count=1)


def _only_denoted(sentence: str, place: int) -> bool:
    """Whether a name stands there with what it is alone: u is the torque."""
    said = p.DENOTED.match(sentence, place)
    return said is not None and p.COUNTS.search(said["words"]) is None


def senses(facts: SceneFacts, sentence: str) -> bool:
    """Whether left, right or clockwise is said of what the scene counts the other way round."""
    found = (said for row in (p.TURNS, p.PUSHES) for said in row.finditer(sentence))
    return any(isinstance(sense(facts, said), tuple) for said in found)


def _found(facts: SceneFacts, sentence: str) -> Iterator[tuple[Outcome, list[tuple[int, int]]]]:
    for row, check in ROWS:
        for said in row.finditer(sentence):
            yield check(facts, said), [said.span()]
    yield from _features(facts, sentence)


def _half(facts: SceneFacts, said: Said) -> Outcome:
    return convention_of(facts, f"half-length of {name_of(said)}")


def _twice(facts: SceneFacts, said: Said) -> Outcome:
    return convention_of(facts, f"twice the length of {name_of(said)}")


def _quantity(facts: SceneFacts, unit: str, words: str) -> str:
    """What a parameter is said to be; ``the rod`` of a mass is the mass of the rod."""
    words = p.HANGING_PREPOSITION.sub("", words)
    what = {"kg": "mass", "m": "length"}.get(unit)
    thing = p.THINGS.fullmatch(words) or p.WITHOUT_A_BODY.fullmatch(words) or facts.bodies(words)
    return f"{what} of the {words}" if what and thing else words


def _to_an_end(facts: SceneFacts, said: Said) -> Outcome:
    """A length that is said to go to the end of a rod is no half of it."""
    own = facts.own(said)
    if facts.unit(own) != "m" or "half" in facts.meaning(own) or has_rod_twice_as_long(facts, own):
        return None
    return "" if only_words(said, p.OF_AN_END | facts.words, facts) else None


def _whole(facts: SceneFacts, said: Said) -> Outcome:
    own = facts.own(said)
    if "half" not in facts.meaning(own) and not has_rod_twice_as_long(facts, own):
        return None
    return read_declared([f"twice the length of {name_of(said)}"], facts.known)


def _to_centre(facts: SceneFacts, said: Said) -> Outcome:
    own = facts.own(said)
    ratio = facts.ratio(own)
    if own not in facts.parameters:
        return None
    if ratio == 1:
        words = re.split(r"[,;\u27e8]|\.(?!\d)", said.string[said.end("name") + 1 :], maxsplit=1)[0]
        far = p.FAR_END.search(words) and not p.FAR_END.search(facts.meaning(own))
        if far or _another_number(own, words):
            have = f"the text says {bare(said.string)!r}"
            return f"{have}, the scene's {own} is the {facts.meaning(own)}"
        return "" if only_words(said, p.TO_A_CENTRE | facts.words, facts) else None
    if ratio in RATIOS:
        return read_declared([f"half-length of {name_of(said)}"], facts.known)
    words = f"the text says that {name_of(said)} is the distance to a mass centre"
    return f"{words}, but {own} of the scene is not"


def _denoted(facts: SceneFacts, said: Said) -> Outcome:
    """What the words behind a name say of the scene's symbol."""
    own, words = facts.own(said), said["words"].strip()
    if own not in facts.names or (said["formula"] and not LINKED.match(said[0])):
        return None  # a mass ⟨m⟩, a length ⟨l⟩
    text = f"the text says that {name_of(said)} is the {words}"
    if own not in facts.parameters:
        if own in facts.inputs and p.SCALED.search(words):
            return text
        if _other_sort(facts, own, words):
            return f"{text}, which {own} of the scene is not"
        if own in facts.coordinates and _of_another_place(facts, words):
            return f"{text}, which no body of the scene is"
        return "" if facts.is_called(own, words) or places(facts, own, words) else None
    meaning, unit = facts.meaning(own), facts.unit(own)
    words = _quantity(facts, unit, words)
    if p.SCALED.search(words):
        return text if "/" not in unit else None
    have = f"{text}, the scene's {own} is the {meaning or f'one in {unit}'}"
    behind = said.string[said.start("words") + len(said["words"].rstrip()) :]
    if facts.is_called(own, words):
        return None if p.SHARED.search(said["words"]) or p.SHARED.match(behind) else ""
    if (role := _of_other_role(facts, own, words)) == "":
        return ""
    if other := role or _another(facts, own, words):
        return f"{have}, and {other} is that"
    wrong = (
        _contrary(meaning, words) or _of_another_body(facts, own, words) or _other_kind(unit, words)
    )
    wrong = wrong or (words.startswith("total mass") and p.OF_TWO.match(behind) is not None)
    if wrong or _other_distance(facts, said, meaning, words):
        return have
    if facts.is_sole(own):
        return None
    whose = _same_thing(facts, own, words)
    if whose is None:
        return None
    known = frozenset(map(facts.alike, p.OF_QUANTITIES)) | whose
    return "" if facts.nouns(words) <= known and not p.SHARED.match(behind) else None


def _several(facts: SceneFacts, said: Said) -> Outcome:
    """Names that are called masses, lengths or springs: two rods l1, l2."""
    names = [facts.own_name(n) for n in p.NAMED.findall(said["names"])]
    units = next(units for noun, units in p.PLURALS if re.match(noun, said["what"], re.IGNORECASE))
    if not {*names} <= facts.parameters.keys():
        return None
    other = [n for n in names if facts.unit(n) not in (*units, "")]
    one = re.sub("radii", "radius", re.sub("(?:(?<=ss)e)?s$", "", said["what"].lower()))
    other = other or [n for n in names if _contrary(facts.meaning(n), one)]
    if not other and said.re is p.PLURAL:
        return None  # whose they are follows
    return f"the text has {said['what']} {', '.join(other)}" if other else ""


def _called(facts: SceneFacts, said: Said) -> Outcome:
    """A diameter, where the scene has a radius."""
    own = facts.own(said)
    if own not in facts.parameters or not _contrary(facts.meaning(own), said["words"].lower()):
        return None
    words = f"the text says that {name_of(said)} is the {said['words']}"
    return f"{words}, the scene's {own} is the {facts.meaning(own)}"


def _inertial(facts: SceneFacts, said: Said) -> Outcome:
    """A coordinate that is said to be one of an inertial frame, where the scene's turns."""
    symbol = facts.coordinates.get(facts.own(said))
    slopes = [facts.scene.position(b.centre).diff(symbol) for b in facts.scene.bodies if symbol]
    if not any(slope.has(TIME) for slope in slopes):
        return None
    return f"the text says {bare(said[0])!r}, {symbol} of the scene is of a frame that turns"


def _contrary(meaning: str, words: str) -> bool:
    """Whether words say what a meaning rules out."""
    return any(re.search(a, meaning) and re.search(b, words) for a, b in p.OTHERS)


def _input(facts: SceneFacts, said: Said) -> Outcome:
    """An input that is called a force or a torque, and nothing else."""
    own = facts.own(said)
    if said.groupdict().get("at") and not (facts.turns(own) == {True} and facts.is_hinged_once):
        return None
    words = re.sub(r" of (?:the |a )?(?:motor|actuator|drive|engine|servo)$", "", said["words"])
    return "" if own in facts.inputs and facts.is_called(own, words) else None


def _of_another_place(facts: SceneFacts, words: str) -> bool:
    """Whether a position is said to be of a part of a body: the tip of the rod."""
    said = p.POSITION_OF.match(words)
    return len(facts.scene.bodies) > 1 and said is not None and not facts.bodies(said["part"])


def _same_thing(facts: SceneFacts, own: str, words: str) -> frozenset[str] | None:
    """Words by which it is of the body, the number or the thing that the scene's symbol is of.

    None where it is not, or nothing tells.
    """
    symbol, said = facts.parameters[own], facts.nouns(words)
    things = frozenset(facts.alike(m[0]) for m in p.THINGS.finditer(words))
    if (numbered := _same_number(own, words)) is not None:
        return things.union(_orders(words)) if numbered else None
    bodies = [b for b in facts.scene.bodies if facts.nouns(b.name) & said]
    if not bodies and len(facts.scene.bodies) == 1:
        bodies = [*facts.scene.bodies]
    plain = facts.scene.plain
    of_bodies = frozenset().union(*(facts.nouns(b.name) for b in bodies))
    if re.search(r"\bmass\b", words):
        return of_bodies if any(plain(b.mass) == symbol for b in bodies) else None
    if any(isinstance(b, RigidBody) and isinstance(b.inertia, Expr)
           and plain(b.inertia).has(symbol) for b in bodies):  # fmt: skip
        return of_bodies
    others = (facts.nouns(facts.meaning(n)) for n in facts.parameters
              if n != own and facts.unit(n) == facts.unit(own))  # fmt: skip
    same = (facts.nouns(facts.meaning(own)) & said).difference(*others)
    return same or (frozenset() if _usual_letter(facts, own, words) else None)


def _orders(words: str) -> frozenset[str]:
    return frozenset().union(*p.ORDINALS.values()) & {*words.split()}


def _same_number(own: str, words: str) -> bool | None:
    """Whether words have the number of a name, "second" for 2; None where they have none."""
    if (orders := _orders(words)) and re.search(r"\d$", own):
        return orders <= p.ORDINALS.get(own[-1], frozenset())
    numbers = re.findall(r"\d+", words)
    return numbers == re.findall(r"\d+", own) if numbers else None


def _another_number(own: str, words: str) -> bool:
    """Whether words count otherwise than a name that has a number.

    From joint 2 to the mass centre of link 2, 0.4 m away: a fraction counts nothing.
    """
    (mine,) = re.findall(r"\d+", own)[-1:] or [""]
    numbers = {*re.findall(r"\d+", re.sub(r"\d+\.\d+", "", words))} - {mine}
    return bool(mine and (numbers or _orders(words) - p.ORDINALS.get(mine, frozenset())))


def _usual_letter(facts: SceneFacts, own: str, words: str) -> bool:
    """Whether a name begins as people's do for what it is said to be, and no other of its unit."""
    unit = facts.unit(own)
    others = [n for n in facts.parameters if n != own and facts.unit(n) == unit]
    usual = next((letters for noun, letters in p.LETTERS if noun in words.split()), "")
    return own[0] in usual and not any(n[0] in usual for n in others)


def _other_distance(facts: SceneFacts, said: Said, meaning: str, words: str) -> bool:
    """Whether a distance is said to be between what a length is not; one to a centre, a length."""
    if not meaning or p.TO_CENTRE.match(said.string, said.start()):
        return False
    if "distance" in meaning:
        own_is_to_centre = p.A_CENTRE.search(meaning) is not None
        return (
            own_is_to_centre
            and re.match("length of", words) is not None
            and not (p.A_CENTRE.search(said.string) or re.search("half|centroid", said.string))
        )
    if re.match("distance (?:from|between|of|to)", words) is None:
        return False
    ends = facts.nouns(words.partition(" ")[2]) - {"distance"}
    return not ends or not ends <= p.ENDPOINTS | facts.nouns(meaning)


def _another(facts: SceneFacts, own: str, words: str) -> str:
    """The other parameter of the same unit whose meaning words have that set it apart; or empty."""
    said, mine = facts.nouns(words), facts.nouns(facts.meaning(own))
    for name in facts.parameters:
        theirs = facts.nouns(facts.meaning(name))
        apart = theirs - mine and theirs <= said and not mine <= said
        same = name != own and facts.unit(name) == facts.unit(own)
        if same and apart and not (mine - theirs) & said:
            return name
    return ""


def _of_other_role(facts: SceneFacts, own: str, words: str) -> str | None:
    """The other radius, where one is of what moves and one of what it moves in; empty for the same.

    None where words or scene do not tell.
    """
    inner, outer = (row.search(words) is not None for row in (p.INNER, p.OUTER))
    if "radius" not in words or inner is outer:
        return None
    radii = {n: facts.meaning(n) for n in facts.parameters if "radius" in facts.meaning(n)}
    moving = {n: any(facts.moves(b) for w in facts.nouns(m) for b in facts.bodies(w))
              for n, m in radii.items()}  # fmt: skip
    if len(radii) != 2 or own not in radii or {*moving.values()} != {True, False}:
        return None
    (other,) = radii.keys() - {own}
    return other if moving[own] is outer else ""


def _of_another_body(facts: SceneFacts, own: str, words: str) -> bool:
    """Whether a mass is said to be that of a body that has another; a rate, of another thing."""
    symbol, mine = facts.parameters[own], facts.nouns(facts.meaning(own))
    if re.match(r"(?:\w+ )?mass\b", words):
        named = [b for b in facts.scene.bodies if facts.nouns(b.name) & facts.nouns(words)]
        masses = [facts.scene.plain(body.mass) for body in named]
        return len(named) == 1 and not any(symbol in mass.free_symbols for mass in masses)
    whose = WHOSE.search(words)
    head = facts.alike(whose[1]) if whose else ""
    things = {facts.alike(m[0]) for m in p.THINGS.finditer(facts.meaning(own))}
    return bool(head and facts.bodies(head) and things and head not in mine)


def _other_kind(unit: str, words: str) -> bool:
    """Whether the first noun of what a name is said to be has another unit."""
    head = BEHIND_HEAD.split(p.OF_INERTIA.sub("inertia", words))[0]
    if not unit or SCALE.search(words):
        return False
    if re.search(r"\b(?:damping|friction)\b", words) and JOINT.search(words):
        return dimension_of_unit("N*s/m", "") == dimension_of_unit(unit, "")
    for noun, of in HEADS:
        if re.search(rf"\b(?:{noun})$", head.strip()):
            turns = noun.startswith("stiffness") and TORSION.search(words)
            return dimension_of_unit("N*m" if turns else of, "") != dimension_of_unit(unit, "")
    return False


def _other_sort(facts: SceneFacts, own: str, words: str) -> bool:
    """Whether a coordinate is said to be no place, or a force a torque."""
    (head,) = p.SORTS.findall(BEHIND_HEAD.split(words)[0])[-1:] or [""]
    if own in facts.inputs and head:
        return facts.turns(own) == {head == "force"}
    return own in facts.coordinates and bool(head)


def _unit(facts: SceneFacts, said: Said) -> Outcome:
    return f"the text says {said.groupdict().get('all') or name_of(said)} in {bare(said['unit'])}"


def _stated_unit(facts: SceneFacts, said: Said) -> Outcome:
    """A unit that no scene counts in, or one of another dimension than the scene's."""
    own, stated = facts.own(said), bare(said["unit"]).strip()
    is_name = len(stated) == 1 and "," in said["before"]
    if is_name or stated in ("g", "h", "min", "turns"):
        return None
    text = f"the text says {name_of(said)} in {stated}"
    if OTHER_UNIT.search(stated):
        return text
    for name, symbol in p.LONG_UNITS.items():
        stated = re.sub(rf"{name}s?", symbol, stated, flags=re.IGNORECASE)
    stated = stated.replace("²", "^2").replace("³", "^3").replace(" per ", "/")
    stated = re.sub(r"[ ·]+|(?<=[Nm])(?=[ms])", "*", stated)
    try:
        one = dimension_of_unit(stated.strip("*").replace("*/", "/").replace("/*", "/"), "")
        other = dimension_of_unit(facts.unit(own), "") if facts.unit(own) else one
    except MechanicsError:
        return None
    return None if one == other else f"{text}, it is in {facts.unit(own)}"


def _dots(facts: SceneFacts, said: Said) -> Outcome:
    """Nothing with dots is read as it is meant there."""
    return Unsettled(f"the text says that dots are derivatives by {bare(said['by'])}")


def _primed(facts: SceneFacts, said: Said) -> Outcome:
    """A prime that is no derivative."""
    return Unsettled(f"the text calls another letter {bare(said['by'])}'")


def _scaled_time(facts: SceneFacts, said: Said) -> Outcome:
    """A time of the text's own, by which its dots or primes may be."""
    name = re.sub(r"[\\\s{}]", "", said["by"])
    if facts.own_name(name) in {*facts.coordinates, *facts.parameters}:
        return None
    return Unsettled(f"the text has a time of its own, {bare(said['by'])}")


def _of_length(facts: SceneFacts, said: Said) -> Outcome:
    """``of length l``, where the scene's rod has the length 2 l."""
    own = facts.own(said)
    if "half" not in facts.meaning(own) and not has_rod_twice_as_long(facts, own):
        return None
    return read_declared([f"twice the length of {name_of(said)}"], facts.known)


def _shape(facts: SceneFacts, said: Said) -> Outcome:
    """A body that is said to be a disc, a hoop, a sphere has such an inertia."""
    if "body" in said.re.groupindex:
        bodies = facts.bodies(said["body"])
    elif "name" not in said.re.groupindex:
        bodies = [b for b in facts.scene.bodies if isinstance(b, RigidBody) and b.inertia != 0]
        bodies = bodies if len(bodies) == 1 else []
    else:
        mass = facts.parameters.get(facts.own(said))
        bodies = [b for b in facts.scene.bodies if facts.scene.plain(b.mass) == mass]
    if not other_shape(facts, bodies, said["shape"].lower()):
        return None
    return f"the text says {bare(said[0])!r}, the scene's has another inertia"


def _of_name(facts: SceneFacts, said: Said) -> Outcome:
    """A rate in turns, or a sense against the motion."""
    some = facts.inputs if said.re is p.AGAINST else {*facts.parameters, *facts.inputs}
    scaled = p.DENOTED.match(said.string, said.start())
    if facts.own(said) not in some or (scaled and p.SCALED.search(scaled["words"])):
        return None
    return f"the text says of {name_of(said)} {said['words']!r}"


def _factor(facts: SceneFacts, said: Said) -> Outcome:
    if facts.own(said) not in {*facts.parameters, *facts.inputs}:
        return None
    return f"the text says that {name_of(said)} is {said['size']} the {said['what']}"


def _about(facts: SceneFacts, said: Said) -> Outcome:
    own = facts.own(said)
    meaning = facts.meaning(own)
    if re.search(r"\binertia\b", said[0]) and p.CENTRAL.match(said.string, said.start("to")):
        words = f"the text says that {name_of(said)} is about the mass centre, which it is not"
        return words if about_centre(facts, own) is False else None
    if re.search(r"\binertia\b", said[0]) and p.OUTSIDE.match(said["to"]):
        words = f"the text says that {name_of(said)} is about the {said['to']}"
        return f"{words}, it is about the mass centre" if about_centre(facts, own) else None
    if (
        "inertia" not in meaning
        or said["to"] in p.OF_SYMMETRY
        or facts.alike(said["to"]) in facts.nouns(meaning)
    ):
        return None
    return f"the text says that {name_of(said)} is about the {said['to']}, which it is not"


def _place(facts: SceneFacts, said: Said) -> Outcome:
    """A coordinate that is said to place a body is that, but for what is constant."""
    symbol = facts.coordinates.get(facts.own(said))
    bodies = facts.bodies(said["body"])
    if symbol is None or len(bodies) != 1:
        return None
    moving = {*facts.scene.q}
    entries = facts.scene.position(bodies[0].centre)
    slopes = [e.diff(symbol) for e in entries]
    own = any(s.is_number and s != 0 and not (e - s * symbol).free_symbols & moving
              for s, e in zip(slopes, entries, strict=True))  # fmt: skip
    if own:
        return ""
    if any(a.symbol == symbol for a in facts.angles):
        return None
    return f"the text says {bare(said[0])!r}, which {symbol.name} of the scene is not"


def _on_body(facts: SceneFacts, said: Said) -> Outcome:
    """A force that is said to act on a body does."""
    own, bodies = facts.own(said), facts.bodies(said["body"])
    kind = Force if said["sort"].lower() == "force" else Torque
    on = {x.on for x in facts.loads if isinstance(x, kind) and own in facts.names_in(x)}
    if own not in facts.inputs or len(bodies) != 1 or len(on) != 1 or None in on:
        return None
    if on == {bodies[0].name}:
        flat = ("horizontal",) if facts.way(own) else ()
        sort = p.PUSHING if kind is Force else p.TURNING
        known = {*p.APPLIED, *sort, *p.PUSHES_ON, *p.COUNTED, *flat, said["body"].lower()}
        return "" if only_words(said, known) else None
    words = f"the text says that {name_of(said)} acts on the {said['body']}"
    return f"{words}, the scene's does on {on.pop()}"


def _equal(facts: SceneFacts, said: Said) -> Outcome:
    """Masses, lengths and stiffnesses that are said to be equal, or not."""
    if p.DENIED.search(said.string):
        return None
    scene, what = facts.scene, said["what"].lower()
    masses = [scene.plain(body.mass) for body in scene.bodies]
    lengths = [n for n in facts.parameters if facts.unit(n) == "m" and "length" in facts.meaning(n)]
    springs = [scene.plain(x.stiffness) for x in scene.loads if isinstance(x, Spring)]
    some = {"mass": masses, "leng": lengths, "spri": springs, "stif": springs}.get(what[:4], masses)
    if not some:
        return None
    differ = said["how"].lower() in ("different", "unequal")
    if (len({*some}) > 1) is not differ:
        return f"the text says {said[0]!r}, the scene's are not"
    return "" if len(some) > 1 else None


def _massless(facts: SceneFacts, said: Said) -> Outcome:
    """A body without mass has no inertia."""
    if p.DENIED.search(said.string) and "no" not in said[0].split():
        return None
    bodies = facts.bodies(said["body"])
    link = re.fullmatch(p.SLOTS["LINK"], said["body"], re.IGNORECASE) is not None
    if not bodies and link:
        rods = p.ALIKE[0]
        bodies = [b for b in facts.scene.bodies if rods & set(re.findall("[a-z]+", b.name.lower()))]
    if all(b.mass == 0 for b in bodies) and (bodies or p.WITHOUT_A_BODY.fullmatch(said["body"])):
        return ""
    if link and not any(isinstance(b, RigidBody) and b.inertia != 0 for b in facts.scene.bodies):
        return ""  # points on what has no mass
    heavy = [b.name for b in bodies if isinstance(b, RigidBody) and b.inertia != 0]
    if not heavy or len(heavy) < len(bodies):
        return None
    words = f"the text says {bare(said[0])!r}, the scene has a mass and an inertia"
    return f"{words} of {', '.join(heavy)}"


def _value(facts: SceneFacts, said: Said) -> Outcome:
    """``stiffness $2k$``: something of the scene has that."""
    scene, symbol = facts.scene, facts.parameters.get(facts.own(said))
    if symbol is None:
        return None
    value, what = int(said["factor"]) * symbol, said["what"].lower()
    if what in ("length", "radius"):
        half = "half" in facts.meaning(symbol.name) or _is_half_of_a_rod(facts, symbol.name, value)
        have = half and said["factor"] == "2"
    else:
        parts = [x.stiffness for x in scene.loads if isinstance(x, Spring)]
        every = [b.mass for b in scene.bodies] if what == "mass" else parts
        have = any(is_zero(scene.plain(one) - value) for one in every)
    return "" if have else f"the text has a {what} of {value}, the scene has none"


def _is_half_of_a_rod(facts: SceneFacts, name: str, length: Expr) -> bool:
    """Whether the mass centre of a rod of a length, uniform or of any inertia, is that far away."""
    plain, rods = facts.scene.plain, [b for b in facts.scene.bodies if isinstance(b, RigidBody)]
    inertias = [(plain(b.inertia), plain(b.mass)) for b in rods if isinstance(b.inertia, Expr)]
    return facts.ratio(name) == 1 and any(
        J.is_Symbol or is_zero(J - m * length**2 / 12) for J, m in inertias
    )


def _sort(facts: SceneFacts, said: Said) -> Outcome:
    rigid = any(isinstance(b, RigidBody) and b.inertia != 0 for b in facts.scene.bodies)
    plain = said["sort"].lower() in ("simple", "mathematical")
    return f"the text says {said[0]!r}, which the scene has not" if rigid is plain else None


def _still(facts: SceneFacts, said: Said) -> Outcome:
    some = [facts.moves(body) for body in facts.bodies(said["body"])]
    if not some or (any(some) and not all(some)):
        return None
    return f"the text says {said[0]!r}, the scene's moves" if all(some) else ""


def _only_one(facts: SceneFacts, said: Said) -> Outcome:
    """One body alone rises and falls, or moves; by whatever name, where the scene has one such."""
    scene, some = facts.scene, facts.bodies(said["body"])
    fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
    if (
        len(some) > 1
        or not p.THINGS.fullmatch(said["body"])
        or (said["energy"] and (len(fields) != 1 or facts.has["springs"]))
    ):
        return None
    moving = {*scene.q}

    def changes(body: Particle | RigidBody) -> bool:
        place = scene.position(body.centre)
        return bool(fields[0].dot(place).free_symbols & moving)

    have = [b for b in scene.bodies if (changes(b) if said["energy"] else facts.moves(b))]
    same = have == some if some else len(have) == 1
    return "" if same else f"the text says {bare(said[0])!r}, which the scene has not"


def _driven(facts: SceneFacts, said: Said) -> Outcome:
    named = any("accelerat" in facts.meaning(n) and n != "g" for n in facts.parameters)
    if facts.scene.explicit_time and (way := said["way"]):
        flat = way.lower() in ("horizontally", "sideways", "to and fro")
        other = moves_with_time(facts, vertical=not flat) is False
        return f"the text says {bare(said[0])!r}, the scene's moves otherwise" if other else None
    if facts.scene.explicit_time or named:
        return None
    return f"the text says {said[0]!r}, the scene's is not driven"


def _flat(facts: SceneFacts, said: Said) -> Outcome:
    scene = facts.scene
    fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
    if not fields:
        return None
    named = [b for b in scene.bodies if facts.nouns(b.name) & facts.nouns(said.string)]
    heights = [fields[0].dot(scene.position(body.centre)) for body in named or scene.bodies]
    if any(height.free_symbols & {*scene.q} for height in heights):
        return "the text has a horizontal plane, the scene's bodies rise and fall"
    return ""


def _features(facts: SceneFacts, sentence: str) -> Iterator[tuple[Outcome, list[tuple[int, int]]]]:
    """Whether there is friction, gravity, a spring."""
    start = 0
    yield from (("", [m.span()]) for m in p.OF_FREQUENCY.finditer(sentence))
    sentence = p.OF_FREQUENCY.sub(lambda m: " " * len(m[0]), sentence)
    for stop in (*(m.end() for m in p.PARTS.finditer(sentence)), len(sentence)):
        part = sentence[start:stop]
        absent = [(start + m.start(), start + m.end()) for m in p.ABSENT.finditer(part)]
        for name, words in p.FEATURES:
            found = [(start + m.start(), start + m.end())
                     for m in re.finditer(rf"\w*(?:{words})\w*", part, re.IGNORECASE)]  # fmt: skip
            if not found or facts.has[name] is None:
                continue
            if facts.has[name] is bool(absent):
                other = f"the text speaks of {name}, the scene has none"
                words = f"the text says that there is no {name}" if absent else other
                yield f"{words} ({bare(part)[:60]!r})", found
            elif absent:
                yield "", [*found, *absent]
        start = stop


ROWS: tuple[tuple[re.Pattern[str], Callable[[SceneFacts, Said], Outcome]], ...] = (
    *((row, direction) for row in (*p.DIRECTIONS, *p.DIRECTED)),
    (p.EVERY_ANGLE, every_angle), (p.OPPOSITE, value_at_pi),
    (p.HALF, _half), (p.DOUBLE, _half), (p.TWICE, _twice), (p.WHOLE, _whole),
    (p.TO_AN_END, _to_an_end), (p.TO_CENTRE, _to_centre), (p.NEGATIVE, input_with_minus),
    (p.TURNS, sense), (p.PUSHES, sense),
    (p.DOTS, _dots), (p.SCALED_TIME, _scaled_time),
    (p.PRIMED, _primed), (p.OF_LENGTH, _of_length), (p.EXTENSION, elongation),
    (p.SPRING_LENGTH, elongation), (p.UPWARD, vertical_sense), (p.HEIGHT, vertical_sense),
    (p.SLOPE, slope), *((row, _shape) for row in p.SHAPE),
    (p.DENOTED, _denoted), (p.INPUT_NOUN, _input), (p.EXERTED, _input),
    (p.SEVERAL, _several), (p.PLURAL, _several), (p.CALLED, _called), (p.INERTIAL, _inertial),
    (p.UNIT, _unit),
    (p.STATED_UNIT, _stated_unit), (p.PER, _of_name), (p.AGAINST, _of_name), (p.FACTOR, _factor),
    *((row, counted_from) for row in (p.RELATIVE, p.ABSOLUTE)),
    (p.FROM_EQUILIBRIUM, from_equilibrium), *((row, zero_in_line) for row in p.ALIGNED),
    *((row, kind_of_angle) for row in p.KINDS_OF_ANGLE),
    (p.ABOUT, _about), *((row, _place) for row in p.PLACE), *((row, _on_body) for row in p.ON_BODY),
    *((row, _equal) for row in p.EQUAL), *((row, _massless) for row in p.NO_MASS),
    (p.VALUE, _value), (p.SORT, _sort), (p.STILL, _still), (p.ONLY_ONE, _only_one),
    (p.DRIVEN, _driven), (p.FLAT, _flat),
)  # fmt: skip
"""What a sentence may say, and how it is compared."""
