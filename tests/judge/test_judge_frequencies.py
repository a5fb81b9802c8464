"""Frequencies and periods of small oscillations, which a text gives beside its equations."""

from functools import cache
from pathlib import Path

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from benchmarks.corpus.load import HERE, scene_of
from mechanics.equations import Equations
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction
from systems import cartpole, cylinder_in_cylinder, two_mass_chain
from tests.notation_scenes import judged, verdicts

SWING = r"\[ \ddot\theta = -\frac gl\sin\theta \]"


@cache
def rolling() -> Equations:
    return derived(cylinder_in_cylinder.scene())


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\omega = \sqrt{\frac{g}{l}}", r"\omega = \sqrt{\frac{2g}{l}}"),
        (r"\omega_0^2 = \frac{g}{l}", r"\omega_0^2 = \frac{l}{g}"),
        (r"T = 2\pi\sqrt{\frac lg}", r"T = 2\pi\sqrt{\frac gl}"),
        (r"T = 2\pi\sqrt{\frac lg}", r"T = \pi\sqrt{\frac lg}"),
        (r"f = \frac{1}{2\pi}\sqrt{\frac gl}", r"f = \frac{1}{\pi}\sqrt{\frac gl}"),
        ("omega = sqrt(g/l)", "omega = sqrt(l/g)"),
        ("omega = sqrt(g/l)", "omega = -sqrt(g/l)"),
    ],
)
def test_frequencies(right: str, wrong: str) -> None:
    assert verdicts("pendulum", right) == ["PROVED"]
    assert verdicts("pendulum", wrong) == ["REFUTED"]


def test_it_is_told_what_it_is_read_as() -> None:
    found = judged("pendulum", SWING + r" Its frequency is $\omega = \sqrt{g/l}$.")
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED", "PROVED"]
    notes = found.judged[1].statement.notes
    assert (
        "omega on the left is read as the frequency of small oscillations about theta = 0" in notes
    )


def test_a_frequency_is_that_of_a_stable_equilibrium() -> None:
    right = r"\omega = \sqrt{\frac{2g}{3(R-a)}}"
    (entry,) = mechanics.check(rolling(), right, blame=False).judged
    assert entry.finding.verdict.name == "PROVED"
    (entry,) = mechanics.check(rolling(), right.replace("3", "2"), blame=False).judged
    assert entry.finding.verdict.name == "REFUTED"


@pytest.mark.parametrize(
    "line", [r"\omega = \dot\theta", r"\omega = 7", r"\ddot\theta + \omega^2\sin\theta = 0"]
)
def test_what_may_be_something_else_stays_in_doubt(line: str) -> None:
    assert "UNDECIDED" in verdicts("pendulum", line)


LOWER = (
    r"\omega^2 = \frac{(m_1+m_2)g(l_1+l_2)"
    r" - \sqrt{(m_1+m_2)^2 g^2(l_1+l_2)^2 - 4 m_1(m_1+m_2) g^2 l_1l_2}}{2 m_1 l_1 l_2}"
)


@pytest.mark.campaign
def test_both_frequencies_of_a_double_pendulum() -> None:
    assert verdicts("double", LOWER) == ["PROVED"]
    assert verdicts("double", LOWER.replace(r"- \sqrt", r"+ \sqrt")) == ["PROVED"]
    assert verdicts("double", LOWER.replace("- 4 m_1", "- 2 m_1")) == ["REFUTED"]


def test_a_frequency_about_the_other_equilibrium() -> None:
    hanging = r"\omega = \sqrt{\frac{3(m_c+m_p)g}{l(4m_c+m_p)}}"
    truth = derived(cartpole.scene())
    found = mechanics.check(truth, hanging, blame=False)
    assert [e.finding.verdict.name for e in found.judged] == ["PROVED"]
    assert any("theta = pi" in note for note in found.judged[0].statement.notes)


