"""Objects that a judged function reads: who else may change them."""

import ast

import pytest

from mechanics.claims.code.python.file_names import unsettled

DEFINED = """
from collections import deque
from types import SimpleNamespace
C = [-1, 2]
D = dict(k=4.0, l=[1, 2])
S = SimpleNamespace(s=-1)
E = dict(k=4.0)
N = {"a": {"g": 1}}
Q = deque([1, 2])
def f(x): return C[0]*D["k"]*S.s*x*N["a"]["g"]*Q[0]*E["k"]
def flip(q): q.reverse()
def show(q, n): return q[0]*n
"""


def place(line: str) -> str:
    """What is said of a file with a line; what is under a condition is not run."""
    names: dict[str, object] = {"x": False}
    exec(DEFINED, names)
    code = DEFINED + line
    if not line.startswith(("if", "def", "for")):
        exec(line, names)
    return unsettled(ast.parse(code), {"f", "C", "D", "S", "E", "N", "Q"}, names, {"f"})


@pytest.mark.parametrize(
    "line",
    [
        "if x: list.reverse(C)",
        "if x: flip(C)",
        "if x: dict.update(D, k=1)",
        "pair = (C, 2)\nif x: pair[0][0] = 1",
        "T = C\nif x: T[0] = 1",
        "if x:\n    T = C\n    T[0] = 1",
        "for one in (C,): one[0] = 1",
        "def main():\n    T = S\n    T.s = 1",
        "if x: type(S).s = 1",
        "if x: random.shuffle(D['l'])",
        "if x: D.pop('k')",
        "def main(): return [C]",
        "if x: other.keep(state=C)",
        "def main():\n    for one in N.values(): one['g'] = 1",
        "if x: list(N.values())[0].clear()",
        "if x: Q.rotate(1)",
        "if x: flip(Q)",
    ],
)
def test_what_may_be_changed_is_no_number(line: str) -> None:
    assert place(line)


@pytest.mark.parametrize(
    "line",
    [
        "print(C, len(D), S.s, f'{C}')",
        "if x: print(C, D['k'], E.get('k'), sorted(C))",
        "if x: y = C[0] + D['k']*S.s",
        "if x: y = show(C, 2)",
        "if x: y = [k*2 for k in C]",
        "if x: y = dict(E, m=1)",
        "if x: a, b = C",
        "if x: y = f(C[0])",
        "def main(C): C[0] = 1",
        "def main():\n    C = [1]\n    C.append(2)",
        "import random\nC.append(3)\nrandom.shuffle(C)",
        "T = C",
    ],
)
def test_what_is_only_read_is_one_number(line: str) -> None:
    assert place(line) == ""
