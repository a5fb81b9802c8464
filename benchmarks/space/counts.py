"""What compiled outputs cost, in operations after sharing, beside figures of others.

The figures of others are quoted: SymPyBotics counts multiplications and additions, CasADi's
instructions hold sines and cosines as well.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass

from benchmarks.space import scenes
from benchmarks.space.counting import Counts, count
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.elimination import expand_solves
from mechanics.program.forward import tangent
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import joint_tree
from mechanics.recursions.local_equations import jacobian
from mechanics.recursions.pseudo_inertia import Moments, grouped, moments
from mechanics.routes.rows import remainder

MASSES = (moments, grouped)


@dataclass(frozen=True)
class Cost:
    """Operations of one output; `others` and `goal` as sums where a sum is quoted."""

    work: str
    multiplications: int
    additions: int
    functions: int
    parameters: int
    others: str = ""
    goal: str = ""


def measure(mechanism: Mechanism, nodes: Sequence[Node]) -> Counts:
    """Operations of nodes, those of parameters only apart."""
    program = expand_solves(mechanism.builder.program({"all": nodes}))
    moving = (*mechanism.q, *mechanism.qd, *mechanism.qdd, *mechanism.u, *mechanism.ud)
    first = mechanism.builder.operands[0]
    names = {mechanism.builder.inputs[first[node.number]] for node in moving}
    names |= {mechanism.builder.inputs[first[node.number]] for node in mechanism.given_rates}
    return count(program, set(program.inputs) - names)


def cheapest(mechanism: Mechanism, candidates: Sequence[Sequence[Node]]) -> Counts:
    """Operations of the candidate that has the fewest."""
    return min((measure(mechanism, nodes) for nodes in candidates), key=lambda c: c.total)


def inverse_dynamics(mechanism: Mechanism) -> Counts:
    """Generalized forces in q, u and u', masses as they are or grouped."""
    return cheapest(mechanism, [newton_euler.rows(mechanism, m(mechanism)) for m in MASSES])


def inverse_jacobians(mechanism: Mechanism) -> Counts:
    """Derivatives of the generalized forces by q and u, by columns or by rows."""
    one, variables = mechanism.builder.one, [*mechanism.q, *mechanism.u]
    candidates = []
    for masses in MASSES:
        rows = newton_euler.rows(mechanism, masses(mechanism))
        candidates.append([e for x in variables for e in tangent(rows, {x: one})])
        candidates.append([e for row in rows for e in gradient([row], [1], variables)])
    return cheapest(mechanism, candidates)


def _trees(mechanism: Mechanism) -> Iterator[tuple[Moments, list]]:
    for masses in MASSES:
        found = masses(mechanism)
        links = joint_tree(mechanism, found)
        assert links is not None, mechanism.name
        yield found, list(links)


def matrix(mechanism: Mechanism) -> Counts:
    """Upper triangle of M."""
    found = [mass_matrix(mechanism, links) for _, links in _trees(mechanism)]
    return cheapest(
        mechanism, [[e for i, row in enumerate(rows) for e in row[i:]] for rows in found]
    )


def forward(mechanism: Mechanism) -> Counts:
    """u' by composite bodies and L D L^T, or by articulated bodies."""
    candidates = []
    for masses, links in _trees(mechanism):
        rows = newton_euler.rows(mechanism, masses)
        bias = remainder(mechanism.builder, rows, mechanism.ud)
        own = mass_matrix(mechanism, links)
        right = [-entry for entry in bias]
        candidates.append(mechanism.builder.solve(own, right, symmetric=True))
        candidates.append(forward_dynamics(mechanism, links, bias))
    return cheapest(mechanism, candidates)


def forward_jacobians(mechanism: Mechanism) -> Counts:
    """Derivatives of u' by q and u."""
    variables = [*mechanism.q, *mechanism.u]
    found = [jacobian(mechanism, links, variables) for _, links in _trees(mechanism)]
    return cheapest(mechanism, [[entry for row in rows for entry in row] for rows in found])


WORK: tuple[tuple[str, Callable, Callable, str, str], ...] = (
    ("inverse dynamics, PUMA 560", scenes.puma560, inverse_dynamics,
     "SymPyBotics 345 + 296", "300 + 260"),
    ("inverse dynamics, 7R Panda", scenes.panda, inverse_dynamics,
     "SymPyBotics 415 + 354", "380 + 330"),
    ("inverse dynamics, UR5, numbers in", scenes.ur5, inverse_dynamics,
     "Newton-Euler in CasADi 479", ""),
    ("inverse dynamics, pendulum_chain(10)", lambda: scenes.chain(10), inverse_dynamics,
     "Newton-Euler in CasADi 293", "293"),
    ("M, pendulum_chain(10)", lambda: scenes.chain(10), matrix, "closed form 382", "382"),
    ("M, UR5, numbers in", scenes.ur5, matrix, "composite bodies in CasADi 622", ""),
    ("forward dynamics, pendulum_chain(10)", lambda: scenes.chain(10), forward,
     "articulated bodies in CasADi 595", ""),
    ("forward dynamics, UR5, numbers in", scenes.ur5, forward,
     "composite bodies + LDL^T 856", "800"),
    ("forward dynamics, PUMA 560", scenes.puma560, forward, "", ""),
    ("forward dynamics, 7R Panda", scenes.panda, forward, "", ""),
    ("Jacobians of forward dynamics, pendulum_chain(10)", lambda: scenes.chain(10),
     forward_jacobians, "by ca.jacobian 5208", "4000"),
)  # fmt: skip

RATIOS = (
    ("PUMA 560", scenes.puma560),
    ("7R Panda", scenes.panda),
    ("UR5, numbers in", scenes.ur5),
    ("tree of 12 bodies", lambda: scenes.tree(12)),
    ("pendulum_chain(10)", lambda: scenes.chain(10)),
)


def costs() -> list[dict]:
    """Every row of the table."""
    found = []
    for work, make, measured, others, goal in WORK:
        c = measured(lower(make(), Builder()))
        numbers = (c.multiplications, c.additions, c.functions, c.parameters)
        found.append(asdict(Cost(work, *numbers, others, goal)))
    return found


def ratios() -> list[dict]:
    """Jacobians of inverse dynamics by q and u, and inverse dynamics itself."""
    found = []
    for name, make in RATIOS:
        mechanism = lower(make(), Builder())
        one, all_ = inverse_dynamics(mechanism).total, inverse_jacobians(mechanism).total
        found.append({"scene": name, "inverse dynamics": one, "Jacobians": all_})
    return found
