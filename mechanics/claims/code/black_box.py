"""Code that can only be called: a simulator, compiled code, an environment.

f(state, force) -> accelerations, or the rate of the state        numbers in, numbers out
f(state, force) -> the state after one step of its integrator     with step= and integrator=
"""

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from math import isfinite
from typing import Any

from sympy import Dummy, Expr, Matrix

from mechanics.claims.code.arguments import Arguments, arguments_of
from mechanics.claims.code.outputs import Claim, claims
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.guess import guess
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.tree import Name
from mechanics.errors import InputError
from mechanics.scene import Scene

INTEGRATORS = ("euler", "semi-implicit euler", "rk4")
"""By which a box may advance its state."""


@dataclass(frozen=True)
class BlackBox:
    """A function that is called with numbers only.

    An environment that only steps is a function of a few lines: for Gymnasium's ``CartPole-v1``

        env = gymnasium.make("CartPole-v1").unwrapped

        def step(state, force):
            env.reset()
            env.state, env.force_mag = state, force
            env.step(1)
            return env.state

        box = BlackBox(step, {"mc": 1, "mp": 0.1, "l": 0.5, "g": 9.8}, step=env.tau)
        mechanics.check(scene, box, names={"state": "x x_dot theta theta_dot", "force": "F"})

    Attributes
    ----------
    function : callable
        Its arguments are matched by their names, as those of code that is read.
    values : mapping of str to float
        Parameters of the scene that are numbers inside the box: ``{"g": 9.8}``.
    step : float
        Time by which a call advances the state that it is given, in s, where it returns that;
        0 where it returns accelerations, or the rate of the state.
    integrator : str
        By which it steps, ``"euler"``, ``"semi-implicit euler"`` or ``"rk4"``: the engine's own
        equations are advanced in the same way, and the mean rates over the step are compared.

    Raises
    ------
    InputError
        For a step that is no time, or another integrator.

    Examples
    --------
    >>> from math import sin
    >>> from systems import rod_pendulum
    >>> box = BlackBox(lambda theta, u: [1.5 * 9.81 / 2 * sin(theta) + 3 * u / 4],
    ...                {"m": 1, "l": 2, "g": 9.81})
    >>> [row.finding.verdict.name for row in check(rod_pendulum.scene(), box).judged]
    ['SUPPORTED']
    """

    function: Callable[..., Any]
    values: Mapping[str, float] = field(default_factory=dict)
    step: float = 0.0
    integrator: str = "euler"

    def __post_init__(self) -> None:
        if not (isfinite(self.step) and self.step >= 0):
            raise InputError(f"black box {self.title}: the step {self.step} s is no time")
        if self.integrator not in INTEGRATORS:
            raise InputError(
                f"black box {self.title}: integrator {self.integrator!r}: it can be"
                f" {', '.join(INTEGRATORS)}"
            )

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
    open_names = [Name(0, name) for name in wanted if name not in (names or {})]
    naming = replace(naming, guessed=guess(naming, open_names, ()))
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
    if box.step and (not arguments.state or count != len(arguments.state)):
        raise InputError(
            f"black box {box.title}: a step returns as many numbers as its argument for the state"
            f" has, {len(arguments.state)}; {count} found: say by names= which argument that is"
        )
    outputs = tuple(Dummy(f"output_{i}", real=True) for i in range(count))
    found = claims(naming, Outputs((Matrix(outputs),), ()), arguments.state, None, box.title)
    return Box(box, arguments, outputs, tuple(found))


def entries(value: Any) -> tuple[Expr, ...]:
    """The symbols of an argument."""
    return value if isinstance(value, tuple) else (value,)
