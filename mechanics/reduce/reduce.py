"""What may be left out of an output of some equations, with a proved bound of the change.

    |reduced_i(x) - whole_i(x)|  <=  error S_i      at every x in the box                          (1)

S_i is the size of output i in the box: the value of |whole_i| at a state where it is large, which
its maximum over the box is not smaller than. An absolute error is in the unit of the output.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property, partial
from math import isfinite
from typing import Any

import numpy as np
from sympy import Expr, Rational, Symbol

from mechanics.compiled.graphs import Graphs, function_inputs
from mechanics.equations import Equations
from mechanics.errors import InputError, wanted
from mechanics.kernel import Finding, enclosed
from mechanics.kernel.balls import ball, precision
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.program.program import reachable
from mechanics.program.sympy_reader import read
from mechanics.reduce.base import FORWARD, INVERSE, Base, bases
from mechanics.reduce.box import check_names, complete, fixed_parameters, given_ranges, read_over
from mechanics.reduce.candidates import candidates
from mechanics.reduce.edits import Edit, Kind
from mechanics.reduce.harmonics import BITS, Polynomials
from mechanics.reduce.order import Start, constants, operations, sequence
from mechanics.reduce.proof import BOXES, Box, bound, estimate
from mechanics.reduce.scale import scales

PARTS = 256
"""Of the box, for what is asked on the way."""
SMALL = 400
"""Operations up to which every base is tried."""


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
    base : Base
        Program of the whole output.
    start : Start
        The same with its box.
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
    """

    equations: Equations
    of: str
    error: Fraction
    absolute: bool
    base: Base
    start: Start
    fixed: Mapping[Symbol, Expr]
    sizes: tuple[Fraction, ...]
    bounds: tuple[Fraction, ...]
    edits: tuple[Edit, ...]
    finding: Finding
    before: int

    def __repr__(self) -> str:
        return (
            f"<{self.of} of {self.equations.scene.name}: {self.after} of {self.before}"
            f" operations, {self.finding.verdict.name}>"
        )

    @property
    def box(self) -> dict[str, tuple[Fraction, Fraction]]:
        """Ranges of the inputs that have one."""
        return {name: ends for name, ends in self.start.box.items() if ends[0] < ends[1]}

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
        return tuple(sorted(every & less)), tuple(sorted((every & whole) - less))

    @property
    def couplings(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Entries of the mass matrix that are kept and that are left out, of forward dynamics."""
        gone = [name for node, name in self.base.couplings if self.made.get(node) is Kind.ZERO]
        return tuple(n for _, n in self.base.couplings if n not in gone), tuple(gone)


def _inputs(start: Start, builder: Builder, edits: Mapping[int, Kind]) -> set[str]:
    """Inputs that the outputs need, whatever their values."""
    from mechanics.program.operations import INPUT
    from mechanics.reduce.edits import nodes

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
    allowed = _error(error)
    if not isinstance(boxes, int) or boxes < 1:
        raise InputError(f"boxes {boxes!r}: give how many parts may be looked at, 1 or more")
    ranges = given_ranges(over) if isinstance(over, Mapping) else read_over(over)
    single = given_ranges(values or {})
    if twice := sorted(ranges.keys() & single.keys()):
        raise InputError(f"{twice[0]} has a range and a value: give one of them")
    ranges |= single
    if of not in function_inputs(equations):
        names = ", ".join(function_inputs(equations))
        raise InputError(f"{of!r}: there is no such output to reduce: there are {names}")
    graphs = Graphs(equations)
    known, scene = graphs.quantities, equations.scene
    check_names(scene, known, ranges)
    fixed = fixed_parameters(scene, known, ranges)
    found = []
    for base in bases(graphs, of):
        base = _with_numbers(base, fixed)
        box = complete(
            [n for n in base.program.inputs if n not in _rationals(fixed)],
            known, ranges, f"{of} of {scene.name}", of == INVERSE,
        ) | {n: (v, v) for n, v in _rationals(fixed).items() if n in base.program.inputs}  # fmt: skip
        start = Start(base.program, box, ())
        found.append((operations(start.reduced({})), len(found), base, start))
    found.sort(key=lambda row: row[:2])
    before = found[0][0]
    tried = found if before <= SMALL and of == FORWARD else found[:1]
    speeds = [entry.name for entry in known.u]
    numbers = {entry.name for entry in known.p}
    best: Reduction | None = None
    for _, _, base, start in tried:
        edits = candidates(base.program, speeds, numbers, [node for node, _ in base.couplings])
        start = replace(start, edits=edits)
        progress(f"{len(edits)} candidates in {operations(start.reduced({}))} operations")
        one = _reduced(equations, of, allowed, absolute, base, start, fixed, boxes, before)
        better = best is None or (
            one.finding.shown, -one.after) > (best.finding.shown, -best.after)  # fmt: skip
        best = one if better else best
    assert best is not None  # there is a base at least
    return best


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
    outputs = include(builder, whole, dict(zip(others, read(builder, [*others.values()]), strict=True)))
    again = builder.program(outputs)
    rest = dict(again.outputs)
    places = rest.pop("couplings")
    names = (name for _, name in base.couplings)
    return Base(replace(again, outputs=rest), tuple(zip(places, names, strict=True)))


def _reduced(
    equations: Equations, of: str, error: Fraction, absolute: bool, base: Base, start: Start,
    fixed: Mapping[Symbol, Expr], boxes: int, before: int,
) -> Reduction:  # fmt: skip
    sizes = scales(start.program, start.box)
    unit = tuple(max(sizes) for _ in sizes) if absolute else sizes
    share = float(error / unit[0]) if absolute and unit[0] else float(error)
    bounds = tuple(error if absolute else error * size for size in sizes)
    polynomials = Polynomials(start.program, start.box, start.numbers)
    scale = np.array([float(size) for size in unit])

    def measure(edits: Mapping[int, Kind]) -> Any:
        found = polynomials.bounds(edits)
        if found is not None:
            return np.array(found)
        return estimate(start.program, start.box, edits, scale, min(PARTS, boxes))

    edits = sequence(start, scale, share, measure)
    subject = f"{of} of {equations.scene.name}: the reduced one deviates by no more than its bound"
    while True:
        made = {edit.node: edit.kind for edit in edits}
        finding = _finding(subject, start, polynomials, made, bounds, boxes)
        if finding.shown or not edits:
            break
        edits.pop()
    return Reduction(
        equations, of, error, absolute, base, start, fixed, sizes, bounds, tuple(edits), finding,
        before,
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
