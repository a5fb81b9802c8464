"""Where an error is in what a person wrote: the line, and what is meant underlined.

    error: joint knee: there is no link 'shnak', its child
     --> leg.urdf:12
      |
    12 |   <child link="shnak"/>
      |                ^^^^^
      |

An error says in words what it is about: a place of JSON, a line, something in quotes, or a thing by
its kind and name. The place is looked for in the command where it is about an option or a name
there, then in the files that the command names, then in the command.
"""

import ast
import json
import re
import shlex
import traceback
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple
from xml.etree.ElementTree import ParseError

WIDTH = 80
QUOTED = re.compile(r"'([^']+)'|\"([^\"]+)\"")
KINDS = (
    "body", "bodies", "joint", "joints", "load", "reaction", "frame", "point", "parameter", "link",
    "coordinate", "speed", "input", "constraint", "condition", "output", "option", "quaternion",
)  # fmt: skip
NAMED = re.compile(rf"\b(?:{'|'.join(KINDS)}) ([\w.-]+)")
PLACE = re.compile(r"\$((?:\.\w+|\[\d+\])*)")
STEP = re.compile(r"\.(\w+)|\[(\d+)\]")
OPTION = re.compile(r"--[a-z][a-z-]*")
ASSIGNED = re.compile(r"\b([A-Za-z_]\w*) = ")
FILE = re.compile(r"(?:file|folder) ([^\s:]+)")
ITS = re.compile(r"\bits (\w+)")
LINE = re.compile(r"\bline\W{1,3}(\d+)")
MORE = re.compile(r"did you mean|the \w+ are|: write |: give |: choose |for example")
"""What follows is what might be written instead."""


class Place(NamedTuple):
    """Part of a text: its offsets, and the file that has it, if one does."""

    text: str
    start: int
    end: int
    file: Path | None = None


def excerpt(error: BaseException, words: str, arguments: Sequence[str]) -> str:
    """The lines that show where an error is, or nothing where that is not known.

    Parameters
    ----------
    words : str
        What it says.
    arguments : sequence of str
        Of the command, without the name of the program.
    """
    command = shlex.join(["mechanics", *arguments])
    files = list(_files(arguments))
    if _on_the_command_line(error, words, arguments, files):
        folder = FILE.match(words)
        if span := _argument(command, folder[0] if folder else words):
            return _shown(Place(command, *span))
    for file in files:
        text = file.read_text(encoding="utf-8", errors="replace")
        reader = READERS.get(file.suffix.lower())
        span = None if reader is None else reader(text, error, words, file)
        if span is not None:
            return _shown(Place(text, *span, file))
    span = _argument(command, words)
    return "" if span is None else _shown(Place(command, *span))


C_PLACE = re.compile(r"(\S+\.[ch]):(\d+):(\d+)")
C_OUTPUT = re.compile(r"(\S+\.[ch]): (\w+) = .*?: (\w+\[\d+\])")


def excerpt_of_c(words: str, texts: Mapping[str, str]) -> str:
    """The line of C that a finding names, or that sets the output of the function it names.

    Parameters
    ----------
    words : str
        Its subject and its evidence.
    texts : mapping of str to str
        Texts by the names of their files.
    """
    if (place := C_PLACE.search(words)) and place[1] in texts:
        start = _offset(texts[place[1]], int(place[2]), int(place[3]) - 1)
        return _shown(Place(texts[place[1]], start, start + 1, Path(place[1])))
    if (output := C_OUTPUT.search(words)) and output[1] in texts:
        text = texts[output[1]]
        body = re.search(rf"\b{output[2]}\([^;{{]*\{{", text)
        begins = text.find(f"{output[3]} = ", body.end()) if body else -1
        if begins >= 0:
            return _shown(Place(text, begins, begins + len(output[3]), Path(output[1])))
    return ""


def _files(arguments: Sequence[str]) -> Iterator[Path]:
    """Files that arguments name, also as ``a.py:function`` or ``--scene=a.py``."""
    for argument in arguments:
        plain = argument.rpartition("=")[2] if argument.startswith("-") else argument
        for name in dict.fromkeys((plain, plain.rpartition(":")[0])):
            # A text of many lines is no name of a file, and too long for the system to ask.
            if name and len(name) < 1000 and "\0" not in name and Path(name).is_file():
                yield Path(name)
                break


def _on_the_command_line(
    error: BaseException, words: str, arguments: Sequence[str], files: Sequence[Path]
) -> bool:
    """Whether the words are about an option, a folder or a name of the command itself."""
    own = {str(file) for file in files}
    frames = (f for cause in _causes(error) for f in traceback.extract_tb(cause.__traceback__))
    if any(frame.filename in own for frame in frames):
        return False
    told = _told(words)
    if OPTION.match(told):
        return True
    if (named := FILE.match(told)) and named[1] not in own:
        return named[1] in arguments
    entries = {entry.partition("=")[0] for entry in arguments if not entry.startswith("-")}
    entries |= {entry.split("=")[1] for entry in arguments if re.match("--[a-z-]+=.*=", entry)}
    things = (match[1] for kind in (NAMED, ASSIGNED) for match in kind.finditer(told))
    names = [*_quoted(words), *things]
    return any(name in entries and name not in own for name in names)


