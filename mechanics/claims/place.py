"""Places in a text, and the one line that says what could not be read there.

file pendulum.tex, line 3, column 14: ...
"""

from mechanics.errors import InputError

LARGEST_TEXT = 100_000
"""Characters of a document with its prose; a page has three thousand."""

LARGEST_MATHEMATICS = 15_000
"""Characters of equations: what is parsed within two seconds."""


class Refused(Exception):
    """Something in a text cannot be read; `at` is where, in characters from its beginning."""

    def __init__(self, at: int, words: str) -> None:
        super().__init__(words)
        self.at, self.words = at, words


def line_and_column(text: str, at: int) -> tuple[int, int]:
    """Line and column, from one, of a place in a text."""
    at = max(0, min(at, len(text)))
    return text.count("\n", 0, at) + 1, at - (text.rfind("\n", 0, at) + 1) + 1


def located(text: str, at: int, words: str, origin: str) -> str:
    """One line that says where something is, and what."""
    line, column = line_and_column(text, at)
    return f"{origin}, line {line}, column {column}: {words}"


def refusal(text: str, reason: Refused, origin: str) -> InputError:
    """The error of a text that cannot be read."""
    return InputError(located(text, reason.at, reason.words, origin))


def bounded_mathematics(length: int, at: int) -> None:
    """Refuse more equations than can be parsed at once.

    Raises
    ------
    Refused
        Naming the limit.
    """
    if length > LARGEST_MATHEMATICS:
        raise Refused(
            at,
            f"{length} characters of equations: {LARGEST_MATHEMATICS} are the limit: split them",
        )


def bounded(text: str, origin: str) -> str:
    """The text, if it is short enough to be read.

    Raises
    ------
    InputError
        When it has more than `LARGEST_TEXT` characters.
    """
    if len(text) > LARGEST_TEXT:
        raise InputError(
            f"{origin}, line 1, column 1: {len(text)} characters: {LARGEST_TEXT} are the limit:"
            " cut out the equations"
        )
    return text
