"""A text or file as statements: which notation it is in, and who reads it.

backslashes, ^{...}, $    ->    LaTeX            anything else    ->    text
"""

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from mechanics.claims.about import QUANTITIES
from mechanics.claims.assemble import Reading, assemble
from mechanics.claims.latex.blocks import page
from mechanics.claims.latex.macros import expanded
from mechanics.claims.latex.read import read_latex
from mechanics.claims.lines import Entry
from mechanics.claims.names import Naming
from mechanics.claims.place import LARGEST_TEXT
from mechanics.claims.text.read import read_text
from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.scene import Scene

Reader = Callable[[str, Naming, str], Sequence[Entry]]

NOTATIONS: dict[str, Reader] = {"latex": read_latex, "text": read_text}
SUFFIXES: dict[str, str] = {".tex": "latex", ".m": "text", ".sympy": "text"}
LATEX = re.compile(r"\\[A-Za-z]{2,}|\\\\|[\^_]\s*\{|\$|^\s*\\\[", re.MULTILINE)


def notation_of(text: str) -> str:
    """``"latex"`` or ``"text"``."""
    return "latex" if LATEX.search(text) else "text"


def read_source(
    scene: Scene,
    text: str,
    *,
    names: Mapping[str, str] | None = None,
    notation: str | None = None,
    about: str | None = None,
    origin: str = "",
) -> Reading:
    """Statements of a text in LaTeX, or in SymPy's or MATLAB's notation.

    Parameters
    ----------
    scene : Scene
    text : str
    names : mapping of str to str, optional
        What names of the text mean: names of the scene (``{"phi": "theta", "w": "theta_dot"}``),
        or quantities (``{"T": "kinetic energy"}``).
    notation : str, optional
        ``"latex"`` or ``"text"``; found out when not given.
    about : str, optional
        What every equation is about; found out when not given.
    origin : str
        What messages call the text.

    Raises
    ------
    InputError
        When nothing in the text can be read, by line and column.
    """
    if notation is not None and notation not in NOTATIONS:
        raise InputError(f"notation {notation!r}: {instead(notation, NOTATIONS, 'notations')}")
    if about is not None and about not in QUANTITIES:
        raise InputError(f"about {about!r}: {instead(about, QUANTITIES, 'quantities')}")
    refuse_private_use(text, origin or "text")
    chosen = notation or notation_of(text[:LARGEST_TEXT])
    title = origin or ("LaTeX" if chosen == "latex" else "text")
    if chosen == "latex" and Path(origin).suffix != ".tex":
        text = page(text)
    text = expanded(text, title) if chosen == "latex" else text
    reader = NOTATIONS[chosen]
    try:
        found = assemble(
            scene, lambda naming: reader(text, naming, title), text, title, dict(names or {}),
            about, chosen,
        )  # fmt: skip
    except RecursionError:
        # The limits leave room; a caller that is deep itself may not.
        raise InputError(f"{title}, line 1, column 1: nested too deeply") from None
    if not (found.statements or found.remarks or found.unjudged):
        raise InputError(f"{title}, line 1, column 1: there is no equation in it")
    if all(statement.row is None for statement in found.statements) and found.statements:
        raise InputError(found.statements[0].doubt)
    return found


def read_file(scene: Scene, path: Path, **options: object) -> Reading:
    """`read_source` of a file; the suffix may tell the notation."""
    settings = {"notation": SUFFIXES.get(path.suffix), "origin": str(path)}
    given = {name: value for name, value in options.items() if value is not None}
    return read_source(scene, file_text(path), **{**settings, **given})  # type: ignore[arg-type]


def file_text(path: Path) -> str:
    """The text of a file.

    Raises
    ------
    InputError
        When it cannot be read, or is no UTF-8; by line and column.
    """
    try:
        # Not all of it: a file may have no end, as /dev/zero.
        with path.open("rb") as file:
            data = file.read(4 * LARGEST_TEXT + 1)
    except OSError as error:
        raise InputError(f"file {path}: it cannot be read: {error.strerror}") from None
    return decoded(data, str(path))


def decoded(data: bytes, origin: str) -> str:
    """Bytes as text.

    Raises
    ------
    InputError
        When they are too many, or no UTF-8; by line and column.
    """
    if len(data) > 4 * LARGEST_TEXT:
        raise InputError(f"{origin}, line 1, column 1: more than {4 * LARGEST_TEXT} bytes")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = error.start - (data.rfind(b"\n", 0, error.start) + 1) + 1
        raise InputError(
            f"{origin}, line {line}, column {column}: the file is no UTF-8 text: save it as UTF-8"
        ) from None
    refuse_private_use(text, origin)
    return text


PRIVATE = re.compile("[\ue000-\uf8ff\U000f0000-\U0010ffff]")


def refuse_private_use(text: str, origin: str) -> None:
    """Refuse characters that mean what each font makes of them; some are marks of the readers.

    Raises
    ------
    InputError
    """
    if (found := PRIVATE.search(text)) is not None:
        line = text.count("\n", 0, found.start()) + 1
        column = found.start() - text.rfind("\n", 0, found.start())
        raise InputError(
            f"{origin}, line {line}, column {column}: U+{ord(found[0]):04X} is a character for"
            " private use, which has no meaning of its own: type the sign itself"
        )
