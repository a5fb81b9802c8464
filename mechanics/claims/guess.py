"""The best guess at what a name means that the scene does not have.

    theta -> q1    the only coordinate that is left        m_c -> m0    the same first letter

A guess is made only where one choice is left; every guess is reported, and the person can name
another.
"""

import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from mechanics.claims.kinds import angular, kinds
from mechanics.claims.names import GREEK, Match, Naming, Vocabulary
from mechanics.claims.scaled_names import another_quantity
from mechanics.claims.spelled_rates import bases, families, key
from mechanics.claims.step_indices import at_different_steps
from mechanics.claims.tree import Name
from mechanics.scene import Scene
from mechanics.scene.loads import Torque
from mechanics.scene.symbols import DOTS

ALPHABET = "abcdefghijklmnopqrstuvwxyz"
NUMBER = re.compile(r"(\d+)$")
MOMENTUM = re.compile(r"(p|pi)_?\d+")
BY_UNIT: tuple[tuple[str, str], ...] = (
    ("mM", "kg"), ("lLrRabdh", "m"), ("g", "m/s^2"), ("IJ", "kg*m^2"), ("kKc", "N/m"),
    ("bcd", "N*s/m"),
)  # fmt: skip
"""First letters that are used for quantities of a unit."""
AT_REST = re.compile(r"(?P<of>[A-Za-z]+)_(?:0|e|eq|s|star|ast)")
FIRST = re.compile(r"(?:_|[^\W\d_])0$")
"""Of a name for what is worth at the beginning, where no other number follows: u_0, u0."""
RATES = frozenset(("omega", "Omega", "gamma", "nu", "w", "Omega_d", "omega_d"))
"""Names of frequencies."""
PER_SECOND = ("1/s", "rad/s", "Hz")

SURE = (
    "the same unit and number", "the same unit, its letters in order",
    "an angle or not, the same number", "a momentum, the same number",
)  # fmt: skip
"""Reasons for a guess that nothing beside it turns."""
CAPITALS = "the same but for capitals"
SHORT = "short for "
ONLY_MOMENTUM = "the only momentum"
FIRST_LETTER = "the same first letter"
TWIN = "another way to write what is used, too"
TWINS = (("w", ("omega", "Omega")), ("W", ("Omega", "omega")))
"""Letters for one thing in the hand of one author."""

REASONS = (
    *SURE[:3], CAPITALS, FIRST_LETTER, "its first letters, the same number",
    "the only quantity of its unit that is left", "the only input that is left",
    "the only coordinate of its unit that is left",
)  # fmt: skip
"""Why a name was matched that the scene does not have."""

OTHERS = frozenset(
    ("spring", "friction", "fric", "damper", "damping", "damp", "drag", "gravity", "grav",
     "restoring", "inertia", "inertial", "net", "total", "tot", "crit", "critical", "cr", "avg",
     "mean", "rms", "el", "elastic", "bead", "half", "tip")
)  # fmt: skip
"""What a subscript says that makes a force, a length or a coefficient another one."""
OTHER_INPUTS = frozenset(("left", "right", "wind", "volt", "voltage", "current", "pwm"))
"""What a subscript says that makes an input another one."""
CENTRES = frozenset(("com", "cog", "cg", "cm"))
CENTRE = re.compile(r"\b(?:cent(?:re|er)|half|com)\b", re.IGNORECASE)
"""Of a distance up to a mass centre: in a name, and in the meaning of a parameter."""
Rule = tuple[Callable[[str, str], bool], str]