@cache
def chain() -> Equations:
    return derived(two_mass_chain.scene())


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"$\omega_1 = \sqrt{k/m}$, $\omega_2 = \sqrt{k/(6m)}$", ["PROVED", "PROVED"]),
        ("omega1 = sqrt(k/m)\nomega2 = sqrt(k/(6*m))", ["PROVED", "PROVED"]),
        (r"$\omega_1 = \sqrt{k/m}$, $\omega_2 = \sqrt{k/m}$", ["UNDECIDED", "UNDECIDED"]),
        (r"The two are $\omega_1 = \omega_2 = \sqrt{k/m}$.", ["UNDECIDED", "UNDECIDED"]),
        ("omega^2 = k/m\nomega^2 = k/(6*m)", ["PROVED", "PROVED"]),
        ("omega = sqrt(k/(7*m))\nomega = sqrt(k/m)", ["REFUTED", "PROVED"]),
        (r"A frequency is $\omega = \sqrt{k/m}$.", ["PROVED"]),
        (r"The lowest frequency is $\omega = \sqrt{k/m}$.", ["UNDECIDED"]),
        (r"The lowest frequency is $\omega = \sqrt{k/(6m)}$.", ["PROVED"]),
        (r"The higher frequency is $\omega = \sqrt{k/m}$.", ["PROVED"]),
        (r"The higher frequency is $\omega = \sqrt{k/(6m)}$.", ["UNDECIDED"]),
        (r"The longest period is $T = 2\pi\sqrt{6m/k}$.", ["UNDECIDED"]),
        (r"The only frequency is $\omega = \sqrt{k/m}$.", ["UNDECIDED"]),
    ],
)
def test_of_several_frequencies_each_is_another_root(text: str, verdict: list[str]) -> None:
    found = mechanics.check(chain(), text, blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == verdict


@cache
def trolleys() -> Equations:
    """Two trolleys that a spring of the length a holds apart, free to roll away together."""
    x, y = dynamicsymbols("x y")
    M, m, k, a = parameters("M m k a", units="kg kg N/m m")
    N, O = ReferenceFrame("N"), Point("O")
    ends = [O.locatenew(name, q * N.x) for name, q in (("P", x), ("Q", y))]
    pull = k * (y - x - a) * N.x
    return derived(
        Scene(
            "trolleys", N, O, coordinates=(x, y),
            bodies=(Particle("first", ends[0], M), Particle("second", ends[1], m)),
            loads=(force("on first", ends[0], pull, on="first"),
                   force("on second", ends[1], -pull, on="second")),
            reactions=tuple(
                reaction(f"{side} {name}", at=end, on=name, by=None, along=axis)
                for name, end in zip(("first", "second"), ends, strict=True)
                for side, axis in (("y", N.y), ("z", N.z))
            ),
        )
    )  # fmt: skip


def test_a_frequency_beside_a_mode_that_moves_freely() -> None:
    right = r"\omega = \sqrt{\frac{k(M+m)}{Mm}}"
    assert [e.verdict.name for e in mechanics.check(trolleys(), right).judged] == ["PROVED"]
    (wrong,) = mechanics.check(trolleys(), r"\omega = \sqrt{\frac{kM}{Mm}}").judged
    assert wrong.verdict.name == "REFUTED"
    assert wrong.blame is not None
    (edit,) = wrong.blame.repairs[0].edits
    assert "m" in edit.right


@cache
def hung() -> Equations:
    """A sleeve that hangs on a spring of the length a, on a rod that swings."""
    r, phi = dynamicsymbols("r phi")
    m, k, a, g = parameters("m k a g", units="kg N/m m m/s^2")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (phi, N.z))
    P = O.locatenew("P", -r * A.y)
    return derived(
        Scene(
            "sleeve", N, O, plane=N.z, coordinates=(r, phi), bodies=(Particle("bob", P, m),),
            loads=(gravity(-g * N.y), force("spring", P, k * (r - a) * A.y, on="bob")),
        )
    )  # fmt: skip


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (r"It oscillates about $r = a + \frac{mg}{k}$, $\phi = 0$.", "PROVED"),
        (r"It oscillates about $r = a + \frac{mg}{k}$, $\phi = \pi$.", "UNDECIDED"),
        (r"It oscillates about $r = a - \frac{mg}{k}$, $\phi = 0$.", "UNDECIDED"),
        (r"It oscillates about $r = a + \frac{mg}{k}$.", "UNDECIDED"),
        (r"Up and down its frequency is $\omega = \sqrt{k/m}$.", "PROVED"),
        (r"Up and down its frequency is $\omega = \sqrt{2k/m}$.", "REFUTED"),
    ],
)
def test_a_place_among_several_coordinates(text: str, verdict: str) -> None:
    assert verdict in [e.verdict.name for e in mechanics.check(hung(), text, blame=False).judged]


