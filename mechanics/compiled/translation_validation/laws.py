"""What each function of a model has to be, in terms of what was derived.

    forward dynamics     rows(q, u, x) = 0,  A u' = b at x             x what the graph gives
    jacobians            J w = K^-1 (-(d residual / d s) w) at x       s in q, u, inputs, p;  any w
    inverse dynamics     rows conjugate to u, or M_T (u' - x),         M_T = d2T/du2
    step                 y + h/6 (k1 + 2 k2 + 2 k3 + k4) of the rates
    what is reduced      graph = the program of which a bound was proved
    the rest             graph = program

with K the slope of the residual by (u', lambda), and x = K^-1 k where it is not the graph's. The
law of Jacobians is linear in w: it holds for symbols if and only if it does for every column.
A law gives, by output, pairs of values that have to be equal: the graph's, and what was derived.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from mechanics.compiled.reduced import output_name
from mechanics.compiled.translation_validation.derived import WANTED
from mechanics.compiled.translation_validation.physics import Entry, Physics
from mechanics.program import Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.interpret import include
from mechanics.routes.rows import coefficients, remainder, substitute

Nodes = Sequence[Node]
Outputs = dict[str, list[Node]]
Law = Callable[[Physics, Outputs], Iterator[Entry]]

STATE = ("q", "u", "inputs", "p")


def _derived(physics: Physics) -> dict[str, tuple[Node, ...]]:
    """What was derived, at the values of fixed parameters."""
    known = physics.known
    fixed = {s.name: physics.leaves[s] for s in known.fixed if s.name in known.program.inputs}
    return include(physics.builder, known.program, fixed)


def _unknowns(physics: Physics) -> list[Node]:
    """u' and the multipliers."""
    return [*physics.inputs["ud"], *physics.inputs["multipliers"]]


def _at(physics: Physics, nodes: Nodes, unknowns: Nodes) -> Nodes:
    """Nodes with other accelerations and multipliers."""
    values = dict(zip(_unknowns(physics), unknowns, strict=True))
    return substitute(physics.builder, nodes, values)


def _matrix(physics: Physics, rows: Nodes) -> Sequence[Nodes]:
    """K of rows that are linear in the unknowns."""
    return coefficients(rows, _unknowns(physics))


def _solution(physics: Physics, rows: Nodes) -> Nodes:
    """x of K x = k."""
    right = [-entry for entry in remainder(physics.builder, rows, _unknowns(physics))]
    return physics.builder.solve(_matrix(physics, rows), right)


def _zero(physics: Physics, rows: Nodes) -> Iterator[Entry]:
    for i, row in enumerate(rows):
        yield f"row {i}", row, physics.builder.zero


def _equal(name: str, numbers: Nodes, wanted: Nodes) -> Iterator[Entry]:
    for i, (number, node) in enumerate(zip(numbers, wanted, strict=True)):
        yield f"{name}[{i}]", number, node


def _forward_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    rows = [*derived["rows"], *derived["closing"]]
    yield from _zero(physics, _at(physics, rows, outputs["ud"] + outputs["multipliers"]))


def _rates(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    yield from _forward_dynamics(physics, outputs)
    yield from _equal("qd", outputs["qd"], _derived(physics)["rates"])


def _inverse_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    """tau = M_T w with w = u' - what the loads give, where no conjugate rows say it.

    dT/du is affine in u with the slope M_T: tau is its change from u = 0 to u = w.
    """
    derived = _derived(physics)
    if "forces" in derived:
        yield from _equal("forces", outputs["forces"], _moving(physics, derived))
        return
    speeds, zero = physics.inputs["u"], physics.builder.zero
    moving = gradient(derived["kinetic"], [1], speeds)
    found = _solution(physics, derived["residual"])
    gains = [x - y for x, y in zip(physics.inputs["ud"], found, strict=False)]
    one, two = (
        substitute(physics.builder, moving, dict(zip(speeds, values, strict=True)))
        for values in (gains, [zero] * len(gains))
    )
    yield from _equal("forces", outputs["forces"], [x - y for x, y in zip(one, two, strict=True)])


def _moving(physics: Physics, derived: dict[str, tuple[Node, ...]]) -> Nodes:
    """Rows conjugate to u at the multipliers of the motion."""
    multipliers = physics.inputs["multipliers"]
    if not multipliers:
        return derived["forces"]
    found = _solution(physics, derived["residual"])[-len(multipliers) :]
    values = dict(zip(multipliers, found, strict=True))
    return substitute(physics.builder, derived["forces"], values)


def _jacobians(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    build, rows = physics.builder, _derived(physics)["residual"]
    n = len(physics.inputs["ud"])
    along: dict[Node, Node] = {}
    moved = [build.zero] * n
    for group in STATE:
        for k, entry in enumerate(physics.inputs[group]):
            weight = along[entry] = build.input(f"weight of {group} {k}")
            column = outputs[f"ud_{group}"][n * k : n * (k + 1)]
            moved = [total + weight * slope for total, slope in zip(moved, column, strict=True)]
    slopes = _at(physics, tangent(rows, along), _solution(physics, rows))
    wanted = build.solve(_matrix(physics, rows), [-slope for slope in slopes])
    yield from _equal("along any direction: ud", moved, wanted[:n])


def _energy(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    (kinetic,), (potential,) = derived["kinetic"], derived["potential"]
    for name, value in zip(
        ("kinetic", "potential", "total"), (kinetic, potential, kinetic + potential), strict=True
    ):
        yield from _equal(name, outputs[name], [value])


def _reactions(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    values = _at(physics, derived["reactions"], _solution(physics, derived["residual"]))
    yield from _equal("reactions", outputs["reactions"], values)


def _same(**pairs: str) -> Law:
    """Outputs of a graph that are outputs of the program."""

    def law(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
        derived = _derived(physics)
        for own, name in pairs.items():
            yield from _equal(own, outputs[own], derived[name])

    return law


def law_of(name: str, wanted: Iterable[str]) -> Law | None:
    """What a function has to be; None where it is not known.

    Parameters
    ----------
    wanted : iterable of str
        Outputs of the program of what was derived.
    """
    own, every = f"{WANTED}{name}", tuple(wanted)
    if any(output.startswith(output_name(name, "")) for output in every):
        return partial(_reduced, name)

    def law(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
        for output, numbers in outputs.items():
            yield from _equal(output, numbers, _derived(physics)[own])

    return LAWS.get(name) or (law if own in every else None)


def _reduced(name: str, physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    """A reduced function is the one of which a bound was proved."""
    for output, numbers in outputs.items():
        yield from _equal(output, numbers, _derived(physics)[output_name(name, output)])


LAWS: dict[str, Law] = {
    "forward_dynamics": _forward_dynamics,
    "mass_matrix": _same(mass_matrix="mass"),
    "forcing": _same(forcing="forcing"),
    "residual": _same(residual="residual"),
    "inverse_dynamics": _inverse_dynamics,
    "energy": _energy,
    "momenta": _same(linear="linear", angular="angular", generalized="generalized"),
    "coordinate_rates": _same(qd="rates"),
    "reactions": _reactions,
    "jacobians": _jacobians,
    "rates": _rates,
}
"""By name of a function. The step is composed of the rates, see `translation_validation.step`."""
