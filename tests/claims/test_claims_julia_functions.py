"""Functions of Julia as code: what is solved, arrays that are filled, records, and traps."""

from pathlib import Path

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, pendulum
from mechanics.claims.code.translation.julia import in_python
from mechanics.claims.code.translation.python_page import Unread
from mechanics.errors import InputError
from systems import rod_pendulum

PENDULUM = """using DifferentialEquations, Plots
const g, l = 9.81, 0.5   # of the file

@time println("solving")
function show_it(sol)
    plot(sol, label = "θ")
end

function f!(du, u, p, t)
    θ, ω = u
    du[1] = ω
    du[2] = dω = %s
    return nothing
end

prob = ODEProblem(f!, [0.1, 0.0], (0.0, 10.0))
"""


@pytest.mark.parametrize("row", ["x -1.5", "3x +1.5", "2 (x)", "1.5 x", "-x (x)"])
def test_entries_of_a_row_that_blanks_part_are_several(row: str) -> None:
    first, second = (value(f"a = [{row}]\na[{k}]", x=3.0) for k in (1, 2))
    assert (first, second) == {
        "x -1.5": (3, -1.5), "3x +1.5": (9, 1.5), "2 (x)": (2, 3), "1.5 x": (1.5, 3),
        "-x (x)": (-3, 3),
    }[row]  # fmt: skip


@pytest.mark.parametrize("entry", ["x - 1.5", "x-1.5", "(x -1.5)", "x - 1.5 + 0"])
def test_a_difference_with_blanks_on_both_sides_is_one_entry(entry: str) -> None:
    assert value(f"a = [{entry}, 7.0]\na[1]", x=3.0) == 1.5


def functions(text: str, *names: str):
    return in_python(text, "page.jl", set(names).__contains__).functions


def value(body: str, **given: object) -> float:
    (function,) = functions(f"function f({', '.join(given)})\n{body}\nend")
    return function(**given)


@pytest.mark.parametrize(
    "formula, verdict",
    [("-g / l * sin(θ)", "PROVED"), ("-2g / 2l * sin(θ)", "PROVED"),
     ("-g * l * sin(θ)", "REFUTED"), ("-2g / l * sin(θ)", "REFUTED")],
)  # fmt: skip
def test_a_file_is_judged_by_what_is_solved(tmp_path: Path, formula: str, verdict: str) -> None:
    path = tmp_path / "pendulum.jl"
    path.write_text(PENDULUM.replace("%s", formula))
    m, l, g = P("m:kg l:m g:m/s^2")
    found = mechanics.check(pendulum(dynamicsymbols("theta"), m, 0, l, g), path)
    assert found.verdict.name == verdict
    assert not found.beside  # what only shows says nothing


@pytest.mark.parametrize(
    "formula, right",
    [("2x^2", 18), ("1/2x", 1 / 6), ("-x^2", -9), ("-(x)^2", -9), ("2(x)^2", 18), ("4/2*(x)", 6),
     ("2*(x)^2", 18), ("8-2-(x)", 3), ("sum([x -x])", 0), ("sum([1 -x*2 3])", -2)],
)  # fmt: skip
def test_signs_and_products_are_those_of_julia(formula: str, right: float) -> None:
    assert value(formula, x=3.0) == right


def test_arrays_records_and_broadcasting() -> None:
    text = """function f!(ẋ, x, p, t)
        (; m) = p
        M = @SMatrix [m 0; 0 2]
        s, c = sincos(x[1] - x[2])
        ẋ .= s^2 * (1 + c / c) / 2s^2 * M \\ ([x[2]; x[1]] .* 2)
    end"""
    (function,) = functions(text)
    assert list(function(x=np.array([3.0, 5.0]), m=4.0)) == pytest.approx([2.5, 3.0])


@pytest.mark.parametrize(
    "body",
    [
        "y = x\ny[1] = 2.0\nx",  # one array, two names
        "y = [x, x]\nz = (y)\nz[1] = 0\ny[1]",
        "y = x > 0 ? 1 : 2\n@eval y = 3\ny",
        "m₁ = x\nm1 = 2x\nm₁ + m1",  # one name here
        "while x > 0\nx -= 1\nend\nx",
        "@show x = 2\nx",
        "a = [x * 2 (x)]\na[1]",  # two columns in Julia
        "a = [x -1.5, 2.0]\na[1]",
        "g(y)\nx",
        "inv.([x 1.0; 0.0 2.0])[1]",  # of each entry
        "sum.([x, 1.0])[1]",
    ],
)
def test_what_may_mean_something_else_is_not_read(body: str) -> None:
    with pytest.raises(Unread):
        value(body, x=3.0)


