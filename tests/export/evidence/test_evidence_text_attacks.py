"""Texts that were changed with care, so that a careless reader takes them for their graph."""

import re
from dataclasses import replace

import pytest

from mechanics.export.evidence.chain import second_step
from mechanics.export.evidence.headers import prove_headers
from mechanics.export.evidence.sines import prove_sines
from mechanics.export.evidence.vectors import prove_vectors
from mechanics.kernel import Verdict

pytestmark = pytest.mark.campaign

PUT = "static int put(double *o, double v)\n{\n    *o = v;\n    return 1;\n}\n\n"
OUTPUT = "    ud[0] = v5;\n"
STORED = (
    "    double w[1];\n    w[0] = -v5;\n    const int z = %s;\n    (void)z;\n    ud[0] = w[0];\n"
)
WRONG = "static double %s(double x)\n{\n    return x;\n}\n\n"

BODIES = {
    "and": (PUT, STORED % "(x < .05 || x > .0501) && put(w, v5)"),
    "or": (PUT, STORED % "(x > .05 && x < .0501) || put(w, v5)"),
    "choice": (PUT, STORED % "x < .05 ? put(w, v5) : 0"),
    "stand-in": (WRONG % "mechanics_sin", OUTPUT),
    "library": (WRONG % "sin", OUTPUT),
    "macro": ("#define isfinite fabs\n", OUTPUT),
    "two names": (
        "",
        "#if defined(__GNUC__) && defined(NDEBUG)\n    ud[0] = -v5;\n#else\n" + OUTPUT + "#endif\n",
    ),
    "one and not the other": (
        "",
        "#if defined(__GNUC__) && !defined(__FMA__)\n    ud[0] = -v5;\n#else\n"
        + OUTPUT
        + "#endif\n",
    ),
}


@pytest.mark.parametrize("attack", BODIES)
def test_a_text_that_only_seems_to_be_its_graph_is_not_shown(evidence, attack: str) -> None:
    before, body = BODIES[attack]
    text, begin = evidence.texts["name.c"], "int name_forward_dynamics("
    assert begin in text and OUTPUT in text
    text = text.replace(OUTPUT, body, 1).replace(begin, before + begin, 1)
    kernels = tuple(k for k in evidence.kernels if k.symbol == "name_forward_dynamics")
    changed = replace(evidence, kernels=kernels, texts=evidence.texts | {"name.c": text})
    verdicts = {f.verdict for f in second_step(changed, []) if "forward_dynamics =" in f.subject}
    assert verdicts & {Verdict.REFUTED, Verdict.UNDECIDED}


NOWHERE, SOMEWHERE = Verdict.REFUTED, Verdict.UNDECIDED
NO_NUMBERS = {
    "sqrt(-1.0 - x * x) * sqrt(-1.0 - x * x) + 1.0 + x * x": NOWHERE,
    "0.0 * sqrt(-1.0 - x * x)": NOWHERE,
    "0.0 * acos(2.0 + x * x)": NOWHERE,
    "log(-1.0 - x * x) - log(-1.0 - x * x)": NOWHERE,
    "(x * x < -1.0 ? 0.0 : 0.0 * sqrt(-1.0 - x * x))": NOWHERE,
    "exp(log(x)) - x": SOMEWHERE,
    "sqrt(x) * sqrt(x) - x": SOMEWHERE,
    "x / x - 1.0": SOMEWHERE,
    "0.0 / (x - x)": SOMEWHERE,
    "0.0 / ((x + 1.0) * (x + 1.0) - x * x - 2.0 * x - 1.0)": SOMEWHERE,
}


ONE, MANY = "name_forward_dynamics", "name_forward_dynamics_batch"


@pytest.mark.parametrize(
    ("symbol", "term"), [*((ONE, term) for term in NO_NUMBERS), (MANY, next(iter(NO_NUMBERS)))]
)
def test_what_is_no_number_is_seen_where_the_field_sees_zero(
    evidence, symbol: str, term: str
) -> None:
    (kernel,) = [k for k in evidence.kernels if k.symbol == symbol]
    found = list(second_step(_planted(evidence, kernel, term), []))
    verdicts = [f.verdict for f in found if f.subject.endswith(f"{symbol} = graph")]
    assert verdicts and set(verdicts) == {NO_NUMBERS[term]}


@pytest.mark.parametrize(
    "term",
    [
        "0.0 * sqrt(x * x)",
        "0.0 * sqrt(1.0 + x * x)",
        "0.0 * log(exp(x))",
        "0.0 * acos(sin(x))",
        "(x > 0.0 ? 0.0 * log(x) : 0.0)",
        "(x > 0.0 && log(x) > 1.0 ? 0.0 : 0.0)",
        "0.0 / (1.0 + x * x)",
    ],
)
def test_what_is_a_number_at_all_states_is_none_of_it(evidence, term: str) -> None:
    (kernel,) = [k for k in evidence.kernels if k.symbol == "name_forward_dynamics"]
    found = list(second_step(_planted(evidence, kernel, term), []))
    verdicts = [f.verdict for f in found if f.subject.endswith(f"{kernel.symbol} = graph")]
    assert verdicts and set(verdicts) <= {Verdict.PROVED, Verdict.CERTIFIED}


def _planted(evidence, kernel, term: str):
    """The evidence of one function with a term of zero in an output."""
    text = evidence.texts[kernel.file]
    begin = text.index(f"int {kernel.symbol}")
    head, body = text[:begin], text[begin:]
    stored = re.search(r"^ +ud\[[^]]*\] = [^;]*(?=;)", body, re.MULTILINE)
    assert stored is not None
    body = body[: stored.end()] + f" + ({term})" + body[stored.end() :]
    texts = evidence.texts | {kernel.file: head + body}
    # That of many states calls the one of one state.
    one = replace(kernel, symbol="name_forward_dynamics", file="name.c", shared=None)
    return replace(evidence, kernels=tuple(dict.fromkeys((kernel, one))), texts=texts)


def test_a_sine_that_is_used_has_to_be_defined() -> None:
    (found,) = prove_sines({"name.c": "double f(double x)\n{\n    return mechanics_sin(x);\n}\n"})
    assert found.verdict is Verdict.UNDECIDED


HEADERS = {
    "order": ("const double q[2], const double u[2]", "const double u[2], const double q[2]"),
    "size": ("const double p[5]", "const double p[3]"),
    "no size": ("#define NAME_P_SIZE 5\n", ""),
}


@pytest.mark.parametrize("attack", HEADERS)
def test_headers_say_what_the_code_does(evidence, attack: str) -> None:
    old, new = HEADERS[attack]
    text = evidence.texts["name.h"]
    assert old in text
    assert all(f.shown for f in prove_headers(evidence))
    changed = replace(evidence, texts=evidence.texts | {"name.h": text.replace(old, new, 1)})
    assert not all(f.shown for f in prove_headers(changed))


def test_code_behind_an_enum_is_seen(evidence) -> None:
    text = "enum { COUNT = 1 }; int main(void) { return 0; } +\n"
    (found,) = prove_vectors({"name_selftest.c": text}, evidence.graphs)
    assert found.verdict is Verdict.UNDECIDED
