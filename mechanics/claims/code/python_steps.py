"""Loops of Python that advance a state, and whether an integrator does so with a judged function.

w += accel(th, w)*dt; th += w*dt        k1 = f(t, y); ...; y = y + dt/6*(k1 + 2*k2 + 2*k3 + k4)
Y[i+1] = Y[i] + dt*f(t[i], Y[i])        th.append(th[-1] + dt*w[-1])

A turn of the loop is followed once, with formulas of no mechanics for what the function returns:
which ones do not matter, since an integrator is one for all of them.
"""

import ast
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from random import Random

from sympy import Add, Expr, Rational, S, Symbol, nan, oo, zoo

from mechanics.claims.code.integrators import NAMES, STEP, alike, integrator_of, put

Value = Callable[[int | None], Expr]
"""Entries of a vector by their index, or all of it where it is moved as a whole."""
SAME = ("array", "asarray", "float", "copy", "float64", "list", "tuple")
MOST = 8
"""Names that may be the time of a step."""


@dataclass(frozen=True)
class Called:
    """A judged function.

    Attributes
    ----------
    name : str
    slots : tuple of (str, str, int)
        Names of its arguments, each with what it is: ``"q"`` or ``"u"`` and of which coordinate,
        ``"state"``, ``"time"``, ``"parameter"`` or ``"other"``.
    timed : bool
        Whether time makes a difference.
    """

    name: str
    slots: tuple[tuple[str, str, int], ...]
    timed: bool = False


@dataclass(frozen=True)
class _Halves:
    q: tuple[Expr, ...]
    u: tuple[Expr, ...]


class Unknown(Exception):
    """A line that is not followed."""


def stepped(
    body: Sequence[ast.stmt], functions: Mapping[str, Called], size: int,
    fixed: Mapping[str, ast.expr],
) -> set[str]:  # fmt: skip
    """Names of what a loop advances as an integrator does, with judged functions.

    Parameters
    ----------
    body : sequence of ast.stmt
        Of the loop.
    functions : mapping of str to Called
        Judged ones by name.
    size : int
        Entries of a state.
    fixed : mapping of str to ast.expr
        What names are that have one value.
    """
    for step in _steps(body):
        turn = _Turn(functions, size, step, fixed)
        try:
            turn.run(body)
            if (found := turn.found()) is not None:
                return found
        except Unknown:
            continue
    return set()


def _steps(body: Sequence[ast.stmt]) -> list[str]:
    """What may be the time of a step, likely ones first."""
    found: dict[str, int] = {}
    for line in body:
        for one in ast.walk(line):
            if isinstance(one, ast.Name | ast.Attribute) and isinstance(one.ctx, ast.Load):
                word = getattr(one, "id", getattr(one, "attr", ""))
                found.setdefault(ast.unparse(one), 0 if word in NAMES else 2)
            elif isinstance(one, ast.Constant) and type(one.value) is float:
                found.setdefault(ast.unparse(one), 1)
            elif isinstance(one, ast.BinOp) and isinstance(one.op, ast.Sub) and _is_grid(one):
                found.setdefault(ast.unparse(one), 0)
    return sorted(found, key=lambda text: found[text])[:MOST]


def _is_grid(node: ast.BinOp) -> bool:
    """Whether it is the difference of two entries of one thing: t[i+1] - t[i]."""
    left, right = node.left, node.right
    return (
        isinstance(left, ast.Subscript)
        and isinstance(right, ast.Subscript)
        and ast.unparse(left.value) == ast.unparse(right.value)
    )


