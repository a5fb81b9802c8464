"""The files of a folder: each is looked at by a step, or is what `write_c` writes, or is named.

    manifest, equations.json, graphs.json = the same printed again from scene, graphs and findings
    build files, loader, self-tests = their text, made once more from graphs and tables
    comments and code of headers = those printed again

What a build may find besides, such as a math.h beside the files, is named.
"""

import ast
import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from sympy import Symbol

from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.programs.of_model import PARTS
from mechanics.compiled.quantities import Quantity
from mechanics.compiled.reduced import FILE as REDUCTION
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.errors import ExpressionError
from mechanics.export.batch import batched
from mechanics.export.batch_selftest import batch_selftest
from mechanics.export.contents import Contents, of_quantities
from mechanics.export.evidence.chain import Chain
from mechanics.export.evidence.claims import prove_claims
from mechanics.export.evidence.comments import prove_code, prove_comments
from mechanics.export.evidence.equations import FILE as EQUATIONS
from mechanics.export.evidence.equations import equations_text
from mechanics.export.evidence.graphs import FILE as GRAPHS
from mechanics.export.evidence.graphs import graphs_text
from mechanics.export.evidence.read import NEEDED, Folder
from mechanics.export.evidence.record import by_subject, once, record_again
from mechanics.export.folder import MANIFEST
from mechanics.export.implementation import code_files
from mechanics.export.loader import loader
from mechanics.export.manifest import TOOLS, described, kernel_records
from mechanics.export.package import build_files
from mechanics.export.precision import Part, named_parts
from mechanics.export.selftest import selftest
from mechanics.export.vectors import Vector
from mechanics.kernel import Finding, same, undecided
from mechanics.program.c.literal import literal
from mechanics.program.routine import Routine

TABLE = r"    static const \w+ {name}\[\d+\]\[\d+\] = \{{\n(.*?)\n    \}};"
TOLD = ("system", "form", "reciprocals", "kernels", "chain", "files", "versions")
"""Of a manifest, beside what scene and graphs give again: other steps look at form, reciprocals and
hashes, none at versions."""
PROGRAM = ("values", "inputs", "operations", "outputs")
"""Of what was derived, as operations."""
ODD = (KeyError, TypeError, ValueError, IndexError, AttributeError, SyntaxError, ExpressionError)
"""What reading a text raises that is not as it was written."""
UNREPEATED = "only the whole model, derived again from its scene, shows it"


def prove_files(
    folder: Folder, again: Contents | None, found: Chain, derived: Derived | None = None,
    looked: Sequence[str] = (),
) -> Iterator[Finding]:  # fmt: skip
    """Decide about what stands in a folder, and what the manifest says of it.

    Parameters
    ----------
    again : Contents or None
        What a scene that was derived again says of the functions; without it, the manifest does.
    found : Chain
        What was found about the functions.
    derived : Derived, optional
        What was derived again.
    looked : sequence of str
        Files that another step has looked at.
    """
    prefix = str(folder.manifest.get("prefix"))
    parts = [one for one in named_parts(prefix, "both") if f"{one.prefix}.c" in folder.texts]
    for name in folder.misread:
        yield _odd(name, "the manifest does not list it, and a build may read it")
    try:
        contents = again or as_claimed(folder)
    except ODD as error:
        yield _odd("folder", f"what is written cannot be made again: {error}")
        return
    yield from _texts(folder, prefix, parts, contents, looked)
    source = ("scene and " if again else "") + "graphs"
    yield from _manifest(folder, contents, prefix, parts, found, source)
    yield from _evidence(folder, derived, source)
    for part in parts:
        many = _many(folder, part)
        try:
            wanted = code_files(contents, part, many)
        except ODD as error:
            yield _odd(f"{part.prefix}.c", f"what is written cannot be made again: {error}")
            continue
        yield from prove_comments(folder.texts, wanted, again is not None)
        yield from prove_code({n: t for n, t in wanted.items() if n.endswith(".h")}, folder.texts)


