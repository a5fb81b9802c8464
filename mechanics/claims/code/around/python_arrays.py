"""Arrays of integers, or of few digits, that are given rates or states: these are rounded there.

y = np.array([1, 0]);  y += dt*rate(t, y)           stays an array of integers
ys = np.zeros((9, 2), dtype=np.float16)             rounds each state that is put in it

A new array, y = y + dt*rate(t, y), has doubles.
"""

import ast
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

from mechanics.claims.code.around.python_form import DEFINED, arguments_of, word
from mechanics.claims.code.around.python_laws import root_in, roots_in

MADE_OF = frozenset(("array", "asarray", "full_like", "zeros_like", "ones_like", "empty_like",
                     "copy", "stack", "hstack", "vstack", "concatenate"))  # fmt: skip
"""Makers of arrays that have the numbers of what they are given; full has those of its second."""
COUNTING = frozenset(("arange",))
DOUBLES = frozenset(("float", "float64", "double", "longdouble", "complex", "complex128", "f8", "d",
                     "float_", "np.float64", "object", "None"))  # fmt: skip
SAME = frozenset(("reshape", "copy", "ravel", "flatten", "squeeze", "transpose", "view"))
ROUNDED = frozenset(
    ("randint", "integers", "int64", "int32", "int16", "int8", "intp", "float16", "half", "single")
)
TYPED = {"zeros": 1, "ones": 1, "empty": 1, "array": 1, "asarray": 1, "full": 2, "zeros_like": 1,
         "ones_like": 1, "empty_like": 1, "full_like": 2, "astype": 0, "arange": 3}  # fmt: skip
"""Where the type of the entries stands among arguments, by makers of arrays."""


def rounding(tree: ast.Module, functions: Collection[str]) -> Iterator[ast.stmt]:
    """Lines that make an array which rounds rates or states that others put in it.

    Parameters
    ----------
    tree : ast.Module
    functions : collection of str
        Judged functions, what uses these, and names under which they are passed.
    """
    yield from _Arrays(tree, functions).rounding()


