"""States drawn for numerical evidence: on the constraints, with velocities that these admit.

    phi(q) = 0       q <- q - P^T (P P^T)^-1 phi        P = dphi/dq                    (1)
    A u + a = 0      u <- u - A^T (A A^T)^-1 (A u + a)                                 (2)
    A w = 0          virtual velocities, by the same projection; time and inputs held fast

Numbers are small fractions that depend on the name of what they are for, so that every run draws
the same. Coordinates that (1) has moved become balls that hold an exact solution: for
q(y) = q_1 + P^T y the interval Newton step -(dphi/dy)^-1 phi(q_1) maps a box into itself. Only
the data of the declaration are read, for the reason that `mechanics.checks.virtual_power` gives.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from random import Random

from flint import arb, arb_mat, arb_series, fmpq
from sympy import Expr, Symbol
from sympy.physics.vector import dynamicsymbols

from mechanics.checks.jets import Instant, OutsideDomain
from mechanics.scene import Scene

DRAWS = 40
"""Draws before it is given up to find states on the constraints."""

STEPS = 60
NEAR = arb(2) ** -220
"""How close Newton's method has to come."""

BOX = arb(0, arb(2) ** -200)

Numbers = Sequence[arb]


@dataclass(frozen=True)
class State:
    """One state of a scene: numbers for everything but the accelerations.

    Attributes
    ----------
    index : int
        Of the draw.
    q, u : sequence of arb
        In the order of the declaration.
    """

    scene: Scene
    index: int
    q: Numbers
    u: Numbers

    def parameter(self, symbol: Symbol) -> arb:
        """From 1/2 to 1 where it is positive, from -1/4 to 1/4 where it may have either sign."""
        low, high = (16, 32) if symbol.is_positive else (-8, 8)
        return drawn(symbol.name, self.index, low, high)

    def plain(self, changes: Numbers = ()) -> dict[str, arb]:
        """By plain name: x, x_dot, speeds, inputs and their derivatives, time; u' where given."""
        names = [name_of(q) for q in self.scene.coordinates]
        table = dict(zip(names, self.q, strict=True))
        speeds = [name_of(u) for u, _ in self.scene.speeds] or [f"{name}_dot" for name in names]
        # Named as a person names them; this check asks nothing of how the scene does it.
        rates = [
            f"{name.removesuffix('_dot')}_ddot" if name.endswith("_dot") else f"{name}_dot"
            for name in speeds
        ]
        table |= dict(zip(speeds, self.u, strict=True))
        table |= dict(zip(rates, changes, strict=False))
        for function in self.scene.inputs:
            for order, dots in enumerate(("", "_dot", "_ddot", "_dddot")):
                table[name_of(function) + dots] = self._input(function, order)
        return table | {dynamicsymbols._t.name: self._time}

    def items(self) -> tuple[tuple[str, str], ...]:
        """Names and values for people."""
        table = self.plain() | {p.name: self.parameter(p) for p in self.scene.parameters}
        return tuple((name, value.str(20, radius=False)) for name, value in table.items())

    def motion(self, changes: Numbers) -> Instant:
        """The motion through the state with u' = changes."""
        rates = self.rates(self.u)
        if not self.scene.speeds:
            return self._instant(rates, [change / 2 for change in changes])

        def change(bends: Numbers) -> list[arb]:
            here = self._instant(rates, bends, self.u, changes)
            bent = [here.coefficients(rate)[1] for _, rate in self.scene.speeds]
            return [*bent, *(here.coefficients(r.square)[2] for r in self.scene.rotations)]

        bends = _solve_affine(change, [*changes, *self._kept])
        return self._instant(rates, bends, self.u, changes)

    def virtual_motions(self, count: int) -> Iterator[Instant]:
        """Motions along drawn virtual velocities that the constraints admit."""
        still = self.rates([arb(0)] * len(self.u))
        for k in range(count):
            free = [drawn(f"virtual {k} {i}", self.index, -40, 40) for i in range(len(self.u))]
            w = self._projected(free, moving=False)
            rates = [one - two for one, two in zip(self.rates(w), still, strict=True)]
            yield self._instant(rates, frozen=True)

    def rates(self, u: Numbers) -> list[arb]:
        """q' at speeds u."""
        if not self.scene.speeds:
            return list(u)

        def speeds(rates: Numbers) -> list[arb]:
            here = self._instant(rates)
            told = [here.coefficients(rate)[0] for _, rate in self.scene.speeds]
            return [*told, *(here.coefficients(r.square)[1] for r in self.scene.rotations)]

        return _solve_affine(speeds, [*u, *self._kept])

    @property
    def _kept(self) -> Numbers:
        """Rates of the norms of quaternions."""
        return [arb(0)] * len(self.scene.rotations)

    def on_constraints(self) -> "State":
        """The state moved to where the constraints hold, the coordinates first.

        Raises
        ------
        OutsideDomain
            When Newton's method does not come to a point that is proved to be on them.
        """
        closed = State(self.scene, self.index, self._closed(), self.u)
        return State(self.scene, self.index, closed.q, closed._projected(self.u, moving=True))

    def _closed(self) -> Numbers:
        closing = [c.expression for c in self.scene.constraints if c.holonomic]
        closing += [rotation.square - 1 for rotation in self.scene.rotations]
        if not closing:
            return self.q
        q = _column(self.q)
        for _ in range(STEPS):
            value, slope = self._closure(closing, q)
            if all(abs(entry) < NEAR for entry in value.entries()):
                break
            q = (q - slope.transpose() * (slope * slope.transpose()).solve(value)).mid()
        across = slope.transpose().mid()
        box = across * _column([BOX] * len(closing))
        _, slopes = self._closure(closing, q + box)
        step = (slopes * across).solve(value)
        if not all(BOX.contains_interior(entry) for entry in step.entries()):
            raise OutsideDomain
        return (q + box).entries()

    def _closure(self, closing: Sequence[Expr], q: arb_mat) -> tuple[arb_mat, arb_mat]:
        """phi and dphi/dq."""
        n = q.nrows()
        here = State(self.scene, self.index, q.entries(), self.u)
        columns = []
        for j in range(n):
            moved = here._instant([arb(int(i == j)) for i in range(n)], frozen=True)
            columns.append([moved.coefficients(e) for e in closing])
        value = [entry[0] for entry in columns[0]]
        slope = [[column[i][1] for column in columns] for i in range(len(closing))]
        return _column(value), arb_mat(slope)

    def _projected(self, u: Numbers, moving: bool) -> Numbers:
        """Equation (2); with a = 0 unless what is prescribed is moving."""
        if not self.scene.constraints:
            return u
        n = len(u)
        rest = self._forms([arb(0)] * n)
        units = [self._forms([arb(int(i == j)) for i in range(n)]) - rest for j in range(n)]
        A = arb_mat([unit.entries() for unit in units]).transpose()
        off = A * _column(u) + rest if moving else A * _column(u)
        return (_column(u) - A.transpose() * (A * A.transpose()).solve(off)).entries()

    def _forms(self, u: Numbers) -> arb_mat:
        """Every constraint's condition on the speeds: its rate where it is holonomic."""
        here = self._instant(self.rates(u), u=u)
        return _column(
            [here.coefficients(c.expression)[int(c.holonomic)] for c in self.scene.constraints]
        )

    def _instant(
        self, rates: Numbers, bends: Numbers = (), u: Numbers = (), changes: Numbers = (),
        frozen: bool = False,
    ) -> Instant:  # fmt: skip
        """Coordinates q + rates t + bends t^2, speeds u + changes t."""
        scene, motions = self.scene, {}
        for i, q in enumerate(scene.coordinates):
            motions[name_of(q)] = arb_series([self.q[i], rates[i], *bends[i : i + 1]])
        for i, (speed, _) in enumerate(scene.speeds):
            motions[name_of(speed)] = arb_series([*u[i : i + 1], *changes[i : i + 1]])
        for function in scene.inputs:
            value = [self._input(function, order) for order in range(3)]
            series = [value[0], value[1], value[2] / 2]
            motions[name_of(function)] = arb_series(series[:1] if frozen else series)
        motions[dynamicsymbols._t.name] = arb_series([self._time, arb(int(not frozen))])
        return Instant(motions, self.parameter)

    def _input(self, function: Expr, order: int) -> arb:
        return drawn(f"{name_of(function)} {order}", self.index, -40, 40)

    @property
    def _time(self) -> arb:
        return drawn("t", self.index, 16, 32)


