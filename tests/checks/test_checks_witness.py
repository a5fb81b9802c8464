"""The witness of a refuted row can be put into the row by hand: all that it needs is there."""

import json

import pytest
from sympy import Rational, S, Symbol

from mechanics import derive
from mechanics.checks.ledger_motion import check_equation, check_reaction
from mechanics.kernel import Finding, Verdict
from mechanics.scene import Scene
from systems import four_bar


def substituted(finding: Finding, side: object) -> float:
    witness = finding.witness
    assert witness is not None
    values = {Symbol(name, real=True): Rational(text) for name, text in witness.state}
    values |= {Symbol(name, real=True): Rational(text) for name, text in witness.solved}
    by_name = {symbol.name: value for symbol, value in values.items()}
    expression = S(side)
    missing = {s.name for s in expression.free_symbols} - set(by_name)
    assert missing == set()
    return float(expression.xreplace({s: by_name[s.name] for s in expression.free_symbols}).evalf())


def middle(text: str) -> float:
    return float(text.strip("[]").split(" +/-")[0])


def test_a_wrong_equation_of_a_closed_loop_is_seen_to_be_wrong_by_hand() -> None:
    scene: Scene = four_bar.scene()
    equations = derive(scene, "free_body")
    # A sign of the second equation turned, as a person might.
    wrong = equations.residual[1] + 2 * equations.forcing[1]
    finding = check_equation("(w)", [wrong, S.Zero], equations)
    assert finding.verdict is Verdict.REFUTED and finding.witness is not None
    assert substituted(finding, wrong) == pytest.approx(middle(finding.witness.left), rel=1e-9)
    assert middle(finding.witness.right) == 0
    # Dependent quantities stand beside what was drawn, and none twice.
    given, solved = dict(finding.witness.state), dict(finding.witness.solved)
    assert not set(given) & set(solved)
    assert {symbol.name for symbol in (*scene.q, *scene.u, *scene.ud)} <= set(given) | set(solved)
    assert json.dumps([given, solved])


def test_a_wrong_reaction_too() -> None:
    scene: Scene = four_bar.scene()
    equations = derive(scene, "free_body")
    name = str(equations.multipliers[0])
    side = -equations.multipliers[0]
    finding = check_reaction("(r)", name, [side + scene.ud[0]], equations)
    assert finding.verdict is Verdict.REFUTED and finding.witness is not None
    left, right = finding.witness.left, finding.witness.right
    assert substituted(finding, side + scene.ud[0]) == pytest.approx(middle(left), rel=1e-9)
    assert substituted(finding, -side) == pytest.approx(middle(right), rel=1e-9)
