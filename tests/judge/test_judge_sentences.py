"""What sentences around a right equation say of the scene: against it, as it is, or not read."""

import importlib
import importlib.util

import pytest

from mechanics import check, check_html, check_json
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.kernel import Verdict

EQUATIONS = {
    "rod_pendulum": r"\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}",
    "cartpole": (
        r"(m_c+m_p)\ddot x + m_pl\cos\theta\,\ddot\theta - m_pl\sin\theta\,\dot\theta^2 = F"
    ),
    "double_pendulum": (
        r"l_2\ddot\varphi_2+l_1\ddot\varphi_1\cos(\varphi_1-\varphi_2)"
        r"-l_1\dot\varphi_1^2\sin(\varphi_1-\varphi_2)+g\sin\varphi_2=0"
    ),
    "two_mass_chain": r"3m\ddot x_1 + 2kx_1 - kx_2 = 0",
    "bead_on_hoop": r"\ddot\theta=(\omega^2\cos\theta-g/R)\sin\theta",
    "elastic_pendulum": (
        r"(M+m)\ddot x + 2kx + "
        r"\frac{ML}{2}(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)=0"
    ),
}
"""Right ones, by their system."""

AGAINST = [
    ("rod_pendulum", r"$l$ is measured in centimetres, everything else in SI units."),
    ("rod_pendulum", r"with $\theta$ in $^\circ$:"),
    ("rod_pendulum", r"Time is measured in minutes."),
    ("rod_pendulum", r"A common mistake is"),
    ("rod_pendulum", r"The answer is the negative of"),
    ("rod_pendulum", r"The rod is massless and carries a bob of mass $m$ at its end."),
    ("rod_pendulum", r"There is viscous damping in the pivot."),
    ("rod_pendulum", r"The rod lies on a horizontal table, so that gravity does no work."),
    ("rod_pendulum", r"The motion takes place in a horizontal plane."),
    ("rod_pendulum", r"Gravity is neglected."),
    ("cartpole", r"El carro se mueve con rozamiento."),
    ("rod_pendulum", r"La barra cae sin gravedad."),
    ("cartpole", "\u274c"),
    ("rod_pendulum", r"where $l$ denotes the radius of gyration of the rod,"),
    ("rod_pendulum", r"The pivot is accelerated upwards with $a$."),
    ("cartpole", r"The pole has no mass."),
    ("cartpole", r"Both bodies have the same mass."),
    ("cartpole", r"The cart is held fixed."),
    ("cartpole", r"The cart experiences Coulomb friction."),
    ("cartpole", r"where $F$ is the force on the pole,"),
    ("double_pendulum", r"The two rods have equal length."),
    ("double_pendulum", r"where $\varphi_2$ is the angle between the two rods,"),
    ("double_pendulum", r"The masses are connected by a spring."),
    ("two_mass_chain", r"Each spring is damped by a dashpot."),
    ("bead_on_hoop", r"The bead slides with friction."),
    ("bead_on_hoop", r"where $\omega$ is the angular velocity of the bead along the hoop,"),
    ("two_mass_chain", r"Springs have stiffness $2k$ each."),
    ("two_mass_chain", r"Both masses are equal to $m$."),
    (
        "elastic_pendulum",
        r"where $m$ is the mass of the rod, $M$ the mass of the cart, $L$ its length:",
    ),
    ("elastic_pendulum", r"$L$ is the distance from $B$ to $C$."),
    ("elastic_pendulum", r"$x$ is the position of the mass centre of the pendulum."),
    ("cartpole", r"The pole is a massless rod with a point mass at its end."),
    ("bead_on_hoop", r"With friction $\mu$,"),
    ("double_pendulum", r"$m_1$ is the lower mass and $m_2$ the upper mass."),
]
AS_IT_IS = [
    ("rod_pendulum", r"Figure 3 shows the rod and its free-body diagram."),
    ("rod_pendulum", r"Hence"),
    ("rod_pendulum", r"where $l$ is in metres, $m$ in kilograms and time in seconds,"),
    ("rod_pendulum", r"where $g$ is gravity,"),
    (
        "rod_pendulum",
        r"Consider a uniform rod of length $l$ and mass $m$ that is hinged at one end.",
    ),
    ("rod_pendulum", r"We neglect friction in the pivot."),
    ("rod_pendulum", r"Taking moments about the pivot gives"),
    (
        "rod_pendulum",
        r"where $u$ is the torque at the pivot and $\theta$ the angle from the upward vertical,",
    ),
    ("rod_pendulum", r"This result is well known; see Section 2.3 of the textbook."),
    ("cartpole", r"The cart moves without friction along a horizontal track."),
    ("cartpole", r"A pole of mass $m_p$ is hinged to a cart of mass $m_c$."),
    (
        "cartpole",
        r"Here $x$ is the position of the cart, $\theta$ the angle of the pole from the vertical.",
    ),
    ("cartpole", r"where $F$ is the horizontal force on the cart,"),
    ("double_pendulum", r"The rods are massless and carry point masses at their ends."),
    ("double_pendulum", r"Both angles are measured from the downward vertical."),
    ("double_pendulum", r"The equations are nonlinear and coupled."),
    ("two_mass_chain", r"where $x_1$ and $x_2$ are the displacements from equilibrium,"),
    ("two_mass_chain", r"Applying Newton's second law to the first mass,"),
    (
        "bead_on_hoop",
        r"A bead of mass $m$ slides without friction on a circular hoop of radius $R$.",
    ),
    (
        "bead_on_hoop",
        r"The hoop rotates about its vertical diameter with constant angular velocity $\omega$.",
    ),
    ("elastic_pendulum", r"The carriage is attached to two identical springs of stiffness $k$."),
]


