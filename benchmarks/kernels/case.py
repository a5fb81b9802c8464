"""What all kernels compute: accelerations of the cart with n links, at the same random states."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled import Model, compile
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from systems import pendulum_chain

Array = NDArray[np.float64]
SHORT = 5


@dataclass(frozen=True, eq=False)
class Case:
    """States as structures of arrays, one column a state.

    Attributes
    ----------
    model : Model
        Forward dynamics only.
    q, u : (links + 1, count)
        Angles are absolute.
    inputs : (1, count)
        Force on the cart, in N.
    p : (2 links + 2,)
        g, lengths, masses.
    expected : (links + 1, count)
        Accelerations, by the scalar kernel of the model.
    """

    links: int
    model: Model
    q: Array
    u: Array
    inputs: Array
    p: Array
    expected: Array

    @property
    def count(self) -> int:
        """Number of states."""
        return self.q.shape[1]

    @property
    def lengths(self) -> Array:
        """Of the links, in m."""
        return self.p[1 : 1 + self.links]

    @property
    def masses(self) -> Array:
        """Of the cart and at the ends of the links, in kg."""
        return self.p[1 + self.links :]


@cache
def equations(links: int) -> Equations:
    """Equations of motion: of short chains those that take the fewest operations, else by free
    bodies, the quickest of the routes."""
    return derive(pendulum_chain.scene(links), "kane" if links <= SHORT else "free_body")


@cache
def model(links: int, form: str = "auto") -> Model:
    """Forward dynamics of the chain."""
    return compile(
        equations(links), form=form, outputs=("forward_dynamics",), flags="-O3 -march=native"
    )


@cache
def case(links: int, count: int) -> Case:
    """The chain at `count` random states, the same ones every time."""
    random = np.random.default_rng(links)
    q = random.uniform(-3, 3, (links + 1, count))
    u = random.uniform(-2, 2, (links + 1, count))
    inputs = random.uniform(-3, 3, (1, count))
    p = np.concatenate([[9.81], random.uniform(0.7, 1.3, 2 * links + 1)])
    chain = model(links)
    expected = chain.forward_dynamics(q.T.copy(), u.T.copy(), inputs=inputs.T.copy(), p=p)
    return Case(links, chain, q, u, inputs, p, expected.T)
