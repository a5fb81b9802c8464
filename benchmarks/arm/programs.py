"""Inverse and forward dynamics of the 7R Panda with general inertias, its numbers bound early."""

from collections.abc import Callable, Sequence
from fractions import Fraction

from benchmarks.space.scenes import panda
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Node, Program
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import include
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import joint_tree
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes.rows import remainder

JOINTS = 7
Q, U, UD, TAU = (
    tuple(f"{name}{i}{rest}" for i in range(1, JOINTS + 1))
    for name, rest in (("q", ""), ("u", ""), ("u", "'"), ("tau", ""))
)
LENGTHS = {"d1": "0.333", "d3": "0.316", "d5": "0.384", "a4": "0.0825", "a7": "0.088"}
BODY = {
    "m": "2.3", "cx": "0.031", "cy": "-0.047", "cz": "0.083", "Ixx": "0.041", "Iyy": "0.037",
    "Izz": "0.029", "Ixy": "0.0023", "Iyz": "-0.0031", "Izx": "0.0017",
}  # fmt: skip
"""Of the first body, in SI units; the others are those times 1 + i / 16."""


def numbers() -> dict[str, Fraction]:
    """Values of all parameters."""
    found = {"g": Fraction("9.81")} | {name: Fraction(text) for name, text in LENGTHS.items()}
    for i in range(1, JOINTS + 1):
        for name, text in BODY.items():
            found[f"{name}{i}"] = Fraction(text) * (1 + Fraction(i - 1, 16))
    return found


def joints() -> list[tuple[float, ...]]:
    """Of each joint: cosine and sine of the turn about x before it, and its offset."""
    d1, d3, d5, a4, a7 = (float(Fraction(text)) for text in LENGTHS.values())
    table = [(0, 0, d1), (-1, 0, 0), (1, 0, d3), (1, a4, 0), (-1, -a4, d5), (1, 0, 0), (1, a7, 0)]
    return [(0.0 if s else 1.0, s, a, -d * s, 0.0 if s else d) for s, a, d in table]


def inverse() -> Program:
    """tau in q, u and u', the cheaper of two groupings of masses."""

    def candidates(mechanism: Mechanism) -> list[Sequence[Node]]:
        return [newton_euler.rows(mechanism, masses(mechanism)) for masses in (moments, grouped)]

    return _cheapest(candidates, "tau")


def forward() -> Program:
    """u' in q, u and tau: composite bodies and L D L^T, or articulated bodies."""

    def candidates(mechanism: Mechanism) -> list[Sequence[Node]]:
        builder, found = mechanism.builder, []
        for masses in (moments(mechanism), grouped(mechanism)):
            links = joint_tree(mechanism, masses)
            assert links is not None  # seven turning joints
            rows = newton_euler.rows(mechanism, masses)
            rest = remainder(builder, rows, mechanism.ud)
            bias = [entry - builder.input(name) for entry, name in zip(rest, TAU, strict=True)]
            own = mass_matrix(mechanism, links)
            found.append(builder.solve(own, [-entry for entry in bias], symmetric=True))
            found.append(forward_dynamics(mechanism, list(links), bias))
        return found

    return _cheapest(candidates, "ud")


def _cheapest(candidates: Callable[[Mechanism], list[Sequence[Node]]], output: str) -> Program:
    mechanism = lower(panda(), Builder())
    named = dict(zip((*mechanism.q, *mechanism.u, *mechanism.ud), (*Q, *U, *UD), strict=True))
    found = [
        _bound(mechanism, nodes, {_name(node): name for node, name in named.items()}, output)
        for nodes in candidates(mechanism)
    ]
    return min(found, key=lambda program: program.count)


def _name(node: Node) -> str:
    builder = node.builder
    return builder.inputs[builder.operands[0][node.number]]


def _bound(
    mechanism: Mechanism, nodes: Sequence[Node], named: dict[str, str], output: str
) -> Program:
    """With numbers in the place of parameters, and what they fold to gone."""
    program = expand_solves(mechanism.builder.program({output: nodes}))
    builder, values = Builder(), numbers()
    given = {
        name: builder.constant(values[name]) if name in values
        else builder.input(named.get(name, name))
        for name in program.inputs
    }  # fmt: skip
    return builder.program(include(builder, program, given))
