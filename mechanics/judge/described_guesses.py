"""Names that are guessed, though words beside the code say what they are.

a = Symbol("a")  # twice the length: a = 2*L        a is not the length L, the only one that is left
"""

from collections.abc import Iterator, Sequence

from mechanics.claims.guess import REASONS
from mechanics.claims.names import Match
from mechanics.claims.spelled_rates import key
from mechanics.claims.unread_names import assigned_names, described_names
from mechanics.judge.sources import Source


def described_guesses(known: Sequence[Match], sources: Sequence[Source]) -> Iterator[str]:
    """What is to be said of guesses that comments and documentation may contradict.

    Parameters
    ----------
    known : sequence of Match
        What names were taken for.
    sources : sequence of Source
        The code, and words beside it.
    """
    guesses = {key(match.name): match for match in known if match.why in REASONS}
    if not guesses:
        return
    for line in (line for one in sources for words in one.words() for line in words.splitlines()):
        for name in guesses.keys() & {*assigned_names(line), *(described_names(line) or ())}:
            match = guesses[name]
            yield (
                f"{match.name} is read as {match.meaning}, and {' '.join(line.split())[:60]!r} says"
                f" what it is: --name {match.name}=... says so"
            )
