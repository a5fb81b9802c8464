"""The one table of operations: all that is known of each of them.

A node of a program is an operation on earlier nodes. Every other module that needs to know what an
operation means asks this table; a new operation is one row.

What has no row is written in those that have one when it is read: max(x, y) = select(x < y, y, x),
ceil(x) = -floor(-x), hypot(x, y) = sqrt(x x + y y), fmod(x, y) = x - y trunc(x/y).
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Any

Exact = Callable[..., Fraction]
"""Value at rational operands."""

Partials = Callable[..., tuple[Any, ...]]
"""Partial derivatives: of the operands, then the result, as nodes; 0 and 1 may stand as numbers."""


class Sign(Enum):
    """What an operation demands of an expression, to have a value; the value is for people."""

    NONZERO = "is not 0"
    NONNEGATIVE = "is not negative"
    POSITIVE = "is positive"


Demands = Callable[..., tuple[tuple[Sign, Any], ...]]
"""Of the operands: the signs that they, or expressions in them, must have."""


def _none(*operands: Any) -> tuple[tuple[Sign, Any], ...]:
    return ()


@dataclass(frozen=True)
class Operation:
    """One row.

    Attributes
    ----------
    name : str
    code : int
        Its number in arrays of operations.
    arity : int
        Number of operands that are nodes.
    commutative : bool
    boolean : bool
        Whether the value is a truth value, 0 or 1.
    exact : callable or None
        The value at rational operands, where that is rational for all of them.
    partials : callable or None
        Partial derivatives; None for leaves, whose derivative the caller says.
    demands : callable
        Where it has a real value: signs of expressions in its operands.
    numpy, sympy : str
        The function of that library with the same meaning.
    casadi : str
        CasADi's name of the operation in a graph; select takes two of them, see the printer.
    c : str
        C99, a template of the operands; each may stand in it more than once.
    ulp : float
        Largest error in double precision, in units in the last place: half for what IEEE 754
        rounds correctly, else what the GNU C library's manual states for x86-64, "Known Maximum
        Errors in Math Functions", rounded up.
    """

    name: str
    code: int
    arity: int
    commutative: bool = False
    boolean: bool = False
    exact: Exact | None = None
    partials: Partials | None = None
    demands: Demands = _none
    numpy: str = ""
    casadi: str = ""
    c: str = ""
    sympy: str = ""
    ulp: float = 0.0


CONSTANT, PI, INPUT = 0, 1, 2
ADD, SUBTRACT, MULTIPLY, DIVIDE, NEGATE = 3, 4, 5, 6, 7
SQRT, POWER, EXP, LOG = 8, 9, 10, 11
SIN, COS, TAN, ASIN, ACOS, ATAN, ATAN2 = 12, 13, 14, 15, 16, 17, 18
SINH, COSH, TANH, ASINH, ACOSH, ATANH = 19, 20, 21, 22, 23, 24
ABS, SIGN, FLOOR = 25, 26, 27
LESS, NOT_GREATER, EQUAL, AND, OR, NOT, SELECT = 28, 29, 30, 31, 32, 33, 34
SOLVE, ENTRY = 35, 36
ERF = 37


def _function(
    name: str, code: int, partials: Callable[[Any, Any], tuple[Any]], *, numpy: str | None = None,
    demands: Demands = _none, exact: Exact | None = None, ulp: float = 0.0,
) -> Operation:  # fmt: skip
    """A function of one number that every library but NumPy calls by the same name."""
    return Operation(
        name, code, 1, exact=exact, partials=partials, demands=demands, ulp=ulp, sympy=name,
        casadi=f"OP_{name.upper()}", c=f"{name}({{}})", numpy=name if numpy is None else numpy,
    )  # fmt: skip


def _relation(
    name: str, code: int, holds: Callable[[Fraction, Fraction], bool], c: str, casadi: str,
    numpy: str, sympy: str, *, commutative: bool = False,
) -> Operation:  # fmt: skip
    """A truth value of two numbers."""
    return Operation(
        name, code, 2, boolean=True, commutative=commutative, c=f"{{}} {c} {{}}", casadi=casadi,
        numpy=numpy, sympy=sympy, partials=lambda x, y, r: (0, 0),
        exact=lambda x, y: Fraction(holds(x, y)),
    )  # fmt: skip


OPERATIONS: tuple[Operation, ...] = (
    Operation("constant", CONSTANT, 0),
    Operation("pi", PI, 0, numpy="pi", c="3.141592653589793", sympy="pi", ulp=0.5),
    Operation("input", INPUT, 0),
    Operation(
        "add", ADD, 2, commutative=True, exact=lambda x, y: x + y,
        partials=lambda x, y, r: (1, 1),
        numpy="add", casadi="OP_ADD", c="{} + {}", sympy="Add", ulp=0.5,
    ),
    Operation(
        "subtract", SUBTRACT, 2, exact=lambda x, y: x - y,
        partials=lambda x, y, r: (1, -1),
        numpy="subtract", casadi="OP_SUB", c="{} - {}", ulp=0.5,
    ),
    Operation(
        "multiply", MULTIPLY, 2, commutative=True, exact=lambda x, y: x * y,
        partials=lambda x, y, r: (y, x),
        numpy="multiply", casadi="OP_MUL", c="{} * {}", sympy="Mul", ulp=0.5,
    ),
    Operation(
        "divide", DIVIDE, 2,
        partials=lambda x, y, r: (1 / y, -(r / y)),
        demands=lambda x, y: ((Sign.NONZERO, y),),
        numpy="divide", casadi="OP_DIV", c="{} / {}", ulp=0.5,
    ),
    Operation(
        "negate", NEGATE, 1, exact=lambda x: -x,
        partials=lambda x, r: (-1,),
        numpy="negative", casadi="OP_NEG", c="-{}",
    ),
    _function("sqrt", SQRT, lambda x, r: (1 / (2 * r),),
              demands=lambda x: ((Sign.NONNEGATIVE, x),), ulp=0.5),
    Operation(
        "power", POWER, 2,
        partials=lambda x, y, r: (y * x.power(y - 1), r * x.log()),
        demands=lambda x, y: ((Sign.NONNEGATIVE if (y.constant or 0) > 0 else Sign.POSITIVE, x),),
        numpy="power", casadi="OP_POW", c="pow({}, {})", sympy="Pow", ulp=1.0,
    ),
    _function("exp", EXP, lambda x, r: (r,), ulp=1.0),
    _function("log", LOG, lambda x, r: (1 / x,), demands=lambda x: ((Sign.POSITIVE, x),), ulp=1.0),
    _function("sin", SIN, lambda x, r: (x.cos(),), ulp=1.0),
    _function("cos", COS, lambda x, r: (-x.sin(),), ulp=1.0),
    _function("tan", TAN, lambda x, r: (1 + r * r,),
              demands=lambda x: ((Sign.NONZERO, x.cos()),), ulp=1.0),
    _function("asin", ASIN, lambda x, r: (1 / (1 - x * x).sqrt(),),
              numpy="arcsin", demands=lambda x: ((Sign.NONNEGATIVE, 1 - x * x),), ulp=1.0),
    _function("acos", ACOS, lambda x, r: (-(1 / (1 - x * x).sqrt()),),
              numpy="arccos", demands=lambda x: ((Sign.NONNEGATIVE, 1 - x * x),), ulp=1.0),
    _function("atan", ATAN, lambda x, r: (1 / (1 + x * x),), numpy="arctan", ulp=1.0),
    Operation(
        "atan2", ATAN2, 2,
        partials=lambda y, x, r: (x / (x * x + y * y), -(y / (x * x + y * y))),
        demands=lambda y, x: ((Sign.NONZERO, x * x + y * y),),
        numpy="arctan2", casadi="OP_ATAN2", c="atan2({}, {})", sympy="atan2", ulp=1.0,
    ),
    _function("sinh", SINH, lambda x, r: (x.cosh(),), ulp=2.0),
    _function("cosh", COSH, lambda x, r: (x.sinh(),), ulp=2.0),
    _function("tanh", TANH, lambda x, r: (1 - r * r,), ulp=2.0),
    _function("asinh", ASINH, lambda x, r: (1 / (1 + x * x).sqrt(),), numpy="arcsinh", ulp=2.0),
    _function("acosh", ACOSH, lambda x, r: (1 / (x * x - 1).sqrt(),),
              numpy="arccosh", demands=lambda x: ((Sign.NONNEGATIVE, x - 1),), ulp=3.0),
    _function("atanh", ATANH, lambda x, r: (1 / (1 - x * x),),
              numpy="arctanh", demands=lambda x: ((Sign.POSITIVE, 1 - x * x),), ulp=2.0),
    Operation(
        "abs", ABS, 1, exact=abs, partials=lambda x, r: (x.sign(),),
        numpy="abs", casadi="OP_FABS", c="fabs({})", sympy="Abs",
    ),
    Operation(
        "sign", SIGN, 1, exact=lambda x: Fraction((x > 0) - (x < 0)),
        partials=lambda x, r: (0,), numpy="sign", casadi="OP_SIGN", sympy="sign",
        c="({0} > 0.0 ? 1.0 : ({0} < 0.0 ? -1.0 : {0}))",
    ),
    _function("floor", FLOOR, lambda x, r: (0,), exact=lambda x: Fraction(x.__floor__())),
    _relation("less", LESS, lambda x, y: x < y, "<", "OP_LT", "less", "StrictLessThan"),
    _relation("not_greater", NOT_GREATER, lambda x, y: x <= y, "<=", "OP_LE", "less_equal",
              "LessThan"),
    _relation("equal", EQUAL, lambda x, y: x == y, "==", "OP_EQ", "equal", "Equality",
              commutative=True),
    _relation("and", AND, lambda x, y: x != 0 and y != 0, "&&", "OP_AND", "logical_and", "And",
              commutative=True),
    _relation("or", OR, lambda x, y: x != 0 or y != 0, "||", "OP_OR", "logical_or", "Or",
              commutative=True),
    Operation(
        "not", NOT, 1, boolean=True,
        exact=lambda x: Fraction(x == 0), partials=lambda x, r: (0,),
        numpy="logical_not", casadi="OP_NOT", c="!{}", sympy="Not",
    ),
    Operation(
        "select", SELECT, 3, exact=lambda c, x, y: x if c != 0 else y,
        partials=lambda c, x, y, r: (0, c.choose(1, 0), c.choose(0, 1)),
        numpy="where", c="{} ? {} : {}", sympy="Piecewise",
    ),
    # x of M x = f; its operands are the entries of M and f, and `entry` takes the components of x.
    Operation("solve", SOLVE, 0),
    Operation("entry", ENTRY, 1),
    _function("erf", ERF, lambda x, r: (2 * (-(x * x)).exp() / x.builder.pi.sqrt(),),
              numpy="", ulp=1.0),
)  # fmt: skip

BY_NAME = {row.name: row for row in OPERATIONS}
ARITY = bytes(row.arity for row in OPERATIONS)
