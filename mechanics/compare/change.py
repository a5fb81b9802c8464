"""A change of a scene: what engines add, leave out or take otherwise; and inputs for it.

masses + dm, inertias + dI, gravity + dg, loads (1 - left out)

All changes are inputs of one program: the scene is derived once, and a changed scene is other
numbers in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from mechanics.mechanism import GROUND, Field, Line, Mass, Mechanism, Push, Torsion
from mechanics.program.vectors import scale

Array = NDArray[np.float64]
AXES = "xyz"


@dataclass(frozen=True, eq=False)
class Change:
    """In what a scene is changed; None for nothing. A row for each state may stand before.

    Attributes
    ----------
    gravity : (3,)
        To be added to the field, in the inertial frame, m/s^2.
    masses : (bodies,)
        To be added, kg.
    inertias : (bodies, 3, 3)
        To be added, about the mass centres in the frames of the bodies, kg m^2.
    armature, damping, friction : (speeds,)
        A, b and c of equation (1).
    loads : (loads,)
        What part of each load but gravity is left out, in the order of `Ours.loads`.
    step : float or (N,)
        h of an implicit step, in s: what is damped is damped at its end, by D (v + h a).
    opened : bool
        Whether the constraints of the scene are left out.
    locked : mapping of int to float
        Speeds that are zero, and the values at which their coordinates stay.
    """

    gravity: Array | None = None
    masses: Array | None = None
    inertias: Array | None = None
    armature: Array | None = None
    damping: Array | None = None
    friction: Array | None = None
    loads: Array | None = None
    step: float | Array = 0.0
    opened: bool = False
    locked: Mapping[int, float] = field(default_factory=dict)

    def __bool__(self) -> bool:
        """Whether something is changed."""
        added = (getattr(self, name) for name in AMOUNTS)
        return bool(self.opened or self.locked or any(np.any(x) for x in added if x is not None))

    def repeated(self, times: int) -> Change:
        """The change for so many copies of the states, where it has a row for each of these."""
        plain = {"inertias": 3, "step": 0}
        rows: dict[str, Any] = {
            name: np.concatenate([entries] * times)
            for name in AMOUNTS
            if np.ndim(entries := getattr(self, name)) > plain.get(name, 1)
        }
        return replace(self, **rows) if rows else self


NOTHING = Change()
AMOUNTS = ("gravity", "masses", "inertias", "armature", "damping", "friction", "loads", "step")
"""Fields of a change that are added."""


def changeable(mechanism: Mechanism, bare: Sequence[Mass] = ()) -> Mechanism:
    """The mechanism with inputs for what a `Change` adds.

    Parameters
    ----------
    bare : sequence of Mass
        Bodies that are added.
    """
    build = mechanism.builder

    def changed(place: int, body: Mass) -> Mass:
        inertia = body.inertia
        if inertia is not None:
            inertia = tuple(
                tuple(entry + build.input(_entry(place, i, k)) for k, entry in enumerate(row))
                for i, row in enumerate(inertia)
            )
        return replace(body, mass=body.mass + build.input(f"added_mass_{place}"), inertia=inertia)

    kept = {load.name: build.one - build.input(_left(k)) for k, load in enumerate(loads(mechanism))}
    pull = tuple(build.input(f"added_{axis}") for axis in AXES)
    count, more = len(mechanism.bodies), len(bare)
    return replace(
        mechanism,
        bodies=tuple(changed(k, body) for k, body in enumerate((*mechanism.bodies, *bare))),
        parents=(*mechanism.parents, *[GROUND] * more),
        order=(*mechanism.order, *range(count, count + more)),
        joints=(*mechanism.joints, *[()] * more),
        fields=(*mechanism.fields, Field("added gravity", ((0, pull),))),
        lines=tuple(
            replace(
                line,
                stiffness=line.stiffness * kept[line.name],
                coefficient=line.coefficient * kept[line.name],
            )
            for line in mechanism.lines
        ),
        pushes=tuple(
            replace(push, vector=tuple((f, scale(kept[push.name], v)) for f, v in push.vector))
            for push in mechanism.pushes
        ),
        torsions=tuple(
            replace(spring, stiffness=spring.stiffness * kept[spring.name])
            for spring in mechanism.torsions
        ),
    )


def inputs(mechanism: Mechanism, change: Change) -> dict[str, Array]:
    """Values of the inputs for a change, by name."""
    found: dict[str, Array] = {}
    if change.gravity is not None:
        found |= {f"added_{e}": change.gravity[..., k] for k, e in enumerate(AXES)}
    if change.loads is not None:
        found |= {_left(k): change.loads[..., k] for k in range(len(loads(mechanism)))}
    for place in range(len(mechanism.bodies)):
        if change.masses is not None:
            found[f"added_mass_{place}"] = change.masses[..., place]
        if change.inertias is not None:
            own = change.inertias[..., place, :, :]
            found |= {_entry(place, i, k): own[..., i, k] for i in range(3) for k in range(3)}
    return found


def loads(mechanism: Mechanism) -> tuple[Line | Push | Torsion, ...]:
    """All but gravity, in the order of `Change.loads`."""
    return (*mechanism.lines, *mechanism.pushes, *mechanism.torsions)


def _left(place: int) -> str:
    return f"left_out_{place}"


def _entry(place: int, i: int, k: int) -> str:
    low, high = sorted((i, k))
    return f"added_inertia_{place}_{AXES[low]}{AXES[high]}"
