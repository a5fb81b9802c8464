"""Why a refuted statement is wrong: ``blame(truth, statement) -> Blame``.

edits that make it right at a point  ->  proved  ->  what differs, term by term  ->  where from
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice, product

from sympy import Expr, S, Symbol

from mechanics.blame.difference import differences
from mechanics.blame.reference import Reference
from mechanics.blame.result import Blame, Mistake, Repair
from mechanics.blame.search.budget import Budget
from mechanics.blame.search.candidates import Candidates
from mechanics.blame.search.claim import Claim, as_motion, at_once, claim_of, problems
from mechanics.blame.search.edits import Maker
from mechanics.blame.search.find import EQUALLY, Solution, solutions, words_of
from mechanics.blame.search.probabilistic_check import Problem
from mechanics.blame.search.repair import edited_row, proved, spelling_of
from mechanics.claims.from_sympy import Untreeable
from mechanics.claims.place import Refused
from mechanics.claims.statement import Statement
from mechanics.compiled.dimensions import check_energy
from mechanics.errors import ExpressionError, MechanicsError
from mechanics.scene.published import Published
from mechanics.scene.quantities import Lagrangian

SHOWN = 3
"""Repairs that are told, where several are equally small."""

MOST = 40
"""Equalities of a statement beside the first one, as of a mass matrix, that are searched."""

TRIED = 12
"""Edits that are proved at most."""

TRIED_ONE_BY_ONE = 60
"""Edits that are proved where no point tells whether they help."""

STEPS = 10_000
"""After which nothing more is tried; an equation of a page takes less than a thousand."""


def blame(
    reference: Reference,
    statement: Statement,
    kept: frozenset[int | str] = frozenset(),
    budget: Budget | None = None,
    put: Mapping[Symbol, Expr] | None = None,
    beside: Expr = S.Zero,
) -> Blame:
    """Which term of a refuted statement is wrong.

    Parameters
    ----------
    reference : Reference
        What the statements of a text are compared with.
    statement : Statement
        Refuted.
    kept : frozenset of int or str
        Entries and definitions that other statements are shown with: edits elsewhere come first.
    budget : Budget, optional
        Of a whole text; what is taken from it, at most `STEPS`, is counted.
    put : mapping of Symbol to Expr, optional
        What stands for the person's symbols, by a convention or as values of parameters; then what
        differs is not shown term by term.
    beside : Expr, optional
        What makes of an energy with potentials of forces the scene's own; the same then.

    Returns
    -------
    Blame
        With the smallest repairs, each of them proved; `searched` says what was tried in vain.
    """
    try:
        claim = claim_of(reference, statement, put)
    except (Untreeable, Refused) as reason:
        return Blame((), (), searched=f"not searched: an edit cannot be placed in it: {reason}")
    if claim is None:
        return Blame((), (), searched="not searched: it could not be read")
    own = Budget(STEPS)
    try:
        claim = replace(claim, beside=beside)
        return _searched(claim, statement, kept, own)
    finally:
        if budget is not None:
            budget.spend(STEPS - own.left)


def _searched(
    claim: Claim, statement: Statement, kept: frozenset[int | str], budget: Budget
) -> Blame:
    """What the search finds within a budget."""
    row, repairs, words = None, tuple[Repair, ...](), ""
    try:
        mended = _mended(claim, statement, kept, budget)
        if mended:
            row, repairs = mended[0][1], tuple(repair for repair, _ in mended)
        else:
            words = STOPPED if budget.spent else SEARCHED
    except (MechanicsError, Refused) as reason:
        words = f"not searched to the end: {reason}"
    spelling = spelling_of(claim)

    def spell(expression: Expr) -> str:
        try:
            return spelling(claim.written.tree(expression))
        except Untreeable:
            return str(expression)

    if claim.written.put or claim.beside:
        return Blame((), repairs, searched=words)
    try:
        terms, doubt = differences(claim.reference, statement, repaired=row, spell=spell), ""
    except MechanicsError as reason:
        terms, doubt = (), f"the difference is not shown term by term: {reason}"
    return Blame(terms, repairs, searched="; ".join(filter(None, (words, doubt))))


def _mended(
    claim: Claim, statement: Statement, kept: frozenset[int | str], budget: Budget
) -> list[tuple[Repair, Published]]:
    """Proved repairs; what spoils another statement is a smaller change than any that does not."""
    asked = (claim, *as_motion(claim))
    smallest: list[tuple[Repair, Published]] = []
    for places in (kept, frozenset[int | str]())[not kept :]:
        searches = (
            list(islice(_repairs(each, replace(statement, row=each.row), budget), SHOWN))
            for each in (replace(claim, kept=claim.kept | places) for claim in asked)
        )
        more = next((repairs for repairs in searches if repairs), [])
        if more and (not smallest or len(more[0][0].edits) < len(smallest[0][0].edits)):
            smallest = more
        if smallest and len(smallest[0][0].edits) == 1:
            break
    return smallest


BESIDE = 2
"""Edits of one equality that are tried beside those of another one."""

SEARCHED = (
    "no edit was found that makes it right: none of a sign, factor, symbol, function, power, extra"
    " or missing term, and no likely pair of these"
)


STOPPED = f"none of the simplest edits makes it right; the search ended after {STEPS} steps"


def _repairs(
    claim: Claim, statement: Statement, budget: Budget
) -> Iterator[tuple[Repair, Published]]:
    """Proved repairs, equally small ones, the likeliest first, until the budget is spent."""
    for search in (_in_one_place, _up_to_a_rate):
        single = False
        for mended in search(claim, statement, budget):
            single = True
            yield mended
        if single:
            return
    wrong = [problem for problem in problems(claim) if problem.residual]
    if not wrong:
        return
    first, *others = wrong
    if len(others) > MOST:
        raise ExpressionError(f"{len(wrong)} of its equalities are wrong")
    rest = [_cheapest(claim, problem, statement, budget) for problem in others]
    smallest: float | None = None
    seen: set[tuple] = set()
    tried = 0
    for stage in _stages(claim, first, statement, budget):
        for solution, *fixed in product(stage, *rest):
            group = (solution, *fixed)
            cost = sum(part.cost for part in group)
            if smallest is not None and cost > smallest + EQUALLY:
                continue
            made = edited_row(claim, group)
            if made is None or made[0].sides in seen:
                continue
            seen.add(made[0].sides)
            tried += 1
            budget.spend(len(first.tree.nodes))
            repair = proved(claim, group, statement.source)
            if repair is not None:
                smallest = cost if smallest is None else smallest
                yield repair, made[0]
            if tried >= TRIED or budget.spent:
                return
        if smallest is not None or budget.spent:
            return


def _in_one_place(
    claim: Claim, statement: Statement, budget: Budget
) -> Iterator[tuple[Repair, Published]]:
    """Single edits of an energy as a whole, or of what should be an equation of motion."""
    for asked, problem in at_once(claim):
        for solution in islice(next(_stages(asked, problem, statement, budget)), TRIED):
            if budget.spent:
                return
            budget.spend(len(problem.tree.nodes))
            made = edited_row(asked, (solution,))
            repair = proved(asked, (solution,), statement.source) if made else None
            if repair is not None and made is not None:
                yield repair, made[0]


def _up_to_a_rate(
    claim: Claim, statement: Statement, budget: Budget
) -> Iterator[tuple[Repair, Published]]:
    """Single edits of a Lagrangian that is right up to the rate of a function of q and t.

    No value at a point tells these: the likeliest ones are proved one by one.
    """
    if not isinstance(claim.row.quantity, Lagrangian) or not claim.truth.scene.explicit_time:
        return
    for asked, problem in at_once(claim):
        words = words_of(asked, problem)
        changes = Candidates(Maker(problem.tree, problem.sheets, words)).all()
        tried = 0
        # Numbers, of which there are many, come last.
        for change in sorted(changes, key=lambda c: (c.mistake is Mistake.FACTOR, c.cost)):
            solution = Solution(problem, (change,))
            made = edited_row(asked, (solution,))
            if made is None or check_energy(claim.truth, made[0]) is not None:
                continue
            tried += 1
            budget.spend(len(problem.tree.nodes))
            if (repair := proved(asked, (solution,), statement.source)) is not None:
                yield repair, made[0]
                return
            if tried >= TRIED_ONE_BY_ONE or budget.spent:
                return


def _stages(
    claim: Claim, problem: Problem, statement: Statement, budget: Budget
) -> Iterator[list[Solution]]:
    """Solutions stage by stage; each looks at all nodes."""
    for stage in solutions(claim, problem, statement):
        budget.spend(len(problem.tree.nodes))
        yield stage


def _cheapest(
    claim: Claim, problem: Problem, statement: Statement, budget: Budget
) -> list[Solution]:
    """The cheapest solutions of one equality among several."""
    found = next((stage for stage in _stages(claim, problem, statement, budget) if stage), [])
    return found[:BESIDE]
