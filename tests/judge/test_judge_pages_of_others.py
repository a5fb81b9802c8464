"""Pages as others set them: what only names a thing is passed over, what is wrong is refuted."""

import pytest

from mechanics.errors import InputError
from tests.notation_scenes import judged


def verdict(name: str, text: str, **options: object) -> str:
    return judged(name, text, **options).verdict.name


FENCED = r"""
For the pendulum with $\theta$ from below:

```math
l \ddot\theta = SIGN g \sin\theta
```

which is *nonlinear*.
"""
DIRECTIVE = r"""
A bob of mass :math:`m` hangs on a rod.

.. math::

    l \ddot\theta
    = SIGN g \sin\theta

It swings.
"""
WIKIPEDIA = r"""
θ = ángulo respecto a la vertical

{\displaystyle {\ddot {\theta }}=SIGN{\frac {g}{l}}\operatorname {sen} \theta }
"""
FORUM = r"So we get ##l\ddot\theta = SIGN g\sin\theta## for the bob."
BESIDE = r"$$ l \ddot\theta = SIGN gsin(\theta), \quad m \not= 0 $$"
ROOT = r"$$\ddot\theta + \omega_0^2\sin\theta = 0, \omega_0 = \sqrt \frac{g}{l}$$".replace(
    "+", "TURNED"
)


@pytest.mark.parametrize("page", [FENCED, DIRECTIVE, WIKIPEDIA, FORUM, BESIDE])
def test_an_equation_is_read_where_its_notation_displays_it(page: str) -> None:
    assert verdict("pendulum", page.replace("SIGN", "-")) == "PROVED"
    assert verdict("pendulum", page.replace("SIGN", "-2 ")) == "REFUTED"


def test_a_fraction_is_the_argument_of_a_root() -> None:
    assert verdict("pendulum", ROOT.replace("TURNED", "+")) == "PROVED"
    assert verdict("pendulum", ROOT.replace("TURNED", "+ 2")) == "REFUTED"


ENERGIES = r"""
$$ H = T LAW V $$
$$ H = \frac12 m l^2 \dot\theta^2 - FACTOR m g l \cos\theta $$
"""


def test_the_law_of_an_energy_names_its_parts() -> None:
    right = ENERGIES.replace("LAW", "+").replace("FACTOR", "")
    assert verdict("pendulum", right) == "PROVED"
    assert verdict("pendulum", right.replace("- ", "- 2 ")) == "REFUTED"
    assert verdict("pendulum", ENERGIES.replace("LAW", "-").replace("FACTOR", "")) != "PROVED"


def test_what_only_names_parts_says_nothing_alone() -> None:
    assert verdict("pendulum", "$$ H = T + V $$") == "UNDECIDED"
    assert verdict("pendulum", r"$$ T = T_{bob} + T_{rod} $$") == "UNDECIDED"


def test_a_term_that_is_not_explained_is_no_name_of_a_part() -> None:
    both = r"$$\ddot\theta = a \sin\theta + b \dot\theta$$ $$\ddot\theta = -\frac{g}{l}\sin\theta$$"
    assert verdict("pendulum", both) == "UNDECIDED"
    one = r"$$\ddot\theta = \Omega^2 \sin\theta$$ $$\ddot\theta = -\frac{g}{l}\sin\theta$$"
    assert verdict("pendulum", one) == "UNDECIDED"


SUMMED = r"$$ T = \sum \frac12 m v^2 = \frac12 m (l\dot\theta)^2 = FACTOR m l^2 \dot\theta^2 $$"


def test_a_sum_over_bodies_is_what_the_other_sides_are() -> None:
    assert verdict("pendulum", SUMMED.replace("FACTOR", r"\frac12")) == "PROVED"
    assert verdict("pendulum", SUMMED.replace("FACTOR", r"\frac14")) == "REFUTED"
    with pytest.raises(InputError, match="sum"):
        verdict("pendulum", r"$$ T = \sum \frac12 m v^2 $$")


