"""A statement of a person about a scene: a row of the ledger, with what it was read from.

source -> row.sides, in the scene's plain symbols; row.quantity is what it is about
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sympy import Expr, Symbol

from mechanics.claims.claim import Trees, Written
from mechanics.claims.demands import Demands
from mechanics.claims.names import Match
from mechanics.scene.published import Published

NO_DEMANDS = Demands()


@dataclass(frozen=True)
class Letter:
    """A name on the left, or of a function, that may mean several things.

    Attributes
    ----------
    name : str
    sides : tuple of Expr
        What it is said to be, in the scene's plain symbols.
    said : str
        What the person says that it means, a word of `mechanics.claims.about.WORDS`, or empty.
    own : bool
        Whether the scene has it.
    returned : bool
        Whether it is a function, and the sides are what it returns.
    owner : frozenset of str
        Words of its name for whose it is.
    """

    name: str
    sides: tuple[Expr, ...]
    said: str = ""
    own: bool = False
    returned: bool = False
    owner: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Statement:
    """One thing that a person claims.

    Attributes
    ----------
    row : Published or None
        What the ledger checks; None for what could not be read.
    source : str
        As it was written.
    tag : str
        The number that it has in its source, ``"(6)"``, or its place among the others, ``"1"``.
    place : str
        ``file, line 3``, where it has one.
    notes : tuple of str
        How what can be read in two ways was read, and what was added.
    doubt : str
        Why it has no verdict, one line: it could not be read, or holds a name that nothing
        explains. Empty otherwise.
    written : Written or None
        The trees of what was written, where it was read from a text.
    others : tuple of (str, tuple of Node)
        Other ways to read it, in words, and its sides then.
    demands : Demands
        What was written that has no value everywhere, before anything was put together.
    letter : Letter or None
        The name on the left, where that may mean several things; `row` takes it as the first.
    ways : mapping of Expr to Written
        The trees of each way through code that decides, by what its output is then.
    taken : tuple of (str, Published)
        Other things that an output of code may be, in words, and the row then; the words are the
        same for all outputs of one call.
    derived : bool
        Whether a side of `row` is the scene's own, what was written is compared with: an entry of
        the mass matrix, what accelerates at an equilibrium. It counts as the scene does.
    unsure : tuple of str
        Under what else it may be right: what nobody said, and has no list of other ways to try
        (`mechanics.judge.guesses`). It is not REFUTED then, only open.
    defines : str
        The name that it defines for other statements, where its meaning is a claim, too.
    rounded : str
        What is rounded to single precision among doubles, as it is written; read as exact, too.
    assumption : str
        What has to be so for it to be right, in words, where nothing here says it.
    missing_code : str
        What is not here, in words, and may give any name that it uses another meaning.
    under_any_guess : Published or None
        What it claims under all that is in `unsure`, too: where that is REFUTED, so is it.
    code_values : tuple of (Expr, Expr)
        Parameters, and the values that code gives them, which are not used; other numbers of it
        may be made of these.
    comments : str
        Those of its code, one a paragraph.
    file_values : tuple of (Symbol, Expr)
        Parameters and inputs of which its file says the value, and that its code does not take.
    """

    row: Published | None
    source: str
    tag: str
    place: str = ""
    notes: tuple[str, ...] = ()
    doubt: str = ""
    written: Written | None = None
    others: tuple[tuple[str, Trees], ...] = ()
    demands: Demands = NO_DEMANDS
    letter: Letter | None = None
    ways: Mapping[Expr, Written] = field(default_factory=dict)
    taken: tuple[tuple[str, Published], ...] = ()
    derived: bool = False
    unsure: tuple[str, ...] = ()
    defines: str = ""
    rounded: str = ""
    comments: str = ""
    assumption: str = ""
    missing_code: str = ""
    under_any_guess: Published | None = None
    code_values: tuple[tuple[Expr, Expr], ...] = ()
    file_values: tuple[tuple[Symbol, Expr], ...] = ()


@dataclass(frozen=True)
class Reading:
    """What was read.

    Attributes
    ----------
    statements : tuple of Statement
    names : tuple of Match
        What each name of the person was taken for.
    remarks : tuple of str
        Definitions of the person, and what else was made of the text.
    unjudged : tuple of str
        Definitions of the person's own names that nothing uses and nothing can contradict.
    beside : tuple of str
        Functions and lines of a file of code that are no part of what was read.
    """

    statements: tuple[Statement, ...]
    names: tuple[Match, ...]
    remarks: tuple[str, ...]
    unjudged: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()

    def rounded(self, what: str) -> "Reading":
        """It, where this is rounded to single precision among doubles, and read as exact."""
        return replace(self, statements=tuple(replace(s, rounded=what) for s in self.statements))