@cache
def damped() -> Equations:
    x, force_of_drive = dynamicsymbols("x F")
    m, c, k = parameters("m c k", units="kg N*s/m N/m", typical="1 0.5 4")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x)
    pull = (force_of_drive - k * x - c * x.diff()) * ground.x
    block = Particle("block", place, m)
    loads = (force("pull", place, pull, on="block"),)
    scene = Scene("damped", ground, origin, (x,), (block,), loads, inputs=(force_of_drive,))
    return derived(scene)


NATURAL, OF_MOTION, RESONANT = r"\sqrt{k/m}", r"\sqrt{k/m - c^2/(4m^2)}", r"\sqrt{k/m - c^2/(2m^2)}"


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        (rf"The natural frequency is $\omega = {NATURAL}$.", "PROVED"),
        (rf"$\omega_n = {NATURAL}$", "PROVED"),
        (rf"The natural period is $T = 2\pi/{NATURAL}$.", "PROVED"),
        (rf"The natural frequency of the damped oscillator is $\omega = {NATURAL}$.", "PROVED"),
        (rf"As shown, it slows down and has the frequency $\omega = {NATURAL}$.", "UNDECIDED"),
        (rf"Without neglecting damping, the frequency is $\omega = {NATURAL}$.", "UNDECIDED"),
        (rf"As shown, the frequency is $\omega = {OF_MOTION}$.", "PROVED"),
        (rf"Its frequency is $\omega = {NATURAL}$.", "UNDECIDED"),
        (rf"The damped frequency is $\omega = {NATURAL}$.", "UNDECIDED"),
        (rf"Its period is $T = 2\pi/{NATURAL}$.", "UNDECIDED"),
        (rf"Its frequency is $\omega = {OF_MOTION}$.", "PROVED"),
        (rf"Its period is $T = 2\pi/{OF_MOTION}$.", "PROVED"),
        (rf"The undamped frequency is $\omega = {OF_MOTION}$.", "UNDECIDED"),
        (rf"The resonance frequency is $\omega = {RESONANT}$.", "PROVED"),
        (rf"Its frequency is $\omega = {RESONANT}$.", "UNDECIDED"),
        (r"Its frequency is $\omega = \sqrt{k/m - c^2/(3m^2)}$.", "REFUTED"),
    ],
)
def test_a_damper_makes_three_frequencies(text: str, verdict: str) -> None:
    (entry,) = mechanics.check(damped(), text, blame=False).judged
    assert entry.finding.verdict.name == verdict


def test_an_edit_is_searched_for_each_root() -> None:
    """A pendulum on a spring: its length at rest is l + m g/k."""
    scene = scene_of(HERE / "scenes" / "bobs_and_hinged_rods.py", "spring_x")
    (entry,) = mechanics.check(scene, r"\[ \omega_2 = \sqrt{\frac{g}{l - \frac{m g}{k}}} \]").judged
    assert entry.blame is not None
    assert [(e.written, e.right) for e in entry.blame.repairs[0].edits] == [("-", "+")]


@pytest.mark.parametrize("other", [r"$\omega := \dot\theta$", r"$\omega = \dot\theta$ is its rate"])
def test_a_name_of_a_rate_is_no_frequency(other: str) -> None:
    text = other + r", $\dot\omega = -\frac gl\sin\theta$, $\omega = \sqrt{g/l}$"
    assert verdicts("pendulum", text) == ["PROVED", "UNDECIDED"]
    apart = text.replace(r"$\omega = \sqrt", r"$\omega_0 = \sqrt")
    assert verdicts("pendulum", apart) == ["PROVED", "PROVED"]


