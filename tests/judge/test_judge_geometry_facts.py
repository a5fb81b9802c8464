"""Sentences that say what a name or a body is are compared with the geometry of the scene."""

from pathlib import Path

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check

SCENES = HERE / "scenes"
OPEN, RIGHT, WRONG = "UNDECIDED", "PROVED", "REFUTED"
POLAR = r"$$m\ddot r = mr\dot\theta^2 + mg\cos\theta - k(r-b)$$"
BOWL = r"$$\ddot\theta = -\frac{2g}{3(R-a)}\sin\theta$$"
LADDER = r"$$\ddot\theta = \frac{3g}{4l}\sin\theta$$"
PULLEY = r"$$\ddot x = \frac{(m_1-m_2)g}{m_1+m_2+M/2}$$"
BODY = r"$$I\ddot\theta = -mgh\sin\theta$$"
ROD = r"$$\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3}{ml^2}u$$"
BOBS = r"$$V = -(m_1+m_2)gl_1\cos\phi_1 - m_2gl_2\cos\phi_2$$"
PLACE = r"$$V = mgy + \tfrac12 k(\sqrt{x^2+y^2}-b)^2$$"
CYCLOID = r"$$V = mga(1+\cos\theta)$$"

CART = r"$$(m_c+m_p)\ddot x + m_p l(\ddot\theta\cos\theta - \dot\theta^2\sin\theta) = F$$"