def guess(naming: Naming, used: Sequence[Name], defined: Iterable[str]) -> tuple[Match, ...]:
    """Matches for the names that nothing explains.

    Parameters
    ----------
    naming : Naming
    used : sequence of Name
        Every name of the text.
    defined : iterable of str
        Names that the text defines itself.
    """
    used = [name for name in used if not _is_open(naming, name.name)]
    short = _short(naming, used)
    naming = replace(naming, guessed=(*naming.guessed, *short))
    own = {key(name) for name in defined if not naming.knows(name)}
    moving: set[str] = set()
    still: set[str] = set()
    taken: set[str] = set()
    for name in used:
        found = naming.lookup(name.name)
        if found is not None:
            taken.add(found[0])
        elif key(name.name) not in own and name.name != "t":
            (moving if name.order or name.bracket else still).add(name.name)
    rates = families(moving | still)
    moving = (moving - rates.keys()) | set(rates.values())
    still = {name for name in still if equilibrium_of(naming, name) is None}
    still -= moving | rates.keys()
    momenta = _momenta(naming, [n for n in used if n.name in moving | still], own, taken)
    moving -= {match.name for match in momenta}
    still -= moving | {match.name for match in momenta}
    vocabulary = naming.vocabulary
    scene = vocabulary.scene
    inputs = {symbol.name for symbol in scene.input_symbols}
    free = [name for name in vocabulary.functions if name not in taken]
    coordinates = [name for name in free if name not in inputs]
    found_moving = _pairs(sorted(moving), coordinates, _moving_rules(scene))
    rest = [c for c in coordinates if c not in {match.meaning for match in found_moving}]
    constants = [name for name in vocabulary.constants if name not in taken]
    held = {symbol.name for symbol in scene.parameters}
    constants = [name for name in constants if name in held]
    left = [name for name in free if name in inputs] + constants
    found_still = _pairs(sorted(still), left + rest, _still_rules(scene, inputs))
    rated = {name.name for name in used if name.order}
    missing = sorted(moving - {match.name for match in found_moving} - rated)
    found_inputs = _pairs(
        missing,
        [n for n in free if n in inputs and n not in {m.meaning for m in found_still}],
        [(lambda name, other: True, "the only input that is left")],
    )
    every = (*short, *momenta, *found_moving, *found_still, *found_inputs)
    apart = _at_different_steps(naming, used, every)
    first = {n for n in still if FIRST.search(n) and f"{n[:-1]}1" not in still | moving}
    first = {m.name for m in every if m.name in first and m.meaning in vocabulary.functions}
    slips = {match.name for match in every if _is_slip(match, taken, vocabulary)}
    unlike = {key(name) for name in apart | first | slips}
    every = tuple(match for match in every if key(match.name) not in unlike)
    left_over = (moving | still) - {match.name for match in every} - apart - first - slips
    return (*every, *_twins(sorted(left_over), taken, vocabulary.functions))


def at_one_step(naming: Naming, names: Sequence[str]) -> tuple[Match, ...]:
    """theta_t and theta_dot_t, where both are there for all coordinates, and neither without _t."""
    scene = naming.vocabulary.scene
    state = {(str(q), order) for q in scene.q for order in (0, 1)}
    for end in ("_t", "_k", "_n"):
        ended = [name for name in names if name.endswith(end) and not naming.knows(name)]
        found = {name: naming.lookup(name.removesuffix(end)) for name in ended}
        plain = {naming.lookup(name) for name in names if name not in ended}
        if {*found.values()} == state and len(found) == len(state) and not state & plain:
            why = f"the state at a step: {end} of all its entries"
            return tuple(
                Match(name, f"{known[0]}{DOTS[known[1]]}", why)
                for name, known in found.items() if known is not None
            )  # fmt: skip
    return ()


def _at_different_steps(naming: Naming, used: Sequence[Name], matches: Iterable[Match]) -> set[str]:
    """Names of functions of time at a step of their own, as ``u_{k-1}`` beside ``theta_k``."""
    given = {key(name) for name in naming.given}
    naming = replace(naming, guessed=(*naming.guessed, *matches))
    names = dict.fromkeys(one.name for one in used if key(one.name) not in given)
    found = [(name, naming.lookup(name)) for name in names]
    moves = naming.vocabulary.functions
    apart = at_different_steps([(name, of[0]) for name, of in found if of and of[0] in moves])
    return apart | {base for name in apart for base, _ in bases(name)}


def _is_open(naming: Naming, name: str) -> bool:
    """Whether a name is what the text alone can say."""
    otherwise = naming.lookup(name) is None and another_quantity(name)
    return bool(otherwise or naming.unread_at(name))


