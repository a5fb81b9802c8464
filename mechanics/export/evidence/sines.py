"""The text of the inline sine and cosine in a folder: proved on its own.

Elsewhere in the chain a call of ``mechanics_sincos``, ``mechanics_sin`` and ``mechanics_cos`` is
taken for the sine and the cosine.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pycparser import c_generator

from mechanics.errors import ExpressionError
from mechanics.exact import Finding, Verdict
from mechanics.exact.c_parse import parse
from mechanics.exact.sine.proof import verify_sine
from mechanics.export.evidence.chain import Report, silent

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


def prove_sines(texts: Mapping[str, str], report: Report = silent) -> Iterator[Finding]:
    """Decide for each header with an inline sine whether it is sine and cosine."""
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    for name, text in headers.items():
        for kind, f in SUFFIX.items():
            if f" mechanics_sincos{f}(" in text:
                report(f"{name}: mechanics_sincos{f} = sine and cosine")
                yield verify_sine(text, kind, file=name, includes=headers)
                yield from _singles(name, text, kind, headers)


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
        if _words(found[own]) == _words(wanted[own]):
            yield Finding(subject, Verdict.PROVED, "it calls it, and gives no number beyond")
        else:
            yield Finding(subject, Verdict.UNDECIDED, "refused: its text is another one")


def _words(function: Any) -> str:
    return str(c_generator.CGenerator().visit(function))
