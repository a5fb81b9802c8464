"""What a function of code returns, as statements, with what else it may be and what doubts it."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from sympy import Expr

from mechanics.claims.about import QUANTITIES
from mechanics.claims.assemble import Reading
from mechanics.claims.code.arguments import (
    Arguments,
    entries_of,
    places_of_vectors,
    state_is_stated,
)
from mechanics.claims.code.code_function import CodeFunction
from mechanics.claims.code.energy_names import named_by_title, refuse_energy_of_a_part
from mechanics.claims.code.function_names import spoken
from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.named_numbers import named_numbers
from mechanics.claims.code.output_names import listed_otherwise, unknown_words
from mechanics.claims.code.outputs import (
    Claim,
    claims,
    in_order_of,
    is_settled,
    manipulator,
    state_of_scalars,
    statement,
    taken_otherwise,
)
from mechanics.claims.code.qualified_names import another_quantity_word, unknown_qualifiers
from mechanics.claims.code.state_permutations import arguments_and_outputs, in_other_orders
from mechanics.claims.code.trace.assignments import names_used
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.names import Match, Naming
from mechanics.claims.scaled_names import unit_at_end
from mechanics.claims.state_order import comments_of
from mechanics.claims.statement import Letter
from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.quantities import MassMatrix

PART = re.compile(r"grav|coriol|centri|friction|damping", re.IGNORECASE)
"""In the name of a function that returns a part of what drives."""


@dataclass(frozen=True)
class Meaning:
    """What outputs are taken for.

    Attributes
    ----------
    outputs : Outputs
    naming : Naming
        With what arguments are.
    about : str, optional
        What the person, or the name of the function, says that they are.
    passed : tuple of Expr
        All that is an argument.
    claims : list of Claim
    others : list of tuple of str and list of Claim
        What else they may be, in words.
    letter : Letter, optional
        For a number that is looked for in the scene.
    """

    outputs: Outputs
    naming: Naming
    about: str | None
    passed: tuple[Expr, ...]
    claims: list[Claim]
    others: list[tuple[str, list[Claim]]]
    letter: Letter | None


def read_outputs(code: CodeFunction, about: str | None = None) -> Reading:
    """Statements of a function; comments of its file count.

    Parameters
    ----------
    code : CodeFunction
    about : str, optional
        What it returns, as the person says.

    Raises
    ------
    InputError
        When an argument or an output is unexplained, or the code hides a formula.
    """
    scene, title = code.scene, code.title
    arguments, outputs = arguments_and_outputs(code)
    if about is None and len(outputs.entries) == 1:
        refuse_energy_of_a_part(scene, title)
    meaning = _meaning(code, arguments, outputs, about)
    outputs, others = meaning.outputs, meaning.others
    unsure = _unsure(scene, title, meaning)
    if others and unknown_words(scene, outputs.names):
        others = []
        unsure += (f"{', '.join(outputs.names)} are in another order: say what {title} returns",)
    parts = meaning.about is None and bool(manipulator(scene, outputs))
    mass = ("mass matrix", MassMatrix(), (outputs.values[0],)) if parts else None
    comments = comments_of(code.text)
    doubt = _doubt_of_words(meaning, title, comments)
    doubt = doubt or _doubt_of_unit(title, meaning.outputs)
    if not doubt and about is None and (otherwise := another_quantity_word(scene, title)):
        doubt = f"the name {title} says {otherwise!r}: say what it returns, --about (about=)"
    statements = []
    for k, claim in enumerate(meaning.claims):
        taken = [(words, other[k]) for words, other in others]
        one = statement(claim, title, outputs, meaning.naming, taken, unsure, mass, meaning.letter)
        statements.append(replace(one, doubt=one.doubt or doubt, comments=comments))
    unknown = unknown_qualifiers(scene, title) if about is None else ()
    quoted = tuple(f"the word {word} in the name {title}" for word in unknown)
    return Reading(tuple(statements), arguments.matches, (), quoted)


def _meaning(
    code: CodeFunction, arguments: Arguments, outputs: Outputs, about: str | None
) -> Meaning:
    scene, title, naming = code.scene, code.title, code.naming
    state = arguments.state or state_of_scalars(scene, outputs.values, arguments.values.values())
    passed = [entry for value in arguments.values.values() for entry in entries_of(value)]
    passed += [STEP] if any(entry.has(STEP) for entry in outputs.entries) else []
    about = about or named_by_title(title, len(outputs.entries), len(scene.u))
    by_order = about is None or about in QUANTITIES  # else it names them in the code's order
    places = places_of_vectors(scene, arguments) if by_order and not state else ()
    outputs = in_order_of(outputs, places) if places else outputs
    named, letter = named_numbers(naming, outputs, about, title, passed)
    meant = named or claims(naming, outputs, state, about, title, passed)
    naming = replace(naming, guessed=(*naming.guessed, *_renamed(naming, arguments.matches)))
    others = [] if places or named else taken_otherwise(naming, outputs, meant, about, title)
    meaning = Meaning(outputs, naming, about, tuple(passed), meant, others, letter)
    guessed = arguments.state and not state_is_stated(arguments)
    if letter is None and guessed and len(outputs.entries) < len(arguments.state):
        others = [*others, *_of_other_states(code, arguments, meaning)]
    return replace(meaning, others=others)


def _of_other_states(
    code: CodeFunction, guess: Arguments, meaning: Meaning
) -> list[tuple[str, list[Claim]]]:
    """The claims where the state that is an argument has another usual order."""
    about, title, passed = meaning.about, code.title, meaning.passed
    found: list[tuple[str, list[Claim]]] = []
    for words, (arguments, outputs) in in_other_orders(replace(code, naming=meaning.naming), guess):
        try:
            other, _ = named_numbers(meaning.naming, outputs, about, title, passed)
            state = arguments.state
            other = other or claims(meaning.naming, outputs, state, about, title, passed)
        except InputError:
            continue
        found += [(words, other)] if len(other) == len(meaning.claims) else []
    return found


def _renamed(naming: Naming, matches: Iterable[Match]) -> list[Match]:
    """Arguments that are one thing of the scene, under another name: formulas are told with it."""
    return [m for m in matches if m.name != m.meaning and naming.vocabulary.target(m.meaning)]


def _doubt_of_words(meaning: Meaning, title: str, comments: str) -> str:
    """How the name of a function, or a comment, lists its outputs otherwise; empty if neither."""
    quantities = [sides[0] for _, _, sides in meaning.claims]
    taken = ", ".join(map(str, quantities))
    ways = ((title.replace("_", ", "), f"the name {title}"), (comments, "a comment"))
    for text, what in ways:
        names = meaning.outputs.names
        if listed := listed_otherwise(meaning.naming, names, quantities, text):
            said = "" if what.endswith(title) else f" {listed!r},"
            return (
                f"{what} says{said} another order than that in which {title} returns {taken}:"
                " say which, --about (about=)"
            )
    return ""


def _doubt_of_unit(title: str, outputs: Outputs) -> str:
    """That a name of the code ends with a unit that no scene counts in; empty if none does."""
    names = (title, *outputs.names, *sorted(names_used(outputs.formulas)))
    for name, unit in ((name, unit_at_end(name)) for name in names):
        if unit:
            return f"the name {name} says {unit!r}, in which no scene counts: rename what is in SI"
    return ""


def _unsure(scene: Scene, title: str, meaning: Meaning) -> tuple[str, ...]:
    """Under what else outputs may be right that are taken for accelerations."""
    about = meaning.about
    if about is None and manipulator(scene, meaning.outputs):
        if is_settled(scene):
            return ()
        return (f"the parts that {title} returns are put together otherwise than M u' + C + G",)
    moving = {*scene.u, *scene.ud, *scene.input_symbols, *momentum_symbols(scene)}
    if about or [sides[0] for _, _, sides in meaning.claims] != [*scene.ud]:
        return ()
    if len(scene.u) > 1 and not {*meaning.passed} & moving:
        return (f"{title}, which takes neither speeds nor inputs, returns no accelerations",)
    name = title if len(scene.u) > 1 else spoken(title).rpartition(" ")[2]
    return (f"{title} returns a part of the forces",) if PART.search(name) else ()