@dataclass
class _Turn:
    functions: Mapping[str, Called]
    size: int
    step: str
    fixed: Mapping[str, ast.expr]
    values: dict[str, Value] = field(default_factory=dict)
    used: dict[str, set[int | None]] = field(default_factory=dict)
    written: dict[str, None] = field(default_factory=dict)
    followed: set[str] = field(default_factory=set)
    calls: list[tuple[Called, dict[tuple[str, int], Value]]] = field(default_factory=list)

    def run(self, body: Sequence[ast.stmt]) -> None:
        """Follow the lines of a turn."""
        for line in body:
            self._line(line)

    def _line(self, line: ast.stmt) -> None:
        match line:
            case ast.Assign(targets=targets, value=value):
                made = self._value(value)
                for target in targets:
                    self._put(target, made)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                self._put(target, self._value(value))
            case ast.AugAssign(target=target, op=op, value=value):
                read = ast.parse(ast.unparse(target), mode="eval").body
                self._put(target, self._value(ast.BinOp(read, op, value)))
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=ast.Name(id=name), attr="append"),
                                         args=[value])):  # fmt: skip
                made = self._value(value)
                self.values[f"{name}[-1]"] = made
                self.written[f"{name}[-1]"] = None
            case ast.If() | ast.For() | ast.While() | ast.With() | ast.Try():
                inside = {_root(ast.unparse(n)) for n in ast.walk(line) if isinstance(
                    getattr(n, "ctx", None), ast.Store)}  # fmt: skip
                if inside & {_root(name) for name in (*self.values, *self.used)}:
                    raise Unknown

    def _put(self, target: ast.expr, made: Value) -> None:
        match target:
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                for k, part in enumerate(parts):
                    self._put(part, _entry(made, k))
            case ast.Subscript(value=base, slice=ast.Constant(value=int(k))) if k >= 0:
                old = self._value(_loaded(base))
                name = self._key(_loaded(base))

                def changed(i: int | None) -> Expr:
                    if i is None:
                        raise Unknown
                    return made(None) if i == k else old(i)

                self.values[name] = changed
                self.written[name] = None
            case _:
                name = self._key(_loaded(target))
                self.values[name] = made
                self.written[name] = None

    def _key(self, node: ast.expr) -> str:
        """What a place is called: an entry of an array by its distance from the turn's."""
        if isinstance(node, ast.Subscript):
            inner = node.slice
            parts = [*inner.elts] if isinstance(inner, ast.Tuple) else [inner]
            parts = [p for p in parts if not (isinstance(p, ast.Slice) and not _kept(p))]
            if not parts:
                return self._key(node.value)
            if len(parts) > 1:
                raise Unknown
            return f"{self._key(node.value)}[{_offset(parts[0])}]"
        if isinstance(node, ast.Name | ast.Attribute):
            return ast.unparse(node)
        raise Unknown

    def _value(self, node: ast.expr) -> Value:
        if ast.unparse(node) == self.step:
            return lambda i: STEP
        match node:
            case ast.Constant(value=int() | float() as number):
                exact = Rational(str(number))
                return lambda i: exact
            case ast.NamedExpr(target=target, value=value):
                made = self._value(value)
                self._put(target, made)
                return made
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                return _column([self._value(part) for part in parts])
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                made = self._value(inner)
                return lambda i: -made(i)
            case ast.UnaryOp(op=ast.UAdd(), operand=inner):
                return self._value(inner)
            case ast.BinOp() if (angle := unwrapped_angle(node)) is not None:
                return self._value(angle)
            case ast.BinOp(left=left, op=op, right=right):
                return _joined(self._value(left), op, self._value(right))
            case ast.Call():
                return self._call(node)
            case ast.Subscript(value=base, slice=ast.Constant(value=int(k))) if k >= 0:
                return _entry(self._value(base), k)
            case ast.Subscript(
                value=base, slice=ast.Tuple(elts=[index, ast.Constant(value=int(k))])
            ):
                return _entry(self._value(ast.Subscript(base, index, ast.Load())), k)
            case ast.Name() | ast.Attribute() | ast.Subscript():
                return self._named(node)
        return _opaque(node)

    def _named(self, node: ast.expr) -> Value:
        name = self._key(node)
        if name in self.values:
            return self.values[name]
        known = self.fixed.get(name)
        last = f"{_root(name)}[-1]"
        if last in self.values and any(_next(used) == name != used for used in self.used):
            return self.values[last]  # what was appended
        inner = [*map(ast.unparse, ast.walk(known))] if isinstance(known, ast.BinOp) else []
        if known is not None and self.step in inner and name not in self.followed:
            self.followed.add(name)
            self.values[name] = self._value(known)
            return self.values[name]
        used = self.used.setdefault(name, set())

        def symbol(i: int | None) -> Expr:
            used.add(i)
            return _symbol(name, i)

        return symbol

    def _call(self, node: ast.Call) -> Value:
        word = getattr(node.func, "id", getattr(node.func, "attr", ""))
        if word in self.functions:
            return self._result(self.functions[word], node)
        if word in SAME and len(node.args) == 1:
            return self._value(node.args[0])
        if word == "copy" and isinstance(node.func, ast.Attribute):
            return self._value(node.func.value)
        return _opaque(node)

    def _result(self, function: Called, node: ast.Call) -> Value:
        """What a judged function returns, as a formula of what moves."""
        given: dict[tuple[str, int], Value] = {}
        names = {name: (role, k) for name, role, k in function.slots}
        pairs = [(slot[1:], arg) for slot, arg in zip(function.slots, node.args, strict=False)]
        pairs += [(names[k.arg], k.value) for k in node.keywords if k.arg in names]
        for place, arg in pairs:
            if place[0] in ("q", "u", "state") or (place[0] == "time" and function.timed):
                given[place] = self._value(arg)
        wanted = [s[1:] for s in function.slots if s[1] in ("q", "u", "state")]
        if not wanted or any(place not in given for place in wanted):
            raise Unknown
        self.calls.append((function, given))
        return self._formula(function, given)

    def _formula(self, function: Called, given: Mapping[tuple[str, int], Value]) -> Value:
        def entry(i: int | None) -> Expr:
            parts = [e for place in sorted(given) for e in self._entries(place, given[place])]
            source = Random(zlib.crc32(f"{function.name} {i}".encode()))
            factors = [Rational(source.randint(3, 19), 7) for _ in parts]
            inner = sum((f * p for f, p in zip(factors, parts, strict=True)), S.One / 3)
            return 1 / (inner**2 + 1) + Rational(source.randint(3, 19), 11) * parts[0] ** 2

        return cache(entry)

    def _entries(self, place: tuple[str, int], value: Value) -> list[Expr]:
        if place[0] == "state":
            return [value(k) for k in range(self.size)]
        return [value(None)]

    def _advanced(self) -> Iterator[tuple[str, str]]:
        """Places that are read before they are written, and those of the next turn."""
        for name in self.used:
            if name in self.written:
                yield name, name
            elif (after := _next(name)) in self.written:
                yield name, after
            elif after != name and f"{_root(name)}[-1]" in self.written:
                yield name, f"{_root(name)}[-1]"

    def found(self) -> set[str] | None:
        """Roots of the places that are advanced as by an integrator.

        None where no rates are those of a judged function: the step may be another one.
        """
        for _, given in self.calls:
            for place, value in given.items():
                self._entries(place, value)  # learns which entries are used
        state: dict[Expr, Expr] = {}
        roots: dict[Expr, str] = {}
        for now, after in [*self._advanced()]:
            done: set[int | None] = set()
            self.used[now] |= set() if self.used[now] else {None}
            while left := self.used[now] - done:
                for i in left:
                    state[_symbol(now, i)] = self.values[after](i)
                    roots[_symbol(now, i)] = now
                done |= left
        moving = {s: v for s, v in state.items() if not (v - s).is_number}
        rates = {s: _rate(s, v) for s, v in moving.items()}
        moving = {s: v for s, v in moving.items() if rates[s] is not S.One or self._is_timed(s)}
        for function, given in self.calls:
            halves = self._halves(function, given, rates)
            if halves is None:
                continue
            own = [*halves.q, *halves.u]
            timed = [s for s in moving if rates[s] is S.One]
            whole = [*own, *timed]
            free = {s for v in (*(moving[s] for s in whole), *(rates[s] for s in whole))
                    for s in v.free_symbols}  # fmt: skip
            name, _ = integrator_of(
                halves, {s: rates[s] for s in whole}, whole, [moving[s] for s in whole],
                sorted({*free, *whole, STEP}, key=str),
            )  # fmt: skip
            return {_root(roots[s]) for s in own} if name else set()
        return None

    def _is_timed(self, symbol: Expr) -> bool:
        return any(
            function.timed and symbol in value(None).free_symbols
            for function, given in self.calls
            for place, value in given.items() if place[0] == "time"
        )  # fmt: skip

    def _halves(
        self, function: Called, given: Mapping[tuple[str, int], Value], rates: Mapping[Expr, Expr]
    ) -> _Halves | None:
        """The state that a call is made at, if its rates are what the call returns."""
        given = {place: _at_once(value) for place, value in given.items()}
        made = self._formula(function, given)
        if ("state", 0) in given:
            state = tuple(given["state", 0](k) for k in range(self.size))
            if all(s in rates and _same(rates[s], made(k)) for k, s in enumerate(state)):
                return _Halves(state, ())
            return None
        q = {k: value(None) for (role, k), value in given.items() if role == "q"}
        u = {k: value(None) for (role, k), value in given.items() if role == "u"}
        whole = made(None)
        for k, one in q.items():
            u.setdefault(k, rates.get(one, S.Zero))
        if {*q} != {*u} or not all(s in rates for s in (*q.values(), *u.values())):
            return None
        for k, one in q.items():
            right = whole if len(q) == 1 else made(k)
            single = len(q) == 1 and _same(rates[u[k]], made(0))
            if not _same(rates[one], u[k]) or not (single or _same(rates[u[k]], right)):
                return None
        order = sorted(q)
        return _Halves(tuple(q[k] for k in order), tuple(u[k] for k in order))


