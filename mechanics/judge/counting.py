"""From where, and which way, coordinates and inputs count: what sentences say, beside the scene.

theta is measured from the upright            a convention, where the scene's hangs
phi_2 is the angle between the rods           against the scene, whose angles are absolute
r is the extension of the spring              its length where r = 0 is the natural one
y is measured upwards                         a convention, where the scene's counts downwards

A function that a row of `phrases` stands beside takes the facts of a scene and the row's match, and
returns an `Outcome`.
"""

import re
from collections.abc import Collection

from sympy import S

from mechanics.claims.convention import combined_table
from mechanics.claims.declared_conventions import read_declared, readings
from mechanics.errors import InputError, SceneError
from mechanics.judge import phrases as p
from mechanics.judge.geometry_facts import elongates, upward
from mechanics.judge.outcome import Outcome, Said
from mechanics.judge.scene_facts import SceneFacts
from mechanics.judge.sentences import bare
from mechanics.scene.potential import potential
from mechanics.symbolic import is_zero

MARKED = re.compile("\u27e8[^\u27e9]*\u27e9")


def name_of(said: Said) -> str:
    """The name in a match, as it is typed."""
    return said["name"].replace("{", "").replace("}", "")


def convention_of(facts: SceneFacts, words: str) -> Outcome:
    """A convention, unless the scene counts so, or does not tell."""
    try:
        some = read_declared([words], facts.known)
        tables = [combined_table(c) for c in readings(facts.scene, some, facts.symbols)]
    except InputError:
        return _in_space(facts, words)
    sizes = [facts.meaning(d.of) for d in some if "length" in d.name]
    if any(not size for size in sizes) or not tables:
        return None
    if any("half" in size for size in sizes):
        return "" if all(d.name == "half-length" for d in some) else None
    same = any(all(s == e for s, e in table.items()) for table in tables)
    return "" if same else some


def _in_space(facts: SceneFacts, words: str) -> Outcome:
    """The same of an angle without a sense, which is counted from one end of the vertical."""
    way, _, name = words.rpartition(" of ")
    turned = {"up": 1, "downward vertical": 3, "hanging": 3}
    said = [quarter for start, quarter in turned.items() if way.startswith(start)]
    own = facts.own_name(name)
    have = [a.quarter for a in facts.angles if a.symbol.name == own and not a.sense]
    if not said or not have or have[0] not in (1, 3):
        return None
    return "" if have == said else convention_of(facts, f"other vertical of {name}")


def only_words(said: Said, words: Collection[str], facts: SceneFacts | None = None) -> bool:
    """Whether a match has no words but these and function words: it may hide others.

    Parameters
    ----------
    said : re.Match
    words : collection of str
    facts : SceneFacts, optional
        Where one word for a thing is as good as another.
    """
    every = {*re.findall("[a-z]+", MARKED.sub(" ", said[0]).lower())} - p.ARTICLES
    return all(w in words or (facts is not None and facts.alike(w) in words) for w in every)


def direction(facts: SceneFacts, said: Said) -> Outcome:
    """From where a name is counted; that of another thing than its own is not known."""
    way = _way(facts, said["way"])
    sense = (said.groupdict().get("sense") or "").lower().rstrip("+")
    outcome = _along(facts, f"{way} {sense}".strip(), name_of(said))
    if outcome and said.re not in p.DIRECTED:
        return outcome
    own = {*p.COUNTED, *re.findall("[a-z]+", f"{said['way']} {sense}".lower())}
    return outcome if only_words(said, own | things_of(facts, facts.own(said)), facts) else None


def _way(facts: SceneFacts, words: str) -> str:
    """A way as conventions call it; empty where the scene does not tell which it is."""
    way = " ".join(re.findall("[a-z]+", words.lower()))
    if axis := p.AXIS.match(way):
        up = upward(facts, axis["axis"]) * (1 if axis["sign"] == "positive" else -1)
        return {1: "upright", -1: "hanging"}.get(up, "")
    if "equilibrium" in way:
        falls = facts.has["gravity"] and facts.has["springs"] is False
        return ("upright" if "unstable" in way else "hanging") if falls else ""
    if "vertical" in way or way.startswith(("point", "straight")):
        end = re.search("down|up(?!on)", way)
        return f"{end[0]}ward vertical" if end else "vertical"
    return p.WAYS.get(way, way)


def _along_vertical(facts: SceneFacts, name: str) -> Outcome:
    """An angle with the vertical, whichever end of it, is none with the horizontal."""
    own = facts.own_name(name)
    quarters = [a.quarter for a in facts.angles if a.symbol.name == own and a.fixed]
    if not quarters or quarters == [None] or not facts.scene.reactions:
        return None  # what is free has no arm that points from a pivot
    if quarters[0] in (1, 3):
        return ""
    return f"the text says that {name} counts from the vertical, {own} does not"


