"""What a mutant is, and all that a file has: one piece of its text replaced by another.

Pieces are found in the syntax tree; text that only people read (messages, docstrings, annotations)
is left alone. A mutant is named by what it replaces and where, without the number of the line, so
that its name lasts when other lines change.
"""

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from hashlib import sha256

ORDER = {"Lt": ("<=", ">="), "LtE": ("<", ">"), "Gt": (">=", "<="), "GtE": (">", "<"),
         "Eq": ("!=",), "NotEq": ("==",), "Is": ("is not",), "IsNot": ("is",),
         "In": ("not in",), "NotIn": ("in",)}  # fmt: skip
ARITHMETIC = {"Add": ("+", "-"), "Sub": ("-", "+"), "Mult": ("*", "/"), "Div": ("/", "*"),
              "FloorDiv": ("//", "/"), "Mod": ("%", "*"), "Pow": ("**", "*"),
              "LShift": ("<<", ">>"), "RShift": (">>", "<<"), "BitAnd": ("&", "|"),
              "BitOr": ("|", "&")}  # fmt: skip
NAMES = {"min": "max", "max": "min", "ceil": "floor", "floor": "ceil", "any": "all", "all": "any",
         "upper": "lower", "lower": "upper", "abs": "", "sorted": "list"}  # fmt: skip
STRICT = ("comparison", "condition", "bound", "sign")
"""Kinds of which none may survive in the kernel: comparisons, sign tests and error bounds."""
LARGEST = 16
BOUND = ("bound", "error", "log2", "degree", "height", "radius", "bits", "chance", "size", "sign")


@dataclass(frozen=True)
class Mutant:
    """One change of a file.

    Attributes
    ----------
    path : str
        Below ``mechanics/``.
    start, end : int
        Bytes of the text that is replaced.
    new : str
        What stands there instead.
    kind : str
        What is changed: ``comparison``, ``sign``, ``constant``, ...
    function : str
        Qualified name; empty at the level of the module.
    in_function : bool
        Whether the body of a function is changed that nothing calls while it is imported.
    name : str
        Function, line with the change, and which of equal ones it is.
    """

    path: str
    start: int
    end: int
    new: str
    kind: str
    function: str
    in_function: bool
    name: str

    @property
    def key(self) -> str:
        """Twelve hexadecimal digits that draw and name the mutant."""
        return sha256(f"{self.path} {self.name}".encode()).hexdigest()[:12]

    def apply(self, text: str) -> str:
        """The text of the file with the change."""
        data = text.encode()
        return (data[: self.start] + self.new.encode() + data[self.end :]).decode()


def is_python(text: str) -> bool:
    """Whether a text can be parsed."""
    try:
        ast.parse(text)
    except SyntaxError:
        return False
    return True


def mutants(path: str, text: str) -> list[Mutant]:
    """All mutants of a file; some of them may be no Python, which `is_python` tells."""
    data, seen, made = text.encode(), Counter[str](), []
    starts = [0]
    for line in data.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def where(node: ast.AST) -> tuple[int, int]:
        return (starts[node.lineno - 1] + node.col_offset,
                starts[node.end_lineno - 1] + node.end_col_offset)  # fmt: skip

    tree = ast.parse(text)
    makers = {called_name(call) for call in _calls_of_the_module(tree)}
    bodies = [
        (where(node.body[0])[0], where(node.body[-1])[1])
        for node in _functions(tree) if node.name not in makers
    ]  # fmt: skip
    for function, kind, first, last, new in _changes(tree, data, where):
        row = max(i for i, start in enumerate(starts) if start <= first)
        old = data[first:last].decode()
        line = data[starts[row] : starts[row + 1]].decode().strip()
        label = f"{function}: {kind} {' '.join(old.split())[:60]} -> {new} in {line}"
        seen[label] += 1
        name = f"{label} #{seen[label]}"
        inside = any(start <= first < end for start, end in bodies)
        # A budget at the head of a module is no statement that could be wrong by one.
        if not inside and old.replace("_", "").isdigit() and int(old) > LARGEST:
            continue
        strict = _strict(kind, function, line)
        made.append(Mutant(path, first, last, new, strict, function, inside, name))
    return made


def _functions(tree: ast.AST) -> Iterator[ast.FunctionDef]:
    """Functions and methods, outermost ones."""
    for child in ast.iter_child_nodes(tree):
        if isinstance(child, ast.FunctionDef):
            yield child
        elif isinstance(child, ast.ClassDef):
            yield from _functions(child)


def _calls_of_the_module(tree: ast.AST) -> Iterator[ast.Call]:
    """Calls that are made when the module is imported: what they made stays what it is."""
    for child in ast.iter_child_nodes(tree):
        if isinstance(child, ast.Call):
            yield child
        if not isinstance(child, ast.FunctionDef | ast.Lambda):
            yield from _calls_of_the_module(child)


def called_name(call: ast.Call) -> str:
    """Last name of what is called."""
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def _strict(kind: str, function: str, line: str) -> str:
    """Whatever is changed in a line or function about bounds is a change of a bound."""
    words = f"{function} {line}".lower()
    return "bound" if kind not in STRICT and any(word in words for word in BOUND) else kind


