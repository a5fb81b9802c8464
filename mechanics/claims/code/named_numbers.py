"""Numbers that code returns by the names of what they are.

double tau2(..., double q1dd, double q2dd)    the input tau2 of the scene, that this motion needs
void f(..., double *T1, double *T2)           the reactions T1 and T2 of the scene
def rope_tension(theta, theta_dot, m, g)      a tension: each reaction of the scene is tried
double motorTorque(..., double q1dd)          the only input, where that is a torque of a motor
double shoulderTorque(..., double q1dd)       asked for: nothing says which it is
"""

import re
from collections.abc import Collection, Sequence

from sympy import Expr, Symbol

from mechanics.claims.about import LETTERS, OTHERS, named_quantity
from mechanics.claims.code.function_names import TITLE, FunctionName, function_name
from mechanics.claims.code.outputs import Claim
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.kinds import angular
from mechanics.claims.names import Naming
from mechanics.claims.statement import Letter
from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.loads import Force, Torque
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.quantities import EquationOfMotion, GeneralizedMomentum, ReactionValue
from mechanics.symbolic import is_zero

NUMBERED = re.compile(r"(?:tau|[uFfTMQ])_?\d+")
"""A drive with a number."""

OF_INPUTS = frozenset(
    ("control", "controlled", "input", "motor", "drive", "driving", "actuator", "applied",
     "required", "needed", "computed", "commanded", "command", "external", "feedforward",
     "inverse", "dynamics")
)  # fmt: skip
"""What people say of what drives a system."""


def named_numbers(
    naming: Naming, outputs: Outputs, about: str | None, title: str, passed: Collection[Expr]
) -> tuple[list[Claim], Letter | None]:
    """Claims of outputs by their names, and the word for a number that is looked for in the scene.

    Parameters
    ----------
    naming : Naming
    outputs : Outputs
    about : str, optional
        What the person says that they are.
    title : str
        Of the function.
    passed : collection of Expr
        All that is an argument.

    Returns
    -------
    claims : list of Claim
        Empty where their names tell nothing.
    letter : Letter or None

    Raises
    ------
    InputError
        Where a number is called a force or a torque, and nothing says which.
    """
    entries = outputs.entries
    names = [TITLE.sub("", name) for name in outputs.names or (title,)]
    if about is not None:
        names = about.replace(",", " ").split()
    if claims := _of_the_scene(naming, names, entries, passed):
        return claims, None
    if len(entries) != 1:
        return [], None
    if about is not None:
        return _looked_for(naming, title, FunctionName(about if about in OTHERS else ""), entries)
    said = _said(naming, (*outputs.names, title), passed)
    if said.word in ("force", "torque", "part") or _is_numbered(naming, names, passed):
        return _of_what_drives(naming, said, title, entries[0], passed), None
    return _looked_for(naming, title, said, entries)


def _said(naming: Naming, names: Sequence[str], passed: Collection[Expr]) -> FunctionName:
    """What the first of some names says that says anything; omega of constants is a frequency."""
    scene = naming.vocabulary.scene
    moves = {*passed} & {*scene.q, *scene.u, *scene.qd, *scene.ud}
    for name in names:
        if not moves and LETTERS.get(name, ((),))[0] == ("frequency",):
            return FunctionName("frequency")
        if (said := function_name(name)).word:
            return said
    return FunctionName()


def _looked_for(
    naming: Naming, title: str, said: FunctionName, entries: Sequence[Expr]
) -> tuple[list[Claim], Letter | None]:
    """The claim that what a function returns is some such thing of the scene."""
    if said.word not in OTHERS:
        return [], None
    sides = (naming.vocabulary.scene.pressed(entries[0]),)
    letter = Letter(title, sides, said.word, returned=True, owner=said.owner)
    return [(title, named_quantity(said.word), sides)], letter