Span = tuple[int, int] | None


def _python(text: str, error: BaseException, words: str, file: Path) -> Span:
    """Where the person's code raised, else where it declares what the error names."""
    for cause in _causes(error):
        if isinstance(cause, SyntaxError) and cause.lineno and cause.offset:
            start = _offset(text, cause.lineno, cause.offset - 1)
            ends = cause.end_offset if cause.end_lineno == cause.lineno else None
            return start, _offset(text, cause.lineno, (ends or 0) - 1)
        own = [f for f in traceback.extract_tb(cause.__traceback__) if f.filename == str(file)]
        if own and own[-1].lineno:
            frame = _of_frame(text, own[-1])
            return _declared(text, list(_quoted(words)), frame) or frame
    return _declared(text, list(_names(words)), (0, len(text)))


def _declared(text: str, names: Sequence[str], within: tuple[int, int]) -> Span:
    """The first name that stands in a string of a part of Python code."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError):
        return None
    constants = [node for node in ast.walk(tree) if isinstance(node, ast.Constant)]
    strings = [(node, node.value) for node in constants if isinstance(node.value, str)]
    for name in names:
        for node, string in strings:
            start = _offset(text, node.lineno, 0)
            begins = text.find(name, start + _columns(text, start, node.col_offset))
            if name in (string, *string.split()) and within[0] <= begins < within[1]:
                return begins, begins + len(name)
    return None


def _of_frame(text: str, frame: traceback.FrameSummary) -> tuple[int, int]:
    first = _offset(text, frame.lineno or 1, 0)
    last = _offset(text, frame.end_lineno or frame.lineno or 1, 0)
    begins = first + _columns(text, first, frame.colno or 0)
    return begins, max(begins + 1, last + _columns(text, last, frame.end_colno or 0))


def _columns(text: str, start: int, size: int) -> int:
    """Characters in so many bytes of the line that starts there."""
    return len(text[start:].partition("\n")[0].encode()[:size].decode(errors="ignore"))


def _json(text: str, error: BaseException, words: str, file: Path) -> Span:
    """The value at the place that the error names, ``$.bodies[0].mass``."""
    for cause in _causes(error):
        if isinstance(cause, json.JSONDecodeError):
            return cause.pos, cause.pos + 1
    place = PLACE.search(words)
    if place is None:
        return _first(text, [f'"{name}"' for name in _names(words)])
    steps = [key or int(index) for key, index in STEP.findall(place[1])]
    start, end = _value(text, _space(text, 0), steps)
    quoted = [f'"{name}"' for name in _quoted(words)]
    return _first(text[:end], quoted, start) or (start, end)


def _value(text: str, start: int, steps: Sequence[str | int]) -> tuple[int, int]:
    """Offsets of a value of JSON; of the last one on the way that is there."""
    _, end = json.JSONDecoder(strict=False).raw_decode(text, start)
    if not steps or text[start] not in "{[":
        return start, end
    for key, place in _entries(text, start):
        if key == steps[0]:
            return _value(text, place, steps[1:])
    return start, start + 1


def _entries(text: str, start: int) -> Iterator[tuple[str | int, int]]:
    """Keys or numbers of the entries of an object or a list, and where their values start."""
    place, count = _space(text, start + 1), 0
    while text[place] not in "}]":
        key: str | int = count
        if text[start] == "{":
            key, place = json.JSONDecoder(strict=False).raw_decode(text, place)
            place = _space(text, _space(text, place) + 1)
        yield key, place
        _, place = json.JSONDecoder(strict=False).raw_decode(text, place)
        place = _space(text, place)
        place = _space(text, place + 1) if text[place] == "," else place
        count += 1


def _space(text: str, place: int) -> int:
    while text[place : place + 1].isspace():
        place += 1
    return place


def _xml(text: str, error: BaseException, words: str, file: Path) -> Span:
    """The element that the error names, in it what it quotes."""
    for cause in _causes(error):
        if isinstance(cause, ParseError):
            line, column = cause.position
            return _offset(text, line, column), _offset(text, line, column) + 1
    if told := LINE.search(words):
        start = _offset(text, int(told[1]), 0)
        line_text = text[start:].partition("\n")[0]
        begins, ends = start + len(line_text) - len(line_text.lstrip()), start + len(line_text)
        # MuJoCo quotes what is wrong, then the tag of the element.
        quoted = (re.escape(name) for name in _quoted(words.partition(" Element ")[0]))
        places = (re.compile(rf"\b{name}\b").search(text, begins, ends) for name in quoted)
        return next((place.span() for place in places if place), (begins, ends))
    names = list(_names(words))
    attributes = [f'"{name}"' for name in names]
    element = _first(text, [f'name="{name}"' for name in names])
    if element is None:
        return _first(text, attributes)
    # What it quotes, or a part by its tag: its mass, its axis.
    after = re.compile(r"\bname=").search(text, element[1])
    inner = text[: after.start()] if after else text
    parts = [f'"{name}"' for name in _quoted(words)]
    parts += [f"<{match[1]}" for match in ITS.finditer(words)]
    return _first(inner, parts, element[1]) or element


def _first(text: str, wanted: Sequence[str], start: int = 0) -> Span:
    """Where the first of some texts is that is there, without its quotes."""
    for one in wanted:
        begins = text.find(one, start)
        if begins >= 0:
            end = begins + len(one) - one.endswith('"')
            return (one.rfind('"', 0, -1) + 1 + begins if '"' in one else begins), end
    return None


READERS = {".py": _python, ".json": _json, ".urdf": _xml, ".xml": _xml}


def _argument(command: str, words: str) -> Span:
    """What the words quote, or the option or entry that they name, where the command has it.

    Of an option and its value, or of an entry and a part of it, the narrower one.
    """
    told = _told(words)
    options = [match[0] for match in OPTION.finditer(told)]
    found: Span = None
    for name in (*_quoted(words), *options):
        place = _placed(command, name)
        inside = found and place and found[0] <= place[0] and place[1] <= found[1]
        if place and (not found or inside or command[found[0]] == "-" != command[place[0]]):
            found = place
    if found and command[found[0]] == "-" and "nvalid" in told:
        value = re.compile(r"[ =](\S+)").match(command, found[1])
        return value.span(1) if value else found
    if found:
        return found
    # A name begins its entry: m=-1.
    names = [match[1] for match in NAMED.finditer(told)]
    names += [match[1] for match in ASSIGNED.finditer(told)]
    entries = (_placed(command, f"{name}=") for name in names)
    files = (_placed(command, match[1]) for match in FILE.finditer(told))
    option = _placed(command, f"--{told.partition(':')[0]}")
    return next(filter(None, (*entries, option, *files)), None)


def _placed(command: str, text: str) -> Span:
    """Where a text stands in a command by itself, rather behind the name of the command."""
    ends = "" if text.endswith("=") else r"(?![\w.])"
    pattern = re.compile(rf"(?<![\w.-]){re.escape(text)}{ends}")
    places = [match.span() for match in pattern.finditer(command, len("mechanics"))]
    after = [place for place in places if command[: place[0]].count(" ") > 1]
    return next(iter(after or places), None)


def _told(words: str) -> str:
    """What an error says before it goes on to what might be written."""
    return MORE.split(words, maxsplit=1)[0]


def _quoted(words: str) -> Iterator[str]:
    for match in QUOTED.finditer(_told(words)):
        yield match[1] or match[2]


def _names(words: str) -> Iterator[str]:
    """Names that an error may be about: what it quotes, what has a kind, and what begins it."""
    told = _told(words)
    yield from _quoted(words)
    yield from (match[1] for match in NAMED.finditer(told))
    yield told.partition(":")[0]


def _causes(error: BaseException) -> Iterator[BaseException]:
    """An error and those while which it was raised."""
    one: BaseException | None = error
    while one is not None:
        yield one
        one = one.__cause__ or one.__context__


def _offset(text: str, line: int, column: int) -> int:
    """Of a line, counted from 1, and a column, from 0."""
    lines = text.splitlines(keepends=True)
    return sum(map(len, lines[: line - 1])) + max(column, 0)


def _shown(place: Place) -> str:
    """Lines with a bar at the left, as compilers print them."""
    text, start, end, file = place
    begins = text.rfind("\n", 0, start) + 1
    line = text[begins:].partition("\n")[0].replace("\t", " ")
    column = min(start - begins, len(line))
    count = max(1, min(end - start, len(line) - column))
    number = str(text.count("\n", 0, start) + 1) if file else ""
    room = WIDTH - len(number) - 4
    # A long line is shown around what is meant.
    skip = 0 if column + count <= room else max(0, min(column - 16, len(line) - room))
    shown = ("..." if skip else "") + line[skip + 3 * (skip > 0) : skip + room].rstrip()
    carets = " " * (column - skip) + "^" * min(count, room - column + skip)
    margin = " " * len(number)
    head = [f"{margin}--> {file}:{number}", f"{margin} |"] if file else []
    return "\n".join([*head, f"{number} | {shown}", f"{margin} | {carets}"])
