"""A folder of generated code that its tests share, and single edits of its C."""

import random
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import pytest

from mechanics.compiled.translation_validation.build import building
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.export.evidence.binaries import third_step
from mechanics.export.evidence.chain import Evidence, Read, second_step
from mechanics.export.evidence.read import read_folder
from mechanics.export.write_c import write_c
from mechanics.kernel import Verdict
from mechanics.program.c.tokens import tokens

OPERATORS = ("+", "-", "*", "/", "<", "<=", "==", "!=", "&&", "||", "&", "|", "%")
TYPES = ("double", "float", "int", "long", "const", "static", "void", "size_t")
SWAPS = {"sin": "cos", "cos": "sin", "isfinite": "fabs", "if": "while", "else": "", "return": ""}


class Edit(NamedTuple):
    """One change of a text: what it is, and the text after it."""

    words: str
    file: str
    symbol: str
    text: str


@pytest.fixture(scope="session")
def generated(modelled, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The elastic pendulum in both precisions."""
    folder = tmp_path_factory.mktemp("generated")
    model = modelled("elastic_pendulum", "free_body")
    write_c(model, folder, name="name", precision="both", system="elastic_pendulum", measure=False)
    return folder


@pytest.fixture(scope="session")
def evidence(generated: Path) -> Evidence:
    return read_folder(generated).evidence


def functions(text: str) -> list[tuple[str, int, int]]:
    """Name, begin and end of every function, which begin and end at the margin."""
    found = []
    for match in re.finditer(r"^(?:static |inline |int |void )+(\w+)\([^;{]*\)\n\{.*?^\}\n", text,
                             re.MULTILINE | re.DOTALL):  # fmt: skip
        found.append((match[1], match.start(), match.end()))
    return found


GROUPS = (
    (r"[.\d]", 6),
    (r"[-+*/<>=!&|%]", 6),
    (r"[a-z]\w*", 7),
    (r"[A-Z]\w*", 1),
    (r"[][(){};,?:]", 2),
)
"""What an edit may begin at, and how often."""


def edit(source: random.Random, file: str, text: str) -> Edit:
    """A random edit of one token of a random function."""
    while True:
        symbol, begin, end = source.choice(functions(text))
        found = [t for _, t in tokens(text[begin:end], file)]
        (group,) = source.choices([g for g, _ in GROUPS], [n for _, n in GROUPS])
        places = [i for i, t in enumerate(found) if re.match(group, t)]
        at = source.choice(places) if places else 0
        change = _changed(source, found, at) if places else None
        if change is None or "".join(change).split() == "".join(found).split():
            continue
        before, after = ("".join(x).splitlines() for x in (found, change))
        lines = zip(before, [*after, "", ""], strict=False)
        old, new = next(((x, y) for x, y in lines if x.split() != y.split()), ("", ""))
        words = f"{symbol}: {old.strip()}  ->  {new.strip()}"
        return Edit(words, file, symbol, text[:begin] + "".join(change) + text[end:])


def _changed(source: random.Random, found: list[str], at: int) -> list[str] | None:
    """The tokens after a change of the one at a place."""
    old, new = found[at], list(found)
    kind = source.random()
    if kind < 0.08:  # a statement is dropped or said twice
        first = max((i for i in range(at) if found[i] in ";{}"), default=0) + 1
        last = next((i for i in range(at, len(found)) if found[i] == ";"), len(found) - 1) + 1
        return found[:first] + found[first:last] * source.choice((0, 2)) + found[last:]
    if kind < 0.12:  # two arguments or names change places
        others = [i for i, t in enumerate(found) if re.match(r"[A-Za-z_]", t)]
        other = min(others, key=lambda i: (abs(i - at), i <= at) if found[i] != old else (1e9, 0))
        new[at], new[other] = new[other], new[at]
        return new
    if old in OPERATORS:
        new[at] = source.choice([o for o in OPERATORS if o != old])
    elif re.match(r"[.\d]", old):
        new[at] = _number(source, old)
    elif old in SWAPS and source.random() < 0.5:
        new[at] = SWAPS[old]
    elif old in TYPES:
        new[at] = source.choice([*(t for t in TYPES if t != old), ""])
    elif re.match(r"[A-Za-z_]", old):
        names = sorted({t for t in found if re.match(r"[A-Za-z_]", t)} - {old, *TYPES, *SWAPS})
        new[at] = source.choice(names)
    elif old in "!;,?:[]{}()":
        new[at] = source.choice(("", "-", "!")) if old in "!(" else ""
        new[at] = old + "-" if old == "(" and new[at] == "-" else new[at]
    else:
        return None
    return new


def _number(source: random.Random, old: str) -> str:
    """Another number: last digit, sign, exponent, type, or any."""
    match = re.fullmatch(r"(0x[\da-f.]*?)([\da-f])(p[+-]?)(\d+)(f?)", old)
    way = source.randrange(4)
    if match and way == 0:
        return f"{match[1]}{int(match[2], 16) ^ 1:x}{match[3]}{match[4]}{match[5]}"
    if match and way == 1:
        return f"{match[1]}{match[2]}{match[3]}{int(match[4]) + 1}{match[5]}"
    if way == 2 and "." in old:
        return old[:-1] if old.endswith("f") else old + "f"
    if way == 3:
        return f"-{old}"
    digits = re.sub(r"\d", lambda m: str((int(m[0]) + source.randrange(1, 10)) % 10), old, count=1)
    return digits if match or not old.isdigit() else str(int(old) + source.choice((-1, 1, 2)))


@pytest.fixture(scope="session")
def edited(evidence: Evidence) -> Callable[[random.Random], Edit]:
    """Makes random edits of the C files that hold kernels."""
    files = sorted({kernel.file for kernel in evidence.kernels})
    weights = [len(evidence.texts[file]) for file in files]

    def make(source: random.Random) -> Edit:
        file = source.choices(files, weights)[0]
        return edit(source, file, evidence.texts[file])

    return make


@pytest.fixture(scope="session")
def judged(evidence: Evidence) -> Callable[[Edit], list]:
    """What the second step says about the function that an edit is in, and those that call it."""
    return lambda change: list(
        second_step(reduced(evidence, change, touched(evidence, change)), [])
    )


def touched(evidence: Evidence, change: Edit) -> list[Kernel]:
    """Kernels that the edited function is or belongs to."""
    mine = [
        kernel
        for kernel in evidence.kernels
        if kernel.file == change.file and change.symbol.startswith(kernel.symbol)
        and change.symbol.removeprefix(kernel.symbol) in ("", "_lanes", "_far", "_prepared")
    ]  # fmt: skip
    parts = ("prepare", "forward_dynamics_prepared")
    if any(kernel.function in parts for kernel in mine):
        mine = [k for k in evidence.kernels if k.file == change.file and k.function in parts]
    return mine


def reduced(evidence: Evidence, change: Edit, kept: list[Kernel]) -> Evidence:
    """The evidence about some kernels of the edited file, and of what they call."""
    # The text of the inline sine has a proof of its own.
    texts = {name: "" if name.endswith("_sine.h") else t for name, t in evidence.texts.items()}
    texts[change.file] = _reduced(change, [k.symbol for k in kept])
    for kernel in kept:
        if kernel.lanes:
            # What its lanes fall back to.
            scalar = kernel.symbol.removesuffix("_batch")
            file = kernel.file.replace("_batch", "")
            texts[file] = _reduced(Edit("", file, scalar, texts[file]), [scalar])
            kept = [*kept, *(k for k in evidence.kernels if k.symbol == scalar)]
    return replace(evidence, kernels=tuple(kept), texts=texts)


def _reduced(change: Edit, symbols: list[str]) -> str:
    """A text without the functions and choices that an edit has nothing to do with."""
    text = re.sub(r"^#ifdef \w+_INLINE_SINE\n.*?^#endif\n", "", change.text, count=1,
                  flags=re.MULTILINE | re.DOTALL)  # fmt: skip
    for name, begin, end in reversed(functions(text)):
        of = [name.removeprefix(symbol) for symbol in symbols if name.startswith(symbol)]
        if name != change.symbol and not {"", "_lanes", "_far"}.intersection(of):
            text = text[:begin] + text[end:]
    return text


@pytest.fixture(scope="session")
def alike(evidence: Evidence) -> Callable[[Edit, str], bool]:
    """Whether the machine code of an edited text gives what the original text says."""

    def same(change: Edit, compiler: str) -> bool:
        kernels = touched(evidence, change)
        original = reduced(evidence, change._replace(text=evidence.texts[change.file]), kernels)
        edited = reduced(evidence, change, kernels)
        files = list(dict.fromkeys(kernel.file for kernel in edited.kernels))
        texts = {**edited.texts, **{n: t for n, t in evidence.texts.items() if n.endswith(".h")}}
        read: list[Read] = []
        list(second_step(original, read))
        with building(texts, files, (compiler,), (("-O1",),)) as collected:
            (library,) = collected()
            findings = third_step(original, read, (library,)).findings
        return bool(findings) and all(f.verdict is Verdict.SUPPORTED for f in findings)

    return same


class Judging:
    """Judges other texts of single functions."""

    def __init__(self, evidence: Evidence) -> None:
        self.evidence = evidence

    def function(self, file: str, symbol: str) -> tuple[str, str]:
        """Text of a function, twice."""
        text = self.evidence.texts[file]
        ((begin, end),) = [(b, e) for name, b, e in functions(text) if name == symbol]
        return text[begin:end], text[begin:end]

    def __call__(self, file: str, symbol: str, new: str, old: str = "") -> list:
        """Findings about the file with another text for a function."""
        text = self.evidence.texts[file]
        changed = text.replace(old or self.function(file, symbol)[0], new)
        change = Edit("", file, symbol, changed)
        return list(second_step(reduced(self.evidence, change, touched(self.evidence, change)), []))


@pytest.fixture(scope="session")
def judging(evidence: Evidence) -> Judging:
    return Judging(evidence)
