"""Documents from documents: words are put in, taken out, doubled, exchanged, nested.

M \\ddot{x} + 2 k x = 0    ->    M \\ddot{\\frac{x + 2 k x = 0
"""

import random
from collections.abc import Sequence

from benchmarks.fuzz.words import TOKENS, WORDS

BRACKETS = ((b"(", b")"), (b"{", b"}"), (b"[", b"]"), (b"\\frac{", b"}{2}"), (b"sin(", b")"))


def mutated(data: bytes, notation: str, source: random.Random, seeds: Sequence[bytes]) -> bytes:
    """A document with one to four changes.

    Parameters
    ----------
    seeds : sequence of bytes
        Documents from which parts are taken.
    """
    tokens = TOKENS[notation].findall(data) or [b""]
    for _ in range(source.choice((1, 1, 2, 4))):
        tokens = _changed(tokens, notation, source, seeds) or [b""]
    return b"".join(tokens)


def _changed(
    tokens: list[bytes], notation: str, source: random.Random, seeds: Sequence[bytes]
) -> list[bytes]:
    n = len(tokens)
    i = source.randrange(n)
    j = min(n, i + source.choice((1, 1, 2, 4, 16)))
    part = tokens[i:j]
    words = WORDS[notation]
    match source.randrange(9):
        case 0:
            return [*tokens[:i], *tokens[j:]]
        case 1 | 2:
            return [*tokens[:i], source.choice(words), *tokens[i:]]
        case 3 | 4:
            return [*tokens[:i], source.choice(words), *tokens[i + 1 :]]
        case 5:
            times = source.choice((2, 2, 3, 8, 64, 512))
            return [*tokens[:i], *part * times, *tokens[j:]]
        case 6:
            k = source.randrange(n)
            tokens = list(tokens)
            tokens[i], tokens[k] = tokens[k], tokens[i]
            return tokens
        case 7:
            left, right = source.choice(BRACKETS)
            times = source.choice((1, 1, 1, 2, 50))
            return [*tokens[:i], left * times, *part, right * times, *tokens[j:]]
        case _:
            other = TOKENS[notation].findall(source.choice(seeds)) or [b""]
            k = source.randrange(len(other))
            return [*tokens[:i], *other[k : k + source.choice((1, 4, 16, 64))], *tokens[j:]]
