"""A function of code: its arguments, what they are, and what it returns for them."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from sympy import Expr

from mechanics.claims.about import WORDS
from mechanics.claims.code.arguments import (
    Arguments,
    arguments_of,
    named_entries,
    vectors_of_motion,
)
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.code.unpacking import Apart
from mechanics.claims.guess import at_one_step, guess
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.state_order import state_order
from mechanics.claims.tree import Name
from mechanics.scene import Scene

Run = Callable[[Arguments], Outputs]


@dataclass(frozen=True)
class CodeFunction:
    """What is called, with what is known of its arguments.

    Attributes
    ----------
    naming : Naming
    title : str
    names : tuple of str
        Of its arguments.
    sizes : mapping of str to int
        Numbers of entries of arguments; None where the code does not say.
    run : callable
        What it returns for arguments.
    meanings : mapping of str to str
        What arguments are, as the person or the text says.
    parts : mapping of str to Apart
        Of arguments that the code takes apart.
    text : str
        Of its file.
    """

    naming: Naming
    title: str
    names: tuple[str, ...]
    sizes: Mapping[str, int | None]
    run: Run
    meanings: Mapping[str, str]
    parts: Mapping[str, Apart]
    text: str

    @property
    def scene(self) -> Scene:
        """What it is read for."""
        return self.naming.vocabulary.scene

    def arguments(self, meanings: Mapping[str, str] | None = None) -> Arguments:
        """Symbols for all arguments, of which some mean what is given here.

        Raises
        ------
        InputError
            For those that are unexplained.
        """
        meanings = {**self.meanings, **(meanings or {})}
        return arguments_of(self.naming, self.names, self.sizes, meanings, apart=self.parts)


def code_function(
    scene: Scene, title: str, wanted: Sequence[str], sizes: Mapping[str, int | None], run: Run,
    names: Mapping[str, str] | None = None, apart: Mapping[str, Apart] | None = None,
    text: str = "", standing: Iterable[Expr] = (),
) -> CodeFunction:  # fmt: skip
    """A function with the meanings of its arguments that its text and its names say.

    Parameters
    ----------
    sizes : mapping of str to int
        Numbers of entries, of the arguments where they are known.
    names : mapping of str to str, optional
        What arguments are, by the person.
    text : str
        Of its file.
    standing : iterable of Expr
        What numbers of the code stand for: a number that stands for a parameter leaves it to no
        other name.
    """
    apart = {n: a for n, a in (apart or {}).items() if n in wanted}
    given = {n: m for n, m in (names or {}).items() if m not in WORDS}
    naming = Naming(Vocabulary(scene))
    for name, known in apart.items():
        if known.vector and not named_entries(naming, name, known):
            for place, entry in enumerate(state_order(text, name, naming)):
                known.places[place] = {entry}
    for name in wanted:  # a vector that the code uses as a whole
        if not (name in given or name in apart or naming.knows(name) or sizes.get(name) == 1):
            given |= {name: " ".join(order)} if (order := state_order(text, name, naming)) else {}
    sizes = {n: sizes.get(n) or (apart[n].size if n in apart else None) for n in wanted}
    parted = {n for n, known in apart.items() if known.vector}
    parted |= vectors_of_motion(naming, [n for n in wanted if sizes[n] is None])
    scalars = [n for n in wanted if n not in given and sizes[n] in (None, 1) and n not in parted]
    open_names = [Name(0, n) for n in scalars if n not in STEPS]
    open_names += [Name(0, str(s)) for e in standing for s in sorted(e.free_symbols, key=str)]
    stepped = at_one_step(naming, scalars)
    naming = replace(naming, guessed=stepped)
    naming = replace(naming, guessed=(*stepped, *guess(naming, open_names, ())))
    return CodeFunction(naming, title, tuple(wanted), sizes, run, given, apart, text)
