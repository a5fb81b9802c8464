"""Brackets of a text that has no syntax tree yet.

depth     how many are open                    f(a, {b|, c})     2
closing   where the one that opens here ends   f(a, {b, c})|
pieces    what separators outside of them cut  a, f(b, c), d     a   f(b, c)   d

Text in which brackets do not match is cut at depth 0 only, as if more had been opened or closed.
"""

from collections.abc import Iterator


def depth(text: str, at: int, opens: str = "{", closes: str = "}") -> int:
    """How many brackets are open at a place."""
    return sum(text.count(c, 0, at) for c in opens) - sum(text.count(c, 0, at) for c in closes)


def closing(text: str, at: int, pair: str = "{}") -> int:
    """The place behind the bracket that closes the one that opens here; else the text's end."""
    level = 0
    for place in range(at, len(text)):
        level += (text[place] == pair[0]) - (text[place] == pair[1])
        if level == 0:
            return place + 1
    return len(text)


def pieces(
    text: str, separators: str, opens: str = "([", closes: str = ")]"
) -> Iterator[tuple[int, str]]:
    """What stands between separators outside of brackets, each with its place.

    Parameters
    ----------
    text : str
    separators : str
        Characters, each of which is one.
    opens, closes : str
        Characters, brackets of several kinds.
    """
    level = start = 0
    for place, character in enumerate(text):
        level += (character in opens) - (character in closes)
        if level == 0 and character in separators:
            yield start, text[start:place]
            start = place + 1
    yield start, text[start:]
