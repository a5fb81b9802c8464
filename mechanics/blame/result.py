"""What is wrong with a refuted statement.

written - right = sum of differences        statement with one of the repairs put in: PROVED
"""

from dataclasses import dataclass
from enum import Enum

from mechanics.claims.claim import Written
from mechanics.kernel import Finding
from mechanics.scene.published import Published


class Mistake(Enum):
    """What an edit undoes; the value is the sentence."""

    SIGN = "the sign is reversed"
    FACTOR = "the factor is wrong"
    MISSING = "a term is missing"
    EXTRA = "a term is too many"
    FUNCTION = "sine, cosine or tangent is the wrong one"
    SYMBOL = "a wrong symbol stands here"
    POWER = "the power is wrong"
    TERM = "the term is wrong"
    ORDER = "two outputs stand in each other's place"


@dataclass(frozen=True)
class Edit:
    """One change of what was written.

    Attributes
    ----------
    written : str
        What stands there, in the person's own notation; empty where a term is missing.
    right : str
        What has to stand there; empty where a term is too many.
    span : tuple of int or None
        Where it stands in the source of the statement, from and to; None for code and objects.
    definition : str
        Name of the person's definition that it stands in; empty for the statement itself.
    place : str
        Where that definition stands, ``cart.py, line 12``; empty where that is not known.
    """

    mistake: Mistake
    written: str
    right: str
    span: tuple[int, int] | None = None
    definition: str = ""
    place: str = ""


@dataclass(frozen=True)
class Repair:
    """Edits that together make the statement right, and the proof of it.

    Attributes
    ----------
    edits : tuple of Edit
        One for each independent error.
    repaired : str
        The statement with the edits put in, in the person's notation.
    finding : Finding
        Of the statement with the edits put in; PROVED or CERTIFIED.
    row : Published or None
        The statement with the edits put in, as the ledger checked it.
    written : Written or None
        Its trees and definitions then.
    """

    edits: tuple[Edit, ...]
    repaired: str
    finding: Finding
    row: Published | None = None
    written: Written | None = None


@dataclass(frozen=True)
class Difference:
    """One group of terms in which what is written differs from what is right.

    Attributes
    ----------
    group : str
        ``"coefficient of theta_ddot"``, ``"products of speeds"``, ``"gravity"``, ...
    written, right : str
        The terms of the group on either side, in the person's own notation; empty where none.
    origin : tuple of str
        Where the right terms come from: ``"pole: rate of linear momentum"``, ``"load k"``.
    """

    group: str
    written: str
    right: str
    origin: tuple[str, ...] = ()


@dataclass(frozen=True)
class Blame:
    """Why a statement is refuted.

    Attributes
    ----------
    differences : tuple of Difference
        Term by term; empty where there is no right equation near enough to compare with.
    repairs : tuple of Repair
        The smallest ones, all equally small; the likeliest first.
    explanations : tuple of str
        Known mistakes that were proved to be the reason: ``"parallel axis counted twice: pole"``.
    searched : str
        Where no repair was found: what was tried. Where numbers stand for parameters: which values
        the repairs are for.
    """

    differences: tuple[Difference, ...]
    repairs: tuple[Repair, ...]
    explanations: tuple[str, ...] = ()
    searched: str = ""
