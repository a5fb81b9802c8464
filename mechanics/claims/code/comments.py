"""Words in code: comments, documentation and strings, of all languages by one table.

# only valid for        ->    only valid for small angles
# small angles
dx = 1;  % FIXME        ->    FIXME
"""

import re
from collections.abc import Iterator

QUOTED = r'"(?:\\.|[^"\\\n])*"'
TRIPLE = r'"{3}.*?"{3}|\'{3}.*?\'{3}'
OF_C = rf"//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z)|(?P<string>{QUOTED}|'(?:\\.|[^'\\\n])*')"
OF_PYTHON = rf"#[^\n]*|{TRIPLE}|(?P<string>{QUOTED}|'(?:\\.|[^'\\\n])*')"
OF_JULIA = rf"#=.*?(?:=#|\Z)|#[^\n]*|{TRIPLE}|(?P<string>{QUOTED}|'(?:\\.|[^'\\\n])')"
OF_MATLAB = (
    r"^[ \t]*[%#]\{[ \t]*$.*?(?:^[ \t]*[%#]\}[ \t]*$|\Z)|[%#][^\n]*|\.\.\.[^\n]*"
    r"|(?P<string>\"(?:\"\"|[^\"\n])*\"|(?<![\w)\]}'.])'(?:''|[^'\n])*')"
)
OF_MODELICA = r"//[^\n]*|/\*.*?(?:\*/|\Z)|(?P<string>\"(?:\\.|[^\"\\])*\")"
LANGUAGES = {
    suffix: re.compile(pattern, re.DOTALL | re.MULTILINE)
    for suffixes, pattern in (
        (".py", OF_PYTHON), (".jl", OF_JULIA), (".m", OF_MATLAB),
        (".mo", OF_MODELICA),
        (".c .h .cpp .cc .cxx .hpp .hh .ino", OF_C),
    )
    for suffix in suffixes.split()
}  # fmt: skip
"""Comments, and strings, in which there are none, by the ends of files."""
OPENS = re.compile(r"^[ \t]*(?:/[/*!<]+|\*+(?!/)|[#%][#%={!]*|\.\.\.|['\"]+)[ \t]?", re.MULTILINE)
CLOSES = re.compile(r"[ \t]*(?:\*+/|=#|[#%]\}|['\"]+)[ \t]*$", re.MULTILINE)
"""Marks of comments, which are no words."""
DESCRIBED = ".mo"
"""Whose strings are documentation."""
SENTENCE = re.compile(r"[^\W\d_]{2,}[,;:]?[ ]+[^\W\d_]{2,}")
"""What a string has that is read by people."""
EQUATION = re.compile(
    r"[^\s=<>!:~+*/-][ \t&]*(?:={1,2}|:=|\u2254|\u2248|\u2261|\\(?:approx|simeq|equiv|sim)\b)"
    r"[ \t&]*[-+]?[ \t]*[^\W_]"
    r"|[\w)\]'}][ \t&]*(?:={1,2}|:=|\u2254|\u2248|\u2261)[ \t&]*[-+]?[ \t]*[(\[\\{]"
)
"""What words hold that may be wrong as an equation is."""
GOES_ON = re.compile(r"(?:(?<=[a-z]{2})|(?<=,))[ \t]*\n[ \t]*(?=[a-z])")
"""The end of a line within a sentence."""


def comments(text: str, suffix: str) -> Iterator[str]:
    """What code says in words; comments in successive lines are one.

    Parameters
    ----------
    text : str
    suffix : str
        Of its file.
    """
    if suffix not in LANGUAGES:
        return
    last, block = -1, ""
    for found in LANGUAGES[suffix].finditer(text):
        if found["string"] is not None and suffix != DESCRIBED and not _says(found[0]):
            continue
        if block and text[last : found.start()].strip(" \t") not in ("", "\n"):
            yield GOES_ON.sub(" ", block)
            block = ""
        words = CLOSES.sub("", OPENS.sub("", found[0]))
        block, last = f"{block}\n{words}" if block else words, found.end()
    if block:
        yield GOES_ON.sub(" ", block)


def _says(string: str) -> bool:
    return any(words.search(string) for words in (SENTENCE, EQUATION))


def without_comments(text: str, suffix: str) -> str:
    """Code alone, each line of it in its place."""
    if suffix not in LANGUAGES:
        return text

    def bare(found: re.Match[str]) -> str:
        return found[0] if found["string"] is not None else " " + "\n" * found[0].count("\n")

    return LANGUAGES[suffix].sub(bare, text)
