"""States put onto constraints: what depends on the rest, and that nothing else is touched.

The expected numbers follow by hand from each constraint and its derivatives.
"""

from collections.abc import Mapping
from fractions import Fraction

import pytest
from quaternions import ball_top
from sympy import Expr, Symbol, cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.errors import ExpressionError
from mechanics.kernel import Verdict, enclose
from mechanics.kinematics.constraints import velocity_forms
from mechanics.kinematics.manifold import ConstraintManifold
from mechanics.program import Node
from mechanics.scene import Particle, Scene, holonomic, nonholonomic, parameters, reaction
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.symbols import plain_symbol
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
    a, manifold = Arithmetic(), ConstraintManifold(scene)
    manifold.project(a)
    manifold.project_accelerations(a)
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


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_constraints_and_their_derivatives_vanish(scene: Scene) -> None:
    closing = [scene.plain(c.expression) for c in scene.constraints if c.holonomic]
    forms = velocity_forms(scene)
    slopes = [rate(form, rate_table(scene)) for form in forms]

    def experiment(a: Arithmetic) -> list:
        ConstraintManifold(scene).project(a)
        assert len(a.assigned) == len(closing) + len(forms)
        ConstraintManifold(scene).project_accelerations(a)
        assert len(a.assigned) == len(closing) + 2 * len(forms)
        return [(a.value(entry), 0) for entry in (*closing, *forms, *slopes)]

    assert decide("constraints", experiment, try_normal=False).shown


def test_a_quaternion_is_put_onto_the_unit_sphere() -> None:
    scene = ball_top()
    (rotation,) = scene.rotations

    def experiment(a: Arithmetic) -> list:
        ConstraintManifold(scene).project(a)
        assert set(a.assigned) == set(scene.q)
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


@pytest.mark.parametrize(("branch", "root", "speed"), [(1, -1, -2), (-1, -2, 5)])
def test_coordinate_has_either_root(branch: int, root: int, speed: int) -> None:
    # 2 x^2 + 6 x y + 4 y^4 = 0: at y = 1, x = -1 or -2; (4 x + 6 y) x' + (6 x + 16 y^3) y' = 0.
    scene = bead(2 * x**2 + 6 * x * y + 4 * y**4)
    found = values(scene, **{"y": 1, "branch of x": branch, "x_dot": 10, "x_ddot": 0})
    assert (found["x"], found["y_dot"]) == (root, speed)


@pytest.mark.parametrize("name", ["branch_of_x", "branch of x"])
def test_a_root_is_chosen_by_no_symbol_of_a_statement(name: str) -> None:
    # x^2 = y^4: x = y^2 or -y^2, whatever the sign of another symbol.
    other = Symbol(name, real=True)

    def experiment(a: Arithmetic) -> list[tuple[Node, Node]]:
        ConstraintManifold(bead(x**2 - y**4)).project(a)
        return [(a.value(plain_symbol(x)), a.value(plain_symbol(y) ** 2 * abs(other) / other))]

    assert decide("x = y^2 sgn", experiment).verdict is Verdict.REFUTED


def test_each_of_two_squares_is_solved_for_what_it_alone_holds() -> None:
    # z^2 + y^2 = 5 holds y, too, which the first constraint needs: its own is z.
    scene = bead(x**2 - y**3, y**2 + z**2 - 5)
    found = values(scene, **{"y": 1, "branch of x": 1, "branch of z": -1, "x_dot": 3, "x_ddot": 0})
    # 2 x x' = 3 y^2 y',  y y' + z z' = 0
    assert [found[name] for name in ("x", "z", "y_dot", "z_dot")] == [1, -2, 2, 1]


def test_dependent_speed_is_the_last_that_is_held() -> None:
    # x' = 3 y' + v: z is free, though it comes last; x'' = 3 y'' + v'.
    scene = bead(x.diff() - 3 * y.diff() - v)
    found = values(scene, x_dot=10, v=1, x_ddot=7, v_dot=1)
    assert found == {"y_dot": 3, "y_ddot": 2}


def test_acceleration_has_what_the_coefficients_change_by() -> None:
    # x' = y z'  and  x'' = y' z' + y z''
    found = values(bead(x.diff() - y * z.diff()), x_dot=6, y=2, y_dot=5, x_ddot=19)
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
    scene = bead(x.diff() - y * z.diff())
    a = projected(scene)
    program = a.builder.program({s.name: [node] for s, node in a.assigned.items()})
    state = dict.fromkeys(program.inputs, Fraction(1)) | {"y": Fraction(0)}
    found = enclose(program, state, 80)
    assert not any(number.is_finite() for (number,) in found.values())


@pytest.mark.parametrize("closing", [x**3 + y**3 + z**3 - 1, cos(x) + cos(y) + cos(z)])
def test_constraint_without_exact_points_is_refused(closing: Expr) -> None:
    with pytest.raises(ExpressionError, match=r"bead: .* linear in no 1 quantities together"):
        ConstraintManifold(bead(closing)).project(Arithmetic())


def test_second_constraint_without_a_square_of_its_own_is_refused() -> None:
    with pytest.raises(ExpressionError, match="quadratic in nothing that it alone holds"):
        ConstraintManifold(bead(x**2 + y**2 - 1, y**2 + x**2 - z**3)).project(Arithmetic())


def test_what_was_used_before_is_refused() -> None:
    scene, a = bead(x + 2 * y - l), Arithmetic()
    a.value(l)
    with pytest.raises(ValueError, match="symbol l has been used"):
        ConstraintManifold(scene).project(a)


def test_one_manifold_serves_every_arithmetic() -> None:
    manifold, texts = ConstraintManifold(four_bar.scene()), set()
    for _ in range(2):
        a = Arithmetic()
        manifold.project(a)
        texts.add(str(a.builder.program({s.name: [n] for s, n in a.assigned.items()})))
    assert len(texts) == 1
    assert repr(manifold) == "<constraint manifold of four-bar linkage>"
