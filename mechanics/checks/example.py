"""An example that gives every coordinate of a constraint satisfies it, within its digits.

    |phi(q)| <= sum_i |dphi/dq_i| d_i,    d_i half a unit of the last digit of q_i              (1)

A coordinate that the example leaves out follows from the others. A constraint that is not linear in
the coordinates closes in several ways: there an example may be rough, and says which one is meant.
"""

from collections.abc import Mapping
from fractions import Fraction

from mechanics.closure import BITS, closed_state
from mechanics.errors import SceneError
from mechanics.kernel import enclose
from mechanics.mechanism import Mechanism, name_of
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.scene import Scene

ROUNDED = 1e-9
"""What code may have lost that computed a coordinate in doubles, of that or of 1."""


def check_example(scene: Scene, mechanism: Mechanism) -> None:
    """Refuse an example that contradicts a linear constraint at the typical values.

    Raises
    ------
    SceneError
        With the first constraint that does not hold, its value, and for each coordinate the nearest
        value at which it does.
    """
    example = {name: Fraction(str(float(value))) for name, value in scene.example.items()}
    typical = {p.name: p.typical for p in scene.parameters if getattr(p, "typical", None)}
    for constraint in mechanism.constraints:
        coordinates = [q for q in mechanism.q if name_of(q) in example]
        if constraint.holonomic:
            _check(scene, constraint.name, constraint.expression, coordinates, typical | example)


def _check(
    scene: Scene, name: str, value: Node, coordinates: list[Node], state: Mapping[str, Fraction]
) -> None:
    """Equation (1) for one constraint, where all that it holds is given."""
    builder = value.builder
    slopes = gradient([value], [1], coordinates)
    program = builder.program({"value": [value], "slopes": slopes})
    curved = {name_of(q) for q in coordinates} & set(builder.program({"slopes": slopes}).inputs)
    if curved or not state.keys() >= set(program.inputs):
        return
    balls = enclose(program, dict(state), BITS)
    (found,), rates = ([float(ball.mid()) for ball in balls[key]] for key in ("value", "slopes"))
    given = [state[name_of(q)] for q in coordinates]
    allowed = sum(abs(r) * half_digit(float(v)) for r, v in zip(rates, given, strict=True))
    if not abs(found) > allowed:
        return
    nearest = []
    for q, rate in zip(coordinates, rates, strict=True):
        closed = closed_state(builder, [value], [q], state) if rate else {}
        if closed:
            nearest.append(f"{name_of(q)} = {float(closed[name_of(q)]):.6g}")
    there = ", ".join(f"{name_of(q)} = {float(state[name_of(q)]):.6g}" for q in coordinates)
    cure = f"{' or '.join(nearest)} satisfies it" if nearest else "correct the example"
    raise SceneError(
        f"constraint {name}: the example of {scene.name} contradicts it: at {there} it is"
        f" {found:.6g}, not zero, at the typical values: {cure}; a coordinate that the example"
        " leaves out follows from the others"
    )


def half_digit(value: float) -> float:
    """Half a unit of the last digit of a number, as Python writes it."""
    mantissa, _, exponent = str(value).partition("e")
    decimals = len(mantissa.partition(".")[2]) - int(exponent or 0)
    return max(10.0**-decimals / 2, ROUNDED * max(1.0, abs(value)))


def contradicted(example: Mapping[str, float], values: Mapping[str, float]) -> dict[str, float]:
    """What an example gives and is not so, but for its digits, among values by their names."""
    return {
        name: float(value)
        for name, value in example.items()
        if name in values and abs(values[name] - value) > half_digit(float(value))
    }
