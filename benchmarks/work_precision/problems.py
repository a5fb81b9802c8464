"""The problems, each in the format of its collection.

IFToMM: Library of Computational Benchmark Problems of the IFToMM Technical Committee for Multibody
Dynamics, A01 to A04 (M. Gonzalez, F. Gonzalez, A. Luaces and J. Cuadrado, A collaborative
benchmarking framework for multibody system dynamics, Engineering with Computers 26, 2010): 10 s,
measured by the largest error of the energy, in J. Test Set: F. Mazzia and C. Magherini, Test Set
for Initial Value Problem Solvers, University of Bari (2008): significant correct digits (scd) of
the end. SciML: benchmarks of SciMLBenchmarks.jl that are mechanics, by the energy or by the end.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from math import pi

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from sympy import Expr, lambdify
from sympy.physics.mechanics import dynamicsymbols

from benchmarks.work_precision import scenes
from mechanics.scene import Scene
from systems import andrews, double_pendulum, four_bar_chain
from tests.spatial_loops import bricard

Array = NDArray[np.float64]
ENERGY, DIGITS, MIXED = "energy", "digits", "mixed"


@dataclass(frozen=True)
class Problem:
    """What is integrated, and how the collection measures it.

    Attributes
    ----------
    name, collection : str
    scene : callable
    duration : float
        In s.
    measure : str
        ``"energy"``: its largest error along the way, in J; ``"digits"``: scd at the end;
        ``"mixed"``: mescd, where an entry ends near zero.
    levels : tuple of float
        Errors of the energy, or numbers of digits, at which work is compared.
    initial, parameters : mapping
        What differs from the example and the typical values of the scene.
    compared : tuple of str
        Entries of the state whose digits count; all if empty.
    published : mapping
        The end, as the collection gives it.
    energy : callable, optional
        Of states (k, n + m), where the scene does not tell it.
    solution : callable, optional
        Of times, to states: where it is known otherwise than by a run with many digits.
    """

    name: str
    collection: str
    scene: Callable[[], Scene]
    duration: float
    measure: str = DIGITS
    levels: tuple[float, ...] = (3, 6, 9, 12)
    initial: dict[str, float] = field(default_factory=dict)
    parameters: dict[str, float] = field(default_factory=dict)
    compared: tuple[str, ...] = ()
    published: dict[str, float] = field(default_factory=dict)
    energy: Callable[[Array], Array] | None = None
    solution: Callable[[Array], Array] | None = None


def four_bars(times: Array, loops: int) -> Array:
    """A02 by its one freedom: loops + 1 bars that turn and loops bars that move with their ends.

    ((loops + 1) / 3 + loops) a'' = -((loops + 1) / 2 + loops) g cos a
    """
    ratio = 9.81 * ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
    found = solve_ivp(
        lambda t, y: (y[1], -ratio * np.cos(y[0])), (0, times[-1]), (pi / 2, -1.0), "DOP853", times,
        rtol=3e-14, atol=1e-14,
    ).y  # fmt: skip
    turning = np.tile([1.0, 0.0], loops + 1)[: 2 * loops + 1]
    return np.hstack([np.outer(found[0], turning), np.outer(found[1], turning)])


def _energy(potential: Expr) -> Callable[[Array], Array]:
    at = lambdify(dynamicsymbols("q1 q2"), potential)

    def energy(states: Array) -> Array:
        q1, q2, u1, u2 = states.T
        return np.asarray((u1**2 + u2**2) / 2 + at(q1, q2))

    return energy


PLEIADES_END = {
    "x1": 0.3706139143970502, "x2": 3.237284092057233, "x3": -3.222559032418324,
    "x4": 0.6597091455775310, "x5": 0.3425581707156584, "x6": 1.562172101400631,
    "x7": -0.7003092922212495, "y1": -3.943437585517392, "y2": -3.271380973972550,
    "y3": 5.225081843456543, "y4": -2.590612434977470, "y5": 1.198213693392275,
    "y6": -0.2429682344935824, "y7": 1.091449240428980,
}  # fmt: skip
J = (1e-1, 1e-3, 1e-6, 1e-9)

PROBLEMS: tuple[Problem, ...] = (
    Problem("A01", "IFToMM", scenes.pendulum, 10.0, ENERGY, J),
    Problem("A01 by x and y", "IFToMM", scenes.pendulum_by_place, 10.0, ENERGY, J),
    *(Problem(f"A02, {n} loops", "IFToMM", partial(four_bar_chain.scene, n), 10.0, ENERGY, J,
              {"q0": pi / 2, "q1": 0.0, "q0_dot": -1.0}, solution=partial(four_bars, loops=n))
      for n in (2, 10, 40)),
    Problem("A03", "IFToMM and Test Set", andrews.scene, andrews.END, DIGITS, (3, 6, 9, 10),
            compared=tuple(andrews.ANGLES), published=andrews.ANGLES),
    Problem("A04", "IFToMM", lambda: replace(bricard(), redundant="drop"), 10.0, ENERGY, J),
    Problem("Pleiades", "Test Set and SciML", scenes.pleiades, 3.0, published=PLEIADES_END),
    Problem("three bodies", "SciML", scenes.three_bodies, 2 * 17.0652165601579625588917206249,
            MIXED, (1, 3, 5, 7), published={"x": 0.994, "y": 0.0}),
    Problem("rigid body", "SciML", scenes.rigid_body, 10.0, compared=("y1", "y2", "y3")),
    Problem("Henon-Heiles", "SciML", scenes.henon_heiles, 100.0, ENERGY, (1e-3, 1e-6, 1e-9, 1e-12),
            energy=_energy(scenes.HENON_HEILES)),
    Problem("quadrupole boson", "SciML", scenes.quadrupole_boson, 100.0, ENERGY, (1, *J[1:]),
            energy=_energy(scenes.QUADRUPOLE_BOSON)),
    Problem("pendulum", "SciML", scenes.pendulum, 100.0,
            initial={"theta": -pi / 2, "theta_dot": 2 * 0.999}, parameters={"g": 1.0}),
    Problem("double pendulum", "SciML", double_pendulum.scene, 10.0),
)  # fmt: skip
