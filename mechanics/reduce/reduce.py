"""What may be left out of an output of some equations, with a proved bound of the change.

    |reduced_i(x) - whole_i(x)|  <=  error S_i      at every x in the box                       (1)

S_i is the size of output i in the box: the value of |whole_i| at a state where it is large, which
its maximum over the box is not smaller than. An absolute error is in the unit of the output.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import isfinite
from typing import Any

import numpy as np
from sympy import Expr, Rational, Symbol

from mechanics.compiled.graphs import Graphs, function_inputs
from mechanics.equations import Equations
from mechanics.errors import InputError, MechanicsError, ZeroDivisorError, wanted
from mechanics.kernel import Finding, enclosed
from mechanics.kernel.balls import precision
from mechanics.nearest import instead
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.program.operations import INPUT
from mechanics.program.program import reachable
from mechanics.program.sympy_reader import read
from mechanics.reduce.base import FORWARD, INVERSE, Base, bases
from mechanics.reduce.box import check_names, complete, fixed_parameters, given_ranges, read_over
from mechanics.reduce.candidates import candidates
from mechanics.reduce.edits import Edit, Kind, nodes
from mechanics.reduce.harmonics import BITS, Polynomials
from mechanics.reduce.order import Start, operations, sequence
from mechanics.reduce.proof import BOXES, Box, bound, estimate
from mechanics.reduce.scale import scales

WORK, FEWEST, MOST = 12_800, 16, 256
"""Nodes times parts of the box for what is asked on the way, and the fewest and most parts."""
SMALL = 400
"""Nodes up to which every base is tried, and every way to a bound."""


@dataclass(frozen=True, eq=False)
class Reduction:
    """A reduced output, and what is shown about it.

    Attributes
    ----------
    equations : Equations
        Of the whole model.
    of : str
        The output.
    error : Fraction
        That was allowed.
    absolute : bool
        Whether it is in the unit of the output.
    boxes : int
        Parts of the box that may be looked at.
    base : Base
        Program of the whole output.
    start : Start
        The same with its box.
    place : int
        Of the base among all.
    fixed : mapping of Symbol to Expr
        Parameters that are numbers.
    sizes : tuple of Fraction
        S_i of equation (1).
    bounds : tuple of Fraction
        What no deviation is larger than, in the units of the outputs.
    edits : tuple of Edit
        What was done, in this order.
    finding : Finding
        PROVED, or UNDECIDED and why.
    before : int
        Operations of the whole output at these numbers, in the shortest form.
    unproved : int
        Edits that are not made though each keeps within the error at the states that were drawn:
        with the others, or at other states, no bound of them is known.
    bounded : tuple of bool
        Whether the whole output is known to be bounded in the box. Where it is not, the box may
        hold a singular state, and a share of its size says little.
    """

    equations: Equations
    of: str
    error: Fraction
    absolute: bool
    boxes: int
    base: Base
    start: Start
    place: int
    fixed: Mapping[Symbol, Expr]
    sizes: tuple[Fraction, ...]
    bounds: tuple[Fraction, ...]
    edits: tuple[Edit, ...]
    finding: Finding
    before: int
    unproved: int
    bounded: tuple[bool, ...]

    def __repr__(self) -> str:
        return (
            f"<{self.of} of {self.equations.scene.name}: {self.after} of {self.before}"
            f" operations, {self.finding.verdict.name}>"
        )

    @property
    def box(self) -> dict[str, tuple[Fraction, Fraction]]:
        """Ranges of what is not fixed; of a coordinate or input with one value, it twice."""
        fixed = {symbol.name for symbol in self.fixed}
        return {name: ends for name, ends in self.start.box.items() if name not in fixed}

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the entries: ``theta_ddot``, ``mass_matrix[0]``."""
        equations, outputs = self.equations, self.start.program.outputs
        symbols = {"ud": equations.scene.ud, "multipliers": equations.multipliers}
        return tuple(
            str(symbols[name][k]) if name in symbols else f"{name}[{k}]"
            for name, nodes in outputs.items()
            for k in range(len(nodes))
        )

    @cached_property
    def made(self) -> dict[int, Kind]:
        """Edits by node."""
        return {edit.node: edit.kind for edit in self.edits}

    @cached_property
    def program(self) -> Program:
        """The reduced output, a function of what has a range."""
        return self.start.reduced(self.made)

    @property
    def after(self) -> int:
        """Its operations."""
        return operations(self.program)

    @property
    def parameters(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Names of the parameters that the reduced output depends on, and of those it does not."""
        program = self.base.program
        every = {entry.name for entry in self.equations.scene.parameters} & {*program.inputs}
        builder = Builder()
        whole, less = (
            _inputs(self.start, builder, edits) for edits in ({}, self.made)
        )  # fmt: skip
        kept = (every & less) | {*self.base.inner}
        return tuple(sorted(kept)), tuple(sorted((every & whole) - less))

    @property
    def couplings(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Entries of the mass matrix that are kept and that are left out, of forward dynamics."""
        gone = [name for node, name in self.base.couplings if self.made.get(node) is Kind.ZERO]
        return tuple(n for _, n in self.base.couplings if n not in gone), tuple(gone)


def _inputs(start: Start, builder: Builder, edits: Mapping[int, Kind]) -> set[str]:
    """Inputs that the outputs need, whatever their values."""
    found = nodes(start.program, builder, {}, edits)
    needed = reachable(builder, [found[k].number for k in start.program.roots])
    codes, first = builder.operations, builder.operands[0]
    return {builder.inputs[first[k]] for k in needed if codes[k] == INPUT}


def reduce(
    equations: Equations,
    error: Any,
    *,
    of: str = FORWARD,
    over: Mapping[str, Any] | Sequence[str] = (),
    values: Mapping[str, Any] | None = None,
    absolute: bool = False,
    boxes: int = BOXES,
    progress: Callable[[str], None] = lambda words: None,
) -> Reduction:
    """Find what may be left out of an output, and prove how much that changes it at most.

    Parameters
    ----------
    equations : Equations
    error : number or str
        That is allowed: of the size of each output in the box, or in its unit.
    of : str
        A function of `compile`: ``"forward_dynamics"``, ``"inverse_dynamics"``, ...
    over : mapping of str to (number, number), or sequence of str
        Ranges: ``{"theta": (-1, 1)}`` or ``["theta in [-1, 1]"]``, of coordinates, speeds, their
        rates, inputs and parameters.
    values : mapping of str to number, optional
        What has one value. Parameters without value and range are at their typical values; inputs
        of inverse dynamics are 0.
    absolute : bool
        Whether the error is in the unit of the output.
    boxes : int
        Parts of the box that are looked at, at most.
    progress : callable
        Told what is done.

    Raises
    ------
    InputError
        If the error is no number that is not negative, a range is empty, a name is not known, or
        something that the output depends on has neither range nor value.
    ValueMissingError
        For a parameter without a value.
    """
    wanted(equations, Equations, "reduce", "pass derive(scene, route)")
    asked = _asked(equations, error, of, over, values, absolute, boxes)
    starts = _starts(asked)
    before = operations(starts[0][1].reduced({}))
    tried = starts if before <= SMALL and of == FORWARD else starts[:1]
    found = []
    for base, start, place in tried:
        progress(f"{len(start.edits)} candidates in {before} operations")
        found.append(_reduced(asked, base, start, place, before, None))
    return min(found, key=lambda one: (not one.finding.shown, one.after))


def repeated(
    equations: Equations, error: Any, *, of: str, over: Mapping[str, Any],
    values: Mapping[str, Any], absolute: bool, boxes: int, place: int, edits: Sequence[Edit],
    unproved: int,
) -> Reduction:  # fmt: skip
    """The same with edits that are known, of the base at a place.

    Raises
    ------
    ValueError
        If there is no such base, or an edit is none of those that may be made.
    """
    defined = {symbol.name for symbol in equations.scene.definitions}
    given = {name: value for name, value in values.items() if name not in defined}
    asked = _asked(equations, error, of, over, given, absolute, boxes)
    starts = _starts(asked)
    before = operations(starts[0][1].reduced({}))
    rows = [row[:2] for row in starts if row[2] == place]
    if not rows or not {*edits} <= {*rows[0][1].edits}:
        raise ValueError("an edit is none of those that may be made")
    ((base, start),) = rows
    asked = replace(asked, unproved=unproved)
    return _reduced(asked, base, start, place, before, list(edits))


@dataclass(frozen=True, eq=False)
class _Asked:
    """What a caller wants, looked through."""

    equations: Equations
    graphs: Graphs
    of: str
    error: Fraction
    absolute: bool
    ranges: Box
    fixed: Mapping[Symbol, Expr]
    boxes: int
    unproved: int = 0


def _asked(
    equations: Equations, error: Any, of: str, over: Mapping[str, Any] | Sequence[str],
    values: Mapping[str, Any] | None, absolute: bool, boxes: int,
) -> _Asked:  # fmt: skip
    allowed = _error(error)
    if not isinstance(boxes, int) or boxes < 1:
        raise InputError(f"boxes {boxes!r}: give how many parts may be looked at, 1 or more")
    ranges = given_ranges(over) if isinstance(over, Mapping) else read_over(over)
    single = given_ranges(values or {})
    if twice := sorted(ranges.keys() & single.keys()):
        raise InputError(f"{twice[0]} has a range and a value: give one of them")
    ranges |= single
    if of not in function_inputs(equations):
        ask = instead(of, function_inputs(equations), "outputs")
        raise InputError(f"output {of!r} of {equations.scene.name}: there is none: {ask}")
    graphs = Graphs(equations)
    check_names(equations.scene, graphs.quantities, ranges)
    fixed = fixed_parameters(equations.scene, graphs.quantities, ranges)
    return _Asked(equations, graphs, of, allowed, absolute, ranges, fixed, boxes)


def _starts(asked: _Asked) -> list[tuple[Base, Start, int]]:
    """Every base with its box, what may be done, and its place; the shortest first."""
    known, rationals = asked.graphs.quantities, _rationals(asked.fixed)
    speeds, numbers = [e.name for e in known.u], {e.name for e in known.p}
    words = f"{asked.of} of {asked.equations.scene.name}"
    found: list[tuple[int, Base, Start, int]] = []
    refusals: list[MechanicsError] = []
    for place, plain in enumerate(bases(asked.graphs, asked.of)):
        try:
            base = _with_numbers(plain, asked.fixed)
            inputs = base.program.inputs
            moving = [name for name in inputs if name not in rationals]
            box = complete(moving, known, asked.ranges, words, asked.of == INVERSE)
            box |= {name: (rationals[name],) * 2 for name in inputs if name in rationals}
            places = [node for node, _ in base.couplings]
            start = Start(
                base.program, box, candidates(base.program, speeds, numbers, places)
            )  # fmt: skip
            found.append((operations(start.reduced({})), base, start, place))
        except ZeroDivisorError:
            refusals.append(
                InputError(f"{words}: something is divided by zero at these values of parameters")
            )
        except InputError as error:
            # Another form may depend on less.
            refusals.append(error)
    if not found:
        raise refusals[0]
    return [row[1:] for row in sorted(found, key=lambda row: (row[0], row[3]))]


def _error(error: Any) -> Fraction:
    try:
        found = Fraction(str(error))
        right = found >= 0 and isfinite(float(found))
    except (ValueError, ZeroDivisionError, OverflowError):
        right = False
    if not right:
        raise InputError(f"error {error!r}: give a number that is not negative, such as 1e-2")
    return found


def _rationals(fixed: Mapping[Symbol, Expr]) -> dict[str, Fraction]:
    return {
        s.name: Fraction(int(e.p), int(e.q)) for s, e in fixed.items() if isinstance(e, Rational)
    }


def _with_numbers(base: Base, fixed: Mapping[Symbol, Expr]) -> Base:
    """Numbers that are no rationals, such as pi, in the program itself."""
    others = {s.name: e for s, e in fixed.items() if not isinstance(e, Rational)}
    others = {name: e for name, e in others.items() if name in base.program.inputs}
    if not others:
        return base
    program, builder = base.program, Builder()
    entries = {"couplings": tuple(node for node, _ in base.couplings)}
    whole = replace(program, outputs={**program.outputs, **entries})
    outputs = include(
        builder, whole, dict(zip(others, read(builder, [*others.values()]), strict=True))
    )
    again = builder.program(outputs)
    rest = dict(again.outputs)
    places = rest.pop("couplings")
    names = (name for _, name in base.couplings)
    return Base(replace(again, outputs=rest), tuple(zip(places, names, strict=True)), tuple(others))


def _reduced(
    asked: _Asked, base: Base, start: Start, place: int, before: int, known: list[Edit] | None
) -> Reduction:
    """Reduced by what is known to do, or by what is found."""
    error, absolute, boxes = asked.error, asked.absolute, asked.boxes
    sizes = scales(start.program, start.box)
    unit = tuple(max(sizes) for _ in sizes) if absolute else sizes
    share = float(error / unit[0]) if absolute and unit[0] else float(error)
    bounds = tuple(error if absolute else error * size for size in sizes)
    polynomials = Polynomials(start.program, start.box, start.numbers)
    scale = np.array([float(size) for size in unit])
    parts = min(boxes, max(FEWEST, min(MOST, WORK // max(1, len(start.program)))))

    def measure(edits: Mapping[int, Kind], level: float) -> Any:
        found = polynomials.bounds(edits)
        if found is not None and (len(start.program) > SMALL or (found <= level * scale).all()):
            return np.array(found)
        other = estimate(start.program, start.box, edits, scale, parts)
        return other if found is None else np.minimum(found, other)

    roots = dict.fromkeys(start.program.roots, Kind.ZERO)
    most = polynomials.bounds(roots) or [
        *estimate(start.program, start.box, roots, scale, parts)
    ]  # fmt: skip
    edits, unproved = (
        sequence(start, scale, share, measure) if known is None else (known, asked.unproved)
    )
    scene = asked.equations.scene.name
    subject = f"{asked.of} of {scene}: reduced = whole within the bound, over the box"
    while True:
        made = {edit.node: edit.kind for edit in edits}
        finding = _finding(subject, start, polynomials, made, bounds, boxes)
        if finding.shown or not edits or known is not None:
            break
        edits.pop()
    return Reduction(
        asked.equations, asked.of, error, absolute, boxes, base, start, place, asked.fixed, sizes,
        bounds, tuple(edits), finding, before, unproved, tuple(map(isfinite, most)),
    )  # fmt: skip


def _finding(
    subject: str, start: Start, polynomials: Polynomials, made: Mapping[int, Kind],
    bounds: Sequence[Fraction], boxes: int,
) -> Finding:  # fmt: skip
    """By harmonics where they are within the bounds, else by parts of the box."""
    balls = polynomials.bounds(made, digits=True)
    if balls is not None:
        words = "the squares of the coefficients of its harmonics, summed, for all angles at once"
        with precision(BITS):
            rows = list(zip([-b for b in bounds], balls, bounds, strict=True))
            finding = enclosed(subject, rows, words)
        if finding.shown:
            return finding
    return bound(subject, start.program, start.box, made, bounds, boxes).finding
