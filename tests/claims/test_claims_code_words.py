"""What code cannot do is said in words of its author's language, in one line."""

import pytest

import mechanics
from mechanics.errors import InputError
from systems import cartpole_friction, rod_pendulum


@pytest.mark.parametrize(
    ("suffix", "text", "words"),
    [
        (
            ".ino",
            "float theta = 0;\nfloat acc(float theta, float u, float m, float l, float g)"
            " { return 3*g/(2*l)*sin(theta)+3*u/(m*l*l); }\n"
            "void loop() { theta = 2*theta; float a = acc(theta, 0, 1, 1, 1); }\n",
            "theta is set in the function and read before",
        ),
        (
            ".m",
            "function dx = pend(t, x, u, m, l, g)\n  a = 3*g/(2*l)*sin(x(1));\n"
            "  dx = [x(2); a +3*u/(m*l^2)];\nend\n",
            "rows of a matrix have 1 and 2 entries",
        ),
    ],
)
def test_what_fails_is_said_in_words(tmp_path, suffix, text, words):
    file = tmp_path / f"mine{suffix}"
    file.write_text(text)
    with pytest.raises(InputError, match=words) as raised:
        mechanics.check(rod_pendulum.scene(), file, blame=False)
    assert "Error" not in str(raised.value)


def test_a_force_that_jumps_is_no_position():
    text = r"$F_f=-\mu_cN_c\,\mathrm{sgn}(\dot x)$"
    found = mechanics.check(cartpole_friction.scene(), text, notation="latex", blame=False)
    assert len(found.judged) == 1