def _twins(names: Sequence[str], taken: set[str], functions: Iterable[str]) -> list[Match]:
    """Th beside th, w beside omega: slips of a pen, where nothing else is left for the name."""
    found = []
    for name in names:
        moving = [t for t in taken & {*functions} if _same_letters(name, t) and len(key(t)) > 1]
        letters = [t for one, some in TWINS for t in some if one == name and t in taken]
        if len(fits := moving or letters) == 1:
            found.append(Match(name, fits[0], TWIN))
    return found


def _is_slip(match: Match, taken: Iterable[str], vocabulary: Vocabulary) -> bool:
    """Whether a guess takes l_3 for l2, or l_2 for lc2 beside l_1, or F_spring for F."""
    constants = vocabulary.constants
    if _says_another(match, vocabulary):
        return True
    (stem, number), (other, end) = (_stem(name) for name in (match.name, match.meaning))
    if not (number or end):
        return False
    if stem == other:
        return bool(number and end and number != end) or any(_stem(n)[0] == stem for n in taken)
    if stem.lower() == other.lower() and number == end:  # L_2 for l2, where the scene has no L1
        return any(_stem(name)[0] == stem for name in constants)
    return any(_stem(name)[0].lower() == stem.lower() for name in taken)


def _says_another(match: Match, vocabulary: Vocabulary) -> bool:
    """Whether a word in a name says that it is no such thing: F_spring, l_com, mg, u_left."""
    constants = vocabulary.constants
    first, *parts = [*filter(None, re.split(r"[_{}\d]+", match.name.lower()))] or [""]
    is_input = match.meaning not in constants
    words = {first[1:], *parts, *([first] if is_input else [])}  # Ffriction, F_friction, friction
    said = getattr(constants.get(match.meaning), "meaning", "")
    if words & OTHERS or (words & CENTRES and said and not CENTRE.search(said)):
        return True
    if is_input and (
        words & OTHER_INPUTS or ("force" in words and match.meaning in _torques(vocabulary.scene))
    ):
        return True
    return "g" in constants and ([first, *parts] == ["mg"] or parts == ["g"])


def _stem(name: str) -> tuple[str, str]:
    """A name without the number at its end, and that."""
    found = NUMBER.search(name)
    return (key(name[: found.start()]), found[1]) if found else (key(name), "")


def equilibrium_of(naming: Naming, name: str) -> str | None:
    """The coordinate of which a name is the value at an equilibrium: theta_0."""
    part = AT_REST.fullmatch(name)
    found = naming.lookup(part["of"]) if part else None
    moves = found is not None and found[1] == 0 and found[0] in naming.vocabulary.functions
    return found[0] if found is not None and moves else None


def _short(naming: Naming, used: Sequence[Name]) -> tuple[Match, ...]:
    """th for theta, where thdd or th'' is written, and no other name of the scene begins so."""
    vocabulary = naming.vocabulary
    orders: dict[str, int] = {}
    for name in used:
        if not naming.knows(name.name):
            for base, order in ((key(name.name), 0), *bases(name.name)):
                orders[base] = max(orders.get(base, 0), order + name.order)
    found: dict[str, str] = {}
    for base in (base for base, order in orders.items() if order > 1):
        head = base.rstrip("0123456789")
        fits = [
            name
            for name in (*vocabulary.functions, *vocabulary.constants)
            if is_short_for(base, name)
        ]
        if len(fits) == 1 and len(head) > 1 and fits[0] in vocabulary.functions:
            found[base] = fits[0]
    once = Counter(found.values())
    return tuple(
        Match(base, name, f"{SHORT}{name}") for base, name in found.items() if once[name] == 1
    )


def is_short_for(base: str, name: str) -> bool:
    """Whether a name begins with the letters of a base, and ends with its number."""
    letters, whole = base.rstrip("0123456789"), key(name)
    number = base[len(letters) :]
    rest = whole.removeprefix(letters)
    return whole.startswith(letters) and rest.lstrip(ALPHABET) == number


