"""The headers: sizes, statuses and flags as the graphs have them, functions as they are defined."""

from collections.abc import Iterator

from pycparser import c_generator

from mechanics.compiled.c.lanes import FAR, WILD
from mechanics.compiled.translation_validation.status import BAD_INPUT, OK, OVERFLOW, SINGULAR
from mechanics.errors import ExpressionError
from mechanics.export.evidence.chain import Evidence
from mechanics.export.evidence.texts import FMA, odd_conditions
from mechanics.kernel import Finding, refuted, same, undecided
from mechanics.program.c.parse import parse
from mechanics.program.c.text import preprocess
from mechanics.program.c.types import parameters

CODES = {
    "OK": OK, "SINGULAR": SINGULAR, "OVERFLOW": OVERFLOW, "BAD_INPUT": BAD_INPUT,
    "BATCH_FAR": FAR, "BATCH_NOT_FINITE": WILD,
}  # fmt: skip
SIZE = "_SIZE"


def prove_headers(evidence: Evidence) -> Iterator[Finding]:
    """Decide for each header whether its numbers are those of the graphs."""
    headers = {name: text for name, text in evidence.texts.items() if name.endswith(".h")}
    prefixes = {k.symbol.removesuffix("_batch").removesuffix(f"_{k.function}").upper()
                for k in evidence.kernels}  # fmt: skip
    wanted = _wanted(evidence)
    yield from _prototypes(evidence, headers)
    yield from _declarations(evidence, headers)
    for file, text in headers.items():
        # What includes a header gets one reading of it, whatever compiles it.
        fused = FMA if file.endswith("_sine.h") else frozenset()
        if words := odd_conditions(text, file, fused.__contains__):
            yield undecided(f"{file}: conditions", f"refused: {words}")
        try:
            macros = preprocess(text, file, headers).macros
        except ExpressionError as error:
            yield undecided(f"{file}: macros", f"refused: {error}")
            continue
        # Longest first: the name of one library may begin that of another.
        known = sorted(prefixes, key=len, reverse=True)
        numbers = {name: body for name, body in macros.items() if body}
        needed = _needed(evidence, file, headers)
        if missing := needed - numbers.keys():
            both = ", ".join(sorted(needed)), ", ".join(sorted(needed & numbers.keys()))
            yield refuted(f"{file}: sizes", f"missing: {', '.join(sorted(missing))}", *both)
        values = {name: _value(name, known, wanted) for name in numbers}
        wrong = [
            f"{name} is {body}{_instead(name, known, wanted)}"
            for name, body in numbers.items()
            if values[name] != body
        ]
        if wrong:
            yield undecided(f"{file}: macros", f"refused: {', '.join(wrong)}")
        elif numbers:
            words = f"{len(numbers)} sizes and codes are those of the graphs"
            yield same(f"{file}: macros", numbers, values, words)


def _prototypes(evidence: Evidence, headers: dict[str, str]) -> Iterator[Finding]:
    """Every declaration of a kernel says what its definition says: names, types, order, sizes."""
    write = c_generator.CGenerator().visit
    for file in dict.fromkeys(kernel.file for kernel in evidence.kernels):
        try:
            source = parse(evidence.texts.get(file, ""), file, headers)
        except ExpressionError:
            continue  # told where it is read
        for name, node in source.functions.items():
            texts = {write(p.type) for p in source.prototypes[name]}
            if len(texts) > 1:
                words = f"it is declared as {' and as '.join(sorted(texts))}"
                yield refuted(f"{node.coord.file}: {name}", words, *sorted(texts)[:2])


def _declarations(evidence: Evidence, headers: dict[str, str]) -> Iterator[Finding]:
    """Headers for users declare the kernels, each once or more, and nothing else."""
    symbols = {kernel.symbol for kernel in evidence.kernels}
    declared: set[str] = set()
    for file, text in headers.items():
        try:
            source = parse(text, file, headers)
        except ExpressionError as error:
            yield undecided(f"{file}: declarations", f"refused: {error}")
            continue
        declared |= source.prototypes.keys() - source.functions.keys()
        # The inline sine is for the sources, and proved by itself.
        if file.endswith("_sine.h"):
            continue
        every = (*source.prototypes.values(), (*source.structs.values(),))
        own = [node for nodes in every for node in nodes if str(node.coord.file) == file]
        names = {node.name or "a struct" for node in own}
        if odd := sorted({*(names - symbols), *source.functions}):
            words = f"refused: no source defines {', '.join(odd)}"
            yield undecided(f"{file}: declarations", words)
    if missing := sorted(symbols - declared):
        words = f"refused: no header declares {', '.join(missing)}"
        yield undecided("declarations", words)


def _needed(evidence: Evidence, file: str, headers: dict[str, str]) -> set[str]:
    """Sizes of arguments of the kernels that a header declares."""
    try:
        source = parse(headers[file], file, headers)
    except ExpressionError:
        return set()  # told where it is read
    needed = []
    for kernel in evidence.kernels:
        ends = f"_{kernel.function}"
        for node in source.prototypes.get(kernel.symbol, ()) if not kernel.lanes else ():
            prefix = kernel.symbol.removesuffix(ends).upper()
            needed += [
                f"{prefix}_{p.name.upper()}{SIZE}"
                for p in parameters(node.type) if p.name in evidence.known.symbols
            ]  # fmt: skip
    return set(needed)


def _wanted(evidence: Evidence) -> dict[str, str]:
    """Number of every macro, by the end of its name."""
    found = {name: str(number) for name, number in CODES.items()}
    sizes = {group: len(symbols) for group, symbols in evidence.known.symbols.items()}
    for graph in evidence.graphs.values():
        sizes |= dict(graph.written.inputs)
        sizes |= {name: rows * columns for name, (rows, columns) in graph.written.shapes
                  if columns == 1 and name not in sizes}  # fmt: skip
    return found | {f"{name.upper()}{SIZE}": str(size) for name, size in sizes.items()}


def _value(name: str, prefixes: list[str], wanted: dict[str, str]) -> str | None:
    for prefix in prefixes:
        if name.startswith(f"{prefix}_") and name.removeprefix(f"{prefix}_") in wanted:
            return wanted[name.removeprefix(f"{prefix}_")]
    return None


def _instead(name: str, prefixes: list[str], wanted: dict[str, str]) -> str:
    value = _value(name, prefixes, wanted)
    return ", which is not supported" if value is None else f" instead of {value}"
