"""States that are drawn, and motions through them, read from the declaration."""

from flint import arb
from linkages import lifted_bead
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.as_declared import Motion
from mechanics.checks.jets import precision
from mechanics.checks.states import State
from mechanics.scene import Particle, Scene, holonomic, parameters, reaction

x, y, z = dynamicsymbols("x y z")


def slider() -> Scene:
    """A bead on a rail that is lifted as prescribed."""
    N, O = ReferenceFrame("N"), Point("O")
    bead = O.locatenew("B", x * N.x + 2 * y * N.y)
    return Scene("slider", N, O, coordinates=(x,), inputs=(y,),
                 bodies=(Particle("bead", bead, *parameters("m")),))  # fmt: skip


def state(scene: Scene) -> State:
    n = len(scene.coordinates)
    return State(scene, 0, [arb(i + 1) / 4 for i in range(n)], [arb(i + 2) / 8 for i in range(n)])


def test_what_is_prescribed_moves_along_the_motion_and_stands_still_virtually() -> None:
    with precision(100):
        here = state(slider())
        assert here.motion([arb(1)]).coefficients(y)[1] != 0
        for virtual in here.virtual_motions(2):
            _, rate, bend = virtual.coefficients(y)
            assert rate == 0
            assert bend == 0
            assert virtual.coefficients(x)[1] != 0


def test_a_place_is_its_components_and_the_origin_none() -> None:
    with precision(100):
        scene = slider()
        motion = Motion(scene, state(scene).motion([arb(1)]))
        place, rate, bend = motion.centre("bead").parts
        inputs = motion.instant.coefficients(y)
        assert place.entries() == [arb(1) / 4, 2 * inputs[0], 0]
        assert rate.entries() == [arb(1) / 4, 2 * inputs[1], 0]
        assert bend.entries()[0] == arb(1) / 2
        assert all(part.entries() == [0, 0, 0] for part in motion.position(scene.origin).parts)
        assert (motion.position(scene.origin).parts[0].nrows(), place.nrows()) == (3, 3)


def test_time_runs_along_the_motion_alone() -> None:
    with precision(100):
        here = state(lifted_bead())
        time = dynamicsymbols._t
        assert here.motion([arb(1), arb(1)]).coefficients(time)[1] == 1
        assert all(v.coefficients(time)[1] == 0 for v in here.virtual_motions(1))


def test_a_state_comes_to_where_all_constraints_hold() -> None:
    """A plane is met in one step of Newton's method, a ball in several."""
    N, O = ReferenceFrame("N"), Point("O")
    bead = O.locatenew("B", x * N.x + y * N.y + z * N.z)
    scene = Scene(
        "bead", N, O, coordinates=(x, y, z), bodies=(Particle("bead", bead, *parameters("m")),),
        reactions=tuple(reaction(n, bead, "bead", None, e) for n, e in (("P", N.x), ("Q", N.z))),
        constraints=(holonomic("plane", 2 * x - y, "P"), holonomic("ball", x**2 + z**2 - 1, "Q")),
    )  # fmt: skip
    with precision(400):
        closed = state(scene).on_constraints()
        a, b, c = closed.q
        assert (2 * a - b).contains(0) and (a**2 + c**2 - 1).contains(0)
        assert all(entry.rad() < 1e-50 for entry in closed.q)