@pytest.fixture(scope="module")
def truths() -> dict[str, Equations]:
    systems = {name: importlib.import_module(f"systems.{name}") for name in EQUATIONS}
    return {name: derived(module.scene()) for name, module in systems.items()}


@pytest.mark.parametrize(("system", "said"), AGAINST)
def test_what_is_against_the_scene_or_not_read_shows_nothing(
    truths: dict[str, Equations], system: str, said: str
) -> None:
    answer = check(truths[system], f"{said} $${EQUATIONS[system]}$$", blame=False)
    assert answer.verdict is Verdict.UNDECIDED
    words = [entry.finding.evidence for entry in answer.judged if not entry.finding.shown]
    assert all("the text" in one for one in words)


@pytest.mark.parametrize(("system", "said"), AS_IT_IS)
def test_what_is_said_as_the_scene_has_it_disturbs_nothing(
    truths: dict[str, Equations], system: str, said: str
) -> None:
    answer = check(truths[system], f"{said} $${EQUATIONS[system]}$$", blame=False)
    assert answer.verdict is Verdict.PROVED


@pytest.mark.parametrize(
    ("comment", "verdict"),
    [
        ("theta in degrees, clockwise", Verdict.UNDECIDED),
        ("theta: angle from the downward vertical (hanging)", Verdict.UNDECIDED),
        ("l: half the length of the rod", Verdict.UNDECIDED),
        ("l: length of the rod, theta: angle from the upward vertical", Verdict.PROVED),
    ],
)
@pytest.mark.parametrize("opens", ["# ", '"""'])
def test_comments_and_documentation_of_code_are_prose(
    truths: dict[str, Equations],
    tmp_path,
    comment: str,
    verdict: Verdict,
    opens: str,  # type: ignore[no-untyped-def]
) -> None:
    closes = opens.strip() if opens != "# " else ""
    source = (
        "from math import sin\n\n\ndef f(theta, theta_dot, u, m, l, g):\n"
        f"    {opens}{comment}{closes}\n    return 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)\n"
    )
    path = tmp_path / "written.py"
    path.write_text(source)
    spec = importlib.util.spec_from_file_location("written", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert check(truths["rod_pendulum"], module.f, blame=False).verdict is verdict


FILES = {
    ".cpp": "void f(const double x[2], double u, double dx[2]) {{\n{}\ndx[0] = x[1];\n"
            "dx[1] = 1.5*g/l*sin(x[0]) + 3*u/(m*l*l);\n}}\n",
    ".jl": "function f!(dx, x, p, t)\n(; m, l, g, u) = p\n{}\ndx[1] = x[2]\n"
           "dx[2] = 1.5*g/l*sin(x[1]) + 3*u/(m*l^2)\nend\n",
    ".m": "function dx = f(t, x, u, m, l, g)\n{}\n"
          "dx = [x(2); 1.5*g/l*sin(x(1)) + 3*u/(m*l^2)];\nend\n",
}  # fmt: skip
FILES[".c"] = FILES[".cpp"].replace("double u", "double u, double m, double l, double g")
MARKS = [
    (".c", "/* {}\n * {} */"), (".cpp", "// {}\n// {}"), (".cpp", "/** {}\n * {} */"),
    (".jl", "# {}\n# {}"), (".jl", "#=\n{}\n{}\n=#"), (".jl", 'println("{} {}")'),
    (".m", "% {}\n% {}"), (".m", "%{{\n{}\n{}\n%}}"), (".m", "disp('{} {}');"),
]  # fmt: skip


@pytest.mark.sample(4)
@pytest.mark.parametrize(("suffix", "marks"), MARKS)
def test_words_in_code_of_any_language_are_of_the_classes_of_a_text(
    truths: dict[str, Equations],
    tmp_path,
    suffix: str,
    marks: str,  # type: ignore[no-untyped-def]
) -> None:
    path = tmp_path / f"words{suffix}"
    for first, second, verdict in (
        ("FIXME: the sign", "is wrong", Verdict.UNDECIDED),
        ("it holds only", "for small angles", Verdict.UNDECIDED),
        ("the rod is", "massless", Verdict.UNDECIDED),
        ("the rod is made", "of steel", Verdict.PROVED),
    ):
        path.write_text(FILES[suffix].format(marks.format(first, second)))
        answer = check(truths["rod_pendulum"], path, blame=False)
        assert answer.verdict is verdict
        if verdict is Verdict.PROVED:
            assert answer.unjudged == ("the rod is made of steel",)


LIMITS = [
    r"Unlike the true model, the author has",
    r"Without an external torque we have",
    r"This is for a thread with a bob and holds only for small $\theta$:",
    r"Die Reibung wird nicht vernachlässigt.",
    r"\[ g = 10 \text{ unless it is measured} \]",
]


@pytest.mark.parametrize("said", LIMITS)
def test_what_denies_or_limits_shows_nothing(truths: dict[str, Equations], said: str) -> None:
    answer = check(truths["rod_pendulum"], f"{said} $${EQUATIONS['rod_pendulum']}$$", blame=False)
    assert answer.verdict is Verdict.UNDECIDED
    assert any("denies or limits" in e.finding.evidence for e in answer.judged)


def test_a_convention_explains_no_denial(truths: dict[str, Equations]) -> None:
    turned = r"$$\ddot\theta = -\frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}$$"
    options = {"convention": "other vertical", "blame": False}
    assert check(truths["rod_pendulum"], turned, **options).ok
    denied = check(truths["rod_pendulum"], f"This is wrong: {turned}", **options)
    assert denied.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("formula", "why"),
    [
        (r"%s \tag{false}", "false"),
        (r"%s \tag*{not valid}", "not"),
        (r"\ddot\theta \stackrel{?}{=} RIGHT", "?"),
        (r"\ddot\theta \overset{!}{=} RIGHT", "?"),
        (r"\underbrace{\ddot\theta}_{\text{negligible}} = RIGHT", "negligible"),
    ],
)
def test_labels_in_a_formula_are_sentences(
    truths: dict[str, Equations], formula: str, why: str
) -> None:
    whole = EQUATIONS["rod_pendulum"]
    text = formula.replace("%s", whole).replace("RIGHT", whole.partition("=")[2])
    answer = check(truths["rod_pendulum"], f"$${text}$$", blame=False)
    assert answer.verdict is Verdict.UNDECIDED
    assert why in answer.judged[0].finding.evidence


