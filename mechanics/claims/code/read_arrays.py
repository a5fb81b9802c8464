"""Files of languages of arrays, whose functions are followed as Python's are.

x.m -> its tree -> functions of Python, line by line -> statements
"""

from collections.abc import Callable, Mapping

from mechanics.claims.assemble import Reading
from mechanics.claims.code import matlab
from mechanics.claims.code.read import read_function
from mechanics.claims.names import Naming, Vocabulary
from mechanics.errors import InputError
from mechanics.scene import Scene


def with_code(formulas: Callable[[], Reading], code: Callable[[], Reading]) -> Reading:
    """The formulas of a file where all of them are read, else its functions where these are.

    Raises
    ------
    InputError
        What is said of the formulas, where neither are.
    """
    failure: InputError | None = None
    try:
        found = formulas()
        if all(one.row is not None and not one.doubt for one in found.statements):
            return found
    except InputError as error:
        failure = error
    try:
        return code()
    except InputError:
        if failure is not None:
            raise failure from None
        return found


def read_matlab(
    scene: Scene, text: str, names: Mapping[str, str] | None, about: str | None, origin: str
) -> Reading:
    """Statements of the functions of a file, as code.

    Parameters
    ----------
    scene : Scene
    text, origin : str
    names, about
        As for `mechanics.check`.

    Raises
    ------
    InputError
        Where one is not read.
    """
    translated = matlab.in_python(text, origin, Naming(Vocabulary(scene)).knows)
    readings = [read_function(scene, one, names, about) for one in translated.functions]
    return Reading(
        tuple(statement for reading in readings for statement in reading.statements),
        tuple(match for reading in readings for match in reading.names),
        (*translated.remarks, *(words for reading in readings for words in reading.remarks)),
    )
