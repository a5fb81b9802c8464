"""Rows may be scaled and combined at will; a sign or a coefficient may not be changed."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from random import Random
from typing import Any

import pytest
from sympy import Add, Expr, Matrix, Rational, cos, expand

import systems
from mechanics.crosscheck import ROUTES
from mechanics.crosscheck.programs import Programs, check_textbook, derive_rows
from mechanics.equations import Equations
from mechanics.kernel import Finding, Verdict
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.symbolic import canonical, is_zero

SYSTEMS = [system.name for system in systems.ALL]
NAMES = [route.name for route in ROUTES]
SAMPLE = 6
"""Mutations of one route of one system, drawn from all of them."""


@cache
def programs_of(system: str) -> Programs:
    (scene,) = (one.scene() for one in systems.ALL if one.name == system)
    return derive_rows(lower(scene, Builder()), NAMES)


def compared(system: str, route: str, equations: Equations) -> Finding:
    """Equations in SymPy against the program of a route."""
    (finding,) = check_textbook(programs_of(system), {route: equations})
    return finding


def combined(equations: Equations) -> Equations:
    """Rows reversed, scaled by functions, added to each other, and both sides swapped."""
    r = equations.mass.rows
    scale = Matrix(r, r, lambda i, j: int(i + j == r - 1) * (2 + cos(equations.scene.q[0])))
    add = Matrix(r, r, lambda i, j: 1 if i == j else Rational(1, 3) if j == i + 1 else 0)
    change = -add * scale
    return equations.with_matrices(
        mass=change * equations.mass,
        forcing=change * equations.forcing,
        reaction_matrix=change * equations.reaction_matrix,
    )


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("route", NAMES)
def test_combinations_of_rows_still_agree(derived: Any, system: str, route: str) -> None:
    # Rows that were combined are power-conjugate to u no more.
    equations = replace(combined(derived(system)[route]), conjugate=False)
    for other in ("lagrange" if route != "lagrange" else "kane", route):
        assert compared(system, other, equations).shown


def changed_terms(expression: Expr) -> Iterator[Expr]:
    """Copies of an expression with one of its terms negated, or half as large again."""
    terms = Add.make_args(expand(expression))
    for i, term in enumerate(terms):
        if term != 0:
            for factor in (-1, Rational(3, 2)):
                yield Add(*terms[:i], factor * term, *terms[i + 1 :])


def mutations(equations: Equations) -> list[tuple[Equations, Expr]]:
    """Copies with one term of M or f changed, and by how much."""
    found = []
    for name in ("mass", "forcing"):
        matrix = getattr(equations, name)
        for place, entry in enumerate(matrix):
            for other in changed_terms(entry):
                entries = list(matrix)
                entries[place] = other
                copy = equations.with_matrices(**{name: Matrix(*matrix.shape, entries)})
                found.append((copy, other - entry))
    return found


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("route", NAMES)
def test_a_changed_term_is_refuted_with_a_witness(derived: Any, system: str, route: str) -> None:
    equations = derived(system)[route]
    every = mutations(equations)
    drawn = Random(f"{system} {route}").sample(every, min(SAMPLE, len(every)))
    assert drawn
    for copy, difference in drawn:
        assert canonical(difference) != 0 and not is_zero(difference)
        finding = compared(system, route, copy)
        assert finding.verdict is Verdict.REFUTED, (difference, finding)
        assert finding.witness is not None
        assert finding.witness.state
        assert finding.witness.left != finding.witness.right
