"""What a slip of the hand changes in C is REFUTED: the output is named, and a state is shown.

A sign, an index, the last digit of a constant, two arguments: in every function of one state and
of many, in both precisions. What is written in another way passes.
"""

import re
from collections.abc import Callable

import pytest

from mechanics.kernel import Verdict

pytestmark = pytest.mark.campaign

OUTPUT = re.compile(r"[a-z_]+\[\d+\]: ")
KEPT = "coordinate_rates", "prepare"
"""No operations in the first; the second is compared entry by entry with the program."""


SLIPS: dict[str, tuple[str, str | Callable[[re.Match[str]], str]]] = {
    "sign": (r"(= [^;\n]*\w) ([+-]) (?=[\w(])", lambda m: f"{m[1]} {'-' if m[2] == '+' else '+'} "),
    "index": (r"(double|float) (L|M) = p\[\d\];", r"\1 \2 = p[2];"),
    "last digit": (r"(0x1\.5+)[56]p", r"\g<1>4p"),
    "operator": (r"(= [^;\n]*\w) \* (?=\w)", r"\1 + "),
    "function": (r"\bsin(f?)\((?=theta)", r"cos\1("),
    "output": (r"^( +)(\w+)\[0\] = (\w+);\n +\2\[1\] = (\w+);",
               r"\1\2[0] = \4;\n\1\2[1] = \3;"),
}  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS)
@pytest.mark.parametrize("precision", ["", "_single"])
def test_a_slip_is_refuted_in_every_function(evidence, judging, slip: str, precision: str) -> None:
    file = f"name{precision}.c"
    pattern, put = SLIPS[slip]
    seen = 0
    for kernel in evidence.kernels:
        if kernel.file != file or kernel.function in KEPT:
            continue
        before, changed = judging.function(file, kernel.symbol)
        changed = re.sub(pattern, put, before, count=1, flags=re.MULTILINE)
        if changed == before:
            continue
        findings = judging(file, kernel.symbol, changed)
        bad = [f for f in findings if f.verdict is Verdict.REFUTED]
        assert bad, f"{kernel.symbol}: {[f.evidence for f in findings]}"
        assert OUTPUT.match(bad[0].evidence) and bad[0].witness is not None
        assert bad[0].witness.left != bad[0].witness.right and bad[0].witness.state
        seen += 1
    assert seen >= 3


def test_swapped_arguments_are_refuted(judging) -> None:
    for symbol in ("name_forward_dynamics", "name_residual", "name_energy"):
        before, _ = judging.function("name.c", symbol)
        swapped = re.sub(r"double q\[2\], const double u\[2\]", "double u[2], const double q[2]",
                         before)  # fmt: skip
        assert swapped != before
        findings = judging("name.c", symbol, swapped)
        assert any(f.verdict is Verdict.REFUTED and f.witness for f in findings)


BATCH = [
    ("1 * stride + i]", "i]", Verdict.REFUTED),
    ("cos_theta * v7)", "sin_theta * v7)", Verdict.REFUTED),
    ("&sin_theta, &cos_theta", "&cos_theta, &sin_theta", Verdict.REFUTED),
    ("i < count", "i < stride", Verdict.UNDECIDED),
    ("q[i]", "q[i + 1]", Verdict.UNDECIDED),
    ("far |= beyond;", "", Verdict.UNDECIDED),
    ("status != 0 ? 2 : 0", "0", Verdict.UNDECIDED),
    ("found |= name_forward_dynamics", "name_forward_dynamics", Verdict.UNDECIDED),
    ("i += 256", "i += 255", Verdict.UNDECIDED),
    ("if (flags & 1)", "if (flags & 2)", Verdict.UNDECIDED),
    ("(flags & 1)", "(1)", Verdict.CERTIFIED),
    ("stride, q + i, u + i, p, ud + i)", "stride, u + i, q + i, p, ud + i)", Verdict.REFUTED),
    ("ud[k * stride + i] = ud_[k]", "ud[k * stride + i] = q_[k]", Verdict.REFUTED),
]


@pytest.mark.parametrize(("old", "new", "verdict"), BATCH)
def test_functions_of_many_states(judging, evidence, old: str, new: str, verdict) -> None:
    text = evidence.texts["name_batch.c"]
    symbol = "name_forward_dynamics_batch"
    first = text.index(f"int {symbol}_lanes")
    part = text[first : text.index(f"int {symbol}(") + 900]
    assert old in part
    found = judging("name_batch.c", symbol, part.replace(old, new, 1), part)
    verdicts = {finding.verdict for finding in found}
    assert verdict in verdicts, [finding.evidence for finding in found]
    assert verdict is Verdict.CERTIFIED or not all(finding.shown for finding in found)


REWRITTEN = [
    lambda text: re.sub(r"\n +", "\n\t", text),
    lambda text: text.replace("(", "( ").replace(";", " ;  /* said again */\n"),
    lambda text: re.sub(r"const (double|float) (\w+) = ", r"\1 const \2 =\n", text),
    lambda text: re.sub(r"\bv(\d+)\b", r"other_name_\1", text),
    lambda text: re.sub(r"= (\w+) \* (\w+);", r"= \2 * \1;", text),
    lambda text: re.sub(r"= (\w+) \+ (\w+);", r"= (\2 + (\1));", text),
    lambda text: text.replace("2.0", "2").replace("0x1p-1 *", "0.5 *"),
]


@pytest.mark.parametrize("how", range(len(REWRITTEN)))
def test_what_is_written_in_another_way_passes(judging, evidence, how: int) -> None:
    for kernel in evidence.kernels:
        if kernel.file == "name.c":
            before, _ = judging.function("name.c", kernel.symbol)
            findings = judging("name.c", kernel.symbol, REWRITTEN[how](before))
            assert findings and all(f.shown for f in findings), [f.evidence for f in findings]
