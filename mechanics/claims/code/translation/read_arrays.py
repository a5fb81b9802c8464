"""Files of languages of arrays, whose functions are followed as Python's are.

x.m -> its tree -> functions of Python, line by line -> statements
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace

from mechanics.claims.assemble import Reading
from mechanics.claims.code.c.macros import keeps_keywords
from mechanics.claims.code.c.plain import in_doubles
from mechanics.claims.code.read import read_function
from mechanics.claims.code.translation import cpp_functions, julia, matlab
from mechanics.claims.code.translation.manipulator_parts import together
from mechanics.claims.code.translation.python_page import Unread, renamed
from mechanics.claims.lines import NOT_USED
from mechanics.claims.names import Naming, Vocabulary
from mechanics.scene import Scene

FOR_ALL = "read as the scene's, for all values"
"""What is said of numbers that stand for parameters."""


LANGUAGES = {".m": matlab.in_python, ".jl": julia.in_python}
"""Of arrays, by the ends of their files."""


PLACE = re.compile(r"\[(\d+)\]")
"""Of an entry, which Julia counts from 1 as MATLAB does: p[2] is told as p(2)."""


ONE_LINE = re.compile(
    r"^[ \t]*(?:@\w+[ \t]+)*\w+!?\(\s*[^\W\d]\w*(?:::[\w{}]+)?\s*[,;][^()=~]*\)"
    r"(?:::\w+)?\s*=(?!=)",
    re.MULTILINE,
)
"""``f(x, y) = ...`` of Julia."""


def may_be_code(text: str, suffix: str) -> bool:
    """Whether a file without a function of several lines may be code; it may be text, too.

    A script of MATLAB that has a handle solved, or a function of Julia on one line.

    Parameters
    ----------
    text : str
    suffix : str
        Of its file.
    """
    if suffix == ".m":
        return re.search(r"=\s*@\(", text) is not None and re.search(r"\bode\d+", text) is not None
    return suffix == ".jl" and ONE_LINE.search(text) is not None


def has_function(text: str) -> bool:
    """Whether a file is code: its equations alone are text."""
    return re.search(r"^[ \t]*(?:@[\w.]+[ \t]+)*function\b", text, re.MULTILINE) is not None


def read_arrays(
    scene: Scene, text: str, suffix: str, function: str | None, names: Mapping[str, str] | None,
    about: str | None, origin: str,
) -> Reading:  # fmt: skip
    """Statements of the functions of a file of MATLAB or Julia, as code.

    Parameters
    ----------
    scene : Scene
    text, origin : str
    suffix : str
        Of the file, one of `LANGUAGES`.
    function : str, optional
        The one that is judged.
    names, about
        As for `mechanics.check`.

    Raises
    ------
    InputError
        Where one is not read.
    """
    with located(origin):
        known = Naming(Vocabulary(scene)).knows
        translated = renamed(
            lambda code, name: LANGUAGES[suffix](code, origin, known, name), text, function
        )
    told = PLACE.sub(r"(\1)", text) if suffix == ".jl" else text
    functions = together(translated.functions, origin, scene)
    readings = [read_function(scene, one, names, about, told) for one in functions]
    found = _together(readings, translated.remarks)
    assumption = " and ".join(translated.assumed)
    if assumption:
        found = replace(
            found, statements=tuple(replace(s, assumption=assumption) for s in found.statements)
        )
    return _elsewhere(found, translated.elsewhere, names, "a file that is read first")


def read_cpp(
    scene: Scene, text: str, function: str | None, names: Mapping[str, str] | None,
    about: str | None, origin: str,
) -> Reading:  # fmt: skip
    """Statements of the functions of a file of C++, as code; as `read_arrays`."""
    keeps_keywords(text, origin)
    with located(origin):
        translated = renamed(
            lambda code, name: cpp_functions.in_python(code, origin, name),
            cpp_functions.with_plain_types(text), function,
        )  # fmt: skip
    functions = together(translated.functions, origin, scene)
    readings = [read_function(scene, one, names, about, text) for one in functions]
    found = _together(readings).rounded(translated.rounded)
    missing_code = ""
    if absent := cpp_functions.absent_headers(text):
        missing_code = f"{absent[0]} is not here, and may give any name another meaning"
    notes = in_doubles(text)[1]
    if origin.endswith(cpp_functions.SMALL) and re.search(r"\bdouble\b", text):
        notes = (*notes, "double may be single precision on a small processor: read as exact")
    assumption = " and ".join(translated.granted)
    statements = (
        replace(s, notes=(*s.notes, *notes), assumption=assumption, missing_code=missing_code)
        for s in found.statements
    )
    return replace(found, statements=tuple(statements))


def _elsewhere(
    found: Reading, unknown: Iterable[str], names: Mapping[str, str] | None, where: str
) -> Reading:
    """The reading; in doubt where nothing here says what names are, and something elsewhere may."""
    left = [name for name in unknown if name not in (names or {})]
    if not left:
        return found
    doubt = (
        f"nothing here declares {', '.join(left)}, and {where} that is not here may: put the"
        " declaration into the file"
    )
    return replace(
        found, statements=tuple(replace(s, doubt=s.doubt or doubt) for s in found.statements)
    )


@contextmanager
def located(origin: str) -> Iterator[None]:
    """What is not read, with the file where it stands."""
    try:
        yield
    except Unread as error:
        raise Unread(f"{origin}, {error}") from None


def _together(readings: Sequence[Reading], remarks: Sequence[str] = ()) -> Reading:
    """One reading; refused where nothing says what the parts of several functions are for.

    M(q), C(q, qd) and G(q) are an equation only together, and what G returns is no acceleration.
    """
    if len(readings) > 1:
        raise Unread(
            f"{len(readings)} functions, of which none calls another: --function (function=) says"
            " which"
        )
    (found,) = readings
    said = tuple(f"{one}: {NOT_USED}" for one in found.remarks if one.endswith(FOR_ALL))
    return replace(
        found,
        statements=tuple(replace(s, notes=(*s.notes, *said)) for s in found.statements),
        remarks=(*remarks, *(one for one in found.remarks if not one.endswith(FOR_ALL))),
    )
