"""C in fewer ways of saying: arrays of arrays as arrays, loops that count up from a declaration.

double A[2][3];  A[i][j]                  ->  double A[6];  A[i*3 + j]
f(double *y, double, int n) {...}         ->  f(const double *y), where n is not used, y only read
int i;  for (i = 0; i <= n; i++)          ->  for (int i = 0; i < n + 1; i++)
for (int i = n; i >= a; i--) s            ->  for (int k = 0; k < n - a + 1; ++k) {int i = n - k; s}
if (c) return a; s; return b;             ->  if (c) r = a; else {s; r = b;} return r;
"""

from copy import deepcopy
from dataclasses import replace
from itertools import pairwise
from typing import Any

from pycparser import c_ast

from mechanics.claims.code.c.library import below
from mechanics.claims.code.c.pointers import use_of
from mechanics.claims.code.c.wrapper import WRAPPER
from mechanics.errors import ExpressionError
from mechanics.program.c.parse import Source

LARGEST = 64
"""Entries of an array of arrays."""

Columns = dict[str, int]
KINDS = (c_ast.Decl, c_ast.Typename)
"""Of arguments, with and without a name."""


def flat(source: Source) -> Source:
    """The source in fewer ways of saying; its own tree is not changed.

    Raises
    ------
    ExpressionError
        For an array of arrays that is used in parts, and a parameter without a name of a function
        that is called, by line and column.
    """
    functions, prototypes = deepcopy((dict(source.functions), dict(source.prototypes)))
    called = {
        getattr(node.name, "name", "")
        for own, f in functions.items() if own != WRAPPER
        for node in below(f.body) if isinstance(node, c_ast.FuncCall)
    }  # fmt: skip
    for name, function in functions.items():
        if name in called:
            _refuse_nameless(function)
        else:
            _without_idle(function)
            _only_read(function)
    declarations = [(f, f.decl) for f in functions.values()]
    heads = {name: [_flat_declared(p, {}) for p in _parameters(f.decl)]
             for name, f in functions.items()}  # fmt: skip
    for known in prototypes.values():
        for declaration in known:
            if all(declaration is not own for _, own in declarations):
                _ = [_flat_declared(p, {}) for p in _parameters(declaration)]
    for name, function in functions.items():
        columns: Columns = {
            p.name: n for p, n in zip(_parameters(function.decl), heads[name], strict=True) if n
        }
        for node in below(function.body):
            if isinstance(node, c_ast.Decl):
                _flat_declared(node, columns)
        _uses(function.body, columns, heads)
        _loops(function.body, _plain_counters(function.body))
        _assignments(function.body)
        _one_way_out(function)
    return replace(source, functions=functions, prototypes=prototypes)


def _parameters(declaration: Any) -> list[Any]:
    arguments = declaration.type.args
    return [p for p in (arguments.params if arguments else []) if isinstance(p, c_ast.Decl)]


def _refuse_nameless(function: Any) -> None:
    """Refuse a parameter without a name of a function that is called: an argument is for it."""
    arguments = function.decl.type.args
    for parameter in arguments.params if arguments else []:
        if isinstance(parameter, c_ast.Typename) and _kind(parameter) != ["void"]:
            words = f"a parameter of {function.decl.name} has no name: give it one"
            raise ExpressionError(f"{function.decl.coord}: {words}")


def _kind(parameter: Any) -> list[str] | None:
    """The words of a number's type; none of a pointer and an array."""
    return getattr(getattr(parameter.type, "type", None), "names", None)


def _without_idle(function: Any) -> None:
    """Leave out arguments without a name, and numbers that are not used."""
    arguments = function.decl.type.args
    if arguments is None or not all(isinstance(p, KINDS) for p in arguments.params):
        return
    used = {node.name for node in below(function.body) if isinstance(node, c_ast.ID)}

    def idle(parameter: Any) -> bool:
        words = _kind(parameter)
        if not getattr(parameter, "name", None):
            return words != ["void"]
        return words is not None and parameter.name not in used

    arguments.params = [p for p in arguments.params if not idle(p)]


def _only_read(function: Any) -> None:
    """Say const of pointers that are only read."""
    for parameter in _parameters(function.decl):
        kind = parameter.type
        pointer = isinstance(kind, c_ast.PtrDecl | c_ast.ArrayDecl)
        if not pointer or not isinstance(kind.type, c_ast.TypeDecl):
            continue
        if "const" not in kind.type.quals and not use_of(function.body, parameter.name).written:
            kind.type.quals = [*kind.type.quals, "const"]


def _number(node: Any) -> int | None:
    try:
        return int(node.value, 0) if isinstance(node, c_ast.Constant) else None
    except ValueError:
        return None