MARKUP = [
    (r"\st{%s}", r"\st"),
    (r"\setbox0\hbox{%s}", r"\setbox"),
    (r"\cite{%s}", r"\cite"),
    (r"{\color{white} %s}", r"\color"),
    (r"\begin{question}%s\end{question}\begin{solution}\end{solution}", "question"),
    ("<details>%s</details>", "details"),
    ("<p style='display:none'>%s</p>", "<p>"),
    ("<!-- %s -->", "commented"),
    (">! %s", "quotation"),
    ("> [!note]- Fold\n> %s", "quotation"),
    ("> > %s", "quotation"),
    ("Ann wrote:\n\n> %s", "quotation"),
    ("> %s\n\nI doubt it.", "quotation"),
    ("> %s\n> \u2014 Ann", "quotation"),
    ("~~%s~~", "struck"),
]


@pytest.mark.parametrize(("around", "told"), MARKUP)
def test_a_formula_is_stated_only_inside_markup_that_shows_it_plainly(
    truths: dict[str, Equations], around: str, told: str
) -> None:
    formula = f"${EQUATIONS['rod_pendulum']}$"
    answer = check(truths["rod_pendulum"], around.replace("%s", formula), blame=False)
    assert answer.verdict is Verdict.UNDECIDED
    assert any(told in entry.finding.evidence for entry in answer.judged)


