"""The principle of virtual power for a scene as its author declared it.

    sum over bodies of (m a - F) . v + (H' - T) . w = 0        every admissible (v, w)       (1)
    m a = F + sum of reactions,  H' = T + sum of their moments          every body           (2)
    sum of F . v + T . w = -dV/dt,  R . v = 0      loads with a potential; ideal reactions   (3)

Four routes that read a scene through the same functions are one witness where these are wrong. So
this check reads SymPy's frames, points, vectors and dyadics itself (`mechanics.checks.as_declared`)
and evaluates them itself (`mechanics.checks.jets`). Nothing of `mechanics.scene` is used but the
data of the declaration, nothing of `mechanics.kinematics` or `mechanics.routes`, and of
`mechanics.kernel` only the form of a finding. The equations in question say u' at a drawn state;
that motion, as a Taylor series, has to satisfy (1) to (3) and the constraints.

Numbers are enclosures. Sides that are apart at a state prove the statement false there: REFUTED.
Sides that meet within 2^-100 are SUPPORTED at the states drawn and no more, for there is no bound
of the chance of an error that vanishes there. Doubt is no success, so these findings stand apart
from those that have to be shown: `SystemResult.witnesses`, which fail unless all are SUPPORTED.
"""

from collections.abc import Callable, Iterator, Sequence

from flint import arb, arb_mat
from sympy import Expr, Symbol

from mechanics.checks.as_declared import NONE, Motion, Wrench, cross
from mechanics.checks.jets import Instant, OutsideDomain, precision
from mechanics.checks.states import State, draw_states
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, enclose, refuted, supported, undecided
from mechanics.program import Program
from mechanics.scene import Scene
from mechanics.scene.loads import CONSERVATIVE, Coulomb

BITS = 300
CLOSE = arb(2) ** -100
"""Sides that overlap have to be known this well, or their meeting says nothing."""

STATES, USED = 6, 2
"""States that are drawn, and at how many that are admissible a statement is tried."""

VIRTUAL = 2
"""Virtual velocities at each state."""

Row = tuple[str, arb, arb]


def drawn_states(scene: Scene) -> tuple[State, ...]:
    """States for the checks of this module."""
    with precision(BITS):
        return draw_states(scene, STATES)


def check_powers(scene: Scene, states: Sequence[State], potential: Expr) -> Iterator[Finding]:
    """Statement (3), of a potential energy in plain symbols, in J, and of the reactions."""

    def released(state: State) -> Iterator[Row]:
        for virtual in state.virtual_motions(VIRTUAL):
            motion = Motion(scene, virtual)
            wrenches = _wrenches(motion, CONSERVATIVE)
            stored = virtual.coefficients(potential)[1]
            yield "power of loads with a potential", _power(motion, wrenches), -stored

    def ideal(state: State) -> Iterator[Row]:
        for virtual in state.virtual_motions(VIRTUAL):
            motion = Motion(scene, virtual)
            powers = dict.fromkeys((reaction.name for reaction in scene.reactions), arb(0))
            for name, unit in motion.reactions():
                powers[name] += motion.power(unit)
            for name, power in powers.items():
                yield f"power of {name}", power, arb(0)

    if any(isinstance(load, CONSERVATIVE) for load in scene.loads):
        yield tried("power of the declared loads = -dV/dt", states, released)
    if scene.reactions:
        yield tried("declared reactions have no power", states, ideal)


def check_virtual_power(
    equations: Equations, states: Sequence[State], support: Equations | None = None
) -> Finding:
    """Statement (1) at the accelerations of a route, and (2) where it tells the reactions.

    Parameters
    ----------
    states : sequence of State
        From `drawn_states`.
    support : Equations, optional
        Of a route that tells what presses, where friction acts and `equations` do not.
    """
    telling = equations if equations.reactions or support is None else support
    return _checked(
        equations.scene, equations.route, states, lambda state: solved(equations, telling, state)
    )


def check_program(scene: Scene, route: str, program: Program, states: Sequence[State]) -> Finding:
    """The same of a route that is a program.

    Parameters
    ----------
    program : Program
        Outputs ``"ud"``, the rates of the speeds in the order of the scene, and by name whatever
        reactions it tells, in the scene's plain symbols.
    """
    declared = {symbol.name: symbol for symbol in scene.parameters}

    def values_at(state: State) -> Solved:
        table = state.plain()
        values = {
            name: table[name] if name in table else state.parameter(declared[name])
            for name in program.inputs
        }
        found = enclose(program, values, BITS)
        changes = list(found["ud"])
        return changes, {name: entry[0] for name, entry in found.items() if name != "ud"}

    return _checked(scene, route, states, values_at)


Solved = tuple[list[arb], dict[str, arb]]
"""u' in the order of the declaration, and the reactions that are told, by name."""


