"""The operating point of a linearization: what is given of it, and nodes with its values put in."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sympy import Expr, Rational, Symbol, sympify

from mechanics.errors import InputError
from mechanics.kernel.angles import base_angles
from mechanics.nearest import instead
from mechanics.program import Builder, Node
from mechanics.program.interpret import include
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.scene import Scene
from mechanics.scene.symbols import DOTS

Values = Mapping[str | Expr, Expr | int]


@dataclass(frozen=True)
class OperatingPoint:
    """A state of rest or a steady motion, as it was given.

    Attributes
    ----------
    coordinates, inputs : mapping of Symbol to Expr
        q_0 and w_0; of a steady motion the coordinates that have no effect may be missing.
    speeds : mapping of Symbol to Expr
        Speeds, and rates of inputs, that were given; all others that are independent are zero.
    parameters : mapping of Symbol to Expr
        Relations between parameters that hold there.
    """

    coordinates: Mapping[Symbol, Expr]
    inputs: Mapping[Symbol, Expr]
    speeds: Mapping[Symbol, Expr]
    parameters: Mapping[Symbol, Expr]

    @property
    def moves(self) -> bool:
        """Whether it is a motion: a speed is not zero."""
        return any(value != 0 for value in self.speeds.values())

    @property
    def point(self) -> dict[Symbol, Expr]:
        """Values of coordinates and inputs."""
        return {**self.coordinates, **self.inputs}

    def words(self, angles: Mapping[Symbol, bool]) -> str:
        """``"theta = pi/2 rad, f = 0"``; `angles` says which coordinates turn."""
        units = {q: " rad" if turns else " m" for q, turns in angles.items()}
        known = {**self.point, **{s: v for s, v in self.speeds.items() if v != 0}}
        return ", ".join(f"{s} = {value}{units.get(s, '')}" for s, value in known.items())


def operating_point(
    scene: Scene, at: Values, inputs: Values, speeds: Values, parameters: Mapping[Symbol, Expr]
) -> OperatingPoint:
    """Sort what was given by symbol.

    Raises
    ------
    InputError
        For a name that the scene does not have, or a value that is missing.
    """
    driven = [Symbol(w.name + dots, real=True) for w in scene.input_symbols for dots in DOTS[1:-1]]
    place = OperatingPoint(
        _named(scene, "coordinate", scene.q, at),
        _named(scene, "input", scene.input_symbols, inputs),
        _named(scene, "speed", (*scene.u, *driven), speeds),
        parameters,
    )
    required = {"input": scene.input_symbols} if place.moves else {}
    if not place.moves:
        required = {"coordinate": scene.q, "input": scene.input_symbols}
    for kind, symbols in required.items():
        for symbol in symbols:
            if symbol not in place.point:
                raise missing(scene, kind, symbol)
    known = dict(parameters)
    q, w, u = (
        {symbol: value.subs(known) for symbol, value in group.items()}
        for group in (place.coordinates, place.inputs, place.speeds)
    )
    return OperatingPoint(q, w, u, parameters)


def missing(scene: Scene, kind: str, symbol: Symbol) -> InputError:
    """What is said where a value is missing."""
    return InputError(
        f"{scene.name}: the operating point gives no value for {kind} {symbol}:"
        " give one for each, zero if that is meant"
    )


def _named(scene: Scene, kind: str, symbols: Sequence[Symbol], given: Values) -> dict[Symbol, Expr]:
    values: dict[Symbol, Expr] = {}
    names = {symbol.name: symbol for symbol in symbols}
    for key, value in given.items():
        name = key if isinstance(key, str) else str(scene.plain(key, "operating point"))
        if name not in names:
            raise InputError(
                f"{scene.name}: {name!r} is no {kind}: {instead(name, names, f'{kind}s')}"
            )
        number = sympify(value, rational=True)
        # The decimal that was typed, not the double next to it.
        values[names[name]] = Rational(str(number)) if number.is_Float else number
    return values


@dataclass(frozen=True)
class Place:
    """Nodes with values in place of inputs, in a builder of their own.

    Attributes
    ----------
    source : Builder
        Where the nodes come from.
    values : mapping of str to Expr
        By the name of the input; what is not listed stays an input.
    """

    source: Builder
    values: Mapping[str, Expr]
    builder: Builder = field(default_factory=Builder)

    def __call__(self, nodes: Sequence[Node]) -> tuple[Node, ...]:
        """The nodes with the values put in.

        Raises
        ------
        ZeroDivisorError
            If something is divided by zero there.
        """
        program = self.source.program({"nodes": nodes})
        known = {name: value for name, value in self.values.items() if name in program.inputs}
        inputs = dict(zip(known, read(self.builder, tuple(known.values())), strict=True))
        return include(self.builder, program, inputs)["nodes"]

    def matrix(self, rows: Sequence[Sequence[Node]]) -> list[list[Node]]:
        """A matrix with the values put in."""
        flat = iter(self([entry for row in rows for entry in row]))
        return [[next(flat) for _ in row] for row in rows]


def pivots(builder: Builder, matrix: Sequence[Sequence[Node]]) -> list[tuple[int, int]]:
    """(row, column) of pivots that are not zero, in the order of an elimination: earlier first."""
    if not matrix:
        return []
    # Where angles are given as pi/6 or asin(3/5), entries are zero by what their sines are.
    program = base_angles(builder.program({"entries": [entry for row in matrix for entry in row]}))
    own = Builder()
    residues = Residues(own)
    values = iter(residues.values(include(own, program)["entries"]))
    rows = [[next(values) for _ in row] for row in matrix]
    return residues.eliminate(rows, len(matrix[0]))
