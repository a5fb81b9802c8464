"""Functions of a C folder: which function of the model each is, and what its arguments are."""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.program.c.function import Parameter

COUNT, STRIDE = "count", "stride"
"""The first arguments of a function of many states."""


@dataclass(frozen=True)
class Kernel:
    """One function of a C text, and what it should be.

    Attributes
    ----------
    function : str
        Name in the model.
    symbol : str
        Name in C.
    kind : str
        ``"double"`` or ``"float"``.
    shared : tuple of str or None
        For a function of many states the inputs that all share; None for one of one state.
    """

    function: str
    symbol: str
    file: str
    kind: str
    shared: tuple[str, ...] | None = None

    @property
    def lanes(self) -> bool:
        """Whether it takes many states."""
        return self.shared is not None


def parameters(
    kernel: Kernel, groups: Sequence[tuple[str, int]], outputs: Sequence[tuple[str, int]]
) -> list[Parameter]:
    """What the arguments of a C function are, with arrays of these names and sizes."""
    given = [Parameter(COUNT, "size_t"), Parameter(STRIDE, "size_t")] if kernel.lanes else []
    for group, size in groups:
        moving = kernel.shared is not None and group not in kernel.shared
        given.append(Parameter(group, kernel.kind, size, False, STRIDE if moving else ""))
    for name, size in outputs:
        given.append(Parameter(name, kernel.kind, size, True, STRIDE if kernel.lanes else ""))
    return given