def draw_states(scene: Scene, count: int) -> tuple[State, ...]:
    """So many states of a scene, or as many as were found; precision is the caller's."""
    found: list[State] = []
    for index in range(DRAWS):
        q = [drawn(name_of(function), index, -40, 40) for function in scene.coordinates]
        u = [drawn(f"u{i}", index, -40, 40) for i in range(len(scene.u))]
        try:
            found.append(State(scene, index, q, u).on_constraints())
        except (OutsideDomain, ArithmeticError, ValueError):
            # Arb says so where a matrix is singular there, or a series has no inverse.
            continue
        if len(found) == count:
            break
    return tuple(found)


def drawn(name: str, index: int, low: int, high: int) -> arb:
    """A multiple of 1/32 between low/32 and high/32, none of them near zero."""
    source = Random(f"{name} {index}")
    size = source.randint(max(low, high // 4, 1), high)
    return arb(fmpq(size if low > 0 else size * source.choice((-1, 1)), 32))


def name_of(function: Expr) -> str:
    """``"x"`` for x(t)."""
    return str(function.func.__name__)


def _column(values: Sequence[arb]) -> arb_mat:
    return arb_mat(len(values), 1, list(values))


def _solve_affine(function: Callable[[Numbers], Sequence[arb]], wanted: Numbers) -> list[arb]:
    """x with function(x) = wanted, for a function that is affine in x."""
    n = len(wanted)
    rest = function([arb(0)] * n)
    columns = [function([arb(int(i == j)) for i in range(n)]) for j in range(n)]
    slope = [[columns[j][i] - rest[i] for j in range(n)] for i in range(n)]
    right = [value - other for value, other in zip(wanted, rest, strict=True)]
    return list(arb_mat(slope).solve(_column(right)).entries())
