"""The evidence of a model that is written beside its C: which graphs, which functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from mechanics.compiled import Model
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.custody.code import Code, code_of
from mechanics.compiled.custody.derived import derived
from mechanics.compiled.custody.graph import STEP
from mechanics.compiled.custody.kernel import Kernel
from mechanics.compiled.custody.prove import Graph
from mechanics.compiled.programs import PARTS, WHOLE
from mechanics.export.evidence.chain import Evidence
from mechanics.export.precision import Part


def evidence_of(
    model: Model,
    parts: Sequence[Part],
    names: Sequence[str],
    many: Sequence[str],
    texts: Mapping[str, str],
) -> Evidence:
    """What is known about the files of a model before they are written.

    Parameters
    ----------
    model : Model
    parts : sequence of Part
        Precisions.
    names, many : sequences of str
        Functions of one state, and those that are there for many, too.
    texts : mapping of str to str
        C files and headers.
    """
    codes: dict[str, Code] = {}
    graphs: dict[str, Graph] = {}
    for name in names:
        whole = WHOLE if name in PARTS else name
        if whole not in codes:
            codes[whole] = code_of(*model.casadi.exact(whole))
        graphs[name] = Graph(codes[whole], model.program(name))
    rates = code_of(*model.casadi.exact_rates()) if STEP in names else None
    kernels: list[Kernel] = []
    for part in parts:
        own, file = part.prefix, f"{part.prefix}.c"
        kernels += [Kernel(name, f"{own}_{name}", file, part.kind) for name in names]
        batch = f"{own}_batch.c"
        kernels += [Kernel(n, f"{own}_{n}_batch", batch, part.kind, SHARED) for n in many]
    return Evidence(derived(model.casadi, names), graphs, rates, tuple(kernels), dict(texts))
