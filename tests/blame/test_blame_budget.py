"""A search ends after so many steps, and says so; what is found does not depend on what is left."""

from collections.abc import Callable, Sequence

import pytest

import mechanics
from mechanics.blame import blame as one
from mechanics.blame.search import candidates, function_arguments
from mechanics.blame.search.budget import Budget
from mechanics.blame.search.change import Change
from mechanics.blame.search.inverse_evaluation import Sheet
from mechanics.claims.tree import Node
from mechanics.judge import bounded_blame as text
from mechanics.judge.check import Check

WRONG = "(M + m)*x'' + 3*k*x + M*L/2*(theta''*cos(theta) + theta'^2*sin(theta)) = 0"


def searched(check: Callable[[str], Check], equation: str) -> list[str]:
    return [entry.blame.searched for entry in check(equation).judged if entry.blame is not None]


@pytest.fixture
def check() -> Callable[[str], Check]:
    from systems import elastic_pendulum

    truth = mechanics.derive(elastic_pendulum.scene(), "free_body")
    return lambda equation: mechanics.check(truth, equation)


def test_steps_are_counted() -> None:
    budget = Budget(10)
    budget.spend(9)
    assert not budget.spent
    budget.spend(5)
    assert budget.spent and budget.left == -4


def test_a_search_without_steps_says_that_it_ended(check, monkeypatch: pytest.MonkeyPatch) -> None:
    assert searched(check, WRONG) == [""]
    monkeypatch.setattr(one, "STEPS", 1)
    (words,) = searched(check, WRONG)
    assert "the search ended after" in words


def test_what_comes_after_the_steps_of_a_text_is_not_searched(
    check, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text, "STEPS", 1)
    first, second = searched(check, f"{WRONG}\n{WRONG.replace('3*k', '5*k')}")
    assert first == ""
    assert second == "not searched: those before it took 1 steps"


def test_what_is_computed_anew_in_a_large_function_is_bounded(
    check, monkeypatch: pytest.MonkeyPatch
) -> None:
    computed: list[int] = [0]
    every, worth = candidates.Candidates.all, function_arguments.worth

    def begun(self: candidates.Candidates) -> list[Change]:
        computed.append(0)
        return every(self)

    def counted(sheets: Sequence[Sheet], node: Node) -> tuple[int, ...] | None:
        computed[-1] += sum(1 for _ in text.walked(node))
        return worth(sheets, node)

    monkeypatch.setattr(candidates.Candidates, "all", begun)
    monkeypatch.setattr(function_arguments, "worth", counted)
    monkeypatch.setattr(candidates, "MOST_EVALUATED", 2000)
    cosines = "+".join(f"cos(theta/{k})" for k in range(2, 20))
    assert searched(check, f"x'' = cos({cosines})")
    # An edit makes a function a little larger.
    assert 0 < max(computed) < 2 * candidates.MOST_EVALUATED