def places(facts: SceneFacts, name: str, words: str) -> bool:
    """Whether words call a coordinate the angle or the place of what it turns or places.

    Parameters
    ----------
    facts : SceneFacts
    name, words : str
    """
    if name not in facts.coordinates:
        return False
    turned = any(angle.symbol.name == name for angle in facts.angles)
    kinds = {"angle"} if turned else p.PLACES - {"angle"}
    said = re.findall("[a-z]+", words.lower())
    numbers = re.findall(r"\d+", words)
    own = [word for word in said if word not in p.ARTICLES | {"for", "joint", "inertia"}]
    things = things_of(facts, name)
    return (
        bool(kinds & {*own[:1]})
        and all(w in things or facts.alike(w) in things for w in own[1:])
        and (not numbers or numbers == re.findall(r"\d+", name))
    )


def _things_before(facts: SceneFacts, name: str) -> frozenset[str]:
    """Words for what carries what a coordinate places: from that a relative one is counted."""
    symbol = facts.coordinates[name]
    moved = {body.name: facts.moved_by(body) for body in facts.scene.bodies}
    own = [some for some in moved.values() if symbol in some]
    before = [n for n, some in moved.items() if some and any(some < one for one in own)]
    number = re.search(r"\d$", name)
    order = p.ORDINALS.get(str(int(number[0]) - 1), frozenset()) if number else frozenset()
    words = (facts.nouns(n) for n in before)
    links = p.LINKS if order or len(facts.scene.bodies) < 3 else ()
    return frozenset().union(*words, order, map(facts.alike, links), p.PREVIOUS)


def things_of(facts: SceneFacts, name: str) -> frozenset[str]:
    """Words for what a coordinate places or turns, and nothing else of the scene.

    Parameters
    ----------
    facts : SceneFacts
    name : str
    """
    symbol = facts.coordinates.get(name)
    if symbol is None:
        return frozenset()
    moved = {body.name: facts.moved_by(body) for body in facts.scene.bodies}
    least = min((len(some) for some in moved.values() if symbol in some), default=0)
    own = {n for n, some in moved.items() if symbol in some and len(some) == least}
    mine, others = (
        frozenset().union(*(facts.nouns(n) for n in names)) for names in (own, moved.keys() - own)
    )
    turned = any(angle.symbol == symbol for angle in facts.angles)
    links = frozenset(map(facts.alike, p.LINKS)) if turned else frozenset()
    if place := re.search(r"\d$", name):
        order = p.ORDINALS.get(place[0], frozenset())
        return (mine - others) | links | order if order else mine - others
    directed = [angle for angle in facts.angles if angle.quarter is not None]
    return (mine | (links if len(directed) == 1 else frozenset())) - others


def value_at_pi(facts: SceneFacts, said: Said) -> Outcome:
    """``theta = pi is upright``: it is counted from hanging."""
    way = said["way"].lower()
    start = "upright" if p.WAYS.get(way, way) == "hanging" else "hanging"
    return convention_of(facts, f"{start} of {name_of(said)}") or None


def every_angle(facts: SceneFacts, said: Said) -> Outcome:
    """From where all angles are counted."""
    way = _way(facts, said["way"])
    each = [_along(facts, way, angle.symbol.name) for angle in facts.angles]
    if not each or None in each:
        return None
    against = [one for one in each if isinstance(one, str) and one]
    if against:
        return against[0]
    return tuple(d for one in each if isinstance(one, tuple) for d in one) or ""


def _along(facts: SceneFacts, way: str, name: str) -> Outcome:
    """An angle that is counted from a way."""
    if have := facts.inclination(facts.own_name(name)):
        words = f"the text says that {name} counts from the {way}, it does from the {have}"
        return "" if way == have else words if way in p.VERTICALS else None
    if way == "vertical":
        return _along_vertical(facts, name)
    return convention_of(facts, f"{way} of {name}") if way else None


def kind_of_angle(facts: SceneFacts, said: Said) -> Outcome:
    """Angles that are said to be relative, of joints, or absolute."""
    every = [angle.symbol.name for angle in facts.angles]
    groups = said.groupdict()
    own = [facts.own_name(n) for n in (groups.get("name"), groups.get("more")) if n] or every
    some = [n for n in own if n in every]
    absolute = said["kind"].lower() == "absolute"
    if not absolute:  # the first is of a joint on the ground, by either
        some = [n for n in some if n != every[0]]
    other = [n for n in some if facts.is_absolute(n) is not absolute]
    if not other:
        return "" if groups.get("name") and some else None
    return f"the text says {bare(said[0])!r}, {', '.join(other)} of the scene is not"


