"""Values of parameters that change no verdict, in statements that do not have the parameter.

--value m=3 with theta'' = 3*g/(2*l)*sin(theta)    ->    "m = 3 makes no difference"
"""

from collections.abc import Sequence

from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.at_values import Values, words
from mechanics.judge.single import judge
from mechanics.kernel import Finding, Verdict


def unused_values(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding], values: Values
) -> tuple[str, ...]:
    """A remark for each value without which all verdicts are the same, where nothing has its name.

    Parameters
    ----------
    findings : sequence of Finding
        With the values.
    values : mapping of Symbol to Expr
    """
    rows = [statement.row for statement in statements if statement.row is not None]
    held = {symbol for row in rows for side in row.sides for symbol in side.free_symbols}
    verdicts = [finding.verdict for finding in findings]
    if Verdict.UNDECIDED in verdicts:
        return ()
    told = []
    for symbol, value in values.items():
        others = {s: v for s, v in values.items() if s != symbol}
        if symbol in held or [judge(truth, s, others).verdict for s in statements] != verdicts:
            continue
        told.append(
            f"{words({symbol: value})} makes no difference: no statement has {symbol.name}, and the"
            " verdicts are the same without it"
        )
    return tuple(told)