SERIES = r"""
For small $\theta$ we have
\[ \ddot\theta = -\frac{g}{FACTOR l}\theta + \mathcal{O}(\theta^2) \]
"""


def test_what_a_series_leaves_out_is_no_term() -> None:
    assert verdict("pendulum", SERIES.replace("FACTOR", "")) == "PROVED"
    assert verdict("pendulum", SERIES.replace("FACTOR", "2")) == "REFUTED"


GLOSSARY = """
The equation of the pendulum is:
    m l ddtheta = SIGN m g sin(theta)
    where
        m: mass of the bob (a point)
        g: acceleration by gravity
        theta: angle of the rod
"""


def test_a_list_of_what_names_mean_is_no_equation() -> None:
    assert verdict("pendulum", GLOSSARY.replace("SIGN", "-")) == "PROVED"
    assert verdict("pendulum", GLOSSARY.replace("SIGN", "- 2")) == "REFUTED"


def test_a_line_with_a_colon_and_a_formula_is_read() -> None:
    with pytest.raises(InputError, match=":"):
        verdict("pendulum", "eq: l ddtheta - g sin(theta)")


def test_dots_of_asciimath() -> None:
    assert verdict("pendulum", "l ddot theta = - g sin(theta)") == "PROVED"
    assert verdict("pendulum", "l ddot theta = - 2 g sin(theta)") == "REFUTED"
    assert verdict("oscillator", "m ddot x + c dot x + k x = F0 cos(omega t)") == "PROVED"
    assert verdict("oscillator", "m ddot x + c ddot x + k x = F0 cos(omega t)") == "REFUTED"


JULIA = '''
"""
    swing!(du, u, p, t)
"""
@inline function swing!(du, u, p, t)
    "a pendulum"
    (; g, l) = p
    ϑ, ω = u
    du[1] = ω
    du[2] = SIGNg / l * sin(ϑ)
end
'''


def test_julia_with_words_on_its_function_and_a_record_of_parameters() -> None:
    assert verdict("pendulum", JULIA.replace("SIGN", "-")) == "PROVED"
    assert verdict("pendulum", JULIA.replace("SIGN", "-2")) == "REFUTED"


MODELICA = """
model Pendulum
  constant Real pi = Modelica.Constants.pi;
  parameter Real g = 9.81 "of gravity (m/s^2)";
  parameter Real l = 1;
  Real theta(start = pi/4) "angle (rad)";
  Real w(start = 0);
equation
  der(theta) = w;
  der(w) = SIGN g/l*sin(theta);
end Pendulum;
"""


def test_a_start_value_is_no_equation() -> None:
    assert verdict("pendulum", MODELICA.replace("SIGN", "-")) == "PROVED"
    assert verdict("pendulum", MODELICA.replace("SIGN", "-2*")) == "REFUTED"


MASSES = r"""$$ M = \begin{bmatrix} (m_1+m_2) l_1^2 + m_2 l_2^2 + 2 m_2 l_1 l_2 c_2
& m_2 l_2^2 + m_2 l_1 l_2 c_2 \\ m_2 l_2^2 + m_2 l_1 l_2 c_2 & FACTOR m_2 l_2^2 \end{bmatrix} $$"""


@pytest.mark.campaign
def test_a_mass_matrix_holds_cosines_alone() -> None:
    assert verdict("arm", MASSES.replace("FACTOR", "")) == "PROVED"
    assert verdict("arm", MASSES.replace("FACTOR", "2")) == "REFUTED"
    assert verdict("arm", MASSES.replace("FACTOR", "").replace("c_2", "c_1")) == "REFUTED"


def test_a_constant_may_have_a_name() -> None:
    conserved = r"$$ \frac12 \dot\theta^2 - \frac{g}{l}\cos\theta = const. \equiv c $$"
    assert verdict("pendulum", conserved) == "PROVED"
    assert verdict("pendulum", conserved.replace("- ", "- 2 ")) == "REFUTED"
