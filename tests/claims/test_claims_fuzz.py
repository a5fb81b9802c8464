"""Any text gives statements or one line with a place: no traceback, no hang, nothing is run."""

import random
import re
import time

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from benchmarks.fuzz import corpus, law
from benchmarks.fuzz.mutate import mutated
from mechanics.claims.read import read_source
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import elastic_pendulum

TRUTH = derived(elastic_pendulum.scene())
SCENE = elastic_pendulum.scene()
PLACE = re.compile(r"line \d+, column \d+: ")
LATEX_WORDS = r"""
\frac \dot \ddot { } ( ) [ ] ^ _ \left( \right) \left[ \right] \sin \cos \theta x M L & \\ = + -
/ \cdot 2 3 0 . , d t f(t) ' \tag{1} \begin{matrix} \end{matrix} \sqrt \bar \text{and} $ \prime
\mathrm{d} \operatorname{sign} \begin{array}{rr} \end{array} \{ \} | \pi e
"""
TEXT_WORDS = r"""
x theta M L 2 0 0.5 1e3 ( ) [ ] , ; = == + - * / ** ^ .diff(t) .diff( ' sin( cos( Eq( Rational(
x(t) Derivative( t xdd log( sqrt( . .T ... % # : \ diff( é ² θ
"""
C_WORDS = r"""
double int const void return if else for ( ) { } [ ] ; , = + - * / < > == && ! ? : += ++ & x theta
x_dot theta_dot M m L k g q[0] u[1] a[0] a[1] 0 1 2 0.5 1e308 sin( cos( sqrt( pow( fabs( #define
#include "/etc/passwd" <math.h> #if #endif /* */ // 'a' struct while << % |= sizeof
"""
HEAD = "void f(const double q[2], const double u[2], double M, double k, double *a) {"
C = st.lists(st.sampled_from([*C_WORDS.split(), "\n", " "]), max_size=40).map(" ".join)
LATEX = st.lists(st.sampled_from(LATEX_WORDS.split()), max_size=40).map(" ".join)
TEXT = st.lists(st.sampled_from([*TEXT_WORDS.split(), "\n", " "]), max_size=40).map("".join)


def assert_read_or_refused(text: str, notation: str) -> None:
    start = time.process_time()
    try:
        found = read_source(SCENE, text, notation=notation)
    except InputError as error:
        assert "\n" not in str(error)
        assert PLACE.search(str(error))
    else:
        for statement in found.statements:
            assert statement.row is not None or PLACE.search(statement.doubt)
            assert "\n" not in statement.doubt
    assert time.process_time() - start < SLOWER * law.LONGEST_READING


def assert_kept(notation: str, data: bytes) -> None:
    """A verdict, or one line with a line and a column."""
    assert law.outcome(TRUTH, notation, data, blame=False).broken == ""


SLOWER = 5
"""How much slower a shared machine may be, under coverage, than the one that the law is for."""

FUZZ = settings(
    max_examples=150, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True
)


@FUZZ
@given(LATEX)
def test_latex_of_its_own_words(text: str) -> None:
    assert_read_or_refused(text, "latex")


@FUZZ
@given(TEXT)
def test_text_of_its_own_words(text: str) -> None:
    assert_read_or_refused(text, "text")


@FUZZ
@given(C, st.booleans())
def test_c_of_its_own_words(text: str, inside: bool) -> None:
    assert_kept("c", (f"{HEAD} {text} }}" if inside else text).encode())


@FUZZ
@given(st.binary(max_size=80), st.sampled_from(["latex", "text", "c"]))
def test_any_bytes(data: bytes, notation: str) -> None:
    assert_kept(notation, data)


@pytest.mark.campaign
@FUZZ
@given(st.randoms(use_true_random=False), st.sampled_from(corpus.NOTATIONS))
def test_documents_of_the_corpus_changed(source: random.Random, notation: str) -> None:
    seeds = [entry.data for entry in corpus.load(notation) if len(entry.data) < 400]
    assert_kept(notation, mutated(source.choice(seeds), notation, source, seeds))


@pytest.mark.campaign
@FUZZ
@given(st.text(max_size=60), st.sampled_from(["latex", "text"]))
def test_any_text(text: str, notation: str) -> None:
    assert_read_or_refused(text, notation)


@pytest.mark.sample(2)
@pytest.mark.parametrize("notation", ["latex", "text"])
@pytest.mark.parametrize(
    "text",
    [
        "(" * 40_000, "{" * 40_000, "-" * 40_000, "x^" * 20_000 + "2", "x**" * 20_000 + "2",
        "\\dot" * 20_000 + "x", "\\sqrt" * 20_000 + "2", "'" * 50_000, "x" + "'" * 50_000,
        "1" * 90_000, "x+" * 40_000 + "x", "x*" * 45_000 + "x", "\\\\" * 40_000, "=" * 50_000,
        "\\begin{matrix}" * 5_000, "\\left(" * 10_000, "((x+1)**60)**60 = 0", "_{" * 30_000,
        "x_" + "{a" * 20_000, "sin(" * 20_000, "[" * 40_000, "f(t)" * 20_000, "$" * 50_001,
        "2**(x-x+10**9)", "x**(2**(x-x+64))**64", "sqrt(2)**sqrt(2)**sqrt(10**30)",
        "10**64*10**64*10**64*10**64", "exp(exp(exp(exp(64))))", "\\text{" * 10_000,
        "\n".join(f"a{i} = a{i - 1}*a{i - 1} + a{i - 1}" for i in range(1, 300)),
        "a0 = x + L\n" + "\n".join(f"a{i} = a{i - 1}**60" for i in range(1, 9)) + "\na8'' = 0",
        "\x00" * 100,
    ],
)  # fmt: skip
def test_large_and_deep_inputs(text: str, notation: str) -> None:
    assert_read_or_refused(text, notation)