def _of_the_scene(
    naming: Naming, names: Sequence[str], entries: Sequence[Expr], passed: Collection[Expr]
) -> list[Claim]:
    """Claims of numbers whose names are inputs, reactions or momenta; empty for others.

    An input is what a motion needs, where code takes accelerations and not this input. What else
    returns one may be a law of control.
    """
    scene = naming.vocabulary.scene
    reactions = {one.name for one in scene.reactions}
    inputs = _inputs(scene, passed)
    claims: list[Claim] = []
    for written, entry in zip(names, entries, strict=False):
        known = naming.lookup(written)
        name = known[0] if known is not None and known[1] == 0 else written
        momentum = None if naming.lookup(name) else naming.momentum(name)
        if name in reactions:
            claims.append((name, ReactionValue(name), (entry,)))
        elif name in inputs:
            claims.append((name, EquationOfMotion(), (inputs[name], entry)))
        elif momentum is not None and momentum[1] == 0:
            of = momentum_symbols(scene)[naming.vocabulary.momenta[momentum[0]]]
            claims.append((name, GeneralizedMomentum(of.name), (entry,)))
    return claims if len(claims) == len(names) == len(entries) else []


def _inputs(scene: Scene, passed: Collection[Expr]) -> dict[str, Symbol]:
    """Inputs that code with accelerations may return, by name."""
    moves = {*passed} & {*scene.ud}
    return {str(s): s for s in scene.input_symbols if moves and s not in passed}


def _is_numbered(naming: Naming, names: Sequence[str], passed: Collection[Expr]) -> bool:
    """Whether it is called a drive by its number, of which the scene has none."""
    scene = naming.vocabulary.scene
    several = len(scene.u) > 1 and len(_inputs(scene, passed)) == len(scene.input_symbols) > 0
    return several and any(NUMBERED.fullmatch(n) and naming.lookup(n) is None for n in names)


def _of_what_drives(
    naming: Naming, said: FunctionName, title: str, entry: Expr, passed: Collection[Expr]
) -> list[Claim]:
    """The only input, where a force or torque is one; none where it drives the only coordinate.

    Raises
    ------
    InputError
        Where nothing says which force or torque it is.
    """
    scene = naming.vocabulary.scene
    inputs = _inputs(scene, passed)
    if inputs and len(scene.input_symbols) == 1:
        ((name, symbol),) = inputs.items()
        if said.word == _kind(scene, symbol) and said.owner <= OF_INPUTS | _owners(scene, symbol):
            return [(name, EquationOfMotion(), (symbol, entry))]
    driven = ["torque" if q in angular(scene) else "force" for q in scene.q]
    if {*passed} & {*scene.ud} and driven == [said.word] and said.owner <= OF_INPUTS:
        return []
    choices = ", ".join((*map(str, scene.input_symbols), *(one.name for one in scene.reactions)))
    raise InputError(
        f"{title} returns a force or a torque, and nothing says which: say what it is: --about"
        f" (about=) can be equation of motion, reaction, tension, torque, {choices}".rstrip(", ")
    )


def _kind(scene: Scene, symbol: Symbol) -> str:
    """Whether an input is a force or a torque; empty where it is neither by itself."""
    kinds = {
        "force" if isinstance(load, Force) else "torque" for load in _loads(scene, symbol)
    }  # fmt: skip
    return kinds.pop() if len(kinds) == 1 else ""


def _loads(scene: Scene, symbol: Symbol) -> list[Force | Torque]:
    """Loads that are an input along an axis, up to direction."""
    found = []
    for load in scene.loads:
        if isinstance(load, Force | Torque):
            vector = scene.vector(load.vector, load.name)
            if symbol in vector.free_symbols and is_zero(vector.dot(vector) - symbol**2):
                found.append(load)
    return found


def _owners(scene: Scene, symbol: Symbol) -> frozenset[str]:
    """Words for an input: its name, that of its load, and the body that it drives."""
    loads = _loads(scene, symbol)
    words = " ".join((str(symbol), *(f"{load.name} {load.on or ''}" for load in loads)))
    return frozenset(words.lower().replace("_", " ").split())
