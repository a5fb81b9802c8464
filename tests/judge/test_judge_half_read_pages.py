r"""Pages of which the half is read: what one word or letter more makes another statement.

Found by who looked for wrong statements that are PROVED; beside each stands one that is right.
"""

from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import pytest

from mechanics import check
from tests.verdict_of import verdict_in

OPEN, RIGHT, WRONG = ("UNDECIDED", "not read"), ("PROVED",), ("REFUTED", "UNDECIDED", "not read")
NOT_REFUTED = ("PROVED", *OPEN)
PAGES: dict[str, tuple[str, str, tuple[str, ...]]] = {
    # a sentence of two names
    "two angles, one read": (
        "double_pendulum",
        r"$\phi_1$ and $\phi_2$ are measured from the upward vertical."
        r" $V=-(m_1+m_2)gl_1\cos\phi_1+m_2gl_2\cos\phi_2$",
        OPEN,
    ),
    "an angle from the other rod": (
        "double_pendulum",
        r"Let $\phi_2$ be measured from the extension of the first rod. The potential energy is"
        r" \[ V = -(m_1+m_2) g l_1\cos\phi_1 - m_2 g l_2\cos\phi_2 . \]",
        OPEN,
    ),
    "both clockwise, one sign": (
        "rod_pendulum",
        r"Let $\theta$ be the angle, clockwise from upright, and $u$ the torque, positive"
        r" clockwise. $\ddot\theta = \frac{3g}{2l}\sin\theta - \frac{3u}{ml^2}$",
        WRONG,
    ),
    "both clockwise": (
        "rod_pendulum",
        r"Let $\theta$ be the angle, clockwise from upright, and $u$ the torque, positive"
        r" clockwise. $\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}$",
        RIGHT,
    ),
    "clockwise of all angles": (
        "rod_pendulum",
        r"Positive angles are clockwise. The torque $u$ acts clockwise:"
        r" $\frac13ml^2\ddot\theta = \frac12mgl\sin\theta - u$.",
        OPEN,
    ),
    "force and place to the left": (
        "cartpole",
        r"$F$ acts to the left. $x$ is positive to the left. $(m_c+m_p)\ddot x"
        r" + m_pl\ddot\theta\cos\theta - m_pl\dot\theta^2\sin\theta = -F$",
        OPEN,
    ),
    # indices and subscripts
    "a length of another index": (
        "acrobot", r"$V = -(m_1l_{c1}+m_2l_1)g\cos\theta_1-m_2gl_2\cos(\theta_1+\theta_2)$", OPEN,
    ),
    "the lengths as they are": (
        "acrobot",
        r"$V = -(m_1l_{c1}+m_2l_1)g\cos\theta_1-m_2gl_{c2}\cos(\theta_1+\theta_2)$", RIGHT,
    ),
    "a capital of another index": ("furuta_pendulum", r"\[ V = -m_2gL_2\cos\theta_2 \]", OPEN),
    "an angle of another index": (
        "double_pendulum", r"\[ V = -(m_1+m_2)gl_1\cos\phi_1-m_2gl_2\cos\phi_3 \]", OPEN,
    ),
    "the torque of gravity": (
        "rod_pendulum", r"\[ \frac13ml^2\ddot\theta=\frac12mgl\sin\theta+\tau_g \]", OPEN,
    ),
    "a force for a torque": (
        "rod_pendulum", r"\[ \frac13ml^2\ddot\theta=\frac12mgl\sin\theta+F \]", OPEN,
    ),
    "a torque by another letter": (
        "rod_pendulum", r"\[ \frac13ml^2\ddot\theta=\frac12mgl\sin\theta+\tau \]", RIGHT,
    ),
    "the greatest of one": (
        "rod_pendulum", r"\[ \frac13ml^2\ddot\theta=\frac12mgl\sin\theta+\max u \]", OPEN,
    ),
    # the order of a text
    "an entry of another order": (
        "cartpole", r"With $q=(\theta,x)^T$ the mass matrix has $M_{11} = m_c+m_p$.", OPEN,
    ),
    "an entry of this order": (
        "cartpole", r"With $q=(x,\theta)^T$ the mass matrix has $M_{11} = m_c+m_p$.", RIGHT,
    ),
    "a matrix of another order": (
        "cartpole",
        r"With $q=(\theta,x)^T$ the mass matrix is $M = \begin{pmatrix} m_c+m_p & m_pl\cos\theta\\"
        r" m_pl\cos\theta & \frac43 m_pl^2\end{pmatrix}$.", OPEN,
    ),
    # variants of a letter
    "a length and half of it": (
        "rod_pendulum", r"Let $\ell = l/2$. $\frac43m\ell^2\ddot\theta = mg\ell\sin\theta + u$",
        RIGHT,
    ),
    "half of a length for it": (
        "rod_pendulum", r"Let $\ell = l/2$. $\frac43ml^2\ddot\theta = mgl\sin\theta + u$", WRONG,
    ),
    "one length": (
        "rod_pendulum", r"$\frac13m\ell^2\ddot\theta = \frac12mg\ell\sin\theta + u$", RIGHT,
    ),
    "a matrix and a mass": (
        "elastic_pendulum",
        r"\[ \mathbf M\ddot{\mathbf q}+\mathbf c+\mathbf K\mathbf q=0,\ \mathbf q ="
        r" \begin{pmatrix}\theta\\x\end{pmatrix},\ \mathbf M = \begin{pmatrix}\frac13ML^2&"
        r"\frac12ML\cos\theta\\\frac12ML\cos\theta&M+m\end{pmatrix},\ \mathbf c ="
        r" \begin{pmatrix}\frac12MgL\sin\theta\\-\frac12ML\dot\theta^2\sin\theta\end{pmatrix},\ "
        r"\mathbf K = \begin{pmatrix}0&0\\0&2k\end{pmatrix} \]", RIGHT,
    ),
    # letters of reactions
    "the kinetic energy and a tension": (
        "elastic_pendulum",
        r"$\mathcal L = T - V$ with $T = \frac12(M+m)\dot x^2 + \frac12 M L\dot x\dot\theta"
        r"\cos\theta + \frac16 M L^2\dot\theta^2$ and $V = k x^2 - \frac12 M g L\cos\theta$.",
        RIGHT,
    ),
    "a place and a force": (
        "rod_pendulum",
        r"$X = -\frac l2\sin\theta$, $Y=\frac l2\cos\theta$, $V=mgY$,"
        r" $T = \frac12m(\dot X^2+\dot Y^2)+\frac1{24}ml^2\dot\theta^2$", RIGHT,
    ),
    "a place and a force, a factor": (
        "rod_pendulum",
        r"$X = -\frac l2\sin\theta$, $Y=\frac l2\cos\theta$, $V=mgY$,"
        r" $T = \frac12m(\dot X^2+\dot Y^2)+\frac1{12}ml^2\dot\theta^2$", ("REFUTED",),
    ),
    # motions of their own
    "dots by another time": (
        "rod_pendulum",
        r"Dots are derivatives by $\tau = t\sqrt{g/l}$. For $u=0$ $\ddot\theta=\frac32\sin\theta$",
        OPEN,
    ),
    "primes by an angle": (
        "rod_pendulum", r"where the prime is $d/d\tau$: $\theta'' = \frac32\sin\theta$", OPEN,
    ),
    "dots by the time": (
        "rod_pendulum",
        r"where the dot is $d/dt$: $\ddot\theta = \frac{3g}{l}\sin\theta+\frac{3u}{ml^2}$",
        ("REFUTED",),
    ),
    "all of them one": (
        "rod_pendulum", r"Set $m=g=l=1$: $\ddot\theta = \frac32\sin\theta+3u$.", OPEN,
    ),
    "all of them one, a factor": (
        "rod_pendulum", r"Set $m=g=l=1$: $\ddot\theta = \frac32\sin\theta+2u$.", ("REFUTED",),
    ),
    "a mode shape": (
        "two_mass_chain", r"Mode shapes: for $\omega_1^2 = k/(6m)$, $x_2 = \frac{3}{2}x_1$.",
        NOT_REFUTED,
    ),
    "a mode by its number": (
        "two_mass_chain", r"In the first mode $x_2 = \frac{3}{2}x_1$.", OPEN,
    ),
    "what is held": (
        "two_mass_chain", r"When the first mass is held, $\ddot x_2 = -\frac{k}{2m}x_2$.", OPEN,
    ),
    "what is always held": (
        "rod_pendulum",
        r"With the pivot held fixed, $\ddot\theta = \frac{3g}{l}\sin\theta+\frac{3u}{ml^2}$",
        ("REFUTED",),
    ),
    "a steady motion": (
        "spinning_top",
        r"For steady precession at constant $\theta$: $I_3\dot\psi\dot\phi = Mgl$", OPEN,
    ),
    # whose it is
    "the speed of another bob": (
        "double_pendulum", r"The speed of the lower bob is $V = l_1\dot\phi_1$.", OPEN,
    ),
    "the speed of this bob": (
        "double_pendulum", r"The speed of the upper bob is $V = l_1\dot\phi_1$.", RIGHT,
    ),
    "the momentum about another point": (
        "rod_pendulum",
        r"The angular momentum about the pivot is $L = \frac1{12}ml^2\dot\theta$.", OPEN,
    ),
    "the momentum about this point": (
        "rod_pendulum",
        r"The angular momentum about the pivot is $L = \frac1{3}ml^2\dot\theta$.", RIGHT,
    ),
    "the greater eigenvalue": (
        "two_mass_chain", r"The smallest eigenvalue is $\omega^2 = k/m$.", OPEN,
    ),
    "the upper of two": (
        "two_mass_chain", r"The upper frequency is $\omega = \sqrt{k/(6m)}$.", OPEN,
    ),
    "the higher of two": (
        "two_mass_chain",
        r"The higher of the two natural frequencies is $\omega = \sqrt{k/(6m)}$.", OPEN,
    ),
    "degrees behind a comma": (
        "rod_pendulum",
        r"$\theta$ is counted from upright, in degrees."
        r" $\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}$", OPEN,
    ),
    "the smaller eigenvalue": (
        "two_mass_chain", r"The smallest eigenvalue is $\omega^2 = k/(6m)$.", RIGHT,
    ),
    # laws and relations beside an equation
    "two tensions": (
        "atwood",
        r"$m_1g - T_1 = m_1\ddot x$, $T_1 = T_2$, $m_2g - T_2 = m_2(\ddot y-\ddot x)$", OPEN,
    ),
    "a momentum that changes": (
        "double_pendulum",
        r"$V=-(m_1+m_2)gl_1\cos\phi_1-m_2gl_2\cos\phi_2$. $\dot p_{\phi_1} = 0$.", ("REFUTED",),
    ),
    "an energy of unknown cosines": (
        "acrobot",
        r"\[ V = -m_1gl_{c1}c_1-m_2g(l_1c_1+l_{c2}c_{2}),\ H_{22} = I_2+m_2l_{c2}^2 \]", OPEN,
    ),
    "a Lagrangian with its input": (
        "rod_pendulum", r"\[ \frac{\partial L}{\partial\theta} = \frac12mgl\sin\theta+u \]", OPEN,
    ),
    "a value behind words": (
        "rod_pendulum",
        r"\[ \ddot\theta = \frac{3g}{2l}\sin\theta+\frac{3u}{ml^2} \quad \text{where } g = -9.81"
        r" \]", OPEN,
    ),
    # how lines are printed
    "a plus repeated": (
        "rod_pendulum",
        "\\begin{align*}\n\\frac13ml^2\\ddot\\theta &= \\frac12mgl\\sin\\theta +\\\\\n"
        "&\\quad + u\n\\end{align*}", RIGHT,
    ),
    "a minus repeated": (
        "rod_pendulum",
        "\\begin{align*}\n\\frac13ml^2\\ddot\\theta &= u -\\\\\n"
        "&\\quad - \\frac12mgl\\sin\\theta\n\\end{align*}", WRONG,
    ),
    "a comma": (
        "rod_pendulum", r"\[ \ddot\theta = 1,5\frac gl\sin\theta + \frac{3u}{ml^2} \]", RIGHT,
    ),
}  # fmt: skip
SIDES = {
    "of an unknown inertia": r"\[ T = I\dot\theta^2 = \tfrac16 m l^2\dot\theta^2 \]",
    "of a definition": r"\[ I\ddot\theta = \frac{m g l}{2}\sin\theta + u,\quad"
    r" I = I_C - m d^2 = \frac{1}{3} m l^2 \]",
    "of a misprint": r"\[ \ddot\theta = \frac{3grl}{2l^2}\sin\theta + \frac{3u}{ml^2}"
    r" = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2} \]",
    "with a sum": r"\[ T = \sum \frac12 m v^2 = \tfrac16 m l^2\dot\theta^2 \]",
}


def scene(name: str) -> object:
    made: Callable[[], object] = import_module(f"systems.{name}").scene
    return made()


@pytest.mark.sample(20)
@pytest.mark.parametrize("name", PAGES)
def test_the_other_half_of_a_page_counts(name: str, tmp_path: Path) -> None:
    system, text, verdicts = PAGES[name]
    assert verdict_in(scene(system), "page.tex", text, tmp_path) in verdicts


@pytest.mark.parametrize("name", SIDES)
def test_a_side_in_names_of_its_own_is_quoted(name: str, tmp_path: Path) -> None:
    path = tmp_path / "page.tex"
    path.write_text(SIDES[name])
    found = check(scene("rod_pendulum"), path, blame=False)
    assert any("side" in words for words in found.unjudged)
