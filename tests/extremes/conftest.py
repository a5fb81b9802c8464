"""Walks to the extremes that the tests share, made once."""

import functools
from collections.abc import Callable

import pytest

from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.extremes import Extremes, extremes
from systems import ALL, SEED, VARIANTS, pendulum_chain

SCENES = {system.name: system.scene for system in (*ALL, *VARIANTS)}
PATHS = {system.name: system.paths for system in (*SEED, *VARIANTS)}


@functools.cache
def _derived(system: str, route: str) -> Equations:
    scene = pendulum_chain.scene(1) if system == "one_link" else SCENES[system]()
    return derive(scene, route)


@functools.cache
def _walked(system: str) -> Extremes:
    # Few points for the pairs: lines, paths and mixed points are all there.
    equations = _derived(system, "kane")
    return extremes(equations, name=system, paths=PATHS.get(system, ()), paired=600)


@pytest.fixture(scope="session")
def derived() -> Callable[[str, str], Equations]:
    return _derived


@pytest.fixture(scope="session")
def walked() -> Callable[[str], Extremes]:
    return _walked
