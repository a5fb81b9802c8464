"""Code that can only be called: a simulator, compiled code, an environment.

f(state, force) -> accelerations, or the rate of the state        numbers in, numbers out
"""

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from sympy import Dummy, Expr, Matrix

from mechanics.errors import InputError
from mechanics.reading.code.arguments import Arguments, arguments_of
from mechanics.reading.code.outputs import Claim, claims
from mechanics.reading.names import Naming, Vocabulary
from mechanics.scene import Scene


@dataclass(frozen=True)
class BlackBox:
    """A function that is called with numbers only.

    Attributes
    ----------
    function : callable
        Its arguments are matched by their names, as those of code that is read.
    values : mapping of str to float
        Parameters of the scene that are numbers inside the box: ``{"g": 9.8}``.
    """

    function: Callable[..., Any]
    values: Mapping[str, float] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """How messages call it."""
        return getattr(self.function, "__name__", type(self.function).__name__)


@dataclass(frozen=True)
class Box:
    """A black box beside a scene.

    Attributes
    ----------
    box : BlackBox
    arguments : Arguments
        Symbols that its arguments stand for.
    outputs : tuple of Dummy
        What stands for its outputs in `claims`.
    claims : tuple of Claim
        Each a rate and the output that it should be.
    """

    box: BlackBox
    arguments: Arguments
    outputs: tuple[Expr, ...]
    claims: tuple[Claim, ...]


def match_box(scene: Scene, box: BlackBox, names: Mapping[str, str] | None, count: int) -> Box:
    """What the arguments and `count` outputs of a black box stand for.

    Raises
    ------
    InputError
        When an argument is unexplained, or a parameter is neither argument nor given as a value.
    """
    try:
        wanted = list(inspect.signature(box.function).parameters)
    except (TypeError, ValueError):
        raise InputError(f"black box {box.title}: its arguments are not known") from None
    naming = Naming(Vocabulary(scene))
    arguments = arguments_of(naming, wanted, {}, names or {})
    passed = {str(symbol) for name in wanted for symbol in entries(arguments.values[name])}
    known = {symbol.name for symbol in scene.parameters}
    for name in box.values:
        if name not in known:
            raise InputError(f"black box {box.title}: the scene has no parameter {name!r}")
    missing = sorted(known - passed - box.values.keys())
    if missing:
        raise InputError(
            f"black box {box.title}: what is {', '.join(missing)} inside? give values={{...}}"
        )
    outputs = tuple(Dummy(f"output_{i}", real=True) for i in range(count))
    found = claims(scene, [Matrix(outputs)], arguments.state, None, box.title)
    return Box(box, arguments, outputs, tuple(found))


def entries(value: Any) -> tuple[Expr, ...]:
    """The symbols of an argument."""
    return value if isinstance(value, tuple) else (value,)
