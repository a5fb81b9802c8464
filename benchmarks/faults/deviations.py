"""Linear equations against the motions that are near: what the exact equations say of deviations.

    x' = f(x),  c(x) = 0       x = (q, u): u' by a route, constraints of q and of u          (1)
    dc t = 0                   t: deviations that the constraints admit                      (2)
    z'' = 0 at the point, M z'' + C z' + K z = 0,  q - q_0 = G z      for every t, where
    z = t,  z' = dq' t,  z'' = dq'' t      of the coordinates that stay                      (3)
    M dz''/dw = E w                        w: inputs and their rates                         (4)
    z'^T M z' = second difference of T     for t that only changes speeds                    (5)

Slopes are central differences of enclosures, with steps of 2^-100 in numbers of 600 bits: nothing
of the elimination or the derivatives by which `linearize` gets M, C, K and G. (5) holds where rows
are power-conjugate to z'; it tells a multiple of all three matrices.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random

from flint import arb, arb_mat
from sympy import Expr, Integer

from mechanics.checks.agreement import Derived
from mechanics.checks.energy import kinetic
from mechanics.kernel import Finding, enclose, refuted, supported, undecided
from mechanics.kernel.balls import precision
from mechanics.linear.form import Linear
from mechanics.mechanism import name_of
from mechanics.program import Builder, Node
from mechanics.program.forward import tangent
from mechanics.program.sympy_reader import read
from mechanics.routes.rows import substitute, velocity_forms
from mechanics.scene.symbols import DOTS

BITS = 600
STEP = Fraction(1, 2**100)
CLOSE = arb(2) ** -80
"""Differences have an error of the order of STEP^2."""

Column = list[arb]
Point = dict[str, arb]


def check_linear(
    linear: Linear, derived: Derived, rates: Mapping[str, Expr] | None = None
) -> Finding:
    """Statements (3) to (5) at one operating point with drawn parameters.

    Parameters
    ----------
    derived : Derived
        Of any route: its accelerations are those that are compared with.
    rates : mapping of str to Expr, optional
        Rates of inputs along the steady motion, ``{"psi_dot": Omega}``; others are zero.
    """
    subject = f"{linear.route}: linear equations = deviations of the exact ones"
    with precision(BITS):
        return _compared(subject, list(_Deviations(linear, derived, rates or {}).rows()))


def _compared(subject: str, rows: Sequence[tuple[str, arb, arb]]) -> Finding:
    for words, left, right in rows:
        if not left.is_finite() or not right.is_finite():
            return undecided(subject, f"{words}: no value at the drawn parameters")
        if not abs(left - right) < CLOSE * (1 + abs(right)):
            return refuted(subject, words, left, right + arb(0, CLOSE * (1 + abs(right))))
    samples = [(arb(left.mid(), CLOSE * (1 + abs(right))), right) for _, left, right in rows]
    return supported(subject, samples, f"slopes at {len(rows)} entries, to 2^-80")


class _Deviations:
    """The exact equations near the operating point, as functions of names."""

    def __init__(self, linear: Linear, derived: Derived, rates: Mapping[str, Expr]) -> None:
        mechanism, self.linear = derived.mechanism, linear
        build = mechanism.builder
        self.q, self.u = ([name_of(n) for n in nodes] for nodes in (mechanism.q, mechanism.u))
        holonomic = [c.expression for c in mechanism.constraints if c.holonomic]
        holonomic += read(build, linear.scene.norms)
        bent = tangent(mechanism.q_rates, mechanism.rates)
        moved = dict(zip(mechanism.ud, derived.accelerations, strict=True))
        outputs: dict[str, Sequence[Node]] = {
            "held": [*holonomic, *velocity_forms(mechanism)],
            "first": mechanism.q_rates,
            "second": substitute(build, bent, moved),
            "T": [kinetic(mechanism)],
        }
        self.program = build.program(outputs)
        # What is not given has no effect, and the speeds are those where it is zero.
        still = dict.fromkeys(linear.scene.q, Integer(0))
        names = {s.name: e for s, e in {**still, **linear.speeds, **linear.point}.items()}
        names |= rates
        self.at = drawn_point(names, [*self.program.inputs, *linear.program.inputs])

    def value(self, name: str, steps: Mapping[str, arb], size: Fraction = STEP) -> Column:
        """An output at so many steps of each name from the point."""
        length = arb(size.numerator) / size.denominator
        moved = {n: self.at[n] + length * k for n, k in steps.items() if n in self.program.inputs}
        point = {n: {**self.at, **moved}[n] for n in self.program.inputs}
        return list(enclose(self.program, point, BITS)[name])

    def slope(self, name: str, along: Mapping[str, arb]) -> Column:
        """Its central difference along a deviation."""
        back = {n: -k for n, k in along.items()}
        pairs = zip(self.value(name, along), self.value(name, back), strict=True)
        half = arb(STEP.denominator) / (2 * STEP.numerator)
        return [(one - two) * half for one, two in pairs]

    def rows(self) -> Iterator[tuple[str, arb, arb]]:
        """(words, left, right) of every statement."""
        linear, zero = self.linear, arb(0)
        found = enclose(linear.program, {n: self.at[n] for n in linear.program.inputs}, BITS)
        n = len(linear.coordinates)
        own = [self.q.index(s.name) for s in linear.coordinates]

        def times(name: str, column: Column) -> Column:
            width, entries = len(column), found[name]
            count = len(entries) // width
            return (arb_mat(count, width, list(entries)) * arb_mat(width, 1, column)).entries()

        for broken in self.value("held", {}):
            yield "what the constraints hold", broken, zero
        for i in own:
            yield "a steady motion", self.value("second", {})[i], zero
        names = [*self.q, *self.u]
        columns = [self.slope("held", {name: arb(1)}) for name in names]
        for t in null_space([list(row) for row in zip(*columns, strict=True)], len(names)):
            along = dict(zip(names, t, strict=True))
            first, second = (self.slope(name, along) for name in ("first", "second"))
            z, zd, zdd = ([column[i] for i in own] for column in (t, first, second))
            parts = (times("mass", zdd), times("damping", zd), times("stiffness", z))
            for three in zip(*parts, strict=True):
                yield "M z'' + C z' + K z", sum(three, zero), zero
            for i, (place, reached) in enumerate(zip(t, times("reach", z), strict=False)):
                if any(entry != 0 for entry in found["reach"][n * i : n * (i + 1)]):
                    yield "G z", reached, place
            if linear.conjugate and all(entry.contains(0) for entry in t[: len(self.q)]):
                (ahead,), (behind,), (here,) = (
                    self.value("T", {name: s * k for name, k in along.items()}, Fraction(1))
                    for s in (1, -1, 0)
                )
                doubled = sum((a * b for a, b in zip(zd, times("mass", zd), strict=True)), zero)
                yield "z'^T M z'", doubled, ahead + behind - 2 * here
        for order, dots in enumerate(DOTS):
            for k, symbol in enumerate(linear.inputs):
                second = self.slope("second", {symbol.name + dots: arb(1)})
                left = times("mass", [second[i] for i in own])
                drive = found.get(f"inputs {order}", (zero,) * n * len(linear.inputs))
                for i in range(n):
                    yield "M z'' = E w", left[i], drive[len(linear.inputs) * i + k]


def null_space(rows: Sequence[Column], width: int) -> list[Column]:
    """A basis of the columns t with rows . t = 0, where slopes are known to `CLOSE`."""
    left, pivots = [list(row) for row in rows], []
    for row in range(len(left)):
        free = [c for c in range(width) if c not in pivots]
        best = max(free, key=lambda c, row=row: abs(left[row][c].mid()))  # type: ignore[misc]
        if abs(left[row][best]) < CLOSE:
            pivots.append(-1)
            continue
        pivots.append(best)
        left[row] = [entry / left[row][best] for entry in left[row]]
        for other in range(len(left)):
            if other != row:
                factor = left[other][best]
                left[other] = [a - factor * b for a, b in zip(left[other], left[row], strict=True)]
    basis = []
    for c in (c for c in range(width) if c not in pivots):
        t = [arb(int(i == c)) for i in range(width)]
        for row, pivot in enumerate(pivots):
            if pivot >= 0:
                t[pivot] = -left[row][c]
        basis.append(t)
    return basis


def drawn_point(
    given: Mapping[str, Expr], names: Sequence[str], seed: str = "", spread: int = 0
) -> Point:
    """Values of the point, and a draw for each name that has none.

    From 1/2 to 3/2, times a power of 2 up to 2^spread or its inverse.
    """
    builder = Builder()
    program = builder.program({name: read(builder, (value,)) for name, value in given.items()})
    free = {*names, *program.inputs} - given.keys()
    # Derivatives of inputs that are not given are zero.
    drawn = {
        name: Fraction(0) if name.endswith(DOTS[1:]) else _drawn(f"{seed} {name}", spread)
        for name in sorted(free)
    }
    with precision(BITS):
        point = {name: arb(v.numerator) / v.denominator for name, v in drawn.items()}
        known = {name: point[name] for name in program.inputs}
        return point | {n: value[0] for n, value in enclose(program, known, BITS).items()}


def _drawn(seed: str, spread: int) -> Fraction:
    source = Random(seed)
    return Fraction(source.randint(16, 48), 32) * Fraction(2) ** source.randint(-spread, spread)
