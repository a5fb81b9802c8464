"""The one namespace of a model: what a scene wants computed, beside what every model has."""

import re
from collections import Counter
from keyword import iskeyword

from mechanics.errors import SceneError
from mechanics.scene.declaration import Declaration
from mechanics.scene.outputs import JACOBIAN
from mechanics.scene.symbols import name_of
from mechanics.scene.wellformed import rate_names

_WORDS = """
    angular backend batch_kernel buffer c casadi compiler constants coordinate_rates energy jax
    entries equations evaluate fixed flags forces forcing form forward_dynamics
    forward_dynamics_prepared generalized h inputs inverse_dynamics jacobians kernel kinetic
    kinetic_energy linear mass_matrix momenta multipliers numbers output p potential
    potential_energy prepare program programs q q_next qd quantities rates reactions residual
    right_hand_side step t total total_energy typical u u_next ud ud_inputs ud_p ud_q ud_u
    vectorised
"""
RESERVED = frozenset(_WORDS.split())
"""Functions, attributes, arrays and columns of every model."""

NAME = re.compile(r"(?!single_)[a-z]\w*(?<!_batch)(?<!_prepared)(?<!_watched)", re.ASCII | re.I)
"""Of a C function that differs from those in single precision and for many states."""


def check_outputs(scene: Declaration) -> None:
    """Names of outputs are names of functions, and differ from everything else in a model.

    Raises
    ------
    SceneError
        Names the output and what it collides with.
    """
    taken = dict.fromkeys(RESERVED, "part of every model")
    taken |= rate_names(scene)
    taken |= {symbol.name: "a parameter" for symbol in scene.parameters}
    taken |= {reaction.name: "a reaction" for reaction in scene.reactions}
    taken |= {name_of(f): "a coordinate or an input" for f in (*scene.coordinates, *scene.inputs)}
    taken |= {name_of(u): "a speed" for u, _ in scene.speeds}
    own: Counter[str] = Counter()
    for name, output in scene.outputs.items():
        if not NAME.fullmatch(name) or iskeyword(name):
            raise SceneError(
                f"output {name!r}: it cannot be the name of a function: give letters, digits and"
                " underscores, as in tool_2"
            )
        given = {name, f"{name}{JACOBIAN}", *(f"{name}{end}" for end, _ in output.entries)}
        own.update(given)
        for one in sorted(given):
            if one in taken or own[one] > 1:
                raise SceneError(
                    f"output {name}: there is {one} already, {taken.get(one, 'of another output')}:"
                    " rename the output"
                )