def test_functions_of_the_file_and_its_macros_keep_their_meaning() -> None:
    for more in ("Base.sin(x) = cos(x)", "+(a, b) = a - b", "π = 3", "macro time(x) end"):
        with pytest.raises(Unread):
            functions(f"{more}\nfunction f(x)\n sin(π + x)\nend")
    with pytest.raises(Unread, match="several methods"):
        functions("f(x) = 2x\nf(x, y) = x\n")
    with pytest.raises(Unread, match="assigned twice"):
        functions("k = 1\nk = 2\nfunction f(x)\n k*x\nend")


def test_entries_that_are_not_set_have_no_value() -> None:
    (function,) = functions("function f!(du, u)\n du[2] = u[1]\nend")
    found = function(u=np.array([3.0, 5.0]))
    assert np.isnan(found[0]) and found[1] == 3.0


@pytest.mark.parametrize(
    ("lines", "read"),
    [
        ("du[1] = s[2]; du[2] = s[1]", True),
        ("du .= [s[2], s[1]]", True),
        ("du = [s[2], s[1]]", False),
        ("du = similar(s); du[1] = s[2]; du[2] = s[1]; nothing", False),
        ("du = copy(du); du[1] = s[2]; du[2] = s[1]; nothing", False),
        ("[s[2], s[1]]", False),
    ],
)
def test_a_function_in_place_sets_entries_of_its_first_argument(lines: str, read: bool) -> None:
    text = f"function f!(du, s, p, t)\n{lines.replace('; ', chr(10))}\nend"
    if read:
        (function,) = functions(text)
        assert list(function(s=np.array([3.0, 5.0]))) == [5.0, 3.0]
        return
    with pytest.raises(Unread, match=r"does not see|sets no entries"):
        functions(text)


@pytest.mark.parametrize("kind", ["Int", "Int64", "Bool", "Q15", "Vector{Int}"])
def test_what_is_converted_to_integers_is_not_read(kind: str) -> None:
    for text in (
        f"function f(x)\na::{kind} = 3x\nreturn a\nend",
        f"function f(x)::{kind}\n3x\nend",
    ):
        with pytest.raises(Unread, match="converted"):
            functions(text)
    assert functions("function f(x)::Float64\n3x\nend")[0](x=2.0) == 6.0


@pytest.mark.parametrize("line", ["using .Other: sin", "import Other: turned as sin"])
def test_a_function_of_another_module_is_not_the_one_of_that_name(line: str) -> None:
    with pytest.raises(Unread, match="another meaning"):
        functions(f"{line}\nf(x) = sin(x)")
    assert functions("using LinearAlgebra: dot\nf(x) = 3x")[0](x=2.0) == 6.0


@pytest.mark.parametrize(("value", "told"), [("Float32(3x)", 1), ("1.5f0*2x", 1), ("3.0*x", 0)])
def test_that_rounding_is_not_judged_is_said(value: str, told: int) -> None:
    translated = in_python(f"f(x) = {value}", "page.jl", lambda name: False)
    assert len([one for one in translated.remarks if "single precision" in one]) == told


MAKER = '''%s
function oscillator(; k=1, m=2)
    """Makes the rates of a mass on a spring."""
    function rates(t, y)
        """The rates at a time."""
        x, v = y
        [v, -k/m*x]
    end
end
'''


def test_a_function_that_one_makes_has_its_arguments() -> None:
    (function,) = functions(MAKER % "", "k", "m")
    assert list(function(y=np.array([3.0, 5.0]), k=4.0, m=2.0)) == [5.0, -6.0]
    with pytest.raises(Unread):
        functions(MAKER % "k = 3", "k", "m")


