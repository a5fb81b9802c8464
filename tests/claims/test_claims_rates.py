r"""What d/dt does with what moves: nothing that changes with time is a constant."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics import Particle, Scene, check, force, gravity, parameters
from mechanics.claims.latex.items import Items
from mechanics.claims.latex.read import read_latex
from mechanics.claims.names import Naming, Vocabulary
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole, rod_pendulum

ROW = r"(m_c+m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)"
CART = derived(cartpole.scene())


def declared() -> Scene:
    """A ball whose velocity has names of its own."""
    x, y, v, w, thrust = dynamicsymbols("x y v w T")
    m, g = parameters("m g", units="kg m/s^2")
    frame, origin = ReferenceFrame("N"), Point("O")
    centre = origin.locatenew("C", x * frame.x + y * frame.y)
    return Scene(
        "ball", frame, origin, (x, y), (Particle("ball", centre, m),),
        loads=(gravity(-g * frame.y), force("T", centre, thrust * frame.x, on="ball")),
        inputs=(thrust,), speeds=((v, x.diff()), (w, y.diff())),
    )  # fmt: skip


BALL = derived(declared())


def verdict(truth, text: str, notation: str = "latex") -> str:
    (entry,) = mechanics.check(truth, text, notation=notation, blame=False).judged
    return entry.finding.verdict.name


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"\frac{d}{dt}(m v) = T", "PROVED"),
        (r"\frac{d}{dt}(m v) = 2 T", "REFUTED"),
        (r"\frac{d}{dt}(m v) + m\ddot x = T", "REFUTED"),
        (r"\frac{d}{dt}(m v) + m\dot v = 2 T", "PROVED"),
        (r"\frac{d}{dt}(x w - y v) m = -x m g - y T", "PROVED"),
        (r"\frac{d}{dt}(x w - y v) m = x m g - y T", "REFUTED"),
    ],
)
def test_declared_speeds_change(text: str, expected: str) -> None:
    assert verdict(BALL, text) == expected


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"\frac{d}{dt}(2 p_x) = 2 F", "PROVED"),
        (r"\frac{d}{dt}(2 p_x) = F", "REFUTED"),
        (rf"\frac{{d}}{{dt}}(p_x) + {ROW} = F", "REFUTED"),
        (rf"\frac{{d}}{{dt}}(\theta p_x) - \dot\theta p_x + {ROW} = F", "REFUTED"),
        (r"\frac{d}{dt}(\theta p_x) = \dot\theta p_x + \theta F", "PROVED"),
    ],
)
def test_momenta_change(text: str, expected: str) -> None:
    assert verdict(CART, text) == expected


@pytest.mark.parametrize(
    ("inside", "what"),
    [
        (r"m_p \ddot x", "x_ddot"),
        (r"N\theta", "N"),
        (r"\dot p_x + F", "p_x_dot"),
        (r"\dot\theta \ddot x", "x_ddot"),
    ],
)
def test_what_has_no_rate_is_refused_and_not_taken_to_be_constant(inside: str, what: str) -> None:
    with pytest.raises(InputError, match=rf"rate of {what}|derivative of order 2 of {what}"):
        verdict(CART, rf"\frac{{d}}{{dt}}({inside}) + {ROW} = F")


def test_text_is_differentiated_alike() -> None:
    row = "(mc + mp)*x'' + mp*l*(theta''*cos(theta) - theta'^2*sin(theta))"
    with pytest.raises(InputError, match="the rate of x_ddot is not known"):
        verdict(CART, f"diff(mp*x'', t) + {row} = F", "text")
    assert verdict(BALL, "diff(m*v, t) = T", "text") == "PROVED"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        # Right if the rate of the product is meant, wrong if that of the bracket is.
        (r"\frac{d}{dt}\left(l^2\cos\theta\right)\dot\theta = 0", "a derivative of the bracket"),
        (
            r"\frac{\partial}{\partial\theta}(\cos\theta)\dot\theta = 0",
            "a derivative of the bracket",
        ),
        (r"\frac{d}{dt}(M)\dot\theta = 0", "a derivative of the bracket"),
    ],
)
def test_what_a_derivative_is_of_has_to_be_plain(text: str, expected: str) -> None:
    with pytest.raises(InputError, match=rf"LaTeX, line 1, column 4: {expected}"):
        mechanics.check(cartpole.scene(), rf"\[ {text} \]", notation="latex", blame=False)


@pytest.mark.parametrize(
    "ratio",
    [r"\frac{d \theta}{d x}", r"\frac{\mathrm{d}\theta}{\mathrm{d} x}", r"\frac{d}{dx}\theta"],
)
def test_d_is_no_factor_of_a_derivative(ratio: str) -> None:
    """It fell out of the fraction, which was theta/x."""
    text = rf"\[ (m_c + m_p)\ddot x = {ratio} x - \theta \]"
    with pytest.raises(InputError, match="by something other than time"):
        mechanics.check(cartpole.scene(), text, notation="latex", blame=False)


def test_a_period_is_no_kinetic_energy() -> None:
    found = mechanics.check(cartpole.scene(), r"\[ T = 2\pi\sqrt{l/g} \]", blame=False)
    (entry,) = found.judged
    assert entry.finding.verdict.name == "REFUTED"
    assert "kinetic energy" not in str(entry.statement.row)


@pytest.mark.parametrize(
    "form", [r"\frac{%s}{2}", r"\frac{%s}{dt}", r"\frac{2}{%s}", r"\frac{d %s}{dt}"]
)
def test_what_stands_within_fractions_is_read_once(form: str, monkeypatch) -> None:
    """Read twice at each level, forty levels would take for ever."""
    read: list[int] = []
    once = Items._read
    monkeypatch.setattr(Items, "_read", lambda self, tree: read.append(1) or once(self, tree))
    counts = []
    for depth in (3, 6, 9):
        text = "x"
        for _ in range(depth):
            text = form % text
        read.clear()
        read_latex(rf"\ddot x = {text}", Naming(Vocabulary(CART.scene)))
        counts.append(len(read))
    assert 0 < counts[1] - counts[0] == counts[2] - counts[1]


@pytest.mark.parametrize("name", ["omega", "w", "v"])
def test_a_rate_on_the_left_uses_the_name_that_a_line_defines(name: str) -> None:
    text = f"theta' = {name}\n{name}' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
    answer = check(rod_pendulum.scene(), text, blame=False)
    assert [entry.verdict.name for entry in answer.judged] == ["PROVED"]
