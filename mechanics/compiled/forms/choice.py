"""The form of forward dynamics that takes the fewest operations and rounds well.

    full(n) = n (n + 1)(n + 8)/3 - 4 n      operations of L D L^T of a full n x n system

A form that starts from the bodies needs no matrix. Where there are many unknowns and it takes fewer
operations than elimination alone would of a full matrix, that is not even written out; otherwise
both are, and weighed.
"""

import casadi as ca

from mechanics.compiled.forms.members import FORMS, Form, named_form, preferred
from mechanics.compiled.forms.operations import operations
from mechanics.compiled.forms.system import System
from mechanics.compiled.forms.weigh import lightest
from mechanics.equations import FEW
from mechanics.errors import SingularError


def written(name: str, system: System) -> tuple[Form, ca.SX]:
    """The form of that name, or the one to choose for ``"auto"``; the graph of (u', lambda).

    Raises
    ------
    InputError
        If there is no such form, or the equations have no such one.
    SingularError
        If what it gives is no solution.
    """
    if name == "auto":
        return chosen(system)
    form = named_form(name, system.equations)
    ways = form.ways(system)
    if not ways:
        raise _unsolved(system, f"form {name!r} gives no")
    return form, lightest(system, ways)


def chosen(system: System) -> tuple[Form, ca.SX]:
    """The form, and the graph of (u', lambda)."""
    bodies = [form for form in FORMS if form.solve is None]
    found = [(form, graph) for form in bodies for graph in form.ways(system)]
    n = len(system.equations.unknowns)
    small = n <= FEW or not found or min(operations(graph) for _, graph in found) >= full(n)
    if small:
        usual = preferred(system.equations)
        found += [(usual, graph) for graph in usual.ways(system)]
    if not found:
        raise _unsolved(system, "no form gives")
    best = lightest(system, [graph for _, graph in found])
    return next(written for written in found if written[1] is best)


def _unsolved(system: System, form: str) -> SingularError:
    equations = system.equations
    return SingularError(
        f"{equations.scene.name} by {equations.route}: {form} accelerations that satisfy"
        " M u' = f at ordinary states: look for a body without mass or redundant constraints"
    )


def full(n: int) -> int:
    """Operations of L D L^T of a full system, a division counted twice.

    Step k, with k - 1 rows left, takes 2 (k - 1) for the factors, k (k - 1) for the entries,
    2 (k - 1) for the right side, and 2 + 2 (k - 1) to go back.
    """
    return n * (n + 1) * (n + 8) // 3 - 4 * n
