"""How something counts and what it is, as a text says it: compared with the scene, or left open."""

from pathlib import Path

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.grading.submission import things_in
from mechanics.scene import Scene
from systems import rod_pendulum

SCENES = HERE / "scenes"
OPEN, RIGHT, WRONG, QUOTED = "UNDECIDED", "PROVED", "REFUTED", "quoted"
ROD = r"$$\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3}{ml^2}u$$"
BOBS = r"$$V = -(m_1+m_2)gl_1\cos\phi_1 - m_2gl_2\cos\phi_2$$"
CART = r"$$(m_c+m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F$$"
CHAIN = r"$$3m\ddot x_1 + 2kx_1 - kx_2 = 0$$"
PLACE = r"$$V = mgy + \tfrac12 k(\sqrt{x^2+y^2}-b)^2$$"
BOWL = r"$$\ddot\theta = -\frac{2g}{3(R-a)}\sin\theta$$"
WIRE = r"$$(1 + 4a^2x^2)\ddot x + 4a^2x\dot x^2 + 2agx = 0$$"
POLAR = r"$$m\ddot r = mr\dot\theta^2 + mg\cos\theta - k(r-b)$$"
SLOPE = r"$$\ddot x = \frac{(M+m)g\sin\alpha}{M+m\sin^2\alpha}$$"
SHAKEN = r"$$l\ddot\phi + (g + a\gamma^2\cos\gamma t)\sin\phi = 0$$"
TABLE = r"$$m\ddot x - 2m\Omega\dot y - m\Omega^2 x + kx = 0$$"
HINGED = r"$$(M+m)\ddot x + b\dot x + ml\ddot\theta\cos\theta - ml\dot\theta^2\sin\theta = F$$"
ROWS = r"\begin{tabular}{ll} $m_c$ & mass of the %s \\ $m_p$ & mass of the %s \end{tabular}"
ITEMS = r"\begin{itemize} \item[$m_c$] mass of the %s \item[$m_p$] mass of the %s \end{itemize}"

ELBOW = (
    r"$$(m_2(l_{c2}^2 + l_1 l_{c2}\cos\theta_2) + I_2)\ddot\theta_1 + (m_2 l_{c2}^2 + I_2)"
    r"\ddot\theta_2 + m_2 l_1 l_{c2}\dot\theta_1^2\sin\theta_2"
    r" + m_2 l_{c2} g\sin(\theta_1 + \theta_2) = \tau$$"
)

