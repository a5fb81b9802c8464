"""What an answer tells once for several statements, and what it puts first."""

from pathlib import Path

from mechanics import check, check_html
from systems import rod_pendulum

WITH_HEADER = """#include "own.h"
#include <math.h>
void rates(const double y[2], double dy[2], double m, double l, double g, double u) {
dy[0] = y[1];
dy[1] = 3*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
}
"""


def test_a_reason_of_several_statements_is_told_once_with_their_names(tmp_path: Path) -> None:
    (tmp_path / "own.c").write_text(WITH_HEADER)
    found = check(rod_pendulum.scene(), tmp_path / "own.c", blame=False)
    assert [e.finding.evidence.count("own.h") for e in found.judged] == [1, 1]
    told = " ".join(str(found).split())
    assert (
        told.startswith('theta_dot, theta_ddot: "own.h" is not here') and told.count("own.h") == 1
    )
    page = check_html(found)
    assert page.count("may give any name") == 1
    one = check(rod_pendulum.scene(), tmp_path / "own.c", only="theta_dot", blame=False)
    assert 'theta_dot: "own.h"' not in str(one) and str(one).count("own.h") == 1


def test_an_equation_that_was_set_aside_is_typeset() -> None:
    text = "$$l\\ddot\\theta = \\frac32 g\\sin\\theta$$\n\n$$V = \\frac{mgl}{2}\\cos\\theta$$"
    found = check(rod_pendulum.scene(), text, only="line 3", blame=False)
    assert found.aside == (r"line 1: l\ddot\theta = \frac32 g\sin\theta",)
    aside = check_html(found).partition("Not judged, as you asked")[2].partition("</details>")[0]
    assert "line 1" in aside and "<math" in aside and "\\ddot" not in aside


def test_what_is_right_in_another_case_is_counted_as_undecided() -> None:
    found = check(rod_pendulum.scene(), r"For $u=0$: $\ddot\theta=\frac{3g}{2l}\sin\theta$.")
    overall = check_html(found).partition('<div class="overall')[2].partition("</div>")[0]
    assert overall.startswith(" doubt") and "undecided" in overall and "refuted<" not in overall
    told = str(found)
    assert told.index("right if u = 0") < told.index("at this state")
