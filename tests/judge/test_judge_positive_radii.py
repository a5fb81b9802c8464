"""The length of a spring is positive: for `check` of a scene, of its equations, and for `grade`."""

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.judge.check import derived
from mechanics.kernel import Verdict

RADIAL = r"m\ddot r = m r\dot\theta^2 + m g\cos\theta - k(r - b)"


def test_equations_of_a_scene_know_that_a_length_is_positive() -> None:
    scene = scene_of(HERE / "scenes" / "spring_pendulum.py", "polar")
    for subject in (scene, derived(scene)):
        assert check(subject, RADIAL).verdict is Verdict.PROVED
        assert check(subject, RADIAL.replace("+ m g", "- m g")).verdict is Verdict.REFUTED