CASES: dict[str, tuple[str, str, str, str]] = {
    # from where
    "an input in another unit": ("rod_pendulum", r"$u$ [N] drives it.", ROD, OPEN),
    "an input in its unit": ("rod_pendulum", r"$u$ [Nm] drives it.", ROD, QUOTED),
    "an input in a list": ("rod_pendulum", r"The torque $u$, m and g are given.", ROD, QUOTED),
    "parameters in a list": ("rod_pendulum", r"We know $g$, $m$ and $l$.", ROD, QUOTED),
    "a mass centre from the joint": (
        "acrobot", r"$l_{c2}$ is the distance of the second link's centre of mass from its joint.",
        ELBOW, RIGHT,
    ),
    "a mass centre of a link with its joint's number": (
        "acrobot",
        r"$l_{c2}$ is the distance from joint 2 to the centre of mass of link 2, that is 0.4 m.",
        ELBOW, QUOTED,
    ),
    "a mass centre from another joint": (
        "acrobot", r"$l_{c2}$ is the distance from joint 1 to the centre of mass of link 2.",
        ELBOW, OPEN,
    ),
    "a mass centre of another link, from its joint": (
        "acrobot", r"$l_{c2}$ is the distance from joint 2 to the centre of mass of link 1.",
        ELBOW, OPEN,
    ),
    "a mass centre from the tip": (
        "acrobot", r"$l_{c2}$ is the distance from the tip of link 2 to its centre of mass.",
        ELBOW, OPEN,
    ),
    "a mass centre of another link": (
        "acrobot", r"$l_{c2}$ is the distance from the joint of link 1 to its centre of mass.",
        ELBOW, OPEN,
    ),
    "a mass centre as a length": (
        "acrobot", r"Here $l_{c2}$ is the length of link 2.", ELBOW, OPEN,
    ),
    "upright with its unit": (
        "rod_pendulum", r"$\theta$ is the angle of the rod in rad from the upright.", ROD, RIGHT,
    ),
    "hanging, of the rod": (
        "rod_pendulum", r"$\theta$: angle of the rod from the downward vertical", ROD, WRONG,
    ),
    "from the vertical, upwards in brackets": (
        "rod_pendulum", r"$\theta$: angle of the rod from vertical (up)", ROD, RIGHT,
    ),
    "the angle alone": (
        "rod_pendulum", r"The angle is measured from the upright position.", ROD, RIGHT,
    ),
    "the angle alone, hanging": (
        "rod_pendulum", r"The angle is measured from the hanging position.", ROD, WRONG,
    ),
    "where the rod points up": (
        "rod_pendulum", r"$\theta$ is zero when the rod points straight up.", ROD, RIGHT,
    ),
    "where the rod points down": (
        "rod_pendulum", r"$\theta$ is zero when the rod points straight down.", ROD, WRONG,
    ),
    "the stable equilibrium": (
        "double_pendulum", r"$\phi_1$ is 0 when the first rod is in stable equilibrium.", BOBS,
        RIGHT,
    ),
    "an axis": (
        "double_pendulum", r"$\phi_1$ is measured from the negative y-axis.", BOBS, RIGHT,
    ),
    "with the rail": (
        "cartpole", r"$\theta$ is the angle which the pole makes with the rail.", CART, WRONG,
    ),
    "both from hanging": ("double_pendulum", "Both angles are from hanging.", BOBS, RIGHT),
    "both from the vertical": (
        "double_pendulum", "Both angles are measured from the vertical.", BOBS, RIGHT,
    ),
    "of the other rod": (
        "double_pendulum", r"$\phi_1$ is the angle of the second rod with the vertical.", BOBS,
        OPEN,
    ),
    "from what nobody knows": (
        "rod_pendulum", r"$\theta$ is measured from the mark of the hall sensor.", ROD, OPEN,
    ),
    "from equilibrium": (
        "two_mass_chain", r"$x_1$ and $x_2$ are the displacements from equilibrium.", CHAIN, RIGHT,
    ),
    "relative to the wall": (
        "two_mass_chain", r"$x_2$ is the displacement relative to the wall.", CHAIN, RIGHT,
    ),
    # which way
    "to the right": ("cartpole", r"The coordinate $x$ grows to the right.", CART, RIGHT),
    "nose-up": ("rod_pendulum", r"The pitch $\theta$ is positive nose-up.", ROD, OPEN),
    "to nobody knows where": ("cartpole", r"$x$ is positive towards the door.", CART, OPEN),
    "pointing up": (
        "planar_wire.py:wire", r"With $y$ pointing vertically up, we have", WIRE, RIGHT,
    ),
    "pointing down": (
        "planar_wire.py:wire", r"With $y$ pointing vertically down, we have", WIRE, OPEN,
    ),
    "a height": ("spring_pendulum.py:cartesian", r"$y$ is the height of the mass.", PLACE, QUOTED),
    "a depth": ("spring_pendulum.py:cartesian", r"$y$ is the depth of the mass.", PLACE, WRONG),
    "shaken up and down": ("kapitza.py:hanging", "The support moves up and down.", SHAKEN, QUOTED),
    "shaken sideways": ("kapitza.py:hanging", "The support is moved sideways.", SHAKEN, OPEN),
    "on the table": (
        "turned.py:table", "$x, y$ are the coordinates in the rotating frame.", TABLE, QUOTED,
    ),
    "beside the table": (
        "turned.py:table", "$x, y$ are the coordinates in the laboratory frame.", TABLE, OPEN,
    ),
    # of lengths and springs
    "by a length we mean": (
        "spring_pendulum.py:polar", "By $r$ we mean the elongation of the spring.", POLAR, OPEN,
    ),
    "by a length we mean the length": (
        "spring_pendulum.py:polar", "By $r$ we mean the length of the spring.", POLAR, RIGHT,
    ),
    "to the free end": (
        "rod_pendulum", r"$l$ is the length of the rod from the axis to its free end.", ROD, RIGHT,
    ),
    "diameters": (
        "cylinder_in_cylinder", "The cylinders have the diameters $R$ and $a$.", BOWL, OPEN,
    ),
    "radii": ("cylinder_in_cylinder", "The cylinders have the radii $R$ and $a$.", BOWL, QUOTED),
    "names, and diameters": (
        "cylinder_in_cylinder", "$R$, $a$: outer diameters", BOWL, OPEN,
    ),
    "a compliance": ("two_mass_chain", "Both springs have the compliance $k$.", CHAIN, OPEN),
    # whose a parameter is
    "rows": (
        "cartpole",
        ROWS % ("cart", "pole"),
        CART, RIGHT,
    ),
    "rows, exchanged": (
        "cartpole",
        ROWS % ("pole", "cart"),
        CART, OPEN,
    ),
    "items": (
        "cartpole",
        ITEMS % ("cart", "pole"),
        CART, RIGHT,
    ),
    "items, exchanged": (
        "cartpole",
        ITEMS % ("pole", "cart"),
        CART, OPEN,
    ),
    "the trolley in brackets": (
        "cartpole", r"The trolley (mass $m_c$) runs on a rail.", CART, RIGHT,
    ),
    "the trolley in brackets, exchanged": (
        "cartpole", r"The trolley (mass $m_p$) runs on a rail.", CART, OPEN,
    ),
    "what is left": (
        "cartpole", r"The cart weighs $m_c$, and $m_p$ is the mass of what it balances.", CART,
        RIGHT,
    ),
    "apposed": ("double_pendulum", r"The second bob $m_2$ hangs from the first.", BOBS, RIGHT),
    "apposed, exchanged": (
        "double_pendulum", r"The second bob $m_1$ hangs from the first.", BOBS, OPEN,
    ),
    "at the ceiling": (
        "double_pendulum", r"$l_2$ is the rod at the ceiling.", BOBS, QUOTED,
    ),
    "only masses": (
        "double_pendulum", r"Two point masses $m_1$, $m_2$ on massless rods $l_1$, $l_2$.", BOBS,
        RIGHT,
    ),
    "about the hinge": (
        "cart_poles.py:ctms", r"$I$ is the moment of inertia of the pendulum about its hinge.",
        HINGED, OPEN,
    ),
    "about the mass centre": (
        "cart_poles.py:ctms", r"$I$ is its moment of inertia about the centre of mass.", HINGED,
        RIGHT,
    ),
    "friction in the hinge": (
        "cart_poles.py:ctms", r"$b$ is the friction in the hinge of the pendulum.", HINGED, OPEN,
    ),
    "a unit of another kind": (
        "oscillators.py:linear", r"$k$ is a damping constant in N s/m.",
        r"$$m\ddot x + c\dot x + kx = 0$$", OPEN,
    ),
    "its unit": (
        "oscillators.py:linear", r"$k$ is a constant in N/m.", r"$$m\ddot x + c\dot x + kx = 0$$",
        RIGHT,
    ),
    # on what an input acts
    "a horizontal force on the cart": (
        "cartpole", r"$F$ is a horizontal force on the cart.", CART, RIGHT,
    ),
    "a force that pushes the cart": ("cartpole", r"The force $F$ pushes the cart.", CART, RIGHT),
    "a force on the bob": (
        "cartpole", r"The force $F$ is applied to the tip of the pole.", CART, QUOTED,
    ),
    "a torque of a motor": ("rod_pendulum", r"A motor exerts the torque $u$.", ROD, RIGHT),
    # what rests, and what is flat
    "bolted": ("cartpole", "The cart is bolted to the floor.", CART, OPEN),
    "an axis that points down": (
        "planar_wire.py:wire", "The axis of $y$ is pointing down.", WIRE, OPEN,
    ),
    "a table": (
        "spring_pendulum.py:polar", "The mass slides on a horizontal air table.", POLAR, OPEN,
    ),
    "pulleys": (
        "atwood", "The pulleys have no mass.",
        r"$$m_1\ddot x + m_2(\ddot x-\ddot y) + m_3(\ddot x+\ddot y) = (m_1-m_2-m_3)g$$", RIGHT,
    ),
    # what stands behind what is compared
    "a force that acts elsewhere": ("cartpole", "$F$ is the force at the hinge.", CART, QUOTED),
    "a force, and its way": ("cartpole", "$F$ is the force; it acts to the left.", CART, OPEN),
    "a torque, and its way": ("rod_pendulum", "$u$ is the torque, it is clockwise.", ROD, OPEN),
    "the vertical, and its end": (
        "rod_pendulum",
        r"$\theta$ is the angle between the rod and the vertical, counted from below.", ROD, OPEN,
    ),
    "a half of it": (
        "cartpole",
        "$m_c$ is the mass of the cart. $m_p$ is the mass of one half of the pole.", CART, QUOTED,
    ),
    "with the pole": ("cartpole", "$m_c$ is the mass of the cart with the pole.", CART, QUOTED),
    "the pole on the cart": (
        "cartpole", "The pole on the cart is uniform, with mass $m_c$.", CART, QUOTED,
    ),
    "lengths exchanged": (
        "double_pendulum",
        "The first bob hangs on a rod of length $l_2$, the second on one of length $l_1$.", BOBS,
        OPEN,
    ),
    "bobs of masses": (
        "double_pendulum",
        "The first bob has mass $m_1$ and the second bob has mass $m_2$.", BOBS, RIGHT,
    ),
    "a rest that is none": (
        "rod_pendulum", "The rod rests on a frictionless hinge and we have",
        r"$$\sin\theta = 0$$", WRONG,
    ),
    "the lowest point": (
        "rod_pendulum", r"At $\theta = 0$ the rod is at its lowest point.", ROD, WRONG,
    ),
    # derivations say nothing
    "with respect to": (
        "rod_pendulum", r"Differentiating the Lagrangian with respect to $\theta$ gives", ROD,
        RIGHT,
    ),
    "from an equation": (
        "rod_pendulum", r"From the equation of Lagrange for $\theta$ we see that", ROD, RIGHT,
    ),
    "positive": ("double_pendulum", "Both $m_1$ and $m_2$ are positive.", BOBS, RIGHT),
    # angles of what does not move
    "a slope from the vertical": (
        "wedge.py:make_scene", r"Its face makes an angle $\alpha$ with the vertical.", SLOPE, OPEN,
    ),
    "a slope": (
        "wedge.py:make_scene", r"Its face makes an angle $\alpha$ with the horizontal.", SLOPE,
        RIGHT,
    ),
    "from hanging": (
        "rod_pendulum", r"$\theta$ counts from hanging.", ROD, WRONG,
    ),
    "from the first link": (
        "double_pendulum", r"$\phi_2$ is measured from the first rod.", BOBS, OPEN,
    ),
    "it falls": ("rod_pendulum", "Left alone the rod falls down.", ROD, RIGHT),
}  # fmt: skip


