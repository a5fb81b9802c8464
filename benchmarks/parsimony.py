"""What a model costs that holds only what is asked for, beside kernels by hand.

Run ``python -m benchmarks.parsimony`` in the project's root: operations, bytes of machine code and
time of everything that a model has, of forward dynamics alone, with parameters fixed, with terms
dropped, and of the kernels in ``benchmarks/kernels``. All of one system is timed in turn.
"""

import argparse
import platform
from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median

from benchmarks.hand import PEERS, Peer, counted
from benchmarks.machine_code import timed
from mechanics.compiled import Model, compile
from mechanics.compiled.c.source import function_source, signature
from mechanics.compiled.machine.native import find_compiler
from mechanics.errors import CompilerError


@dataclass(frozen=True)
class Variant:
    """Functions that are measured together."""

    label: str
    source: str
    names: tuple[str, ...]
    operations: int


def variants(peer: Peer) -> Iterator[Variant]:
    """Everything, less and less of it, and the kernels by hand."""
    yield _generated("everything", compile(peer.equations()))
    energies = ("forward_dynamics", "energy")
    yield _generated("forward dynamics and energy", compile(peer.equations(), outputs=energies))
    yield _generated("forward dynamics", peer.model())
    yield _by_hand("by hand", peer, "")
    dropped = ", ".join(f"{name} = {value}" for name, value in peer.dropped.items())
    yield _generated(f"dropped: {dropped}", peer.model(fixed=peer.dropped))
    yield _generated("all parameters fixed", peer.model(fixed=peer.fixed))
    yield _by_hand("all parameters fixed, by hand", peer, "_fixed")


def _generated(label: str, model: Model) -> Variant:
    # The C library has a function called step, which would be called in place of ours.
    names = {name: f"model_{name}" for name in model.casadi}
    parts = ["#include <math.h>"]
    for name, own in names.items():
        code = model.program(name)
        parts.append(function_source(code, model.entries, head=signature(code, name=own)))
    total = sum(counted(model, name).operations for name in names)
    return Variant(label, "\n".join(parts), tuple(names.values()), total)


def _by_hand(label: str, peer: Peer, suffix: str) -> Variant:
    kernel = peer.kernel(suffix)
    return Variant(label, peer.source, (kernel.name,), kernel.operations)


def table(peer: Peer, rounds: int, compiler: str) -> Iterator[str]:
    """Lines of the table of one system."""
    found = list(variants(peer))
    prepared = [timed(v.source, v.names, compiler) for v in found]
    times: list[list[float]] = [[] for _ in found]
    for _ in range(rounds):
        for functions, seconds in zip(prepared, times, strict=True):
            seconds.append(sum(function.run() for function in functions))
    yield f"\n| {peer.name} | functions | operations | bytes | ns a state |"
    yield "|---|---|---|---|---|"
    for variant, functions, seconds in zip(found, prepared, times, strict=True):
        size = sum(function.size for function in functions)
        yield (
            f"| {variant.label} | {len(functions)} | {variant.operations} | {size}"
            f" | {median(seconds):.1f} |"
        )


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=200, help="runs of each; medians are shown")
    options = parser.parse_args()
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler: set CC to one")
    print(f"{compiler} -O2, {platform.machine()}, medians of {options.rounds} rounds in turn")
    for peer in PEERS:
        for line in table(peer, options.rounds, compiler):
            print(line, flush=True)


if __name__ == "__main__":
    main()
