"""What uses a judged function is named, right or wrong: the verdict is of the function alone."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.claims.code.around.callers import callers
from systems import bead_on_hoop

C = "double rate(double x) { return x; }\n\n/* rate\n of it */\nint main(void) {\n  rate(1);\n}\n"
PYTHON = "def rate(x):\n    return x\n\n\ndef run():\n    return rate(1)\n\nprint(rate(2))\n"
MATLAB = "[t, y] = ode45(@rate, [0 1], 0);\nplot(t, y)\nfunction a = rate(t, x)\na = x;\nend\n"
JULIA = "rate(x) = x\nfunction run()\n    rate(1)\nend\n"


@pytest.mark.parametrize(
    ("suffix", "text", "users"),
    [
        (".c", C, "main (lines 5 to 7) uses it"),
        (".cpp", C, "main (lines 5 to 7) uses it"),
        (".py", PYTHON, "run (lines 5 to 6) and the script (line 8) use it"),
        (".m", MATLAB, "the script (line 1) uses it"),
        (".jl", JULIA, "run (lines 2 to 4) uses it"),
    ],
)
def test_what_uses_a_judged_function_is_named(suffix: str, text: str, users: str) -> None:
    assert callers(text, suffix, {"rate"}) == (f"only rate is judged: {users}",)


@pytest.mark.parametrize(
    ("suffix", "text"),
    [
        (".c", "double rate(double x);\ndouble rate(double x) { return x; } // rate\n"),
        (".py", '"""Of rate."""\nimport math\n\n\ndef rate(x):\n    return rate(x - 1)\n'),
        (".jl", "rate(x) = x # rate\n"),
        (".m", "function a = rate(t, x)\n% rate\na = x;\nend\n"),
    ],
)
def test_a_function_alone_has_no_users(suffix: str, text: str) -> None:
    assert callers(text, suffix, {"rate"}) == ()


def test_the_answer_says_so(tmp_path: Path) -> None:
    path = tmp_path / "motion.c"
    path.write_text(
        "#include <math.h>\n"
        "double acc(double theta, double omega, double g, double R) {\n"
        "  return (omega*omega*cos(theta) - g/R)*sin(theta);\n}\n"
        "int main(void) { acc(1, 2, 9.81, 1); return 0; }\n"
    )
    assert "only acc is judged: main (line 5) uses it" in str(check(bead_on_hoop.scene(), path))
