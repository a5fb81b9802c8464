"""Mutants that are right after all, by the exact normal form.

left - right = 0 as a polynomial, with the accelerations of Kane's method put in
"""

from sympy import Matrix

from benchmarks.detection.rows import UNKNOWN_UP_TO_A_CONSTANT, Row, Subject
from benchmarks.detection.tree import Tree, written
from mechanics.checks.ledger_compare import project_defined
from mechanics.checks.solution import solve
from mechanics.symbolic import Arithmetic
from mechanics.symbolic.decide import proved


def same(about: Subject, row: Row, trees: tuple[Tree, ...]) -> bool:
    """Whether the normal form proves a statement like `row` with these trees.

    False says nothing: where the normal form grows too large, numbers have to do.
    """
    scene = about.scene
    sides = [written(tree) for tree in trees]
    right = sides[1:] if row.equation else [written(tree) for tree in row.trees]
    left = sides[:1] if row.equation else sides
    if row.about in UNKNOWN_UP_TO_A_CONSTANT:
        by = Matrix([*scene.q, *scene.u])
        left, right = (list(Matrix(side).jacobian(by)) for side in (left, right))

    def experiment(a: Arithmetic) -> list:
        project_defined(a, about.kane.kinematics)
        if row.equation:
            found = solve(a, about.kane)[: len(scene.ud)]
            for symbol, number in zip(scene.ud, found, strict=True):
                a.assign(symbol, number)
            for symbol, expression in about.free_body.reactions:
                a.assign(symbol, a.value(expression))
        return [(a.value(x), a.value(y)) for x, y in zip(left, right, strict=True)]

    return proved(experiment)