def _flat_declared(node: Any, columns: Columns) -> int:
    """Declare an array of arrays as an array; its columns, 0 for what is none."""
    outer = node.type
    if not (isinstance(outer, c_ast.ArrayDecl) and isinstance(outer.type, c_ast.ArrayDecl)):
        if node.name in columns:
            raise ExpressionError(f"{node.coord}: {node.name} is declared twice: rename it")
        return 0
    rows, width = _number(outer.dim) if outer.dim else 1, _number(outer.type.dim)
    if rows is None or width is None or not 0 < rows * width <= LARGEST:
        raise ExpressionError(f"{node.coord}: the sizes of {node.name} are not supported")
    if columns.get(node.name, width) != width:
        raise ExpressionError(f"{node.coord}: {node.name} is declared twice: rename it")
    columns[node.name] = width
    inner = outer.type.type
    size = c_ast.Constant("int", str(rows * width), node.coord) if outer.dim else None
    node.type = c_ast.ArrayDecl(inner, size, outer.dim_quals, outer.coord)
    if node.init is not None:
        node.init = c_ast.InitList(_entries(node, rows, width), node.coord)
    return width


def _entries(node: Any, rows: int, width: int) -> list[Any]:
    """Entries of an array of arrays in one row; those that are left out are 0."""
    zero = c_ast.Constant("double", "0.0", node.coord)
    given = node.init.exprs if isinstance(node.init, c_ast.InitList) else []
    found: list[Any] = []
    for row in given:
        if not isinstance(row, c_ast.InitList):
            if len(given) not in (1, rows * width):
                raise ExpressionError(f"{node.coord}: write the rows of {node.name} in braces")
            found.append(row)
            continue
        if len(row.exprs) > width:
            raise ExpressionError(f"{node.coord}: a row of {node.name} is longer than {width}")
        found += [*row.exprs, *[zero] * (width - len(row.exprs))]
    if not found or len(found) > rows * width:
        raise ExpressionError(f"{node.coord}: write the rows of {node.name} in braces")
    return [*found, *[zero] * (rows * width - len(found))]


def _uses(node: Any, columns: Columns, heads: dict[str, list[int]]) -> None:
    """Put two places into one, wherever an array of arrays is used."""
    match node:
        case c_ast.ArrayRef(name=c_ast.ArrayRef(name=c_ast.ID(name=name), subscript=row)) if (
            name in columns
        ):
            place, width = node.subscript, columns[name]
            if (_number(place) or 0) >= width:
                raise ExpressionError(f"{node.coord}: {name} has {width} columns")
            _uses(row, columns, heads)
            _uses(place, columns, heads)
            factor = c_ast.Constant("int", str(width), node.coord)
            first = c_ast.BinaryOp("*", row, factor, node.coord)
            node.name = node.name.name
            node.subscript = c_ast.BinaryOp("+", first, place, node.coord)
            return
        case c_ast.FuncCall(name=c_ast.ID(name=name), args=c_ast.ExprList(exprs=given)):
            widths = heads.get(name, [])
            for k, argument in enumerate(given):
                wanted = widths[k] if k < len(widths) else 0
                own = isinstance(argument, c_ast.ID) and columns.get(argument.name)
                if own and own == wanted:
                    continue
                if wanted:
                    words = f"{name}() takes an array of arrays with {wanted} columns"
                    raise ExpressionError(f"{node.coord}: {words}: pass one as it is")
                _uses(argument, columns, heads)
            return
        case c_ast.ID(name=name) if name in columns:
            raise ExpressionError(
                f"{node.coord}: {name} is an array of arrays: give both places, {name}[i][j]"
            )
    for _, child in node.children():
        _uses(child, columns, heads)


def _plain_counters(body: Any) -> dict[str, Any]:
    """Integers that are declared without a value, and have one in the loops alone they count."""
    inside = {
        (node.init.lvalue.name, id(one))
        for node in below(body)
        if isinstance(node, c_ast.For) and isinstance(node.init, c_ast.Assignment)
        and isinstance(node.init.lvalue, c_ast.ID)
        for one in below(node)
    }  # fmt: skip
    elsewhere = {
        node.name
        for node in below(body)
        if isinstance(node, c_ast.ID) and (node.name, id(node)) not in inside
    }
    return {
        node.name: node
        for node in below(body)
        if isinstance(node, c_ast.Decl) and node.init is None and node.name not in elsewhere
        and isinstance(node.type, c_ast.TypeDecl)
        and getattr(node.type.type, "names", None) == ["int"]
    }  # fmt: skip


def _loops(node: Any, counters: dict[str, Any]) -> None:
    """Write loops as counting up from their own declaration."""
    for _, child in node.children():
        _loops(child, counters)
    if not isinstance(node, c_ast.For):
        return
    match node.init:
        case c_ast.Assignment(op="=", lvalue=c_ast.ID(name=name)) if name in counters:
            own = deepcopy(counters[name])
            own.init, own.coord = node.init.rvalue, node.init.coord
            node.init = c_ast.DeclList([own], node.coord)
    if not (isinstance(node.init, c_ast.DeclList) and len(node.init.decls) == 1):
        return
    counter, condition = node.init.decls[0], node.cond
    if not (isinstance(condition, c_ast.BinaryOp) and isinstance(condition.left, c_ast.ID)):
        return
    if condition.left.name != counter.name or counter.init is None:
        return
    one = c_ast.Constant("int", "1", node.coord)
    if condition.op == "<=":
        last = c_ast.BinaryOp("+", condition.right, one, node.coord)
        node.cond = c_ast.BinaryOp("<", condition.left, last, node.coord)
    elif condition.op in (">=", ">") and _counts_down(node.next, counter.name):
        _turned(node, counter, one)


