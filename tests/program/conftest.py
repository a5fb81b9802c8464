"""Random programs that have a value at every point, and numbers of many digits."""

import pytest
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy
from mpmath_domain import MultiplePrecision

from mechanics.program import Builder, Node, Program
from mechanics.program.interpret import Domain

NAMES = ("x", "y", "z")
STEPS = st.lists(
    st.tuples(st.integers(0, 26), st.integers(0, 40), st.integers(0, 40), st.integers(-6, 6)),
    min_size=1,
    max_size=14,
)


@pytest.fixture(scope="session")
def programs() -> SearchStrategy[Program]:
    """Programs in x, y, z of every operation; well conditioned where these are below 2."""
    return STEPS.map(program_of)


def program_of(steps: list[tuple[int, int, int, int]]) -> Program:
    b = Builder()
    nodes = [b.input(name) for name in NAMES]
    for kind, i, j, k in steps:
        nodes.append(built(b, kind, nodes[i % len(nodes)], nodes[j % len(nodes)], k))
    return b.program({"first": nodes[-2:], "last": [nodes[-1] * nodes[0]]}, inputs=NAMES)


def built(b: Builder, kind: int, x: Node, y: Node, k: int) -> Node:
    # Where a value jumps, the sides are far apart for rounding: at the inputs only.
    jump = b.input(NAMES[k % 3]) - b.constant(k) / 7 - b.constant(1) / 30
    truth = (b.less(jump, 0), b.call("not_greater", jump, 0), b.call("not", b.less(jump, 0)))
    both = b.call("and", truth[0], b.less(b.input("y"), b.constant(3) / 7))
    either = b.call("or", truth[1], b.call("equal", b.input("z"), b.constant(k)))
    names = ("exp", "sinh", "cosh", "tanh", "asinh", "atan", "erf", "tan", "abs")
    match kind:
        case 0:
            return x + y
        case 1:
            return x - y
        case 2:
            return x.sin() * y
        case 3:
            return x / (2 + y.cos())
        case 4:
            return -x
        case 5:
            return x * k / 3 + b.pi
        case 6:
            return (1 + x * x).sqrt()
        case 7:
            return (2 + y.sin()).log()
        case 8:
            return (1 + x.sin() ** 2).power(b.constant(k) / 7)
        case 9:
            return b.call("atan2", x.sin(), 3 + y.cos())
        case 10:
            return b.call(("asin", "acos", "atanh")[k % 3], x.sin() / 2)
        case 11:
            return b.call("acosh", 3 + x.sin())
        case 12:
            return jump.sign() * x + b.call("floor", 3 * jump)
        case 13:
            return truth[k % 3].choose(x, y)
        case 14:
            return both.choose(x, either.choose(y, x + 1))
        case 15:
            return truth[k % 3] * x - both
        case 16:
            u, v = b.solve(*([[3 + x.sin(), y.cos()], [y.cos(), b.constant(2)]], [x, y]),
                           symmetric=True)  # fmt: skip
            return u - v
        case 17:
            u, v = b.solve([[3 + x.sin(), y.cos()], [y.sin(), b.constant(2)]], [x, y])
            return u - v
        case _:
            return b.call(names[kind - 18], x.sin())


@pytest.fixture(scope="session")
def multiple_precision() -> Domain:
    """Numbers of as many digits as mpmath is set to."""
    return MultiplePrecision()
