"""The states at which the constraints of a scene hold, for statements and for points.

phi(q; p) = 0        A(q) u + a = 0        A(q) u' = b, where a statement holds free accelerations

A statement has them as conditions, and the kernel goes to where they hold. At a point that only
proposes, what depends on the rest has the value that the closure gives it (`mechanics.closure`).
"""

from mechanics.closure import extended
from mechanics.errors import ExpressionError
from mechanics.kernel import Range
from mechanics.kinematics.printer import symbols
from mechanics.kinematics.symbolic import Kinematics
from mechanics.mechanism import name_of, ranges
from mechanics.program.interpret import include
from mechanics.routes.rows import acceleration_forms
from mechanics.symbolic import Arithmetic


def restrict(a: Arithmetic, kinematics: Kinematics, *, accelerations: bool = False) -> None:
    """Make an experiment a statement about the states at which the constraints hold.

    Parameters
    ----------
    accelerations : bool
        Whether u', too, is only what the constraints admit.
    """
    mechanism, named = kinematics.mechanism, symbols(kinematics.scene)
    closure = mechanism.closure
    if not closure:
        return
    rates, dependent = list(closure.rates), list(closure.dependent)
    if accelerations:
        rates += acceleration_forms(mechanism)
        dependent = [*map(name_of, reversed(mechanism.ud)), *dependent]
    program = mechanism.builder.program({"zero": closure.configuration, "rates": rates})
    nodes = include(a.builder, program, {name: a.value(named[name]) for name in program.inputs})
    a.constrain(nodes["zero"], nodes["rates"], closure.start, dependent)


def project(a: Arithmetic, kinematics: Kinematics, *, accelerations: bool = False) -> None:
    """Give dependent quantities the values that the constraints ask for.

    Must run before any other expression is evaluated in this arithmetic.

    Parameters
    ----------
    accelerations : bool
        Whether dependent accelerations get theirs, too.

    Raises
    ------
    ExpressionError
        When no exact point on the constraints is known.
    """
    mechanism, named = kinematics.mechanism, symbols(kinematics.scene)
    signs = ranges(mechanism)
    closure = mechanism.closure
    if closure and accelerations:
        names = map(name_of, reversed(mechanism.ud))
        closure = extended(mechanism.builder, closure, acceleration_forms(mechanism), names, signs)
    if closure and not closure.values:
        raise ExpressionError(
            f"{kinematics.scene.name}: no exact point on its constraints is known"
        )
    values = {name_of(old): [new] for old, new in closure.values.items()}
    program = mechanism.builder.program(values)
    given = {name: a.value(named[name]) for name in program.inputs if name in named}
    for name, (node,) in include(a.builder, program, given).items():
        if signs.get(name) is Range.POSITIVE:
            a.require_positive(node)
        a.assign(named[name], node)
