"""What the name of a function says is what it is taken for, or it is asked for."""

import pytest
from notation_scenes import truth

from mechanics import check
from mechanics.claims.code.function_names import function_name
from mechanics.errors import InputError
from systems import acrobot, atwood, cartpole, gyroscope, rocker, rod_pendulum

MATH = "#include <math.h>\n"
CART = (
    MATH + "double {}(double theta, double theta_dot, double x_ddot, double theta_ddot, double mc,"
    " double mp, double l) {{ return (mc + mp)*x_ddot"
    " + mp*l*(theta_ddot*cos(theta) - theta_dot*theta_dot*sin(theta)); }}"
)
ROD = (
    MATH + "double {}(double theta, double theta_ddot, double m, double l, double g) {{"
    " return m*l*l/3*theta_ddot - m*g*l/2*sin(theta); }}"
)
ROCKER = (
    MATH + "double {}(double theta, double theta_dot, double theta_ddot, double M, double I_C,"
    " double R, double g) {{ double s = sin(theta), c = cos(theta);"
    " return ((I_C + M*R*R*(1.25 + c))*theta_ddot - 0.5*M*R*R*theta_dot*theta_dot*s"
    " - 0.5*M*g*R*s){}; }}"
)


@pytest.mark.parametrize(
    ("title", "word", "owner"),
    [
        ("normalForce", "reaction", {"normal"}), ("rope_tension", "tension", {"rope"}),
        ("tension2", "tension", {"2"}), ("compute_tension", "tension", set()),
        ("powerOfMotor", "power", {"motor"}), ("pivotForceX", "force", {"pivot", "x"}),
        ("torque_at_elbow", "torque", {"elbow"}), ("railFriction", "part", {"rail"}),
        ("natural_frequency", "frequency", set()), ("period", "period", set()),
        ("angular_momentum", "angular momentum", set()), ("accel_from_force", "", set()),
        ("pendulum_with_friction", "", set()), ("f", "", set()), ("get_", "", set()),
        ("forced_pendulum", "", set()), ("", "", set()),
    ],
)  # fmt: skip
def test_a_name_ends_with_what_it_is(title: str, word: str, owner: set[str]) -> None:
    said = function_name(title)
    assert (said.word, set(said.owner)) == (word, owner)


@pytest.mark.parametrize("name", ["F", "controlForce", "force", "cart_force", "inverse_dynamics"])
def test_a_force_that_drives_is_the_only_input(name: str) -> None:
    right = CART.format(name)
    assert check(cartpole.scene(), right, notation="c", blame=False).verdict.name == "PROVED"
    wrong = right.replace("- theta_dot", "+ theta_dot")
    assert check(cartpole.scene(), wrong, notation="c", blame=False).verdict.name != "PROVED"


@pytest.mark.parametrize(
    "name", ["railFriction", "pivotForceX", "pole_torque", "gravityForce", "tau1", "side_force"]
)
def test_another_force_is_asked_for(name: str) -> None:
    with pytest.raises(InputError, match="nothing says which"):
        check(cartpole.scene(), CART.format(name), notation="c")


def test_a_normal_force_is_no_input() -> None:
    found = check(cartpole.scene(), CART.format("normalForce"), notation="c", blame=False)
    assert found.verdict.name == "UNDECIDED"


@pytest.mark.parametrize(
    ("name", "verdict"),
    [("torque", "PROVED"), ("motorTorque", "PROVED"), ("u", "PROVED"), ("power", "REFUTED"),
     ("angularMomentum", "REFUTED")],
)  # fmt: skip
def test_what_drives_a_rod(name: str, verdict: str) -> None:
    found = check(rod_pendulum.scene(), ROD.format(name), notation="c", blame=False)
    assert found.verdict.name == verdict


@pytest.mark.parametrize("name", ["frictionTorque", "force", "gravity_torque"])
def test_what_does_not_drive_a_rod_is_asked_for(name: str) -> None:
    with pytest.raises(InputError, match="nothing says which"):
        check(rod_pendulum.scene(), ROD.format(name), notation="c")


@pytest.mark.parametrize(
    ("name", "by", "verdict"),
    [
        ("controlForce", "/(R + 0.5*R*c)", "PROVED"), ("controlForce", "", "REFUTED"),
        ("moment", "", "PROVED"), ("moment", "/(R + 0.5*R*c)", "REFUTED"),
        ("f", "/(R + 0.5*R*c)", "PROVED"),
    ],
)  # fmt: skip
def test_a_force_is_the_input_and_a_moment_what_it_does(name: str, by: str, verdict: str) -> None:
    found = check(rocker.scene(), ROCKER.format(name, by), notation="c", blame=False)
    assert found.verdict.name == verdict