@pytest.mark.parametrize(
    ("around", "verdict"),
    [
        ("### Rod\n\n> %s", "PROVED"),
        ("> - the mass $m$\n> - the length $l$\n\nThe rod obeys %s", "PROVED"),
        ("> [!note] Rod\n> %s", "PROVED"),
        ("> This is wrong: %s", "UNDECIDED"),
    ],
)
def test_a_quotation_is_text_of_the_page(
    truths: dict[str, Equations], around: str, verdict: str
) -> None:
    formula = f"${EQUATIONS['rod_pendulum']}$"
    answer = check(truths["rod_pendulum"], around.replace("%s", formula), blame=False)
    assert answer.verdict.name == verdict


@pytest.mark.parametrize("said", ["g = -9.81", "m = 0"])
def test_a_value_that_the_scene_cannot_have_shows_nothing(
    truths: dict[str, Equations], said: str
) -> None:
    text = f"{said}\ntheta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    assert check(truths["rod_pendulum"], text, blame=False).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("said", "verdict"),
    [
        (r"with $g = -9.81\,\mathrm{m/s^2}$", Verdict.UNDECIDED),
        (r"with $g = \SI{-9.81}{m/s^2}$", Verdict.UNDECIDED),
        (r"\[ l = -2\,\text{m} \]", Verdict.UNDECIDED),
        (r"with $g = 9.81\,\mathrm{m/s^2}$", Verdict.PROVED),
    ],
)
def test_a_value_in_its_unit(truths: dict[str, Equations], said: str, verdict: Verdict) -> None:
    text = rf"\[ {EQUATIONS['rod_pendulum']} \] {said}"
    assert check(truths["rod_pendulum"], text, blame=False).verdict is verdict