def _at_once(value: Value) -> Value:
    """A value at the beginning of a step."""
    return lambda i: put(value(i), {STEP: S.Zero})


def _rate(symbol: Expr, value: Expr) -> Expr:
    parts = Add.make_args(value - symbol)
    found = sum((put(part / STEP, {STEP: S.Zero}) for part in parts), S.Zero)
    return S.NaN if found.has(zoo, nan, oo) else found


def _same(one: Expr, other: Expr) -> bool:
    if one is S.NaN:
        return False
    symbols = sorted(one.free_symbols | other.free_symbols, key=str)
    return alike([one], [other], symbols)


def _symbol(name: str, i: int | None) -> Expr:
    return Symbol(name if i is None else f"{name} {i}")


def _root(name: str) -> str:
    return name.partition("[")[0]


def _opaque(node: ast.expr) -> Value:
    found = Symbol(f"?{ast.unparse(node)}")
    return lambda i: found


def _entry(value: Value, k: int) -> Value:
    """An entry of a column; it is one number."""
    return lambda i: value(k)


def _column(parts: Sequence[Value]) -> Value:
    def entry(i: int | None) -> Expr:
        if i is None or i >= len(parts):
            raise Unknown
        return parts[i](None)

    return entry


def _joined(left: Value, op: ast.operator, right: Value) -> Value:
    match op:
        case ast.Add():
            return lambda i: left(i) + right(i)
        case ast.Sub():
            return lambda i: left(i) - right(i)
        case ast.Mult():
            return lambda i: left(i) * right(i)
        case ast.Div():
            return lambda i: left(i) / right(i)
        case ast.Pow():
            return lambda i: left(i) ** right(i)
    raise Unknown


