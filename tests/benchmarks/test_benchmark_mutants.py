"""The mutation campaign: what it changes, what it leaves alone, and what it draws."""

import json

import pytest

from benchmarks.mutants.__main__ import EQUIVALENT, RESULTS, draw, text_of
from benchmarks.mutants.operators import STRICT, is_python, mutants
from benchmarks.mutants.trial import callers

TEXT = '''
"""Text for people: 1 < 2."""
BUDGET = 3000
TABLE = {"f": lambda x: x + 1}


def bound(a: int, b: int = 2) -> int:
    """Another: a - b."""
    if a < b and not a:
        raise ValueError(f"{a + b} is too much")
    a -= 1
    return min(-a, a % b, key=list[1:3])


class C:
    def method(self, x):
        self.y = x ** 2
        return [i for i in x if i is None] if x == 1.5 else f(x, self)
'''

CHANGES = {
    ("", "x - 1"), ("", "x + 2"), ("", "x + 0"), ("bound", "b: int = 3"), ("bound", "b: int = 1"),
    ("bound", "a <= b"), ("bound", "a >= b"), ("bound", "a < b or"), ("bound", "and  a"),
    ("bound", "a += 1"), ("bound", "a -= 2"), ("bound", "max(-a"), ("bound", "min( a"),
    ("bound", "min(a % b, -a"), ("bound", "a * b"), ("bound", "    pass\n    return"),
    ("C.method", "x * 2"), ("C.method", "i is not None"), ("C.method", "if True] if x"),
    ("C.method", "x != 1.5"), ("C.method", "(1.5 * 2)"), ("C.method", "f(self, x)"),
}  # fmt: skip


def test_operators_signs_constants_conditions_statements_and_arguments_are_changed() -> None:
    made = mutants("x.py", TEXT)
    for function, piece in CHANGES:
        assert any(
            m.function == function and piece in m.apply(TEXT) and piece not in TEXT for m in made
        ), (function, piece)
    assert all(m.in_function == (m.function != "" and "b: int" not in m.name) or
               "int = 2" in m.name for m in made)  # fmt: skip
    assert all(m.apply(TEXT) != TEXT for m in made)
    assert len({m.key for m in made}) == len(made)


def test_what_people_read_and_budgets_stay() -> None:
    for mutant in mutants("x.py", TEXT):
        changed = mutant.apply(TEXT)
        for piece in ('"""Text for people: 1 < 2."""', "3000", '"""Another: a - b."""'):
            assert piece in changed
        assert "is too much" in changed or "pass" in changed


def test_changes_of_bounds_signs_and_comparisons_are_told_apart() -> None:
    kinds = {m.kind for m in mutants("x.py", TEXT) if m.function == "bound"}
    assert kinds <= set(STRICT)
    assert "arguments" in {m.kind for m in mutants("x.py", TEXT) if m.function == "C.method"}


def test_names_last_when_other_lines_change() -> None:
    before = {m.key for m in mutants("x.py", TEXT)}
    assert before == {m.key for m in mutants("x.py", "# a comment\n" + TEXT)}


@pytest.mark.campaign
def test_500_are_drawn_and_each_is_python() -> None:
    drawn = draw(60)
    assert [m.key for m in drawn] == [m.key for m in draw(70)[:60]]
    assert all(is_python(m.apply(text_of(m.path))) for m in drawn)
    assert len({m.path for m in drawn}) > 10


def test_what_is_kept_names_its_mutants_and_reasons() -> None:
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    for kept in results.values():
        assert kept.keys() == {"file", "noticed", "alive"}
        assert not {*kept["noticed"]} & {*kept["alive"]}
    reasons = json.loads(EQUIVALENT.read_text(encoding="utf-8"))
    assert all(len(reason) > 10 for reason in reasons.values())


def test_tests_that_call_a_function_are_chosen_the_quickest_first() -> None:
    mutant = next(m for m in mutants("x.py", TEXT) if m.function == "C.method")
    calls = {
        "slow": (3.0, ["x.py:C.method"]),
        "inner": (1.0, ["x.py:C.method.<locals>.<listcomp>"]),
        "other": (0.1, ["x.py:C.methods", "y.py:C.method"]),
        "slowest": (7.0, ["x.py:C.method"]),
    }
    assert callers(calls, mutant, 6.0) == ["inner", "slow"]
    assert callers(calls, mutant) == ["inner", "slow", "slowest"]
