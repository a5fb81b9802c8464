"""SymPy's `KanesMethod`, on SymPy's own kinematics, with numbers put in."""

from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import Answer
from mechanics.errors import InputError
from mechanics.program.builder import Builder
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.sympy_reader import read
from mechanics.routes import kane_sympy

MANY = 4
"""Bodies in space up to which SymPy ends in seconds."""


def make(sympy: Any, ours: Ours, file: Path | None = None) -> Engine:
    """M and f of M u' = f."""
    scene = ours.scene
    if len(scene.bodies) > MANY or scene.constraints:
        raise InputError(
            f"{scene.name}: SymPy is asked about trees of up to {MANY} bodies: compare a part"
        )
    matrices = kane_sympy.derive(scene).textbook
    assert matrices is not None
    build, size = Builder(), len(scene.u)
    program = build.program({"entries": read(build, [*matrices.mass, *matrices.forcing])})
    known = dict.fromkeys(program.inputs, 0.0) | dict(ours.values)

    def parts(q: Any, v: Any) -> Any:
        state = {s.name: x for s, x in zip((*scene.q, *scene.u), (*q, *v), strict=True)}
        found = np.array(interpret(program, Arrays(), known | state)["entries"], dtype=float)
        return found[: size * size].reshape(size, size), found[size * size :]

    def mass_matrix(q: Any, v: Any) -> Any:
        return parts(q, v)[0]

    def inverse(q: Any, v: Any, a: Any) -> Any:
        mass, right = parts(q, v)
        return mass @ a - right

    def forward(q: Any, v: Any, forces: Any) -> Any:
        mass, right = parts(q, v)
        return np.linalg.solve(mass, right + forces)

    answers: dict[str, Answer] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: -parts(q, v)[1],
        "inverse_dynamics": inverse,
        "forward_dynamics": forward,
        "kinetic_energy": lambda q, v: v @ parts(q, v)[0] @ v / 2,
    }
    return Engine(f"sympy {sympy.__version__}", answers)