QUOTED = [
    ("two_mass_chain", r"The springs are made of steel."),
    ("two_mass_chain", r"Federn aus Stahl verbinden die Massen."),
    ("two_mass_chain", r"The first mass is twice as heavy as the second."),
    ("two_mass_chain", r"$x_2$ is the length of the spring."),
    ("two_mass_chain", r"The mode of $\omega=\sqrt{k/m}$ is $\begin{pmatrix}1\\1\end{pmatrix}$."),
    ("bead_on_hoop", r"The hoop turns freely."),
    ("bead_on_hoop", r"The hoop rotates about its horizontal diameter."),
    ("rod_pendulum", r"Energy is mass."),
    ("rod_pendulum", r"We write $m$ for $l$."),
    ("rod_pendulum", r"Here $t$ is the angle."),
    ("rod_pendulum", r"Der Winkel $\theta$ wird von der unteren Ruhelage aus gemessen."),
    ("rod_pendulum", r"Here $g = 1.62\,\mathrm{m/s^2}$ points upwards."),
    ("rod_pendulum", r"A thin hoop of radius $R$ turns about a pin on its rim."),
    ("rod_pendulum", r"The rod's moment of inertia about its pivot is $m l^2$."),
    ("cartpole", "The wheels roll without slipping."),
    ("cartpole", "Las ruedas ruedan sin deslizar."),
    ("cartpole", "Die Räder rollen ohne zu gleiten."),
    ("cartpole", "\U0001f4cc Problem of the cart"),
    ("cartpole", "考虑摆长为单摆\uff0e摆球的运动方程"),
    ("cartpole", "The cart <!--more-->"),
    ("rod_pendulum", "The rod is \u27e8= a hoop\u27e9."),
    ("rod_pendulum", r"For $\theta \ll 1$ we have"),
    ("rod_pendulum", r"$t < 0$:"),
    ("cartpole", r"The magnet pulls the cart."),
    ("double_pendulum", r"It is a simple pendulum."),
    ("rod_pendulum", r"\section{The rod is a helix}"),
    ("rod_pendulum", r'"The rod is a helix."'),
]


@pytest.mark.parametrize(("system", "said"), QUOTED)
def test_what_is_neither_compared_nor_denies_is_quoted(
    truths: dict[str, Equations], system: str, said: str
) -> None:
    answer = check(truths[system], f"{said} $${EQUATIONS[system]}$$", blame=False)
    assert answer.verdict is Verdict.PROVED
    (words,) = answer.unjudged
    first = str(answer).splitlines()[0]
    assert first == "The formulas are PROVED. 1 sentence around them was not judged."
    assert f"not judged: '{words[:20]}" in " ".join(str(answer).split())
    assert check_json(answer)["unjudged"] == [words]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("system", "said"), dict(QUOTED).items())
def test_what_is_quoted_is_counted_on_the_page(
    truths: dict[str, Equations], system: str, said: str
) -> None:
    answer = check(truths[system], f"{said} $${EQUATIONS[system]}$$", blame=False)
    assert "Not judged beside the statements: 1" in check_html(answer)


@pytest.mark.parametrize(
    "said",
    ["Thus we obtain", "and", "Figure 1", "Solution.", "## Equations of motion\n\n",
     "where $m$ is the mass of the rod and $u$ the applied torque,"],
)  # fmt: skip
def test_what_only_connects_and_what_the_scene_has_is_not_quoted(
    truths: dict[str, Equations], said: str
) -> None:
    answer = check(truths["rod_pendulum"], f"{said} $${EQUATIONS['rod_pendulum']}$$", blame=False)
    assert answer.ok
    assert not answer.unjudged


def test_sentences_are_not_counted_first_where_a_formula_is_not_shown(
    truths: dict[str, Equations],
) -> None:
    answer = check(
        truths["rod_pendulum"], r"A steel rod: $$\ddot\theta = \sin\theta$$", blame=False
    )
    assert answer.unjudged == ("A steel rod: …",)
    assert str(answer).startswith("REFUTED")


@pytest.mark.parametrize(
    ("way", "verdict"), [("downward", Verdict.PROVED), ("upward", Verdict.REFUTED)]
)
def test_a_sentence_on_every_angle_is_one_on_each(
    truths: dict[str, Equations], way: str, verdict: Verdict
) -> None:
    text = f"Both angles are measured from the {way} vertical. $${EQUATIONS['double_pendulum']}$$"
    assert check(truths["double_pendulum"], text, blame=False).verdict is verdict


