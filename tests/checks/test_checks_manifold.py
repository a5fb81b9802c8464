"""States put onto constraints: what depends on the rest, and that nothing else is touched.

The expected numbers follow by hand from each constraint and its derivatives.
"""

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

import pytest
from quaternions import ball_top
from sympy import Expr, S, Symbol, cos, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.manifold import project, restrict
from mechanics.errors import ExpressionError
from mechanics.kernel import Verdict, enclose
from mechanics.kinematics.printer import symbols
from mechanics.kinematics.symbolic import Kinematics
from mechanics.program import Node
from mechanics.program.interpret import include
from mechanics.routes.rows import acceleration_forms, velocity_forms
from mechanics.scene import Particle, Scene, holonomic, nonholonomic, parameters, reaction
from mechanics.symbolic import Arithmetic, decide
from systems import four_bar, rolling_disc
from tests.linkages import slider_crank

x, y, z, v = dynamicsymbols("x y z v")
m, l, d = parameters("m l d", units="kg m m", typical="1 1 1")


def bead(*expressions: Expr) -> Scene:
    """A particle in space whose constraints hold speeds where they hold derivatives."""
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x + y * ground.y + z * ground.z)
    axes = tuple(zip("XY", (ground.x, ground.y), strict=True))
    rates = {x.diff(), y.diff(), z.diff()}
    return Scene(
        "bead",
        ground,
        origin,
        coordinates=(x, y, z),
        bodies=(Particle("bead", place, m),),
        inputs=(v,),
        reactions=tuple(reaction(n, at=place, on="bead", by=None, along=e) for n, e in axes),
        constraints=tuple(
            (nonholonomic if e.atoms(type(x.diff())) & rates else holonomic)(name, e, name)
            for e, name in zip(expressions, "XY", strict=False)
        ),
    )


def projected(scene: Scene) -> Arithmetic:
    """With the state and its accelerations on the constraints."""
    a = Arithmetic()
    project(a, Kinematics(scene), accelerations=True)
    return a


def values(scene: Scene, **given: int) -> Mapping[str, float]:
    """What depends on the rest, at a state."""
    a = projected(scene)
    outputs = {symbol.name: [node] for symbol, node in a.assigned.items()}
    program = a.builder.program(outputs)
    found = enclose(program, {name: Fraction(given[name]) for name in program.inputs}, 80)
    return {name: float(number) for name, (number,) in found.items()}


SCENES = {
    "four bar": four_bar.scene(),
    "rolling disc": rolling_disc.scene(),
    "slider crank, cut at the rod": slider_crank("end of the rod"),
    "slider crank, cut at the slider": slider_crank("slider"),
    "one square": bead(x**2 + y**2 - l**2),
    "two squares": bead(x**2 + 3 * x * y - cos(y), z**2 - y**2 - 2),
}


def forms_of(a: Arithmetic, kinematics: Kinematics) -> list[Node]:
    """The constraints with their first and second derivatives, as nodes."""
    mechanism, named = kinematics.mechanism, symbols(kinematics.scene)
    closing = mechanism.closure.configuration
    nodes = [*closing, *velocity_forms(mechanism), *acceleration_forms(mechanism)]
    program = mechanism.builder.program({"x": nodes})
    return list(include(a.builder, program, {n: a.value(named[n]) for n in program.inputs})["x"])


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_constraints_and_their_derivatives_vanish(scene: Scene) -> None:
    kinematics = Kinematics(scene)

    def at_points(a: Arithmetic) -> list:
        project(a, kinematics, accelerations=True)
        forms = forms_of(a, kinematics)
        assert len(a.assigned) == len(forms)
        return [(form, 0) for form in forms]

    def as_conditions(a: Arithmetic) -> list:
        restrict(a, kinematics, accelerations=True)
        return [(form, 0) for form in forms_of(a, kinematics)]

    assert decide("constraints", at_points, try_normal=False).shown
    assert decide("constraints", as_conditions, try_normal=False).shown


def test_a_quaternion_is_put_onto_the_unit_sphere() -> None:
    scene = ball_top()
    (rotation,) = scene.rotations

    def experiment(a: Arithmetic) -> list:
        project(a, Kinematics(scene))
        assert set(a.assigned) <= set(scene.q)
        return [(a.value(scene.plain(rotation.square)), 1)]

    assert decide("norm", experiment).shown


def test_free_scene_stays_as_it_is() -> None:
    assert projected(bead()).assigned == {}


def test_length_is_chosen_before_a_coordinate() -> None:
    # x + 2 y = l, x' + 2 y' = 0, x'' + 2 y'' = 0; l is declared positive.
    found = values(bead(x + 2 * y - l), x=3, y=4, x_dot=6, x_ddot=8)
    assert found == {"l": 11, "y_dot": -3, "y_ddot": -4}