def _momenta(naming: Naming, used: Sequence[Name], own: set[str], taken: set[str]) -> list[Match]:
    """p_phi1, p1, p_1 or pi_1, p where there is one: no name that has a second derivative."""
    vocabulary = naming.vocabulary
    names = {name.name for name in used} - {name.name for name in used if name.order > 1}
    found = []
    for name in sorted(names):
        meant = vocabulary.momentum(name)
        if meant is not None and key(meant[0]) not in own:
            why = f"the generalized momentum of {meant[0].removeprefix('p_')}"
            found.append(Match(name, meant[0] + DOTS[meant[1]], why))
    taken = taken | {match.meaning for match in found}
    free = [name for name in vocabulary.momenta if name not in taken]
    only = [*vocabulary.momenta] if len(vocabulary.momenta) == 1 else []
    if only and "p" in names - own and naming.lookup("p") is None:
        return [*found, Match("p", only[0], ONLY_MOMENTUM)]
    numbered = sorted(name for name in names if MOMENTUM.fullmatch(name))
    return [*found, *_pairs(numbered, free, [(_same_number, "a momentum, the same number")])]


def _pairs(names: Sequence[str], targets: Sequence[str], rules: Sequence[Rule]) -> list[Match]:
    """Pairs of which each rule leaves one choice on both sides, rule by rule."""
    found: list[Match] = []
    open_names, open_targets = list(names), list(targets)
    for fits, why in rules:
        choices = {n: [t for t in open_targets if fits(n, t)] for n in open_names}
        for name, fitting in choices.items():
            if len(fitting) != 1:
                continue
            rivals = [n for n, others in choices.items() if fitting[0] in others]
            if rivals == [name]:
                found.append(Match(name, fitting[0], why))
                open_names.remove(name)
                open_targets.remove(fitting[0])
    return found


def _moving_rules(scene: Scene) -> list[Rule]:
    angles = {symbol.name for symbol in angular(scene)}

    def kind(name: str, target: str) -> bool:
        return ("angle" if target in angles else "length") in kinds(name)

    return [
        (_same_letters, CAPITALS),
        (lambda n, t: kind(n, t) and _same_number(n, t), "an angle or not, the same number"),
        (kind, "the only coordinate of its unit that is left"),
    ]


def _still_rules(scene: Scene, inputs: set[str]) -> list[Rule]:
    units = {symbol.name: getattr(symbol, "unit", "") for symbol in scene.parameters}
    turning = _torques(scene)

    def unit(name: str, target: str) -> bool:
        if name in RATES:
            return units.get(target) in PER_SECOND
        if _greek(name):
            return False  # alpha is no length, though it begins with an a
        return any(name[0] in letters and units.get(target) == u for letters, u in BY_UNIT)

    def force(name: str, target: str) -> bool:
        letters = "uUQM" if target in turning else "FfuUQ"
        return target in inputs and (name[0] in letters or name.startswith("tau"))

    def first(name: str, target: str) -> bool:
        # mu is no mass, though it begins with an m; th is theta.
        alike = _greek(name) == _greek(target) or target.startswith(name)
        return name[0] == target[0] and alike

    def begins(name: str, target: str) -> bool:
        letters = name.rstrip("0123456789_")
        return len(letters) > 1 and letters != name and is_short_for(name, target)

    return [
        (_same_letters, CAPITALS),
        (begins, "its first letters, the same number"),
        (lambda n, t: unit(n, t) and _same_number(n, t), "the same unit and number"),
        (lambda n, t: unit(n, t) and _initials(n, t), "the same unit, its letters in order"),
        (unit, "the only quantity of its unit that is left"),
        (force, "the only input that is left"),
        (first, FIRST_LETTER),
    ]


def _torques(scene: Scene) -> set[str]:
    """Names that torques of a scene are made of."""
    return {
        symbol.name for load in scene.loads if isinstance(load, Torque)
        for symbol in scene.vector(load.vector, load.name).free_symbols
    }  # fmt: skip


def _greek(name: str) -> bool:
    return re.split(r"[_\d]", name, maxsplit=1)[0] in GREEK


def _same_letters(name: str, target: str) -> bool:
    return key(name).lower() == key(target).lower()


def _initials(name: str, target: str) -> bool:
    """Whether the letters of the scene's name stand in the person's in this order: masscart, mc."""
    rest = iter(key(name).lower())
    return len(key(target)) > 1 and all(letter in rest for letter in key(target).lower())


def _same_number(name: str, target: str) -> bool:
    one, two = NUMBER.search(name), NUMBER.search(target)
    return bool(one and two and one[1] == two[1])