def unwrapped_angle(node: ast.expr) -> ast.expr | None:
    """The angle of which another one is taken between bounds: (x + pi) % (2*pi) - pi."""
    match node:
        case ast.BinOp(left=ast.BinOp(left=ast.BinOp(left=inner, op=ast.Add(), right=half),
                                      op=ast.Mod(), right=turn),
                       op=ast.Sub(), right=again) if (
            _is_pi(half) and _is_pi(again) and _is_turn(turn)):  # fmt: skip
            return inner
        case ast.BinOp(left=inner, op=ast.Mod(), right=turn) if _is_turn(turn):
            return inner
    return None


def _is_pi(node: ast.expr) -> bool:
    return getattr(node, "id", getattr(node, "attr", "")) == "pi"


def _is_turn(node: ast.expr) -> bool:
    match node:
        case ast.BinOp(left=ast.Constant(value=2 | 2.0), op=ast.Mult(), right=pi):
            return _is_pi(pi)
    return getattr(node, "id", getattr(node, "attr", "")) == "tau"


def _kept(part: ast.Slice) -> bool:
    return any(x is not None for x in (part.lower, part.upper, part.step))


def _loaded(node: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(node), mode="eval").body


def _offset(node: ast.expr) -> str:
    match node:
        case ast.Name(id=name):
            return f"{name}+0"
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)):
            return "-1"
        case ast.BinOp(left=ast.Name(id=name), op=ast.Add(), right=ast.Constant(value=int(k))):
            return f"{name}+{k}"
        case ast.BinOp(left=ast.Name(id=name), op=ast.Sub(), right=ast.Constant(value=int(k))):
            return f"{name}+{-k}"
        case ast.Constant(value=str(text)):
            return repr(text)
    raise Unknown


def _next(name: str) -> str:
    """The same place in the turn that follows."""
    root, bracket, index = name.rpartition("[")
    letter, plus, number = index.rstrip("]").partition("+")
    return f"{root}[{letter}+{int(number) + 1}]" if bracket and plus else name