@dataclass(frozen=True)
class _Arrays:
    tree: ast.Module
    functions: Collection[str]

    @cached_property
    def nodes(self) -> list[ast.AST]:
        return [*ast.walk(self.tree)]

    @cached_property
    def assigned(self) -> list[tuple[ast.stmt, ast.expr, ast.expr]]:
        """Lines, with a target and its value."""
        found: list[tuple[ast.stmt, ast.expr, ast.expr]] = []
        for one in self.nodes:
            match one:
                case ast.Assign(targets=targets, value=value):
                    for target in targets:
                        pairs = [(target, value)]
                        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                            pairs = [*zip(target.elts, value.elts, strict=False)]
                        found += [(one, t, v) for t, v in pairs]
                case ast.AnnAssign(target=target, value=ast.expr() as value):
                    found.append((one, target, value))
        return found

    @cached_property
    def made(self) -> set[str]:
        """Names of what the functions returned, and of what is made of it."""
        found: set[str] = set()
        while new := {
            root for _, target, value in self.assigned if self._is_made(value, found)
            for root in _roots(target)
        } - found:  # fmt: skip
            found |= new
        return found

    def _is_made(self, value: ast.AST, made: Collection[str]) -> bool:
        called = any(isinstance(n, ast.Call) and word(n.func) in self.functions
                     for n in ast.walk(value))  # fmt: skip
        return called or not roots_in(value).isdisjoint(made)

    @cached_property
    def filled(self) -> set[str]:
        """Names of arrays into which something that is made of rates is put."""
        found: set[str] = set()
        for one in self.nodes:
            if isinstance(one, ast.AugAssign) and self._is_made(one.value, self.made):
                found |= {root_in(one.target)}
            elif any(k.arg == "out" for k in getattr(one, "keywords", ())):
                found |= {root_in(k.value) for k in getattr(one, "keywords", ()) if k.arg == "out"}
        for _, target, value in self.assigned:
            for part in ast.walk(target):
                if isinstance(part, ast.Subscript) and self._is_made(value, self.made):
                    found.add(root_in(part))
        return found - {""}

    @cached_property
    def filling(self) -> Mapping[str, set[int]]:
        """Functions of the file, with the places of arguments that they fill so."""
        found: dict[str, set[int]] = {}
        for one in self.nodes:
            if isinstance(one, DEFINED):
                inside = _Arrays(ast.Module(one.body, []), self.functions)
                names = arguments_of(one.args)
                found[one.name] = {k for k, name in enumerate(names) if name in inside.filled}
        return found

    def rounding(self) -> Iterator[ast.stmt]:
        """Lines that make an array which rounds."""
        names: set[str] = set()
        for line, target, value in self.assigned:
            copied = isinstance(value, ast.Call) and word(value.func) in ("copy", "asarray", "view")
            same = copied and not roots_in(value).isdisjoint(names)
            if (same or self._rounds(value)) and not isinstance(target, ast.Subscript):
                names |= {*_roots(target)}
                if self.filled & {*_roots(target)}:
                    yield line
        for line in (n for n in self.nodes if isinstance(n, ast.stmt)):
            calls = [n for n in _own(line) if isinstance(n, ast.Call)]
            for call in calls:
                given = [a for k, a in enumerate(call.args)
                         if k in self.filling.get(word(call.func), ())]  # fmt: skip
                if any(self._rounds(a) or root_in(a) in names for a in given):
                    yield line

    def _rounds(self, node: ast.expr) -> bool:
        """Whether it makes an array of other numbers than doubles."""
        if isinstance(node, ast.Subscript):
            stacked = word(node.value) in ("r_", "c_") and self._is_whole(node.slice)
            return stacked or self._rounds(node.value)
        if not isinstance(node, ast.Call):
            return False
        name = word(node.func)
        if name in ROUNDED:
            return True
        if name in SAME and isinstance(node.func, ast.Attribute) and self._rounds(node.func.value):
            return True
        kind = next((k.value for k in node.keywords if k.arg == "dtype"), None)
        place = TYPED.get(name)
        if kind is None and place is not None and len(node.args) > place:
            kind = node.args[place]
        if kind is not None:
            return _kind(kind) not in DOUBLES
        if name == "full":
            return len(node.args) > 1 and self._is_whole(node.args[1])
        if name in COUNTING:
            return all(map(self._is_whole, node.args))
        if name == "astype" or not node.args:
            return False
        inner = node.args[0]
        return name in MADE_OF and (self._is_whole(inner) or self._rounds(inner))

    def _is_whole(self, node: ast.expr, seen: frozenset[str] = frozenset()) -> bool:
        """Whether it is made of integers only, as they are written."""
        whole = partial(self._is_whole, seen=seen)
        match node:
            case ast.Constant(value=value):
                return type(value) in (int, bool)
            case ast.UnaryOp(operand=inner):
                return whole(inner)
            case ast.BinOp(left=left, right=right, op=op):
                return not isinstance(op, ast.Div) and whole(left) and whole(right)
            case ast.List(elts=parts) | ast.Tuple(elts=parts):
                return bool(parts) and all(map(whole, parts))
            case ast.Call(func=ast.Name(id="int" | "len" | "range")):
                return True
            case ast.Name(id=name) if name not in seen:
                given = [v for _, target, v in self.assigned if word(target) == name]
                written = partial(self._is_whole, seen=seen | {name})
                return bool(given) and all(map(written, given))
        return False


def _roots(target: ast.expr) -> Iterator[str]:
    parts: Sequence[ast.expr] = target.elts if isinstance(target, ast.Tuple) else [target]
    yield from (root for part in parts if (root := root_in(part)))


def _own(line: ast.stmt) -> Iterator[ast.AST]:
    """Nodes of a line, without those of lines inside of it."""
    for part in ast.iter_child_nodes(line):
        if not isinstance(part, ast.stmt):
            yield from ast.walk(part)


def _kind(node: ast.expr) -> str:
    if isinstance(node, ast.Constant):
        return str(node.value)
    return word(node) or ast.unparse(node)