def test_a_number_says_which_joint() -> None:
    """The shoulder of an acrobot has no motor, the elbow has tau."""
    elbow = (
        MATH + "double {}(double theta1, double theta2, double theta1_dot, double theta1_ddot,"
        " double theta2_ddot, double m2, double l1, double lc2, double I2, double g) {{ return"
        " (m2*(lc2*lc2 + l1*lc2*cos(theta2)) + I2)*theta1_ddot + (m2*lc2*lc2 + I2)*theta2_ddot"
        " + m2*l1*lc2*sin(theta2)*theta1_dot*theta1_dot + m2*lc2*g*sin(theta1 + theta2); }}"
    )
    scene = acrobot.scene()
    assert check(scene, elbow.format("tau"), notation="c", blame=False).verdict.name == "PROVED"
    for name in ("tau1", "shoulderTorque", "torque1"):
        with pytest.raises(InputError, match="nothing says which"):
            check(scene, elbow.format(name), notation="c")


def test_one_of_several_torques_without_a_name_is_asked_for() -> None:
    code = (
        "double {}(double theta1, double theta2, double theta1_ddot, double m1) {{"
        " return m1*theta1_ddot; }}"
    )
    for name, words in (("elbowTorque", "nothing says which"), ("elbow", "takes accelerations")):
        with pytest.raises(InputError, match=words):
            check(truth("arm"), code.format(name), notation="c")


@pytest.mark.parametrize("factor", ["", "2*"])
def test_a_momentum_is_that_of_its_name(factor: str) -> None:
    code = (
        MATH + "double {}(double beta, double alpha_dot, double gamma_dot, double C) {{"
        f" return {factor}C*(gamma_dot + alpha_dot*sin(beta)); }}}}"
    )
    scene = gyroscope.scene()
    found = check(scene, code.format("p_gamma"), notation="c", blame=False)
    assert found.verdict.name == ("REFUTED" if factor else "PROVED")
    assert check(scene, code.format("p_alpha"), notation="c", blame=False).verdict.name == "REFUTED"


@pytest.mark.parametrize(
    ("name", "verdict"), [("T1", "PROVED"), ("T2", "REFUTED"), ("lower_tension", "UNDECIDED")]
)
def test_a_tension_is_that_of_its_name(name: str, verdict: str) -> None:
    code = (
        "double {}(double m1, double m2, double m3, double g)"
        " {{ return 8.0*m1*m2*m3*g/(4.0*m2*m3 + m1*(m2 + m3)); }}"
    )
    found = check(atwood.scene(), code.format(name), notation="c", blame=False)
    assert found.verdict.name == verdict


@pytest.mark.parametrize("name", ["omega", "natural_frequency", "wn"])
def test_a_frequency_is_no_acceleration(name: str) -> None:
    code = MATH + "double {}(double l, double g) {{ return sqrt({}*g/l); }}"
    for factor, right in (("1.5", True), ("3", False)):
        found = check(rod_pendulum.scene(), code.format(name, factor), notation="c", blame=False)
        assert found.ok is right


def test_an_equation_without_its_input_may_be_a_residual() -> None:
    """The row of the pole, which the force on the cart is no part of."""
    code = (
        MATH + "double row(double theta, double x_ddot, double theta_ddot, double l, double g) {"
        " return 4.0/3*l*theta_ddot + x_ddot*cos(theta) - g*sin(theta); }"
    )
    for factor, verdict in (("4.0", "PROVED"), ("5.0", "REFUTED")):
        wrong = code.replace("4.0", factor)
        found = check(cartpole.scene(), wrong, notation="c", blame=False)
        assert found.verdict.name == verdict
        assert any("residual" in note for note in found.judged[0].statement.notes)


ENERGY = (
    MATH + "double {}(double x_dot, double theta, double theta_dot, double mc, double mp,"
    " double l) {{ return 0.5*(mc + mp)*x_dot*x_dot + mp*l*x_dot*theta_dot*cos(theta)"
    " + 2.0/3*mp*l*l*theta_dot*theta_dot; }}"
)


@pytest.mark.parametrize(
    "name",
    [
        "kinetic_energy",
        "totalKineticEnergy",
        "kinetic_energy_of_all",
        "two_body_kinetic_energy",
        "kinetic_energy_of_two_masses",
    ],
)
def test_an_energy_is_that_of_all(name: str) -> None:
    found = check(cartpole.scene(), ENERGY.format(name), notation="c", blame=False)
    assert found.verdict.name == "PROVED"


@pytest.mark.parametrize(
    "name", ["pole_kinetic_energy", "cartKineticEnergy", "rotational_kinetic_energy",
             "kinetic_energy_of_pole", "kinetic_energy_2", "kinetic_energy_of_body_two"]
)  # fmt: skip
def test_an_energy_of_a_part_is_asked_for(name: str) -> None:
    with pytest.raises(InputError, match=r"returns the kinetic energy of .* alone"):
        check(cartpole.scene(), ENERGY.format(name), notation="c")
    about = check(
        cartpole.scene(), ENERGY.format(name), notation="c", about="kinetic energy", blame=False
    )
    assert about.verdict.name == "PROVED"
