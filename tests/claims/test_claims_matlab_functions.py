"""Functions of MATLAB as code: structs, matrices, conditions, functions that are solved."""

from pathlib import Path

import numpy as np
import pytest

import mechanics
from mechanics.claims.code.matlab import Unread, in_python
from mechanics.cli.load import load

MASSES = """
function run
m1 = 1; k1 = 2;
M = [%s 0; 0 m1];
[t, z] = ode45(@rhs, [0 1], [1 0]', [], M);
end
"""


def functions(text: str, *names: str):
    return in_python(text, "page.m", set(names).__contains__).functions


def test_matrices_are_multiplied_and_solved() -> None:
    text = """function dx = f(x, s, c)
    if c == true
      A = [s.a 0; 0 2];  % of a struct
    end
    dx = zeros(2, 1);
    for i = 1:2
      dx(i) = A(i, :)*x;
    end
    dx(1:2) = A\\dx(1:end) + (A^-1)*[0; 2*x(1)];
    """
    (function,) = functions(text, "a")
    assert list(function(x=np.array([3.0, 5.0]), a=4.0)) == [3.0, 8.0]


def test_what_is_solved_is_the_statement_and_its_caller_gives_the_matrices() -> None:
    text = MASSES.replace("%s", "m1") + "function dz = rhs(t, z, M)\n dz = M*z;\nend\n"
    (function,) = functions(text)
    assert function.__name__ == "rhs"
    assert list(function(z=np.array([3.0, 5.0]))) == [3.0, 5.0]


def test_columns_and_rows_are_not_mixed() -> None:
    (function,) = functions("function y = f(x)\n y = x*[1; 2];\nend")
    with pytest.raises(ValueError):
        function(x=np.array([1.0, 2.0]))


@pytest.mark.parametrize("body", ["for i=1:1e9\n y=i;\nend", "y=zeros(1e5,1e5);", "y=9^(9^9);"])
def test_what_takes_long_is_refused(body: str) -> None:
    (one,) = functions(f"function y = f(x)\ny = x;\n{body}\nend")
    with pytest.raises((ValueError, TypeError)):
        one(x=1.0)


def test_a_while_is_refused_by_its_line() -> None:
    with pytest.raises(Unread, match="line 2"):
        functions("function y = f(x)\nwhile x > 1\n x = x - 1;\nend\ny = x;\nend")


@pytest.mark.parametrize(("factor", "verdict"), [("3", "PROVED"), ("2", "REFUTED")])
def test_a_struct_of_parameters(tmp_path: Path, factor: str, verdict: str) -> None:
    path = tmp_path / "pendulum.m"
    path.write_text(
        "function dx = pendulum(t, x, u, model)\n"
        "A = [0 1; 0 0]; J = model.rod.m*model.rod.l^2/3;\n"
        f"dx = A*x + [0; {factor}*model.rod.g/model.rod.l/2*sin(x(1)) + u/J];\n"
        "end\n"
    )
    assert mechanics.check(load("rod_pendulum").scene(), path).verdict.name == verdict