def _checked(
    scene: Scene, route: str, states: Sequence[State], say: Callable[[State], Solved]
) -> Finding:
    def rows(state: State) -> Iterator[Row]:
        changes, values = say(state)
        motion = Motion(scene, state.motion(changes))
        for load in scene.loads:
            if isinstance(load, Coulomb) and not values[load.normal] > 0:
                raise OutsideDomain
        inertia = [motion.inertia_forces(body.name) for body in scene.bodies]
        applied = [*_wrenches(motion, object), *_friction(motion, values)]
        for constraint in scene.constraints:
            broken = motion.instant.coefficients(constraint.expression)
            yield constraint.name, broken[1 + int(constraint.holonomic)], arb(0)
        for virtual in state.virtual_motions(VIRTUAL):
            along = Motion(scene, virtual)
            yield "virtual power", _power(along, inertia), _power(along, applied)
        if scene.reactions and all(r.name in values for r in scene.reactions):
            yield from _momenta(motion, inertia, applied, values)

    return tried(f"{route}: virtual power of what was declared", states, rows)


def solved(equations: Equations, telling: Equations, state: State) -> Solved:
    """What equations say at a state; `telling` has the reactions."""
    scene = equations.scene
    here = plain_values(state.plain(), state)
    left, right = equations.system
    matrix = arb_mat(*left.shape, [here(entry) for entry in left])
    sides = arb_mat(right.rows, 1, [here(entry) for entry in right])
    unknowns = [symbol.name for symbol in equations.unknowns]
    solution = dict(zip(unknowns, matrix.solve(sides).entries(), strict=True))
    changes = [solution[symbol.name] for symbol in scene.ud]
    there = plain_values(state.plain(changes) | solution, state)
    told = {symbol.name: there(value) for symbol, value in telling.reactions}
    return changes, solution | told


def plain_values(table: dict[str, arb], state: State) -> Callable[[Expr], arb]:
    """Values of expressions in plain symbols."""

    def number(symbol: Symbol) -> arb:
        return table[symbol.name] if symbol.name in table else state.parameter(symbol)

    instant = Instant({}, number)

    def value(expression: Expr) -> arb:
        found: arb = instant.value(expression)
        return found

    return value


def _wrenches(motion: Motion, kinds: type | tuple[type, ...]) -> list[Wrench]:
    """Loads of some kinds, but friction, which needs what presses."""
    return [
        wrench
        for load in motion.scene.loads
        if isinstance(load, kinds) and not isinstance(load, Coulomb)
        for wrench in motion.load(load)
    ]


def _friction(motion: Motion, values: dict[str, arb]) -> Iterator[Wrench]:
    for load in motion.scene.loads:
        if isinstance(load, Coulomb):
            for unit in motion.load(load):
                yield unit.times(values[load.normal])


def _power(motion: Motion, wrenches: Sequence[Wrench]) -> arb:
    return sum((motion.power(wrench) for wrench in wrenches), arb(0))


def _momenta(
    motion: Motion,
    inertia: Sequence[Wrench],
    applied: Sequence[Wrench],
    values: dict[str, arb],
) -> Iterator[Row]:
    """Equation (2) in every direction that the scene uses at this state."""
    held = [unit.times(values[name]) for name, unit in motion.reactions()]
    acting = [*applied, *held]
    speeds = [motion.centre(rate.body).parts[1] for rate in inertia]
    spins = [motion.spin(rate.body)[0] for rate in inertia]
    moves = _used([*speeds, *(wrench.force for wrench in acting)])
    turns = _used([*spins, *(wrench.couple for wrench in acting)])
    if len(moves) == 3:
        turns = [0, 1, 2]
    for rate, spin in zip(inertia, spins, strict=True):
        own = [wrench for wrench in acting if wrench.body == rate.body]
        force = sum((wrench.force for wrench in own), NONE)
        moment = sum((w.couple + cross(w.at - rate.at, w.force) for w in own), NONE)
        for i in moves:
            yield f"momentum of {rate.body}", rate.force[i, 0], force[i, 0]
        for i in turns if _used([spin]) else ():
            yield f"angular momentum of {rate.body}", rate.couple[i, 0], moment[i, 0]


def _used(vectors: Sequence[arb_mat]) -> list[int]:
    """Axes along which one of the vectors has a component."""
    return [i for i in range(3) if any(vector[i, 0] != 0 for vector in vectors)]


def tried(subject: str, states: Sequence[State], rows: Callable[[State], Iterator[Row]]) -> Finding:
    """Rows of (words, left, right) at the first admissible states."""
    used, reason = 0, "no drawn state is admissible"
    samples: list[tuple[arb, arb]] = []
    with precision(BITS):
        for state in states:
            try:
                compared = list(rows(state))
            except ExpressionError as error:
                return undecided(subject, str(error))
            except (OutsideDomain, ArithmeticError, ValueError):
                # Arb says so where a matrix is singular there, or a series has no inverse.
                continue
            if not all(left.is_finite() and right.is_finite() for _, left, right in compared):
                continue
            for words, left, right in compared:
                if not left.overlaps(right):
                    evidence = f"{words}: the enclosures at a real state are disjoint"
                    return refuted(subject, evidence, left, right, state.items())
            wide = [words for words, left, right in compared if not abs(left - right) < CLOSE]
            if wide:
                # Beside a singular state digits are lost: it says nothing, another one may.
                reason = f"{wide[0]}: known too badly"
                continue
            samples += [(arb(left.mid(), CLOSE), right) for _, left, right in compared]
            used += 1
            if used == USED:
                break
        if not used:
            return undecided(subject, reason)
        evidence = f"equal within 2^-100 at {used} drawn states; no bound of the chance of error"
        return supported(subject, samples, evidence)