def as_claimed(folder: Folder) -> Contents:
    """What manifest and loader say of the functions; only names and sizes are the graphs' own."""
    arrays = {
        str(name): tuple(
            Quantity(Symbol(e["name"]), e["unit"], e["meaning"]) for e in entries
        )
        for name, entries in folder.manifest["arrays"].items()
    }  # fmt: skip
    prefix = str(folder.manifest.get("prefix"))
    typical = _typical(folder.texts.get(f"{prefix}_loader.py", ""))
    if typical and list(typical) != [entry.name for entry in arrays.get("p", ())]:
        raise ExpressionError("the loader has typical values of other parameters")
    return Contents(
        str(folder.manifest["scene"]), folder.route, arrays, tuple(typical.values()),
        folder.fixed, *_programs(folder),
    )  # fmt: skip


def as_derived(folder: Folder, graphs: Graphs) -> Contents:
    """What a scene that was derived again says of them."""
    scene, route = graphs.derived.scene.name, graphs.derived.route
    fixed = {symbol.name: str(value) for symbol, value in graphs.fixed.items()}
    return of_quantities(
        scene, route, graphs.quantities, dict(sorted(fixed.items())), *_programs(folder)
    )


def _programs(folder: Folder) -> tuple[dict[str, Routine], int]:
    """What the C was printed from, and its divisions before divisors were shared."""
    graphs = folder.evidence.graphs
    divisions = (g.code.routine.divisions for name, g in graphs.items() if name not in PARTS)
    return {name: graph.written for name, graph in graphs.items()}, sum(divisions)


def _odd(name: str, words: str) -> Finding:
    return undecided(name, f"refused: {words}")


def _many(folder: Folder, part: Part) -> tuple[str, ...]:
    there = f"{part.prefix}_batch.c" in folder.texts
    return batched(tuple(folder.evidence.graphs)) if there else ()


def _wanted_kernels(folder: Folder, parts: Sequence[Part]) -> list[Kernel]:
    """Every function of the graphs in every file of C that is there."""
    names = tuple(folder.evidence.graphs)
    wanted: list[Kernel] = []
    for part in parts:
        own, kind = part.prefix, part.kind
        wanted += [Kernel(n, f"{own}_{n}", f"{own}.c", kind) for n in names]
        batch = f"{own}_batch.c"
        many = _many(folder, part)
        wanted += [Kernel(n, f"{own}_{n}_batch", batch, kind, SHARED) for n in many]
    return wanted


def _manifest(
    folder: Folder, contents: Contents, prefix: str, parts: Sequence[Part], found: Chain,
    source: str,
) -> Iterator[Finding]:  # fmt: skip
    """Whether the manifest is what is printed again."""
    stored = dict(folder.manifest)
    kernels = _wanted_kernels(folder, parts)
    if not kernels:
        yield _odd(str(folder.path.name), "it holds no function that is known")
    again = {**described(contents, prefix), **{key: stored.get(key) for key in TOLD}}
    again["kernels"] = {one["symbol"]: one for one in kernel_records(kernels)}
    system, versions = stored.get("system"), stored.get("versions")
    again["system"] = system if isinstance(system, str) else None
    told = versions if isinstance(versions, dict) else {}
    again["versions"] = {tool: str(told.get(tool)) for tool in TOOLS}
    try:
        stored["kernels"] = once(stored["kernels"], "symbol")
        # Who proved nothing claims nothing.
        if stored.get("chain") != {}:
            stored["chain"] = by_subject(stored["chain"])
            again["chain"] = record_again(stored["chain"], found, folder.evidence.kernels)
    except ODD as error:
        yield _odd(f"{MANIFEST}: chain or kernels", f"no record: {type(error).__name__} {error}")
        return
    # As JSON has it: tuples are lists.
    yield from prove_claims(MANIFEST, stored, json.loads(json.dumps(again)), source)


def _evidence(folder: Folder, derived: Derived | None, source: str) -> Iterator[Finding]:
    """Whether the files of evidence say nothing but what is read in them, or was derived again."""
    known, graphs = folder.evidence.known, folder.evidence.graphs
    for file, text in (
        (EQUATIONS, equations_text(derived or known)),
        (GRAPHS, graphs_text(graphs, folder.evidence.rates)),
    ):
        stored, again = json.loads(folder.texts[file]), json.loads(text)
        if file == EQUATIONS and any(stored.get(key) != again[key] for key in PROGRAM):
            # Other operations may say the same: functions are compared by mathematics.
            yield _odd(f"{file}: program", "it is not the one that this version derives")
            stored, again = ({k: v for k, v in one.items() if k not in PROGRAM}
                             for one in (stored, again))  # fmt: skip
        yield from prove_claims(file, stored, again, source)