def scene(name: str) -> Scene:
    file, _, function = name.partition(":")
    path = SCENES / file if function else Path("systems", f"{file}.py")
    return scene_of(path, function or "scene")


@pytest.mark.parametrize("case", CASES)
def test_what_a_text_says_is_compared_or_leaves_its_page_open(case: str) -> None:
    name, said, formula, expected = CASES[case]
    answer = check(scene(name), f"{said}\n{formula}", blame=False)
    if expected == QUOTED:
        assert answer.verdict.name == RIGHT
        assert answer.unjudged
    else:
        assert answer.verdict.name == expected


@pytest.mark.parametrize("said", ["measured from the mark of the sensor", "positive to the north"])
def test_formulas_alone_are_judged_without_it(said: str) -> None:
    text = rf"$\theta$ is {said}. {ROD}"
    answer = check(rod_pendulum.scene(), text, blame=False)
    assert answer.verdict.name == OPEN
    assert "--only formulas" in str(answer)
    assert check(rod_pendulum.scene(), text, only=["formulas"], blame=False).verdict.name == RIGHT


FUNCTION = """from math import sin


def acceleration(theta, theta_dot, u, m, l, g):
    return 3*g/(2*l)*sin(theta) + 3*u/(m*l**2)
"""
RODS = "class Rod:\n    def __init__(self, l):\n        self.l = l  # "
BESIDE = {
    "a field": (f"{RODS}half the length of the rod\n", OPEN),
    "the field": (f"{RODS}length of the rod\n", RIGHT),
    "a class": ('class Rod:\n    """theta counts from the mark of the sensor."""\n', OPEN),
    "the class": ('class Rod:\n    """theta is measured from the upward vertical."""\n', RIGHT),
    "a message": (
        'def start(theta):\n    print("theta is measured from the mark of the sensor")\n', OPEN,
    ),
}  # fmt: skip


def test_a_comment_without_an_equals_sign_is_words(tmp_path: Path) -> None:
    path = tmp_path / "rod.jl"
    for unit, expected in (("deg", OPEN), ("rad", RIGHT)):
        path.write_text(
            f"# state: theta [{unit}], omega\n"
            "acceleration(theta, omega, u, m, l, g) = 3g/(2l)*sin(theta) + 3u/(m*l^2)\n"
        )
        assert check(rod_pendulum.scene(), path, blame=False).verdict.name == expected


@pytest.mark.parametrize("case", BESIDE)
def test_all_words_of_a_file_of_python_count(tmp_path: Path, case: str) -> None:
    beside, expected = BESIDE[case]
    path = tmp_path / "rod.py"
    path.write_text(f"{FUNCTION}\n\n{beside}")
    things = things_in(path, function="acceleration", run_python=True)
    assert check(rod_pendulum.scene(), things, blame=False).verdict.name == expected