def test_constraints_are_solved_together_where_one_alone_cannot_tell() -> None:
    # d + l = x, 2 d + 2 l = y is singular in d and l: d and x are taken.
    scene = bead(l + d - x, 2 * l + 2 * d - y)
    found = values(scene, l=1, y=8)
    assert (found["d"], found["x"]) == (3, 4)


@pytest.mark.parametrize("sign", [1, -1])
def test_positive_length_is_the_positive_root(sign: int) -> None:
    # l^2 = x^2 + y^2, whichever way round it is written.
    found = values(bead(sign * (x**2 + y**2 - l**2)), x=3, y=4, x_dot=8, x_ddot=0)
    assert found == {"l": 5, "y_dot": -6, "y_ddot": -25}


def decided(scene: Scene, left: Expr, right: Expr) -> Verdict:
    """Whether two expressions are equal where the constraints hold."""

    def experiment(a: Arithmetic) -> list[tuple[Node, Node]]:
        restrict(a, Kinematics(scene))
        return [(a.value(scene.plain(left)), a.value(scene.plain(right)))]

    return decide("left = right", experiment).verdict


@pytest.mark.parametrize("example", [{}, {"x": 3, "y": 4}, {"x": 4, "y": 3}])
def test_a_root_is_one_of_two_though_the_example_has_its_sign(example: dict[str, int]) -> None:
    # Both halves of a circle are one component: the bead goes round.
    circle = replace(bead(x**2 + y**2 - 25), example=example)
    assert decided(circle, y**2, 25 - x**2) is Verdict.PROVED
    assert decided(circle, x * x.diff(), -y * y.diff()) is Verdict.PROVED
    for false in (y - sqrt(25 - x**2), abs(y) - y, x - sqrt(25 - y**2)):
        assert decided(circle, false, S.Zero) is Verdict.REFUTED, false


@pytest.mark.parametrize("name", ["branch_of_x", "branch of x"])
def test_a_root_is_chosen_by_no_symbol_of_a_statement(name: str) -> None:
    # x^2 = y^4: x = y^2 or -y^2, whatever the sign of another symbol.
    other = Symbol(name, real=True)
    assert decided(bead(x**2 - y**4), x, y**2 * abs(other) / other) is Verdict.REFUTED


def test_dependent_speed_is_the_last_that_is_held() -> None:
    # x' = 3 y' + v: z is free, though it comes last; x'' = 3 y'' + v'.
    scene = bead(x.diff() - 3 * y.diff() - v)
    found = values(scene, x_dot=10, v=1, x_ddot=7, v_dot=1)
    assert found == {"y_dot": 3, "y_ddot": 2}


def test_acceleration_has_what_the_coefficients_change_by() -> None:
    # x' = y z'  and  x'' = y' z' + y z''
    scene = replace(bead(x.diff() - y * z.diff()), example={"y": 1})
    found = values(scene, x_dot=6, y=2, y_dot=5, x_ddot=19)
    assert found == {"z_dot": 3, "z_ddot": 2}


@pytest.mark.parametrize(
    ("closing", "positive"),
    [(x + 2 * y - l, ["l"]), (x**2 + y**2 - l**2, ["l"]), (x + y - z, []), (x**2 - y**4, [])],
)
def test_what_is_declared_positive_has_to_be(closing: Expr, positive: list[str]) -> None:
    a = projected(bead(closing))
    solved = {node: symbol.name for symbol, node in a.assigned.items()}
    assert [solved[node] for node in a.positive] == positive


def test_nothing_has_a_value_at_a_singular_state() -> None:
    # x' = y z' tells nothing of z' where y = 0.
    scene = replace(bead(x.diff() - y * z.diff()), example={"y": 1})
    a = projected(scene)
    program = a.builder.program({s.name: [node] for s, node in a.assigned.items()})
    state = dict.fromkeys(program.inputs, Fraction(1)) | {"y": Fraction(0)}
    found = enclose(program, state, 80)
    assert not any(number.is_finite() for (number,) in found.values())


def test_constraint_without_exact_points_is_refused() -> None:
    scene = bead(x**3 + y**3 + z**3 - 1)
    with pytest.raises(ExpressionError, match="bead: no exact point on its constraints is known"):
        project(Arithmetic(), Kinematics(scene))
    assert decided(scene, x, y) is Verdict.UNDECIDED


def test_what_was_used_before_is_refused() -> None:
    scene, a = bead(x + 2 * y - l), Arithmetic()
    a.value(l)
    with pytest.raises(ValueError, match="symbol l has been used"):
        project(a, Kinematics(scene))
