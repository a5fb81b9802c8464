"""Lines as statements: names matched, definitions put in, and what each line is about.

T = ...   with T unknown     the person's own definition, put in below
N1 = ...                     a reaction along the motion
... x'' ...                  an equation of motion
T = ..., V = ..., L = ...    energies, where the scene has no such names
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from sympy import Expr, Symbol
from sympy.matrices import MatrixBase

from mechanics.claims.about import (
    ENERGY_NAMES,
    ENTRIES,
    LETTERS,
    MATRIX_NAMES,
    WORDS,
    as_asked,
    named_quantity,
)
from mechanics.claims.arguments import applied_alike
from mechanics.claims.build import Builder, Value
from mechanics.claims.claim import Written
from mechanics.claims.coefficients import is_coefficient
from mechanics.claims.conserved import with_first_integrals
from mechanics.claims.definition_readings import dimensionally_consistent
from mechanics.claims.definitions import (
    defines,
    definitions,
    gathers,
    in_order,
    needed,
    reached,
    used,
    without_unknown_rates,
)
from mechanics.claims.demands import Demand, Demands
from mechanics.claims.kind import kind_of, letter_on_left, moves_a_constant
from mechanics.claims.kinds import angular
from mechanics.claims.latex.comments import verbatim
from mechanics.claims.lines import Aside, Entry, Line, Unread, told_once
from mechanics.claims.name_resolution import Read, named
from mechanics.claims.names import Naming, Vocabulary, unexplained
from mechanics.claims.place import Refused, line_and_column, located
from mechanics.claims.positions import as_scene_has, body_at, momentum_of_body, places_of
from mechanics.claims.prose import said_of
from mechanics.claims.sides import (
    distinct,
    entries,
    held,
    holds,
    is_named,
    known_first,
    scalar,
    shape,
)
from mechanics.claims.spelled_rates import key
from mechanics.claims.state_space import with_state_space
from mechanics.claims.statement import Letter, Reading, Statement
from mechanics.claims.text.prepare import comments
from mechanics.claims.tree import Call, Name, Node, names
from mechanics.claims.unread_names import reassigned_names
from mechanics.claims.weight import Weight, weight
from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.published import Quantity, published
from mechanics.scene.quantities import EquationOfMotion, Identity, MassMatrix
from mechanics.scene.rates import TIME

LARGEST_WEIGHT = 50_000
"""Of all lines with their definitions put in; one that doubles makes a million in twenty."""

DEEPEST = 100
"""Levels of a line with its definitions put in."""

MOST_STATEMENTS = 200

SAID = re.compile(
    r"\b(?:defin(?:e|ing)|let|with|where|denot(?:e|ing)|abbreviat(?:e|ing))\s+(?:\$+|\\\(|\\\[)?\s*$",
    re.I,
)
IN_PROSE = re.compile(r"[\w,]\s+(?:\$|\\\()\s*\Z")
"""Words before a formula between single dollars."""
CONTROL = re.compile(r"u(?:_?\w+)?")
"""What control theory calls any input."""
DEFINING = re.compile(r"\\equiv(?![A-Za-z])|:=|\\coloneqq")
"""What says that a name is short for something."""
UP_TO_A_CONSTANT = ("energy", "potential energy", "Lagrangian")
CONSTANTS = ("C", "c", "C_0", "C_1", "const", "constant", "V_0", "U_0", "E_0")
"""Names of a constant that an energy is determined up to."""
SHORT = ("sin", "cos", "tan")
"""What a name alone is short for, which says nothing where it is not used."""


def assemble(
    scene: Scene, read: Read, text: str, origin: str, given: dict[str, str], about: str | None,
    notation: str = "text",
) -> Reading:  # fmt: skip
    """Statements of a text.

    Parameters
    ----------
    scene : Scene
    read : callable
        Makes lines, given how names are to be understood.
    text, origin : str
        The text, and what messages call it.
    given : dict of str to str
        The person's names, and what they mean in the scene.
    about : str or None
        What every line is about, where the person says so.
    notation : str
        In which the text is.
    """
    words = {name: meaning for name, meaning in given.items() if meaning in WORDS}
    plain = {name: meaning for name, meaning in given.items() if meaning not in WORDS}
    naming, lines = named(
        lambda own: list(with_first_integrals(read(own), own, text)),
        Naming(Vocabulary(scene), plain),
        text,
        [*(verbatim(text) if notation == "latex" else comments(text))],
    )
    lines = with_state_space(lines, naming, text)
    lines, told = told_once(without_unknown_rates(lines, naming))
    lines = dimensionally_consistent(lines, naming)
    places = places_of(lines, naming, text)
    lines = [*places.values(), *lines]
    work = _Assembly(scene, naming, text, origin, words, about, needed(lines), notation)
    work.learn(lines)
    for line in lines:
        work.add(line)
    statements = _beside_unread(work.statements, lines, naming)
    statements = tuple(_of_places(statement, places) for statement in statements)
    matches = naming.matches(name.name for name in used(lines))
    unjudged = (*work.unjudged, *_commented_out(text))
    return Reading(statements, matches, (*work.remarks, *told), unjudged)


CUT = re.compile(r"^[^\n%#=]*[^\s%#=\\][ \t]*[%#]+[ \t]*(&?=(?!=)[^\n]*)", re.MULTILINE)
"""A line whose right side is a comment."""


def _commented_out(text: str) -> Iterator[str]:
    """Right sides that are comments: the left ones say nothing."""
    for match in CUT.finditer(text):
        line = text.count("\n", 0, match.start(1)) + 1
        yield f"line {line}: {match[1].strip()}, which is a comment"


def _of_places(found: Statement, places: Mapping[str, Line]) -> Statement:
    """The statement; one with coordinates of bodies that nobody said is never REFUTED."""
    written = found.written
    if written is not None and found.letter is not None:  # V = ..., which another line says, too
        written = replace(written, sides=written.sides[1:])
    held = used_names(written) & {key(name) for name in places}
    words = [f"{n} counts otherwise: say what it is" for n in places if key(n) in held]
    notes = [note for n, line in places.items() if key(n) in held for note in line.notes]
    return replace(found, unsure=(*found.unsure, *words), notes=(*found.notes, *notes))


def _beside_unread(
    statements: Sequence[Statement], lines: Sequence[Entry], naming: Naming
) -> tuple[Statement, ...]:
    """The statements; what lines that are not read may define has a doubt, as relations have.

    A name of the scene may be the author's own there: N = ... beside the reaction N.
    """
    unread = any(isinstance(line, Unread) for line in lines)
    lost = reassigned_names(lines, naming)

    def doubt(found: Statement) -> str:
        if found.doubt or found.row is None or found.letter is not None or not unread:
            return found.doubt
        if used := lost & used_names(found.written):
            return f"it uses {', '.join(sorted(used))}, defined in a line that could not be read"
        if isinstance(found.row.quantity, Identity):
            return "a relation without accelerations, beside lines that could not be read"
        return ""

    return tuple(replace(s, doubt=doubt(s)) for s in statements)


def _free_constant(unknown: Sequence[str], sides: Sequence[Value]) -> Symbol | None:
    """The only name that nothing explains, where it is added to an energy as a constant."""
    if len(set(unknown)) != 1 or unknown[0] not in CONSTANTS or not scalar(tuple(sides)):
        return None
    held = {s for side in sides for s in side.free_symbols if s.name == unknown[0]}
    alone = held and all((side.diff(s)).is_Rational for side in sides for s in held)
    return held.pop() if alone else None


def used_names(written: Written | None) -> set[str]:
    """Keys of all names that a statement uses, by its definitions, too."""
    found: set[str] = set()
    own = dict(written.definitions) if written is not None else {}
    trees = [*written.sides] if written is not None else []
    while trees:
        new = {name.name for name in names(trees.pop())} - found
        found |= new
        trees += [own[name] for name in new if name in own]
    return {key(name) for name in found}


def _names_a_rate(line: Line) -> bool:
    """Whether a line only calls the rate of something by another name: a = v', omega = theta'."""
    return all(isinstance(side, Name) and side.order > 0 for side in line.sides[1:])


def _is_other_letter(left: Node, naming: Naming) -> bool:
    """Whether a name of a reaction stands for something else in the text: T of an energy."""
    return isinstance(left, Name) and key(left.name) in naming.others


class _Assembly:
    """Learns all definitions, then goes through the lines in order."""

    def __init__(
        self, scene: Scene, naming: Naming, text: str, origin: str,
        words: dict[str, str], about: str | None, needed: frozenset[str], notation: str,
    ) -> None:  # fmt: skip
        self.needed, self.notation = needed, notation
        self.scene, self.naming, self.text, self.origin = scene, naming, text, origin
        self.words, self.about = words, about
        self.defined: dict[str, Value] = {}
        self.trees: dict[str, Node] = {}
        self.weights: dict[str, Weight] = {}
        self.weight = self.looked = 0
        self.vague: dict[str, list[str]] = {}
        self.own: dict[str, Line] = {}
        self.lines: Sequence[Entry] = ()
        self.learnt: dict[int, tuple[tuple[Value, ...], Builder] | Refused] = {}
        self.demanded: dict[str, list[Demand]] = {}
        self.reached: frozenset[str] = frozenset()
        self.claims = False
        self.statements: list[Statement] = []
        self.remarks: list[str] = []
        self.unjudged: list[str] = []

    def learn(self, lines: Sequence[Entry]) -> None:
        """Build what lines define; it holds in those before them, too."""
        self.lines = lines
        if self.about is not None:
            return
        defined = {n: d for n, d in definitions(lines, self.naming).items() if n not in self.words}
        self.own = defined
        own = {id(line) for name, line in defined.items() if name not in ENERGY_NAMES}
        self.claims = any(isinstance(line, Line) and id(line) not in own for line in lines)
        if defined:
            self.reached = reached(lines, defined, self.needed, self._plainly_held)
        for name in in_order(defined):
            line = defined[name]
            try:
                self.learnt[id(line)] = self._learn(name, line)
            except Refused as reason:
                self.learnt[id(line)] = reason

    def _plainly_held(self, sides: Sequence[Node]) -> list[str]:
        """Names that an equation holds without definitions; all of them where it is too large."""
        self.looked += sum(weight(side, {}).amount for side in sides)
        if self.looked > LARGEST_WEIGHT:
            return [name.name for side in sides for name in names(side)]
        return held(Builder(self.naming, {}, {}), sides)

    def _learn(self, name: str, line: Line) -> tuple[tuple[Value, ...], Builder]:
        size = self._weighed(line)
        builder = self._builder()
        sides, first = known_first(builder, line)
        self.weights[name] = size
        self.defined[name], self.trees[name] = sides[0], first
        self.vague[name] = [n for n in dict.fromkeys(builder.unknown) if holds(sides[0], n)]
        self.demanded[name] = list(dict.fromkeys(builder.demands))
        return sides, builder

    def _builder(self) -> Builder:
        return Builder(self.naming, self.defined, self.vague, self.trees, self.demanded)

    def add(self, line: Entry) -> None:
        """Take one line."""
        number, _ = line_and_column(self.text, line.at)
        if isinstance(line, Aside):
            self.remarks.append(f"line {number}: {line.words}")
            return
        if isinstance(line, Line):
            self.unjudged += line.unjudged
        place = f"{self.origin}, line {number}"
        tag = line.tag or str(len(self.statements) + 1)
        try:
            if isinstance(line, Unread):
                raise Refused(line.where, line.words)
            self._line(line, tag, place)
        except Refused as reason:
            doubt = located(self.text, reason.at, reason.words, self.origin)
            notes = line.notes if isinstance(line, Line) else ()
            self._append(Statement(None, line.source, tag, place, notes, doubt), line.at)

    def _line(self, line: Line, tag: str, place: str) -> None:
        left, learnt = line.sides[0], self.learnt.get(id(line))
        if isinstance(learnt, Refused):
            raise learnt
        if learnt is not None and isinstance(left, Name):
            self._define(line, left.name, *learnt, tag, place)
            return
        self._weighed(line)
        builder = self._builder()
        sides = tuple(builder(side) for side in line.sides)
        letter = None
        if self.about is None:
            letter = letter_on_left(self.naming, self.words, left, sides[1:])
        if letter is not None and (letter.said or moves_a_constant(self.naming, letter)):
            builder.unknown = [name for name in builder.unknown if not is_named(left, name)]
            self._letter(line, tag, place, letter, sides[1:], builder)
            return
        free = self.about == "mass matrix" or _is_other_letter(left, self.naming)
        if self.about is not None and free and defines(line, self.naming):
            builder.unknown = [name for name in builder.unknown if not is_named(left, name)]
            sides = sides[1:]
        if any(isinstance(side, MatrixBase) for side in sides):
            self._matrices(line, tag, place, sides, builder)
            return
        if letter is not None and (said := said_of(self.text, letter.name)):
            letter = replace(letter, said=said)
        self._scalars(line, tag, place, sides, builder, letter)

    def _weighed(self, line: Line) -> Weight:
        """What the sides of a line come to, if it is little enough to be built and judged."""
        applied_alike(line.sides, self.own)
        sides = [weight(side, self.weights) for side in line.sides]
        self.weight += sum(side.amount for side in sides)
        if self.weight > LARGEST_WEIGHT:
            raise Refused(line.at, "too large with the definitions and derivatives put in")
        if max(side.depth for side in sides) > DEEPEST:
            words = f"nested too deeply with the definitions put in: {DEEPEST} levels are the limit"
            raise Refused(line.at, words)
        return max(sides, key=lambda side: side.amount)

    def _letter(
        self, line: Line, tag: str, place: str, letter: Letter, sides: tuple[Value, ...],
        builder: Builder,
    ) -> None:  # fmt: skip
        """A name that may mean several things, first of all what is said or of rank 1."""
        if not letter.said:
            letter = replace(letter, said=said_of(self.text, letter.name))
        words = letter.said or LETTERS[letter.name][0][0]
        if words in UP_TO_A_CONSTANT and (free := _free_constant(builder.unknown, sides)):
            builder.unknown = []
            sides = tuple(side.subs(free, 0) for side in sides)
            letter = replace(letter, sides=tuple(map(self.scene.pressed, sides)))
            line = replace(line, notes=(*line.notes, f"{free} is a constant"))
        self._keep(line, tag, place, named_quantity(words), sides, builder, letter=letter)

    def _define(
        self, line: Line, name: str, sides: tuple[Value, ...], builder: Builder, tag: str,
        place: str,
    ) -> None:  # fmt: skip
        """A definition: it is judged where it is used, or is an energy or the mass matrix."""
        letter = letter_on_left(self.naming, {}, line.sides[0], sides)
        if letter is not None and name in ENERGY_NAMES and name not in self.needed:
            self._letter(line, tag, place, letter, sides, builder)
            return
        size = len(self.scene.u)
        unused = name not in self.reached
        if letter is None and unused and scalar(sides) and (said := said_of(self.text, name)):
            letter = Letter(name, tuple(map(self.scene.pressed, sides)), said)
            self._letter(line, tag, place, letter, sides, builder)
            return
        if letter is not None and unused and name not in self.needed:
            self._letter(line, tag, place, letter, sides, builder)
            return
        if unused and name in MATRIX_NAMES and all(shape(s) == (size, size) for s in sides):
            note = f"{name}, a square matrix, is read as the mass matrix"
            self._keep(line, tag, place, MassMatrix(), sides, builder, note)
            return
        before, moves = len(self.statements), False
        if len(sides) > 1:
            # The other sides have to be equal; where these move, the name says nothing more.
            noted = replace(line, notes=(*line.notes, f"{name} as defined"))
            judge = self._scalars if scalar(sides) else self._matrices
            judge(noted, tag, place, sides, builder)
            rows = [found.row for found in self.statements[before:] if found.row is not None]
            moves = any(not isinstance(row.quantity, Identity) for row in rows)
        short = all(isinstance(side, Call) and side.function in SHORT for side in line.sides[1:])
        if not unused or moves or gathers(line.sides[1:]) or short:
            self._meant(line, name, sides, builder, tag, place, letter)
            self.remarks.append(f"{name} is taken as defined by: {line.source}")
            return
        if len(sides) == 1 and (body := body_at(self.scene, sides[0])):
            self.remarks.append(f"{name} is a coordinate of {body} or its rate: {line.source}")
            return
        inline = IN_PROSE.search(self.text[max(0, line.at - 8) : line.at])
        if inline and scalar(sides) and (what := as_scene_has(self.scene, sides[0])):
            self.remarks.append(f"{name} is {what}: {line.source}")
            return
        if self.claims and letter is None and _names_a_rate(line):
            self.remarks.append(f"{name} is taken as defined by: {line.source}")
            return
        if self.claims and scalar(sides) and self._is_abbreviation(line, name, sides[0]):
            self.unjudged.append(line.source)
            return
        doubt = f"{name} is defined and never used, so it is NOT checked: say what it means"
        tag = line.tag or str(len(self.statements) + 1)
        value = () if isinstance(sides[0], MatrixBase) else (self.scene.pressed(sides[0]),)
        row = published(tag, Identity(), Symbol(name, real=True), *value, label=line.source)
        written = self._written(line)
        self._append(Statement(row, line.source, tag, place, line.notes, doubt, written), line.at)

    def _meant(
        self, line: Line, name: str, sides: tuple[Value, ...], builder: Builder, tag: str,
        place: str, letter: Letter | None,
    ) -> None:  # fmt: skip
        """A definition by a name with a meaning in the scene: what it says is a claim, too.

        A body has a momentum as well, and rows may have another unit; only that of an angle has
        one meaning.
        """
        before = len(self.statements)
        moving = {*self.scene.u, *self.scene.qd}
        if not scalar(sides):
            return
        moves = any(self.scene.plain(side).free_symbols & moving for side in sides)
        meant = self.naming.momentum(name) if moves else None
        ranks = {word for rank in LETTERS.get(name, ()) for word in rank}
        if meant is not None and momentum_of_body(self.scene, sides[0]):
            return
        plain = is_coefficient(name, line, self.lines, self.naming)
        angle = False
        if meant is not None and meant[1] == 0:
            momentum = self.naming.vocabulary.momenta[meant[0]]
            self._scalars(line, tag, place, (momentum, sides[0]), builder)
            turning = {f"p_{q.name}" for q in angular(self.scene)}
            angle = self.naming.vocabulary.momentum(name) is not None and meant[0] in turning
        elif letter is not None and moves and "momentum" in ranks:
            self._letter(line, tag, place, replace(letter, said="momentum"), sides, builder)
        elif letter is not None and ranks & ENTRIES.keys() and not plain:
            self._letter(line, tag, place, letter, sides, builder)
        unsure = () if angle else (f"{name} has another meaning here: say which",)
        self.statements[before:] = [
            replace(s, unsure=(*s.unsure, *unsure), defines=name) for s in self.statements[before:]
        ]

    def _is_abbreviation(self, line: Line, name: str, meaning: Expr) -> bool:
        """Whether the text says that a name is short for something given, and it names no result.

        An input may have another name, u, which is that of no quantity.
        """
        start = " ".join(self.text[max(0, line.at - 60) : line.at].split())
        number, rest = self.scene.plain(meaning).as_coeff_Mul()
        before = self.text[max(0, line.at - 8) : line.at]
        given = {*self.scene.parameters}
        if CONTROL.fullmatch(name) and self.scene.plain(meaning) in self.scene.input_symbols:
            given |= {*self.scene.input_symbols}
        multiple = number.is_Rational and rest in given and IN_PROSE.search(before)
        said = multiple or SAID.search(start) or DEFINING.search(line.source)
        held = self.scene.plain(meaning).free_symbols - {*given, TIME}
        return bool(said) and not held and name not in LETTERS and name not in MATRIX_NAMES

    def _matrices(
        self, line: Line, tag: str, place: str, sides: tuple[Value, ...], builder: Builder
    ) -> None:
        """A matrix alone is the mass matrix; an equation of matrices is one for each entry."""
        shapes = {side.shape for side in sides if isinstance(side, MatrixBase)}
        if len(shapes) > 1 or any(s != 0 for s in sides if not isinstance(s, MatrixBase)):
            raise Refused(line.at, "the sides are matrices of different shapes")
        rows, columns = shapes.pop()
        if len(sides) == 1 and self.about is None and rows == columns > 1:
            note = "a square matrix alone is read as the mass matrix"
            self._keep(line, tag, place, MassMatrix(), sides, builder, note)
            return
        if self.about is not None:
            quantity = named_quantity(self.about)
            if isinstance(quantity, MassMatrix):
                self._keep(line, tag, place, quantity, sides, builder)
                return
        for number, parts in entries(sides):
            self._scalars(line, f"{tag} row {number}", place, parts, builder)

    def _scalars(
        self, line: Line, tag: str, place: str, sides: tuple[Expr, ...], builder: Builder,
        letter: Letter | None = None,
    ) -> None:  # fmt: skip
        if self.about is not None:
            self._asked(line, tag, place, sides, builder)
            return
        momenta = self.naming.vocabulary.momenta
        every = [n.name for side in line.sides for n in names(side)]
        if every and all(name in momenta for name in every) and len({*sides}) == 1:
            self.remarks.append(
                f"{line.source[:60]}: Lagrange's equations, which hold in any scene"
            )
            return
        alike = all(isinstance(n, Name) for n in line.sides) and len({*sides}) == 1
        quantity, sides, note = kind_of(self.scene, distinct(sides))
        if alike and isinstance(quantity, EquationOfMotion):
            self.remarks.append(f"{line.source[:60]}: the same by definition")
            return
        self._keep(line, tag, place, quantity, sides, builder, note, letter)

    def _asked(
        self, line: Line, tag: str, place: str, sides: tuple[Expr, ...], builder: Builder
    ) -> None:
        quantity = named_quantity(self.about or "")
        if not isinstance(quantity, EquationOfMotion | Identity) and len(sides) > 1:
            sides = sides[1:] if isinstance(line.sides[0], Name) else sides
        self._keep(line, tag, place, quantity, as_asked(quantity, sides), builder)

    def _keep(
        self, line: Line, tag: str, place: str, quantity: Quantity, sides: tuple[Value, ...],
        builder: Builder, note: str = "", letter: Letter | None = None,
    ) -> None:  # fmt: skip
        doubt = ""
        if builder.unknown:
            told = [(n, self.naming.unread_at(n)) for n in builder.unknown]
            where = [f"{n} is in {at}" for n, at in dict.fromkeys(told) if at]
            doubt = unexplained(self.scene, builder.unknown)
            doubt = f"{', '.join(where)}, which is not read: say what it means" if where else doubt
        elif isinstance(quantity, Identity) and len(sides) == 1 and letter is None:
            doubt = "an expression without an equals sign: say what it is about"
        notes = (*line.notes, note) if note else line.notes
        row = published(tag, quantity, *map(self.scene.pressed, sides), label=line.source)
        written = self._written(line)
        demands = Demands(tuple(dict.fromkeys(builder.demands)))
        found = Statement(
            row, line.source, tag, place, notes, doubt, written, line.others, demands, letter
        )
        self._append(found, line.at)

    def _written(self, line: Line) -> Written:
        trees = tuple(self.trees.items())
        return Written(line.sides, trees, self.naming, self.notation, self.text, line.at)

    def _append(self, found: Statement, at: int) -> None:
        if len(self.statements) >= MOST_STATEMENTS:
            words = f"more than {MOST_STATEMENTS} statements: split them"
            raise InputError(located(self.text, at, words, self.origin))
        self.statements.append(found)
