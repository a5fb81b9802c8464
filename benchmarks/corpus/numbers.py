"""Numbers that decide which statements are true, with nothing of `mechanics`.

    d/dt dL/dq' - dL/dq = Q

``truths.toml`` has T, V and Q of each scene, typed by hand in its author's letters; ``decide.toml``
has what vanishes where a statement is true, typed by hand from the statement. Both are evaluated
at drawn states, after SymPy's derivatives and NumPy's solution for the accelerations.
"""

import re
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp

HERE = Path(__file__).parent
NAME = re.compile(r"(?<![\w.])[A-Za-z]\w*")
FUNCTIONS = ("sin", "cos", "tan", "tanh", "acos", "atan", "sqrt", "sign", "Abs", "pi")
DRAWS = 4
SMALL = 1e-9


def table(name: str) -> dict[str, Any]:
    """One of the two files."""
    return tomllib.loads((HERE / name).read_text(encoding="utf-8"))


def expression(text: str) -> sp.Expr:
    """What was typed, each name a symbol."""
    names = {name: sp.Symbol(name) for name in NAME.findall(text) if name not in FUNCTIONS}
    return sp.sympify(text, locals=names)


class Truth:
    """The motion of a scene, by its Lagrangian."""

    def __init__(self, row: dict[str, Any]) -> None:
        self.names = row.get("q", row.get("speeds", "")).split()
        self.q, self.v, self.a = (
            sp.Matrix([sp.Symbol(name + dots) for name in self.names]) for dots in ("", "_d", "_dd")
        )
        self.t = sp.Symbol("t")
        self.kinetic, self.potential = expression(row.get("T", "0")), expression(row.get("V", "0"))
        self.loads = [expression(text) for text in row.get("Q", ["0"] * len(self.names))]
        self.lengths = [sp.Symbol(name) for name in row.get("lengths", "").split()]
        self.inputs = [sp.Symbol(name) for name in row.get("inputs", "").split()]
        self.still = {
            sp.Symbol(name): expression(text) for name, text in row.get("rest", {}).items()
        }
        self.also = {name: expression(text) for name, text in row.get("also", {}).items()}
        if "motion" in row:  # of speeds that are no derivatives, as it was typed
            self.v, self.a = self.q, self.v
            self.motion = sp.Matrix([expression(text) for text in row["motion"]])
        else:
            self.motion = self.euler_lagrange(self.kinetic - self.potential)
        self.mass = self.motion.jacobian(self.a)
        self.rest = self.motion.subs(dict.fromkeys(self.a, 0))

    def euler_lagrange(self, lagrangian: sp.Expr) -> sp.Matrix:
        """The left side minus the loads, in q, q' and q''."""
        p = sp.Matrix([sp.diff(lagrangian, v) for v in self.v])
        rate = p.jacobian(self.q) * self.v + p.jacobian(self.v) * self.a + p.diff(self.t)
        force = sp.Matrix([sp.diff(lagrangian, q) for q in self.q])
        return rate - force - sp.Matrix(self.loads)

    def first_order(self, of: sp.Expr) -> sp.Expr:
        """What is left where coordinates, their rates and inputs are small."""
        small = [*self.q, *self.v, *self.a, *self.inputs]
        zero = dict.fromkeys(small, 0)
        return sp.Add(of.subs(zero), *(sp.diff(of, s).subs(zero) * s for s in small))

    def quantities(self) -> dict[str, sp.Expr]:
        """What a statement may be about besides the motion."""
        lagrangian = self.kinetic - self.potential
        momenta = [sp.diff(lagrangian, v) for v in self.v]
        places = range(len(self.names))
        return {
            "KE": self.kinetic, "PE": self.potential, "LAG": lagrangian,
            "HAM": sum(p * v for p, v in zip(momenta, self.v, strict=True)) - lagrangian,
            **{f"p_{name}": p for name, p in zip(self.names, momenta, strict=True)}, **self.also,
            **{f"mass_{i + 1}{j + 1}": self.mass[i, j] for i in places for j in places},
        }  # fmt: skip

    def values(self, residuals: list[sp.Expr], seed: int) -> list[float]:
        """Sizes of the residuals at a drawn state, by the size of their terms."""
        draw = np.random.default_rng(seed)
        every = set().union(*(r.free_symbols for r in [*residuals, *self.mass, *self.rest]))
        at = {s: draw.uniform(0.4, 1.6) for s in sorted(every - set(self.a), key=str)}
        at |= {s: at[s] * (-1) ** seed for s in self.v if s in at}
        mass = np.array(self.mass.subs(at).evalf(), dtype=float)
        rest = np.array(self.rest.subs(at).evalf(), dtype=float)[:, 0]
        at |= dict(zip(self.a, np.linalg.solve(mass, -rest), strict=True))
        return [_size(r, at) for r in residuals]


def _size(residual: sp.Expr, at: dict[sp.Symbol, float]) -> float:
    terms = [abs(complex(term.subs(at))) for term in sp.Add.make_args(residual)]
    return abs(complex(residual.subs(at))) / max([1e-3, *terms])


@cache
def truth(scene: str) -> Truth:
    """The truth of a scene by its place, ``file.py:function``."""
    return Truth(table("truths.toml")[scene])


def holds(scene: str, rows: list[str]) -> bool:
    """Whether a statement is true by the numbers: all that its rows say vanishes."""
    of = truth(scene)
    residuals = [residual for row in rows for residual in _residuals(of, row)]
    return all(size < SMALL for seed in range(DRAWS) for size in of.values(residuals, seed))


def _residuals(of: Truth, row: str) -> list[sp.Expr]:
    """What vanishes; a word and a colon before it say that it is no plain residual."""
    word, _, text = row.rpartition(": ")
    quantities = {sp.Symbol(name): value for name, value in of.quantities().items()}
    typed = expression(text).subs(quantities)
    state = dict.fromkeys([*of.v, *of.a], 0)
    match word:
        case "":
            return [typed]
        case "lagrangian":  # its own equations hold along the motion
            return list(of.euler_lagrange(typed))
        case "energy":  # a constant, of the dimension of an energy: length to the power 2
            grown = sum(s * sp.diff(typed, s) for s in of.lengths)
            return [sp.diff(typed, s) for s in [*of.q, *of.v]] + [grown - 2 * typed]
        case "integral":  # its rate along the motion
            held = sp.Matrix([typed])
            rate = held.jacobian(of.q) * of.v + held.jacobian(of.v) * of.a + held.diff(of.t)
            return [rate[0]]
        case "damping":  # Rayleigh's function: its derivative is what the loads hold of the speed
            return [
                sp.diff(typed, v, 2) + sp.diff(Q, v) for v, Q in zip(of.v, of.loads, strict=True)
            ]
        case "rest":  # the motion can stay at this value of the only coordinate
            return [entry.subs(state).subs(of.q[0], typed) for entry in of.motion]
        case "frequency":  # angular, of a mode about rest: det(K - omega^2 M) = 0
            zero = dict.fromkeys([*of.v, *of.a, *of.q, sp.Symbol("t")], 0) | of.still
            stiff = of.motion.jacobian(of.q).subs(zero)
            return [(stiff - typed**2 * of.mass.subs(zero)).det()]
        case "linear":  # true to the first order about zero
            motion = of.motion.applyfunc(of.first_order)
            mass, rest = motion.jacobian(of.a), motion.subs(dict.fromkeys(of.a, 0))
            along = dict(zip(of.a, -mass.inv() * rest, strict=True))
            return [of.first_order(typed).subs(along)]
    raise ValueError(row)