def zero_in_line(facts: SceneFacts, said: Said) -> Outcome:
    """An angle that is zero where two bodies are in line is no absolute one."""
    if facts.is_absolute(facts.own(said)) is not True or len(facts.angles) < 2:
        return None
    words = f"the text says that {name_of(said)} is zero where they are {said['to']}"
    return f"{words}, it counts alone"


def counted_from(facts: SceneFacts, said: Said) -> Outcome:
    """What a coordinate is counted from."""
    own, relative = facts.own(said), said.re is p.RELATIVE
    absolute = facts.is_absolute(own)
    if absolute is not relative:
        if absolute is None or said["to"] in p.VERTICALS:
            return None
        before = _things_before(facts, own) if relative else {said["to"].lower()}
        known = {*p.COUNTED, *p.PLACES, *before} | things_of(facts, own)
        return "" if only_words(said, known, facts) else None
    way = "relative to" if relative else "from"
    return f"the text says that {name_of(said)} counts {way} the {said['to']}, {own} does not"


def vertical_sense(facts: SceneFacts, said: Said) -> Outcome:
    """A coordinate or an axis that is said to count against gravity, or along it."""
    own, way = facts.own(said), -1 if said["way"].lower().startswith(("down", "depth")) else 1
    have = upward(facts, own)
    if not have:
        return None
    if have == way:
        known = {*p.COUNTED, *p.PLACES, *p.POINTING, said["way"].lower()} | things_of(facts, own)
        return "" if only_words(said, known, facts) and said.re is p.UPWARD else None
    if own in facts.coordinates:
        return read_declared([f"other sign of {name_of(said)}"], facts.known)
    return f"the text says that {name_of(said)} points {said['way']}, the scene's does not"


def slope(facts: SceneFacts, said: Said) -> Outcome:
    """A parameter that is an angle, with the vertical or the horizontal."""
    own = facts.own_name(said["name"] or said["of"])
    if own not in facts.parameters:
        return None
    have = {one for one in p.VERTICALS if one in facts.meaning(own)}
    if len(have) != 1 or said["way"].lower() in have:
        return None
    return f"the text says {bare(said[0])!r}, {own} of the scene is with the {have.pop()}"


def from_equilibrium(facts: SceneFacts, said: Said) -> Outcome:
    """Coordinates that are said to count from equilibrium: nothing pulls where they are zero."""
    scene = facts.scene
    names = [facts.own_name(n) for n in (said["name"], said["more"]) if n]
    some = [facts.coordinates.get(n) for n in names]
    if "equilibrium" not in said[0] and facts.has["gravity"]:
        return None  # what hangs on a spring stretches it
    if None in some or facts.loads or scene.explicit_time:
        return None
    zero = dict.fromkeys(scene.q, S.Zero)
    try:
        energy = potential(scene)
    except SceneError:
        return None
    pulled = [n for n, q in zip(names, some, strict=True) if not is_zero(energy.diff(q).subs(zero))]
    if not pulled:
        known = {*p.COUNTED, *p.PLACES, "static", "their", *p.AT_REST}
        return "" if only_words(said, known) else None
    return f"the text says {bare(said[0])!r}, where {pulled[0]} is zero is none"


def elongation(facts: SceneFacts, said: Said) -> Outcome:
    """A coordinate that is said to be the extension of a spring, or its length."""
    have, extension = elongates(facts, facts.own(said)), said.re is p.EXTENSION
    if have is None or have is extension:
        return None
    what = "extension" if extension else "length"
    return f"the text says that {name_of(said)} is the {what} of a spring, {facts.own(said)} is not"


def input_with_minus(facts: SceneFacts, said: Said) -> Outcome:
    """An input that is said to be minus a force or a torque."""
    if facts.own(said) not in facts.inputs:
        return None
    return read_declared([f"other sign of {name_of(said)}"], facts.known)


def sense(facts: SceneFacts, said: Said) -> Outcome:
    """By left, right and clockwise: as seen from one side."""
    own = facts.own(said)
    way = -1 if said["way"].lower().startswith(("clock", "left")) else 1
    have = facts.way(own)
    if own in facts.coordinates and not any(a.symbol.name == own for a in facts.angles):
        return "" if have == way else None  # a page that is mirrored turns its angles, too
    if have:
        return "" if have == way else read_declared([f"other sign of {name_of(said)}"], facts.known)
    if own not in facts.inputs:
        return None
    words = f"the text says that {name_of(said)} acts {said['way']}"
    return f"{words}, which the scene does not say of {own}"
