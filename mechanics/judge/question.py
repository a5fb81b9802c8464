"""What a person asks: statements that were read, and how they say that they count.

things, options  ->  readings, statements, a choice of them, conventions, values, a region, prose
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.code.black_box import BlackBox
from mechanics.claims.declared_conventions import Declared, read_declared
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.claims.statement import Reading, Statement
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.judge.at_values import Values, read_values
from mechanics.judge.choice import Choice, chosen, read_choice
from mechanics.judge.described_guesses import described_guesses
from mechanics.judge.energy_letters import with_energy_letters
from mechanics.judge.one_document import of_one_document
from mechanics.judge.options import refuse_unused
from mechanics.judge.other_names import best_names
from mechanics.judge.other_reading import of_one_dimension
from mechanics.judge.prose import Prose, prose_of
from mechanics.judge.readers import read, spread
from mechanics.judge.rounded_code import code_conventions
from mechanics.judge.sources import Around, file_of, source_of
from mechanics.judge.where import Where, read_where


@dataclass(frozen=True)
class Question:
    """Statements and how they count.

    Attributes
    ----------
    truth : Equations
    names : mapping of str to str
        The person's, and what they are in the scene.
    parts : tuple
        What is read, but black boxes.
    boxes : tuple of BlackBox
    readings : tuple of Reading
        Of the parts.
    statements : tuple of Statement
        Of all readings.
    choice : Choice
    chosen : tuple of bool
        Which statements the verdict is on.
    declared : tuple of Declared
        Conventions of an option.
    of_code : tuple of str
        Conventions of code.
    values : mapping of Symbol to Expr
    region : tuple of Where
    prose : Prose
    against : tuple of str
        What texts say otherwise than the scene has it.
    """

    truth: Equations
    names: Mapping[str, str]
    parts: tuple[Any, ...]
    boxes: tuple[BlackBox, ...]
    readings: tuple[Reading, ...]
    statements: tuple[Statement, ...]
    choice: Choice
    chosen: tuple[bool, ...]
    declared: tuple[Declared, ...]
    of_code: tuple[str, ...]
    values: Values
    region: tuple[Where, ...]
    prose: Prose
    against: tuple[str, ...]

    @property
    def written_out(self) -> bool:
        """Whether the scene's equations are formulas, and no program."""
        return self.truth.textbook is not None

    @property
    def by_prose(self) -> tuple[Declared, ...]:
        """Conventions that the text says, where no option says how it counts."""
        explicit = self.declared or self.values or self.region or not self.written_out
        return () if explicit else self.prose.conventions

    @property
    def unsettled(self) -> tuple[str, ...]:
        """What texts say that makes statements others, where no option says how they count."""
        return () if self.declared else self.prose.unsettled

    @property
    def counted(self) -> tuple[Declared, ...]:
        """All conventions."""
        return (*self.declared, *self.by_prose)

    @property
    def names_taken(self) -> tuple[Match, ...]:
        """What names of the person were taken for."""
        return tuple(match for reading in self.readings for match in reading.names)

    @property
    def files(self) -> tuple[Around, ...]:
        """Files of Python around judged functions."""
        return tuple(part for part in self.parts if isinstance(part, Around))

    @property
    def beside(self) -> tuple[str, ...]:
        """Lines of code that say something and are not judged."""
        around = (self._around(part) for part in self.files)
        return tuple(dict.fromkeys(chain(*(reading.beside for reading in self.readings), *around)))

    def _around(self, part: Around) -> tuple[str, ...]:
        words = Vocabulary(self.truth.scene)
        names = self.names.items()
        single = {n: m for n, m in names if m == "t" or words.target(m) is not None}
        columns = (Match(n, m, "as given") for n, m in names if " " in m)
        naming = Naming(words, single, (*columns, *self.names_taken))
        return (*part.others, *lines_around(part.code, part.judged, naming))


def question_of(
    truth: Equations, equations: Any, *, names: Mapping[str, str] | None, notation: str | None,
    about: str | None, convention: Sequence[str] | str, function: str | None,
    values: Mapping[str, Any] | None, where: Sequence[str] | str, only: Sequence[str] | str,
) -> Question:  # fmt: skip
    """What is asked by the arguments of `mechanics.check`.

    Raises
    ------
    InputError
        When nothing can be read, or options exclude each other or apply to nothing.
    """
    things = spread(equations)
    boxes = tuple(thing for thing in things if isinstance(thing, BlackBox))
    if truth.textbook is None:
        _refuse_program(boxes, convention=convention, values=values, where=where)
    choice = read_choice(only)
    if boxes and (convention or where or choice):
        raise InputError("check: a black box is only called: leave out convention, where and only")
    of_code, convention = code_conventions(convention)
    options = {"function": function, "notation": notation, "about": about, "values": values}
    refuse_unused(things, notation, [*(n for n, value in options.items() if value), *of_code])
    parts = [thing for thing in things if not isinstance(thing, BlackBox)]
    readings = of_one_document(
        parts, [_read(truth, part, names, notation, about, function) for part in parts]
    )
    every = [s for reading in readings for s in reading.statements]
    statements = tuple(with_energy_letters(truth, of_one_dimension(truth, every)))
    is_chosen = chosen(choice, statements)
    if sum(map(bool, (values, convention, where))) > 1:
        raise InputError(
            "--value (values=), --convention (convention=) and --where (where=) exclude each other:"
            " give one"
        )
    known = [match for reading in readings for match in reading.names]
    sources = [source for part in parts for source in source_of(part)]
    prose = prose_of(truth.scene, statements, known, sources)
    whole = [*sources, *(one for part in parts for one in file_of(part))]
    against = () if convention else _against(prose, truth)
    texts = [where] if isinstance(where, str) else where
    return Question(
        truth, names or {}, tuple(parts), boxes, tuple(readings), statements, choice, is_chosen,
        tuple(read_declared(convention, known)), of_code, read_values(truth.scene, values or {}),
        tuple(read_where(truth, texts, known, names or {})), prose,
        (*against, *dict.fromkeys(described_guesses(truth.scene, known, whole))),
    )  # fmt: skip


def _refuse_program(boxes: Sequence[BlackBox], **options: Any) -> None:
    """Refuse what needs equations that are written out."""
    if boxes:
        raise InputError(
            "check: equations that stay a program are not compared with a black box: pass its"
            " formulas, or functions that can be traced"
        )
    for name, value in options.items():
        if value:
            raise InputError(
                f"check: equations that stay a program are judged as they stand: leave out {name}"
            )


def _read(truth: Equations, part: Any, names: Mapping[str, str] | None, *how: Any) -> Reading:
    """A reading under the best choice of the names that are guessed."""
    found = read(truth.scene, part, names, *how)
    return best_names(
        truth, found, lambda chosen: read(truth.scene, part, {**(names or {}), **chosen}, *how)
    )


def _against(prose: Prose, truth: Equations) -> tuple[str, ...]:
    """What texts say otherwise than the scene has it, in words."""
    conventions = () if truth.textbook is not None else prose.conventions
    return (*(f"the text counts otherwise: {one.told}" for one in conventions), *prose.against)