@pytest.mark.parametrize(
    ("system", "said", "verdict"),
    [
        ("rod_pendulum", "The length of the rod is $l$.", Verdict.PROVED),
        ("rod_pendulum", "A rod of mass $m$ and radius $l$ turns.", Verdict.UNDECIDED),
        ("cartpole", "$m_c$ and $m_p$ are the masses of the cart and the pole.", Verdict.PROVED),
        ("cartpole", "$m_c$ and $m_p$ are the masses of the pole and the cart.", Verdict.UNDECIDED),
        ("cartpole", "The length of the pole is $l$.", Verdict.REFUTED),
        ("cartpole", "$x$ is the velocity of the cart.", Verdict.UNDECIDED),
        ("cartpole", "$F$ is the torque on the cart.", Verdict.UNDECIDED),
        ("bead_on_hoop", "The kinetic energy of the bead is conserved.", Verdict.UNDECIDED),
    ],
)
def test_a_name_is_what_a_sentence_of_any_form_says(
    truths: dict[str, Equations], system: str, said: str, verdict: Verdict
) -> None:
    answer = check(truths[system], f"{said} $${EQUATIONS[system]}$$", blame=False)
    assert answer.verdict is verdict


@pytest.mark.parametrize(
    ("written", "quoted"),
    [
        (r"$$%s$$ with $\dot\theta = 0$.", r"\dot\theta = 0"),
        (r"$$%s$$ where $\dot g = 1$.", r"\dot g = 1"),
        (r"$$%s$$ where $u = 0$.", "u = 0"),
        (r"$$%s \quad\text{for}\quad \theta = 0$$", r"for \theta = 0"),
        (r"$$%s$$ with $g = 32.2\,\mathrm{ft/s^2}$.", "ft/s^2"),
        (r"$$%s$$ with $g = 9.81\,\mathrm{m/s^2}$.", ""),
        (r"- [ ] $$%s$$", "[ ]"),
    ],
)
def test_where_an_equation_holds_is_quoted_and_refutes_nothing(
    truths: dict[str, Equations], written: str, quoted: str
) -> None:
    answer = check(truths["rod_pendulum"], written % EQUATIONS["rod_pendulum"], blame=False)
    assert answer.verdict is Verdict.PROVED
    assert quoted in "".join(answer.unjudged)
    assert bool(answer.unjudged) is bool(quoted)


@pytest.mark.parametrize("said", ["for theta = 0", "with theta' = 0"])
def test_a_condition_behind_a_line_of_text_is_no_equation(
    truths: dict[str, Equations], said: str
) -> None:
    text = f"theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2) {said}"
    answer = check(truths["rod_pendulum"], text, blame=False)
    assert (answer.verdict, answer.unjudged) == (Verdict.PROVED, (said,))


@pytest.mark.parametrize(
    "written", [r"$$%s,\quad m = l$$", r"$$%s$$ where $\vartheta$ is an angle", r"$$%s$$ $m = l$"]
)
def test_names_that_may_be_two_and_aliases_of_another_unit_show_nothing(
    truths: dict[str, Equations], written: str
) -> None:
    answer = check(truths["rod_pendulum"], written % EQUATIONS["rod_pendulum"], blame=False)
    assert answer.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("said", [r"where $l$ is $2m$", "the rest is theta'' = 0", "and $b > 1$"])
def test_a_sentence_with_a_formula_is_quoted_among_many(
    truths: dict[str, Equations], said: str
) -> None:
    many = " ".join(
        f"Chapter {word} tells of history." for word in ["one", "two", "three", "four"] * 4
    )
    text = f"{many}\n\n${EQUATIONS['rod_pendulum']}$. Beside that {said}."
    assert said.replace("$", "") in " ".join(str(check(truths["rod_pendulum"], text)).split())