LENGTH = r"$\omega = \sqrt{g/l}$"


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("At the lower equilibrium the frequency of small oscillations is {}.", "PROVED"),
        ("At the upper equilibrium the frequency of small oscillations is {}.", "UNDECIDED"),
        (r"The frequency of small oscillations about $\theta = 0$ is {}.", "PROVED"),
        (r"The frequency of small oscillations about $\theta = \pi$ is {}.", "UNDECIDED"),
        ("The frequency about the unstable equilibrium is {}.", "UNDECIDED"),
        ("The upper equilibrium is unstable. Near the lower one the frequency is {}.", "PROVED"),
        ("For an amplitude of a quarter turn the frequency is {}.", "UNDECIDED"),
        ("For large oscillations the frequency is {}.", "UNDECIDED"),
        ("For small amplitudes the frequency is {}.", "PROVED"),
        ("The frequency of small oscillations is {}, independent of the amplitude.", "PROVED"),
    ],
)
def test_what_the_sentence_says_of_the_place_and_of_the_size(words: str, verdict: str) -> None:
    assert verdicts("pendulum", words.format(LENGTH)) == [verdict]


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("The undamped natural frequency is {}.", "PROVED"),
        ("The undamped frequency is {}.", "PROVED"),
        ("The natural frequency of the undamped system is {}.", "PROVED"),
        ("The damped natural frequency is {}.", "UNDECIDED"),
        ("The system is undamped. The natural frequency is {}.", "UNDECIDED"),
        ("Without damping, the natural frequency is {}.", "PROVED"),
        ("Without damping, the damped natural frequency is {}.", "UNDECIDED"),
        ("The system moves without damping. The natural frequency is {}.", "UNDECIDED"),
        ("Without damping and the natural frequency is {}.", "UNDECIDED"),
    ],
)
def test_undamped_is_said_of_a_frequency_or_of_the_scene(words: str, verdict: str) -> None:
    scene = scene_of(HERE / "scenes" / "oscillators.py", "linear")
    found = mechanics.check(scene, words.format(r"$\omega_n = \sqrt{k/m}$"), blame=False)
    assert [entry.verdict.name for entry in found.judged] == [verdict]


CHAIN = """import math


def {}(k, m):
    return math.sqrt({}*k/m)
"""


@pytest.mark.parametrize(
    ("title", "factor", "verdict"),
    [
        ("natural_frequency", "1/6", "PROVED"),
        ("natural_frequency", "1", "PROVED"),
        ("lower_natural_frequency", "1/6", "PROVED"),
        ("lower_natural_frequency", "1", "UNDECIDED"),
        ("fundamental_frequency", "1", "UNDECIDED"),
        ("highestNaturalFrequency", "1/6", "UNDECIDED"),
        ("highestNaturalFrequency", "1", "PROVED"),
        ("second_frequency", "1/6", "UNDECIDED"),
        ("frequency_of_small_oscillations", "1/6", "PROVED"),
    ],
)
def test_the_name_of_a_function_says_which(
    title: str, factor: str, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / "chain.py"
    path.write_text(CHAIN.format(title, factor))
    things = things_in(path, run_python=True)
    found = mechanics.check(two_mass_chain.scene(), things, blame=False)
    assert found.verdict.name == verdict


def test_of_two_with_parameters_of_their_own_the_smaller_root_is_the_lower(tmp_path: Path) -> None:
    path = tmp_path / "chain.py"
    for sign, verdict in (("-", "PROVED"), ("+", "UNDECIDED")):
        path.write_text(
            "import math\n\n\ndef lower_frequency(m1, m2, k1, k2):\n"
            "    b = m1*k2 + m2*(k1 + k2)\n"
            f"    return math.sqrt((b {sign} math.sqrt(b*b - 4*m1*m2*k1*k2))/(2*m1*m2))\n"
        )
        things = things_in(path, run_python=True)
        found = mechanics.check(two_mass_chain.unequal(), things, blame=False)
        assert found.verdict.name == verdict
