"""Scenes that several laws ask for before they run, each built once a process."""

from collections.abc import Callable
from functools import cache

from mechanics.scene import Scene


@cache
def built(make: Callable[[], Scene]) -> Scene:
    return make()
