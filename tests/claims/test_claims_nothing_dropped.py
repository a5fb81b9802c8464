r"""What stands in or beside a formula is read, refused, or quoted beside the verdict.

A right equation of the rod pendulum with a mark that changes what it says is never shown.
"""

import pytest

from mechanics.errors import InputError
from mechanics.judge.check import Check, check, derived
from systems import rod_pendulum

TRUTH = derived(rod_pendulum.scene())
TEXT = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"
LATEX = r"\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3u}{ml^2}"
PROGRAM = """function dy = f(t, y)
  theta = y(1);
  omega = y(2);
  dy = zeros(2,1);
  dy(1) = omega;
  dy(2) = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
"""
WRONG = "dy(2) = 3*g/l*sin(theta) + 3*u/(m*l^2);\n"


def found(text: str, notation: str) -> Check | None:
    try:
        return check(TRUTH, text, notation=notation, blame=False)
    except InputError:
        return None


def shown(text: str, notation: str) -> bool:
    """Whether a text is shown, and nothing of it is quoted beside the verdict."""
    answer = found(text, notation)
    return answer is not None and answer.ok and not answer.unjudged


def test_the_equation_itself_is_shown() -> None:
    assert shown(TEXT, "text")
    assert shown(rf"\[{LATEX}\]", "latex")
    assert shown(f"{PROGRAM}end\n", "text")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("*u", "*u\u2074"), ("*u", "*u\u1d40"), ("*u", "*u\u207f"), ("*u", "*u0"),
        ("*u", "*u\u2080"), ("theta''", "# WRONG (2)\ntheta''"),
        ("l^2", "l\u2074"), ("l^2", "l\u00b9\u00b2"), ("= ", "~ "), ("sin", "s\u0307in"),
        ("sin(theta)", "sin(theta:2)"), ("l^2)", "l^2) // 2"), ("l^2)", "l^2); // wrong"),
        ("l^2)", "l^2)%wrong"), ("l^2)", "l^2) % not so: x = 2"),
    ],
)  # fmt: skip
def test_a_mark_in_a_text_is_not_dropped(old: str, new: str) -> None:
    assert old in TEXT
    assert not shown(TEXT.replace(old, new), "text")


@pytest.mark.parametrize("power", ["\u00b2", "^2", "**2"])
def test_powers_in_unicode_are_read(power: str) -> None:
    assert shown(TEXT.replace("^2", power), "text")
    assert shown(TEXT.replace("/(m*l^2)", "*m\u207b\u00b9*l\u207b\u00b2"), "text")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("= ", r"\overset{/}{=} "), ("= ", r"\stackrel{?}{=} "), ("{ml^2}", r"{ml^2} \dots"),
        ("{ml^2}", r"{ml^2}..."), ("{3u}", r"{3u_{ck-1}}"), ("{3u}", r"{3u_{-}}"),
        ("{3u}", r"{3u_{1^*}}"), (r"\sin", r"\sin\cdot"), (r"\ddot", r"\exists u: \ddot"),
        (r"\ddot", r"-: \ddot"), (r"\ddot", r"wrong: \ddot"), (r"\ddot", r"\mathrm{not}: \ddot"),
        (r"\frac{3u}{ml^2}", r"\underbrace{\frac{3u}{ml^2}}_{0}"),
        (r"\ddot", r"\ddot\theta = 5 F_k,\quad \ddot"),
        (r"\ddot", r"\ddot\theta_k = 7\theta_k,\quad \ddot"),
    ],
)  # fmt: skip
def test_a_mark_in_a_display_is_not_dropped(old: str, new: str) -> None:
    assert old in LATEX
    assert not shown(rf"\[{LATEX.replace(old, new, 1)}\]", "latex")


@pytest.mark.parametrize("marks", [("{--", "--}"), ("{>>", "<<}"), ("~~", "~~")])
def test_what_is_struck_out_is_not_shown(marks: tuple[str, str]) -> None:
    assert not shown(f"$${LATEX}$$".join(marks), "latex")


@pytest.mark.parametrize(
    "behind", ["dy = zeros(2,1);\n", "dy = similar(y)\n", "x = 1; dy = ones(2,1);\n"]
)
def test_an_array_that_is_made_anew_holds_nothing(behind: str) -> None:
    assert not shown(f"{PROGRAM}{behind}end\n", "text")


def test_a_block_of_comments_is_no_code() -> None:
    *head, right = PROGRAM.splitlines(keepends=True)
    assert not shown(f"{''.join(head)}{WRONG}%{{\n{right}%}}\nend\n", "text")
    assert not shown(f"{''.join(head)}{WRONG}%{{\n{right}end\n", "text")
    answer = found(f"{PROGRAM}%{{\n{WRONG}%}}\nend\n", "text")
    assert answer is not None and answer.ok
    assert answer.unjudged == (WRONG.strip(),)
    assert not shown(f"{TEXT}\n%{{\nT = 0\n", "text")