CASES: dict[str, tuple[str, str, str, str]] = {
    # springs
    "an extension": (
        "spring_pendulum.py:polar", r"Let $r$ denote the extension of the spring.", POLAR, OPEN,
    ),
    "a length": (
        "spring_pendulum.py:polar", r"Let $r$ denote the length of the spring.", POLAR, RIGHT,
    ),
    # axes
    "an axis downwards": (
        "cycloid.py:make_scene", r"The $y$ axis points vertically downwards.", CYCLOID, OPEN,
    ),
    "an axis upwards": (
        "cycloid.py:make_scene", r"The $y$ axis points vertically upwards.", CYCLOID, RIGHT,
    ),
    "a coordinate upwards": (
        "spring_pendulum.py:cartesian", r"$y$ is measured upwards.", PLACE, RIGHT,
    ),
    "a coordinate downwards": (
        "spring_pendulum.py:cartesian", r"$y$ is the position of the mass, measured downwards.",
        PLACE, WRONG,
    ),
    # shapes
    "a hoop": ("pulley.py:make_scene", "The pulley is a thin hoop.", PULLEY, OPEN),
    "a disc": ("pulley.py:make_scene", "The pulley is a uniform disc.", PULLEY, RIGHT),
    "a ring of a mass": (
        "pulley.py:make_scene", r"A thin ring of mass $M$ and radius $R$ is the pulley.", PULLEY,
        OPEN,
    ),
    "a rod that is a hoop": ("rod_pendulum", "The rod is a hoop.", ROD, OPEN),
    "a rod that is a tube": ("rod_pendulum", "The rod is a thin-walled tube.", ROD, RIGHT),
    "for a tube": ("cylinder_in_cylinder", "For a thin-walled tube:", BOWL, OPEN),
    "for a cylinder": ("cylinder_in_cylinder", "For a solid cylinder:", BOWL, RIGHT),
    # inertias and lengths
    "about the mass centre": (
        "more_pendulums.py:physical", r"$I$ is the moment of inertia about its centre of mass.",
        BODY, OPEN,
    ),
    "about the pivot": (
        "more_pendulums.py:physical", r"$I$ is the moment of inertia about the pivot.", BODY,
        RIGHT,
    ),
    "a ladder of half the length": (
        "ladder.py:from_vertical", r"A uniform ladder has total length $l$.", LADDER, WRONG,
    ),
    "a ladder of the length": (
        "ladder.py:from_vertical", r"A uniform ladder has length $2l$.", LADDER, RIGHT,
    ),
    # angles
    "an inclination": (
        "rod_pendulum", r"$\theta$ is the inclination of the rod to the floor.", ROD, WRONG,
    ),
    "an angle with the vertical": (
        "rod_pendulum", r"$\theta$ is the angle of the rod with the vertical.", ROD, RIGHT,
    ),
    "an angle with the first rod": (
        "double_pendulum", r"Let $\phi_2$ be the angle that the second rod makes with the first.",
        BOBS, OPEN,
    ),
    "an angle between the rods": (
        "double_pendulum", r"$\phi_2$ is the angle between the first and the second rod.", BOBS,
        OPEN,
    ),
    "an angle that a rod makes with the vertical": (
        "double_pendulum", r"$\phi_2$ is the angle that the second rod makes with the vertical.",
        BOBS, RIGHT,
    ),
    "angles of joints": (
        "double_pendulum", r"$\phi_1$ and $\phi_2$ are the joint angles.", BOBS, OPEN,
    ),
    "an absolute angle": (
        "double_pendulum", r"$\phi_2$ is the absolute angle of the second rod.", BOBS, RIGHT,
    ),
    "zero where the rods are in line": (
        "double_pendulum", r"$\phi_2$ is zero when the second rod is aligned with the first.", BOBS,
        OPEN,
    ),
    "zero where it hangs": (
        "double_pendulum", r"$\phi_2$ is zero when the second rod hangs.", BOBS, RIGHT,
    ),
    "hanging at half a turn": (
        "rod_pendulum", r"$\theta = \pi$ is the hanging position.", ROD, RIGHT,
    ),
    "upright at half a turn": (
        "rod_pendulum", r"$\theta = \pi$ is the upright position.", ROD, WRONG,
    ),
    # whose a length, a mass, a stiffness is
    "of the second rod": (
        "double_pendulum", r"$l_1$ is the length of the second rod.", BOBS, OPEN,
    ),
    "of the first rod": (
        "double_pendulum", r"$l_1$ is the length of the first rod.", BOBS, RIGHT,
    ),
    "masses exchanged": (
        "cartpole", "The masses of the cart and the pole are $m_p$ and $m_c$.", CART, OPEN,
    ),
    "masses": (
        "cartpole", "The masses of the cart and the pole are $m_c$ and $m_p$.", CART, RIGHT,
    ),
    "a total mass": (
        "cartpole", "$m_c$ is the total mass of the cart and the pole.", CART, OPEN,
    ),
    "stiffnesses in a list": (
        "vibrations.py:quarter_car",
        "* `ks` - stiffness of the tyre\n* `kt` - stiffness of the suspension spring\n",
        r"$$m_s\ddot z_s = -k_s(z_s-z_u) - d(\dot z_s-\dot z_u)$$", OPEN,
    ),
    "a list": (
        "rod_pendulum", "- `m`: mass of the rod\n- `l`: length of the rod\n", ROD, RIGHT,
    ),
    # whose a radius is
    "radii exchanged": (
        "cylinder_in_cylinder",
        r"$a$ denotes the radius of the hollow cylinder and $R$ the radius of the small one.",
        BOWL, OPEN,
    ),
    "radii": (
        "cylinder_in_cylinder",
        r"$R$ denotes the radius of the hollow cylinder and $a$ the radius of the small one.",
        BOWL, RIGHT,
    ),
    "a table, exchanged": (
        "cylinder_in_cylinder",
        "| symbol | meaning |\n| --- | --- |\n| $R$ | radius of the rolling cylinder |\n"
        "| $a$ | radius of the surface it rolls on |\n",
        BOWL, OPEN,
    ),
    "a table": (
        "cylinder_in_cylinder",
        "| symbol | meaning |\n| --- | --- |\n| $a$ | radius of the rolling cylinder |\n"
        "| $R$ | radius of the surface it rolls on |\n",
        BOWL, RIGHT,
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_sentence_is_compared_with_the_geometry(case: str) -> None:
    where, sentence, formula, verdict = CASES[case]
    file, _, function = where.partition(":")
    path = SCENES / file if function else Path("systems", f"{file}.py")
    scene = scene_of(path, function or "scene")
    answer = check(scene, f"{sentence}\n\n{formula}", blame=False)
    assert answer.verdict.name == verdict
