"""One C function of the inline sine, evaluated in any domain, one value at a time.

    const double n = shifted - 0x1.8p52;          n is what the domain makes of shifted - 1.5 * 2^52

Every local variable is set once, so a value is found by following its text back to what is known.
What is known may stand anywhere in between: a proof about the second half of a function starts from
names in its middle.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import Source

FLOATS = ("float", "double")
BITS = {"int": 32, "unsigned int": 32, "uint32_t": 32, "uint64_t": 64}


class Typed(NamedTuple):
    """A value and its type in C; integers are Python's, modulo the length of their type."""

    kind: str
    value: Any


class Domain:
    """What floating numbers are, and what is done with them; `kind` is the type of the result.

    number(kind, value)       a literal             sum(kind, x, y)         x + y, rounded
    negative(kind, x)         -x                    product(kind, x, y)     x y, rounded
    cast(kind, old, x)        x in another type     fused(kind, x, y, z)    x y + z, rounded once
    bits(kind, x)             read as an integer    flipped(kind, x, mask)  with bits changed
    """

    def do(self, how: str, kind: str, *operands: Any) -> Any:
        """One of these operations; what a domain does not have it refuses."""
        method = getattr(self, how, None)
        if method is None:
            raise ExpressionError(f"{type(self).__name__}: {how} of a {kind} has no meaning there")
        return method(kind, *operands)