def _counts_down(node: Any, name: str) -> bool:
    down = isinstance(node, c_ast.UnaryOp) and node.op in ("--", "p--")
    return down and getattr(node.expr, "name", None) == name


def _turned(node: Any, counter: Any, one: Any) -> None:
    """A loop that counts down as one that counts up."""
    turn = f"{counter.name}_turn"
    if any(getattr(below, "name", None) == turn for below in below(node)):
        return
    first, last = counter.init, node.cond.right
    length = c_ast.BinaryOp("-", deepcopy(first), last, node.coord)
    if node.cond.op == ">=":
        length = c_ast.BinaryOp("+", length, one, node.coord)
    up = deepcopy(counter)
    up.name = up.type.declname = turn
    up.init = c_ast.Constant("int", "0", node.coord)
    counter.init = c_ast.BinaryOp("-", first, c_ast.ID(turn, node.coord), node.coord)
    node.init = c_ast.DeclList([up], node.coord)
    node.cond = c_ast.BinaryOp("<", c_ast.ID(turn, node.coord), length, node.coord)
    node.next = c_ast.UnaryOp("++", c_ast.ID(turn, node.coord), node.coord)
    node.stmt = c_ast.Compound([counter, node.stmt], node.coord)


def _assignments(node: Any) -> None:
    """Write assignments of assignments one by one, the inner one first."""
    for _, child in node.children():
        _assignments(child)
    if not isinstance(node, c_ast.Compound) or not node.block_items:
        return
    found: list[Any] = []
    for item in node.block_items:
        chain = [item]
        while _assigns(chain[-1]) and _assigns(chain[-1].rvalue):
            chain.append(chain[-1].rvalue)
        for outer, inner in pairwise(chain):
            outer.rvalue = deepcopy(inner.lvalue)
        found += reversed(chain)
    node.block_items = found


def _assigns(node: Any) -> bool:
    return isinstance(node, c_ast.Assignment) and node.op == "="


def _one_way_out(function: Any) -> None:
    """Return at the end alone, where each branch that returns does so on all its ways."""
    statements, kind = function.body.block_items or [], function.decl.type.type
    words, where = getattr(kind.type, "names", None), function.coord
    name = f"{function.decl.name}_result" if words == ["double"] else ""
    early = any(_returns(one) and not isinstance(one, c_ast.Return) for one in statements)
    taken = name and any(getattr(node, "name", None) == name for node in below(function))
    if taken or not early or words not in (["double"], ["void"]):
        return
    joined = _without_returns(statements, name)
    if joined is None:
        return
    if name:
        inner = c_ast.TypeDecl(name, [], None, kind.type, where)
        result = c_ast.Decl(name, [], [], [], [], inner, None, None, where)
        joined = [result, *joined, c_ast.Return(c_ast.ID(name, where), where)]
    function.body.block_items = joined


def _returns(node: Any) -> bool:
    return any(isinstance(below, c_ast.Return) for below in below(node))


def _without_returns(statements: list[Any], name: str) -> list[Any] | None:
    """Statements that set the result instead; None where a branch returns on some ways only."""
    at = next((k for k, one in enumerate(statements) if _returns(one)), None)
    if at is None:
        return None if name else statements
    one, before, rest = statements[at], statements[:at], statements[at + 1 :]
    if isinstance(one, c_ast.Return) and not rest and (one.expr is not None) is bool(name):
        set_ = c_ast.Assignment("=", c_ast.ID(name, one.coord), one.expr, one.coord)
        return [*before, set_] if name else before
    if not isinstance(one, c_ast.If):
        return None
    branches = one.iftrue, one.iffalse
    going_on = [branch for branch in branches if branch is None or not _ends(branch)]
    if rest and len(going_on) != 1:
        return None
    sides = []
    for branch in branches:
        if branch in going_on:
            # What follows sees nothing that the branch declares.
            own = [*([] if branch is None else [branch]), *rest]
        else:
            own = branch.block_items if isinstance(branch, c_ast.Compound) else [branch]
        sides.append(_without_returns(own, name))
    if None in sides:
        return None
    return [*before, c_ast.If(one.cond, *(c_ast.Compound(side) for side in sides), one.coord)]


def _ends(node: Any) -> bool:
    """Whether every way through a statement returns."""
    if isinstance(node, c_ast.Compound):
        return bool(node.block_items) and _ends(node.block_items[-1])
    if isinstance(node, c_ast.If):
        return node.iffalse is not None and _ends(node.iftrue) and _ends(node.iffalse)
    return isinstance(node, c_ast.Return)
