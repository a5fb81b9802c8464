"""Conditions of validity: where the model of a scene stops being true.

    N > 0                 or it lifts off
    |T| <= mu N           or it slips

The equations of motion do not know them; a simulation watches them.
"""

from dataclasses import dataclass
from typing import Any

from sympy import Expr
from sympy.core.function import AppliedUndef
from sympy.core.relational import GreaterThan, Relational, StrictGreaterThan, StrictLessThan
from sympy.logic.boolalg import BooleanAtom
from sympy.printing.str import StrPrinter

from mechanics.errors import SceneError
from mechanics.scene.declared import decimals, kind_of


@dataclass(frozen=True)
class Condition:
    """A relation that has to hold for the model to be the system.

    Parameters
    ----------
    name : str
    relation : Relational
        ``<``, ``<=``, ``>`` or ``>=`` between expressions in coordinates, their rates, inputs,
        reactions (by the symbols of their names) and parameters.
    otherwise : str
        What happens where it does not hold, as a verb: ``"lifts off"``.
    """

    name: str
    relation: Relational
    otherwise: str

    @property
    def margin(self) -> Expr:
        """Positive inside of the domain, negative outside."""
        left, right = self.relation.lhs, self.relation.rhs
        upward = isinstance(self.relation, GreaterThan | StrictGreaterThan)
        return left - right if upward else right - left

    @property
    def text(self) -> str:
        """The relation for people: ``|T| <= mu*N``."""
        return _Plain().doprint(self.relation)

    @property
    def strict(self) -> bool:
        """Whether the edge is outside."""
        return isinstance(self.relation, StrictGreaterThan | StrictLessThan)


class _Plain(StrPrinter):
    """SymPy's text, with magnitudes between bars and functions of time by their names."""

    def _print_Abs(self, expression: Expr) -> str:
        return f"|{self._print(expression.args[0])}|"

    def _print_Function(self, function: Expr) -> str:
        if isinstance(function, AppliedUndef):
            return str(function.func.__name__)
        return super()._print_Function(function)

    def _print_Derivative(self, derivative: Expr) -> str:
        return self._print(derivative.expr) + "'" * derivative.derivative_count


def condition(name: str, relation: Any, otherwise: str) -> Condition:
    """A condition of validity: see `Condition`.

    Raises
    ------
    SceneError
        When the relation is no inequality, or does not depend on anything.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> condition("contact", dynamicsymbols("F_N") > 0, "the wheel has lifted off").relation
    F_N(t) > 0
    """
    if isinstance(relation, BooleanAtom | bool):
        raise SceneError(
            f"condition {name}: the relation is {bool(relation)} whatever happens: write the"
            " reaction as Symbol(name, real=True), without an assumption on its sign"
        )
    if not isinstance(relation, Relational) or relation.rel_op not in ("<", "<=", ">", ">="):
        raise SceneError(
            f"condition {name}: the relation is {kind_of(relation)}: write an inequality such as"
            " N > 0"
        )
    exact = relation.func(decimals(relation.lhs), decimals(relation.rhs), evaluate=False)
    return Condition(name, exact, otherwise)