class Function:
    """A function of the text with arguments.

    Parameters
    ----------
    known : mapping of str to Any
        Values of parameters, and of local variables that are not to be followed further back.

    Raises
    ------
    ExpressionError
        If there is no such function, or it holds anything but what the inline sine has.
    """

    def __init__(self, source: Source, name: str, domain: Domain, known: Mapping[str, Any]) -> None:
        if name not in source.functions:
            raise ExpressionError(f"there is no function {name}")
        self._source, self._domain, self._known = source, domain, known
        self._texts: dict[str, Any] = {}
        self._stores: dict[str, Any] = {}
        self._found: dict[str, Typed] = {}
        self._followed: set[str] = set()
        self._unions: dict[str, Typed] = {}
        self._changes: list[Any] = []
        definition = source.functions[name]
        self.result = ""
        for parameter in definition.decl.type.args.params:
            if not isinstance(parameter.type, c_ast.PtrDecl) and parameter.name in known:
                kind = _kind(parameter.type)
                self._found[parameter.name] = Typed(kind, known[parameter.name])
        for statement in definition.body.block_items:
            self._statement(statement)
        self.kind = _kind(definition.decl.type.type)

    def _statement(self, node: Any) -> None:
        if isinstance(node, c_ast.Decl):
            if node.name in self._texts or node.name in self._unions:
                raise ExpressionError(f"{node.coord}: {node.name} is declared twice")
            if isinstance(node.type.type, c_ast.Union):
                self._unions[node.name] = Typed("", None)
            elif node.init is None:
                raise ExpressionError(f"{node.coord}: {node.name} has no value")
            else:
                self._texts[node.name] = node
        elif isinstance(node, c_ast.Return):
            self._stores["return"] = node.expr
        elif isinstance(node, c_ast.Assignment) and isinstance(node.lvalue, c_ast.StructRef):
            self._changes.append(node)
        elif (
            isinstance(node, c_ast.Assignment)
            and node.op == "="
            and isinstance(node.lvalue, c_ast.UnaryOp)
            and node.lvalue.op == "*"
            and node.lvalue.expr.name not in self._stores
        ):
            self._stores[node.lvalue.expr.name] = node.rvalue
        else:
            raise ExpressionError(f"{node.coord}: this is no statement of the inline sine")

    def stored(self, name: str) -> Typed:
        """What is stored where a pointer shows, or returned (``"return"``)."""
        if name not in self._stores:
            raise ExpressionError(f"nothing is stored in {name}")
        for change in self._changes:
            self._change(change)
        self._changes = []
        return self._value(self._stores[name])

    def __getitem__(self, name: str) -> Any:
        return self._named(name).value

    def _named(self, name: str) -> Typed:
        if name not in self._found:
            if name not in self._texts:
                raise ExpressionError(f"{name} has no value")
            node = self._texts[name]
            kind = _kind(node.type)
            if name in self._followed:
                raise ExpressionError(f"{node.coord}: {name} is made of itself")
            self._followed.add(name)
            value = (
                self._known[name]
                if name in self._known
                else self._as(kind, self._value(node.init)).value
            )
            self._found[name] = Typed(kind, value)
        return self._found[name]

    def _change(self, node: Any) -> None:
        """``both.number = x`` or ``both.bits ^= n``."""
        union, field = node.lvalue.name.name, node.lvalue.field.name
        value = self._value(node.rvalue)
        if field == "number" and node.op == "=":
            self._unions[union] = value
        elif field == "bits" and node.op == "^=" and self._unions[union].kind in FLOATS:
            kind, number = self._unions[union]
            self._unions[union] = Typed(kind, self._domain.do("flipped", kind, number, value.value))
        else:
            raise ExpressionError(f"{node.coord}: {union}.{field} {node.op} is not supported")

    def _as(self, kind: str, value: Typed) -> Typed:
        """The value in a type: floating types are converted, integers cut."""
        if kind == value.kind:
            return value
        if kind in FLOATS and value.kind in FLOATS:
            return Typed(kind, self._domain.do("cast", kind, value.kind, value.value))
        if kind in BITS and value.kind in BITS:
            return Typed(kind, value.value % 2 ** BITS[kind])
        raise ExpressionError(f"a {value.kind} is taken for a {kind}")

    def _value(self, node: Any) -> Typed:
        if isinstance(node, c_ast.Constant):
            if node.type.endswith("int"):
                kind = "unsigned int" if node.value[-1] in "uU" else "int"
                return Typed(kind, int(node.value.rstrip("uU"), 0))
            number = literal(node.value)
            return Typed(number.kind, self._domain.do("number", number.kind, number.value))
        if isinstance(node, c_ast.ID):
            return self._named(node.name)
        if isinstance(node, c_ast.StructRef):
            return self._field(node)
        if isinstance(node, c_ast.UnaryOp) and node.op in ("-", "+"):
            kind, value = self._value(node.expr)
            self._floating(kind, node)
            return Typed(
                kind, self._domain.do("negative", kind, value) if node.op == "-" else value
            )
        if isinstance(node, c_ast.BinaryOp):
            return self._combined(node)
        if isinstance(node, c_ast.TernaryOp):
            condition = self._value(node.cond)
            if condition.kind not in BITS:
                raise ExpressionError(f"{node.coord}: this condition is no integer")
            return self._value(node.iftrue if condition.value else node.iffalse)
        if isinstance(node, c_ast.Cast):
            return self._as(_kind(node.to_type.type), self._value(node.expr))
        if isinstance(node, c_ast.FuncCall):
            return self._call(node)
        raise ExpressionError(f"{node.coord}: {type(node).__name__} is not supported")

    def _floating(self, kind: str, node: Any) -> None:
        if kind not in FLOATS:
            raise ExpressionError(f"{node.coord}: a {kind} stands for a floating number")

    def _field(self, node: Any) -> Typed:
        kind, number = self._unions[node.name.name]
        if node.field.name == "number":
            return Typed(kind, number)
        self._floating(kind, node)
        integer = "uint32_t" if kind == "float" else "uint64_t"
        return Typed(integer, self._domain.do("bits", kind, number))

    def _combined(self, node: Any) -> Typed:
        left, right = self._value(node.left), self._value(node.right)
        if left.kind in BITS and right.kind in BITS:
            return _integer(node, left, right)
        self._floating(left.kind, node)
        self._floating(right.kind, node)
        kind = max(left.kind, right.kind, key=FLOATS.index)
        x, y = self._as(kind, left).value, self._as(kind, right).value
        if node.op in ("+", "-"):
            return Typed(
                kind,
                self._domain.do(
                    "sum", kind, x, y if node.op == "+" else self._domain.do("negative", kind, y)
                ),
            )
        if node.op == "*":
            return Typed(kind, self._domain.do("product", kind, x, y))
        raise ExpressionError(f"{node.coord}: {node.op} is not supported")

    def _call(self, node: Any) -> Typed:
        name, given = node.name.name, [self._value(x) for x in node.args.exprs]
        if name in ("fma", "fmaf"):
            kind = "double" if name == "fma" else "float"
            x, y, z = (self._as(kind, value).value for value in given)
            return Typed(kind, self._domain.do("fused", kind, x, y, z))
        if name not in self._source.functions:
            raise ExpressionError(f"{node.coord}: function {name} is not supported")
        parameters = self._source.functions[name].decl.type.args.params
        known = {
            p.name: self._as(_kind(p.type), value).value
            for p, value in zip(parameters, given, strict=True)
        }
        called = Function(self._source, name, self._domain, known)
        return self._as(called.kind, called.stored("return"))


def _kind(node: Any) -> str:
    """``double`` of a declaration; a pointer, a struct and what has several words are refused."""
    names = getattr(getattr(node, "type", None), "names", None)
    if names is None or (names != ["void"] and names[0] not in (*FLOATS, *BITS)):
        raise ExpressionError(f"{node.coord}: this type is not supported")
    return " ".join(names)


def _integer(node: Any, left: Typed, right: Typed) -> Typed:
    """Unsigned integers: C computes modulo the length of the wider type."""
    kind = max(left.kind, right.kind, key=lambda k: (BITS[k], k != "int"))
    if node.op == "<<":
        kind, value = left.kind, left.value << right.value
    elif node.op in ("&", "+"):
        value = left.value & right.value if node.op == "&" else left.value + right.value
    else:
        raise ExpressionError(f"{node.coord}: {node.op} of integers is not supported")
    return Typed(kind, value % 2 ** BITS[kind])
