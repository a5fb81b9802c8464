"""Which faults are planted in which scene: all whose code it calls, as far as a budget goes.

    planted = every k-th of the faults that a scene reaches,  k = ceil(faults * calls / budget)

`calls` counts the Python functions that a run of the scene without a fault calls, which is what a
trial takes at most, on any machine. The first that is taken is another one from scene to scene, so
that large scenes together take what each of them leaves out. Scenes made for faults take all.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from benchmarks.faults.fault import Fault, place_of, planted
from benchmarks.faults.scenes import OWN

LEAST = 8
"""Faults that every scene takes, however large it is."""


@dataclass(frozen=True)
class Plan:
    """What is planted in one scene.

    Attributes
    ----------
    calls : int
        Of Python functions, by a run without a fault.
    reached : tuple of Fault
        Those in functions that it calls.
    planted : tuple of Fault
        Some of these, or all.
    """

    scene: str
    calls: int
    reached: tuple[Fault, ...]
    planted: tuple[Fault, ...]


def plans(
    faults: Sequence[Fault], clean: Mapping[str, Mapping[str, Any]], budget: int
) -> list[Plan]:
    """What is planted in each scene.

    Parameters
    ----------
    clean : mapping of str to mapping
        Of each scene, ``"calls"``, the functions that it calls, and ``"count"``, how often.
    budget : int
        Calls that the trials of one shipped system may take.
    """
    places = [place_of(planted(fault)[0].__code__) for fault in faults]
    made = []
    for i, (scene, entry) in enumerate(clean.items()):
        called = set(entry["calls"])
        reached = tuple(f for f, place in zip(faults, places, strict=True) if place in called)
        step = 1 if scene in OWN else stride(len(reached), entry["count"], budget)
        made.append(Plan(scene, entry["count"], reached, reached[i % step :: step]))
    return made


def stride(faults: int, calls: int, budget: int) -> int:
    """k: 1 where a budget takes all, never so large that fewer than `LEAST` are left."""
    return max(1, min(-(-faults * calls // budget), faults // LEAST))