def _texts(
    folder: Folder, prefix: str, parts: Sequence[Part], contents: Contents, others: Sequence[str]
) -> Iterator[Finding]:
    """Whether files that no other step looks at are what is written."""
    scene, graphs = contents.scene, folder.evidence.graphs
    looked = {kernel.file for kernel in folder.evidence.kernels}
    many = tuple(dict.fromkeys(name for part in parts for name in _many(folder, part)))
    looked |= {f"{part.prefix}{end}.h" for part in parts for end in ("", "_batch", "_sine")}
    made: list[Callable[[], dict[str, str]]] = []
    made += [lambda: build_files(scene, prefix, parts, bool(many))] if parts else []
    made += (
        [lambda: {f"{prefix}_loader.py": loader(contents, prefix, parts, many)}] if graphs else []
    )
    for part in parts:
        made.append(partial(_selftests, folder, scene, part))
    wanted: dict[str, str] = {}
    for make in made:
        try:
            wanted |= make()
        except ODD as error:
            yield _odd("folder", f"what is written cannot be made again: {error}")
    for name, text in wanted.items():
        if name not in folder.texts:
            yield _odd(name, "there is no such file, or the manifest does not list it")
        elif folder.texts[name] != text:
            yield _odd(name, "not shown: it differs from what this version writes for the graphs")
        else:
            yield same(name, folder.texts[name], text, "what is written for these graphs")
    for name in folder.texts:
        if name not in wanted and name not in looked and name not in (*NEEDED, *others):
            yield _odd(name, UNREPEATED if name == REDUCTION else "no step checks it")


def _selftests(folder: Folder, scene: str, part: Part) -> dict[str, str]:
    graphs, own = folder.evidence.graphs, part.prefix
    names, many = tuple(graphs), _many(folder, part)

    def again(file: str, write: Any, tested: Sequence[str]) -> dict[str, str]:
        text = folder.texts.get(file, "")
        return {file: write(scene, part, tested, lambda name: graphs[name].written,
                            lambda name: _states(text, name, folder))}  # fmt: skip

    found = again(f"{own}_selftest.c", selftest, names)
    return found | (again(f"{own}_batch_selftest.c", batch_selftest, many) if many else {})


def _states(text: str, name: str, folder: Folder) -> list[Vector]:
    """The test vectors of a function, from the tables of a self-test."""
    code = folder.evidence.graphs[name].written
    start = text.find(f"static int test_{name}(void)\n")
    if start < 0:
        raise ExpressionError(f"there is no test of {name}")
    body = text[start : text.index("\n}\n", start)]
    given = [_table(body, f"{group}_in") if size else [()] for group, size in code.inputs]
    asked = [name for name, _ in code.shapes]
    sizes = [rows * columns for _, (rows, columns) in code.shapes]
    both = [
        [
            _table(body, f"{out}_{end}") if size else [()]
            for out, size in zip(asked, sizes, strict=True)
        ]
        for end in ("expected", "tolerance")
    ]
    count = max(len(rows) for rows in (*given, *both[0]))
    rows = [
        [
            tuple(table[i] if len(table) > 1 else table[0] for table in tables)
            for tables in (given, *both)
        ]
        for i in range(count)
    ]
    return [Vector(*row) for row in rows]


def _table(body: str, name: str) -> list[tuple[float, ...]]:
    found = re.search(TABLE.format(name=name), body, re.DOTALL)
    if found is None:
        raise ExpressionError(f"there is no table {name}")
    return [
        tuple(_number(word.strip()) for word in row.split(",") if word.strip())
        for row in re.findall(r"\{([^{}]*)\}", found[1])
    ]


def _number(word: str) -> float:
    size = float(literal(word.removeprefix("-")).value)
    return -size if word.startswith("-") else size


def _typical(text: str) -> Mapping[str, float]:
    for node in ast.parse(text).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "TYPICAL":
            found = ast.literal_eval(node.value)
            return {str(name): float(value) for name, value in found.items()}
    raise ExpressionError("the loader has no typical values")