@pytest.mark.parametrize(
    ("name", "head", "body", "end"),
    [
        ("own.jl", 'include("my.jl")\nfunction acc({})', "return {}", "end"),
        ("own.m", "function a = acc({})\nrun('my.m')", "a = {};", "end"),
    ],
)
def test_a_file_that_is_not_here_may_say_what_names_are(
    name: str, head: str, body: str, end: str, tmp_path: Path
) -> None:
    def verdict(arguments: str, **options: object) -> str:
        lines = (head.format(arguments), body.format(right), end)
        (tmp_path / name).write_text("\n".join(lines))
        return mechanics.check(rod_pendulum.scene(), tmp_path / name, **options).verdict.name

    right = "1.5*g/l*sin(theta) + 3*u/(m*l^2)"
    assert verdict("theta, theta_dot, u, m, l, g") == "PROVED"
    assert verdict("theta, theta_dot, u") == "UNDECIDED"
    assert verdict("theta, theta_dot, u", names={"m": "m", "l": "l", "g": "g"}) == "PROVED"


INPUT = """function pendulum!(du, u, p, t)
    du[1] = u[2]
    du[2] = -3g/(2l)*sin(u[1]) + %s
end
"""


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("term", "verdict"),
    [("3/(m*l^2)*p(t)", "PROVED"), ("3/(m*l^2)*p(t) + 0*t", "PROVED"),
     ("3/(m*l)*p(t)", "REFUTED"), ("-3/(m*l^2)*p(t)", "UNDECIDED"), ("3/(m*l^2)*p(2t)", ""),
     ("3/(m*l^2)*p(u)", ""), ("3/(m*l^2)*p(t)*p[1]", ""), ("3/(m*l^2)*p(t) + 0*p", ""),
     ("3/(m*l^2)*p(t, t)", ""), ("3/(m*l^2)*u(t)", ""), ("(t = 2; 3/(m*l^2)*p(t))", "")],
)  # fmt: skip
def test_a_function_of_the_time_is_an_input(term: str, verdict: str, tmp_path: Path) -> None:
    path = tmp_path / "own.jl"
    path.write_text(INPUT % term)
    (theta, M), (m, l, g) = dynamicsymbols("theta M"), P("m:kg l:m g:m/s^2")
    scene = pendulum(theta, m, m * l**2 / 12, l / 2, g, M, (M,))
    try:
        found = mechanics.check(scene, path, blame=False).verdict.name
    except InputError:
        found = ""
    assert found == verdict


ONE_LINE = "accel(theta, u, m, l, g) = 3g/(2l)*sin(theta) + 3u/(m*l^2)\n"


@pytest.mark.parametrize(
    ("text", "verdict"),
    [(ONE_LINE, "PROVED"), (f"using DifferentialEquations\n{ONE_LINE}", "PROVED"),
     (ONE_LINE.replace("3u", "2u"), "REFUTED"),
     (ONE_LINE.replace("theta, u", "theta::Float64, u::Float64"), "PROVED"),
     (f"@inline {ONE_LINE}", "PROVED"),
     (f"@inline @fastmath {ONE_LINE}".replace("3u", "2u"), "REFUTED"),
     # Equations of a page stay text.
     ("theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)\n", "PROVED")],
)  # fmt: skip
def test_a_function_on_one_line_is_code(text: str, verdict: str, tmp_path: Path) -> None:
    path = tmp_path / "own.jl"
    path.write_text(text)
    found = mechanics.check(rod_pendulum.scene(), path, blame=False)
    assert found.verdict.name == verdict


@pytest.mark.parametrize("macro", ["@doc", "@time", "@inbounds @simd"])
def test_nothing_behind_a_macro_is_lost(macro: str) -> None:
    """The grammar splits what is assigned there at 3u."""
    text = f"{macro} f(x) = sin(x) + 3x/(x + 1)\nfunction g(x)\n f(x)\nend"
    try:
        (one,) = functions(text)
    except Unread:
        return
    assert one(2.0) == pytest.approx(np.sin(2.0) + 2.0)


@pytest.mark.parametrize("power", ["x + 2^1^2", "x + 2.0 .^ 1 .^ 2", "2^2x^2", "x^2^3"])
def test_a_power_of_a_power_is_not_read(power: str) -> None:
    """The tree has them from the left, Julia from the right."""
    with pytest.raises(Unread, match="a power of a power"):
        value(power, x=3.0)


@pytest.mark.parametrize(
    ("power", "number"),
    [("(2^1)^2x", 64), ("x*2^(1^2)", 6), ("-x^2", -9), ("2x^2", 18), ("2^2x", 64)],
)
def test_a_power_is_that_of_julia(power: str, number: float) -> None:
    assert value(power, x=3.0) == number