def _changes(tree: ast.AST, data: bytes, where) -> Iterator[tuple[str, str, int, int, str]]:
    """(function, kind, first byte, last byte, new text) of every change."""
    stack: list[tuple[ast.AST, str, bool]] = [(tree, "", True)]
    while stack:
        node, function, outside = stack.pop()
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and (
            outside or isinstance(node, ast.ClassDef)
        ):
            function = f"{function}.{node.name}" if function else node.name
            outside = isinstance(node, ast.ClassDef)
        for kind, first, last, new in _own(node, data, where):
            yield function, kind, first, last, new
        stack += [(child, function, outside) for child in reversed(list(_children(node)))]


def _children(node: ast.AST) -> Iterator[ast.AST]:
    """What is run of a node: no annotations, messages, decorators and names for export."""
    match node:
        case ast.JoinedStr() | ast.Raise() | ast.Import() | ast.ImportFrom():
            return
        case ast.AnnAssign(value=value):
            yield from [value] if value else []
        case ast.FunctionDef(args=args, body=body):
            yield from (*args.defaults, *(d for d in args.kw_defaults if d), *body)
        case ast.ClassDef(body=body):
            yield from body
        case ast.Assign(targets=[ast.Name(id="__all__")]):
            return
        case ast.If(test=ast.Name(id="TYPE_CHECKING")):
            return
        case ast.Subscript(value=ast.Name(id="Counter" | "list" | "dict" | "tuple" | "set")):
            return
        case _:
            yield from ast.iter_child_nodes(node)


def _own(node: ast.AST, data: bytes, where) -> Iterator[tuple[str, int, int, str]]:
    """Changes of one node itself."""

    def between(left: ast.AST, right: ast.AST, old: str) -> tuple[int, int]:
        first, last = where(left)[1], where(right)[0]
        first += data[first:last].decode().index(old)
        return first, first + len(old)

    def text(part: ast.AST) -> str:
        first, last = where(part)
        return data[first:last].decode()

    match node:
        case ast.Compare(left=left, ops=ops, comparators=rest):
            for one, op, other in zip((left, *rest[:-1]), ops, rest, strict=True):
                old = {"IsNot": "is not", "NotIn": "not in", "Is": "is", "In": "in"}.get(
                    type(op).__name__
                ) or {"Lt": "<", "LtE": "<=", "Gt": ">", "GtE": ">=", "Eq": "==",
                      "NotEq": "!="}[type(op).__name__]  # fmt: skip
                for new in ORDER[type(op).__name__]:
                    yield "comparison", *between(one, other, old), new
        case ast.BinOp(left=left, op=op, right=right) if type(op).__name__ in ARITHMETIC:
            if isinstance(left, ast.Constant) and isinstance(left.value, str):
                return
            old, new = ARITHMETIC[type(op).__name__]
            yield "sign" if old in "+-" else "operation", *between(left, right, old), new
        case ast.AugAssign(target=target, op=op, value=value) if type(op).__name__ in ARITHMETIC:
            old, new = ARITHMETIC[type(op).__name__]
            yield "sign" if old in "+-" else "operation", *between(target, value, old), new
        case ast.UnaryOp(op=ast.USub() | ast.Not(), operand=operand):
            kind = "sign" if isinstance(node.op, ast.USub) else "condition"
            yield kind, where(node)[0], where(operand)[0], " "
        case ast.BoolOp(op=op, values=[one, other, *_]):
            old, new = ("and", "or") if isinstance(op, ast.And) else ("or", "and")
            yield "condition", *between(one, other, old), new
        case ast.Constant(value=bool() as value):
            yield "constant", *where(node), str(not value)
        case ast.Constant(value=int() as value):
            yield "constant", *where(node), str(value + 1)
            if value:
                yield "constant", *where(node), str(value - 1)
        case ast.Constant(value=float() as value):
            yield "constant", *where(node), f"({value!r} * 2)"
        case ast.If(test=test) | ast.IfExp(test=test) | ast.While(test=test):
            yield "condition", *where(test), "False"
            if not isinstance(node, ast.While):
                yield "condition", *where(test), f"(not ({text(test)}))"
        case ast.comprehension(ifs=[test, *_]):
            yield "condition", *where(test), "True"
    match node:
        case (
            ast.Expr(value=ast.Call())
            | ast.Raise()
            | ast.AugAssign()
            | ast.Continue()
            | ast.Break()
            | ast.Assign(targets=[ast.Subscript() | ast.Attribute()])
        ):
            yield "deletion", *where(node), "pass"
    if isinstance(node, ast.Call):
        called = called_name(node)
        if (called in NAMES and node.args) or (called in ("upper", "lower") and not node.args):
            last = where(node.func)[1]
            yield "bound", last - len(called), last, NAMES[called]
        match node.args:
            case [one, other, *_] if not isinstance(one, ast.Starred) and text(one) != text(other):
                first, last = where(one)[0], where(other)[1]
                middle = data[where(one)[1] : where(other)[0]].decode()
                yield "arguments", first, last, f"{text(other)}{middle}{text(one)}"
