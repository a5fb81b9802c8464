"""`mechanics.testing.assert_equivalent`: silent where all is shown, the answer where it is not."""

import doctest

import pytest

import mechanics
from mechanics import testing
from mechanics.errors import InputError
from mechanics.testing import assert_equivalent
from systems import SEED, elastic_pendulum, rod_pendulum

SCENE = elastic_pendulum.scene()
SIX = "(M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)) = 0"
SEVEN = "M*L/2*x''*cos(theta) + M*L**2/3*theta'' + M*g*L/2*sin(theta) = 0"


def test_right_equations_pass_in_silence(capsys: pytest.CaptureFixture[str]) -> None:
    assert assert_equivalent([SIX, SEVEN], SCENE) is None
    assert assert_equivalent([SEVEN, SEVEN], SEED[0], partial=True) is None
    phi = f"{SIX}\n{SEVEN}".replace("theta", "phi")
    assert_equivalent(phi, SCENE, names={"phi": "theta"})
    assert capsys.readouterr() == ("", "")


def test_wrong_equations_fail_with_what_the_terminal_prints() -> None:
    wrong = SEVEN.replace("/3", "/12")
    with pytest.raises(AssertionError) as failed:
        assert_equivalent(wrong, SCENE)
    words = str(failed.value)
    assert words.startswith("the equations are not those of pendulum on elastic support\n\n")
    assert "\n\nREFUTED  1  line 1" in words
    assert wrong in words
    assert "write 3 for 12: the factor is wrong" in words
    assert "the enclosures at a real state are disjoint" in words
    assert "\x1b" not in words
    assert max(map(len, words.splitlines())) <= 80


def test_the_blame_can_be_left_out() -> None:
    with pytest.raises(AssertionError) as failed:
        assert_equivalent(SEVEN.replace("/3", "/12"), SCENE, blame=False)
    assert "write 3" not in str(failed.value)
    assert "the enclosures at a real state are disjoint" in str(failed.value)


@pytest.mark.campaign
def test_a_convention_has_to_be_declared() -> None:
    other = SEVEN.replace("/3", "/4")
    with pytest.raises(AssertionError, match="right if every rod is a point mass"):
        assert_equivalent(other, SCENE)
    assert_equivalent(other, SCENE, convention="point mass", partial=True)


def test_doubt_fails_in_other_words() -> None:
    with pytest.raises(AssertionError) as failed:
        assert_equivalent(["x = unknown_thing*k", SEVEN], SCENE)
    assert str(failed.value).startswith(
        "it is undecided whether the equations are those of pendulum on elastic support"
    )
    assert "unknown_thing: the scene has no such name" in " ".join(str(failed.value).split())


def test_numbers_alone_have_to_be_allowed() -> None:
    chain = next(system for system in SEED if system.name == "two_mass_chain").scene()
    model = mechanics.compile(mechanics.derive(chain, "kane"))
    names = [symbol.name for symbol in (*chain.q, *chain.u)]
    parameters = [symbol.name for symbol in chain.parameters]

    def rate(y, p):
        n = len(chain.q)
        given = dict(zip(parameters, p, strict=True))
        return [*y[n:], *model.forward_dynamics(y[:n], y[n:], given)]

    box = mechanics.BlackBox(rate, {})
    options = {"names": {"y": " ".join(names), "p": " ".join(parameters)}}
    with pytest.raises(AssertionError, match=r"only numbers say .* pass allow_supported=True"):
        assert_equivalent(box, chain, **options)
    assert_equivalent(box, chain, allow_supported=True, **options)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "said"),
    [
        (SEVEN, "only 1 of 2 independent equations of motion"),
        (f"{SEVEN}\n{SEVEN}", "only 1 of 2 independent equations of motion"),
        ("V = k*x^2 - M*g*L/2*cos(theta)", "there is no equation of motion"),
        ("p_theta = M*L/2*x'*cos(theta) + M*L^2/3*theta'", "there is no equation of motion"),
    ],
)
def test_what_is_right_and_not_enough_fails(text: str, said: str) -> None:
    with pytest.raises(AssertionError, match=said):
        assert_equivalent(text, SCENE)
    assert_equivalent(text, SCENE, partial=True)


def test_equations_with_reactions_that_nothing_gives_are_not_enough() -> None:
    scene = rod_pendulum.scene()
    along = "m*l/2*(theta''*sin(theta) + theta'^2*cos(theta)) = m*g - Y"
    with pytest.raises(AssertionError, match="only 0 of 1"):
        assert_equivalent(along, scene)


def test_nothing_to_check_is_no_success() -> None:
    with pytest.raises(InputError, match="nothing to check: q is taken as defined by"):
        assert_equivalent("q = [x; theta]", SCENE)
    with pytest.raises(AssertionError, match="I is defined and never used"):
        assert_equivalent("I = M*L**2/3", SCENE)


def test_the_example_of_the_docstring_runs() -> None:
    assert doctest.testmod(testing).failed == 0
    assert doctest.testmod(testing).attempted == 3


def test_pytest_shows_the_line_of_the_test_and_not_the_helper() -> None:
    with pytest.raises(AssertionError) as failed:
        assert_equivalent(SEVEN.replace("sin", "cos"), SCENE)
    frames = [entry for entry in failed.traceback if entry.path.name == "testing.py"]
    assert frames
    assert all(entry.ishidden(failed) for entry in frames)


def test_bad_input_shows_no_frame_of_the_program() -> None:
    for wrong in ("x =", "", "right/c1.tex", "(", lambda omega_9: omega_9):
        with pytest.raises(InputError) as failed:
            assert_equivalent(wrong, SCENE)
        inner = [entry for entry in failed.traceback if not entry.ishidden(failed)]
        assert len(inner) == 1
        assert failed.value.__cause__ is None
        assert failed.value.__suppress_context__ or failed.value.__context__ is None
        assert "\n" not in str(failed.value)


def test_what_fails_is_told_first() -> None:
    with pytest.raises(AssertionError) as failed:
        assert_equivalent(f"{SEVEN}\n{SEVEN.replace('sin', 'cos')}", SCENE)
    text = str(failed.value)
    assert text.index("REFUTED") < text.index("PROVED  1")


@pytest.mark.parametrize("name", ["right/c1.tex", "a b.txt", "mine.C"])
def test_the_name_of_a_file_is_no_text(name: str) -> None:
    with pytest.raises(InputError, match=r"is the name of a file, not its text: pass pathlib.Path"):
        assert_equivalent(name, SCENE)
    with pytest.raises(InputError, match="import it and pass its function"):
        assert_equivalent("sim.py", SCENE)


def test_a_comment_that_nobody_judges_is_a_warning() -> None:
    page = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)  # theta'' = g/l*sin(theta)"
    with pytest.warns(UserWarning, match="not judged: .*theta'' = g/l"):
        assert_equivalent(page, rod_pendulum.scene())
