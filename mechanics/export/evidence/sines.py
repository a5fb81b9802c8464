"""The text of the inline sine and cosine in a folder: proved on its own.

Elsewhere in the chain a call of ``mechanics_sincos``, ``mechanics_sin`` and ``mechanics_cos`` is
taken for the sine and the cosine.
"""

import re
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

from pycparser import c_generator

from mechanics.compiled.translation_validation.sine.proof import verify_sine
from mechanics.errors import ExpressionError
from mechanics.export.evidence.chain import Report, silent
from mechanics.export.evidence.texts import FMA, odd_conditions
from mechanics.kernel import Finding, same, undecided
from mechanics.program.c.parse import parse

SUFFIX = {"double": "", "float": "f"}

SINGLE = """\
static inline {kind} mechanics_{name}{f}({kind} x)
{{
    {kind} sine, cosine;
    mechanics_sincos{f}(x, &sine, &cosine);
    return mechanics_far{f}(x) ? ({kind})NAN : {result};
}}
"""
"""One of the two, and no number where the angle is too large."""


USED = re.compile(r"\bmechanics_(?:sincos|sin|cos|far|fma)(f?)\b")


def prove_sines(texts: Mapping[str, str], report: Report = silent) -> Iterator[Finding]:
    """Decide for each header with an inline sine whether it is sine and cosine."""
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    used = {f for text in texts.values() for f in USED.findall(text.replace("\\\n", ""))}
    for kind, f in SUFFIX.items():
        own = f"mechanics_sincos{f}"
        seen = False
        for name, text in headers.items():
            try:
                functions = parse(text, name, headers).functions
            except ExpressionError as error:
                if USED.search(text):
                    yield undecided(f"{name}: {own}", f"refused: {error}")
                continue
            if stray := _stray(name, text, kind, headers):
                yield undecided(f"{name}: {own}", f"refused: {stray}")
            if own in functions and str(functions[own].coord.file) == name:
                seen = True
                report(f"{name}: {own} = sine and cosine")
                yield verify_sine(text, kind, file=name, includes=headers)
                yield from _singles(name, text, kind, headers)
        if f in used and not seen:
            words = "refused: it is used, and no header defines it"
            yield undecided(own, words)


def _stray(file: str, text: str, kind: str, headers: Mapping[str, str]) -> str:
    """What a header has that the proof does not see; empty if there is nothing."""
    f = SUFFIX[kind]
    plain, fused = (parse(text, file, headers, d) for d in ({}, {"__FMA__": "1"}))
    names = [n for n in plain.functions if str(plain.functions[n].coord.file) == file]
    stand_in = [n for n in names if USED.fullmatch(n) and n.endswith("f") == (f == "f")]
    stand_in = [n for n in stand_in if n not in ("mechanics_sincosf", "mechanics_sincos")]
    if stand_in and f"mechanics_sincos{f}" not in names:
        return f"{stand_in[0]} stands without mechanics_sincos{f}"
    if not names:
        return ""
    if other := odd_conditions(text, file, lambda name: name in FMA):
        return other
    read = [{n: _words(node) for n, node in source.functions.items()} for source in (plain, fused)]
    for count in range(1, len(FMA) + 1):
        for chosen in combinations(sorted(FMA), count):
            functions = parse(text, file, headers, dict.fromkeys(chosen, "1")).functions
            if {n: _words(node) for n, node in functions.items()} not in read:
                return f"with {' and '.join(chosen)} it reads otherwise"
    return ""


def _singles(
    file: str, text: str, kind: str, headers: Mapping[str, str]
) -> Iterator[Finding]:  # fmt: skip
    """The functions of one of the two: their text as it has to stand, in any layout."""
    f = SUFFIX[kind]
    try:
        found = parse(text, file, headers).functions
    except ExpressionError:
        return  # told already
    for name, result in (("sin", "sine"), ("cos", "cosine")):
        wanted = parse(SINGLE.format(kind=kind, name=name, f=f, result=result)).functions
        own = f"mechanics_{name}{f}"
        if own not in found:
            continue
        subject = f"{file}: {own} = one of mechanics_sincos{f}"
        texts = _words(found[own]), _words(wanted[own])
        if texts[0] == texts[1]:
            yield same(subject, *texts, "it calls it, and gives no number beyond")
        else:
            yield undecided(subject, "refused: its text is another one")


def _words(function: Any) -> str:
    return str(c_generator.CGenerator().visit(function))
