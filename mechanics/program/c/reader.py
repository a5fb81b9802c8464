"""C functions as straight-line code: ``read_function(source, name, parameters, target)``.

    int f(const double q[2], double ud[2])     q[0], q[1] -> nodes,   nodes -> ud[0], ud[1], status

    if (...) s = 2; else s = x;                both ways; what differs depends on the condition
    if (...) continue;                         the rest under the opposite condition
    for (int i = 0; i < 4; ++i) { ... }        four times
    for (size_t i = 0; i < count; ++i) { ... } once, for lane i: entry k at k * stride + i
    for (size_t i = 0; i < count; i += 256) {  once, for the block of lanes that begins at i
        size_t n = count - i < 256 ? count - i : 256;   as many as are left
        for (size_t j = 0; j < n; ++j) { ... } }        once, for the lane i + j

Arguments are bound by their place, whatever the text calls them. Functions of the same file are
read where they are called; those of the library are operations. A lane reads and writes its own
entries only, so what holds for one lane holds for all, whatever the count. Inputs may be the same
arrays as outputs, so a read after a write is noted.

What C does silently is refused by name: a float beside a double, a double made an integer, an
integer quotient of what is not known, a variable that is read before it is set, a constant that is
changed, a number that is read where only one branch has set it. Integers beside real numbers are
exact.

    -1 < 1u  is false,      (1u - 2) * x  is 4294967295 x,      -7 / 2u  is 2147483644

C makes both sides unsigned, modulo 2^32. As long as no side and no result is negative that changes
nothing, and sums and products beyond an int are refused anyway. So in a text that has unsigned
integers a negative one may only be a literal, ``-2``, beside a real number or in a signed variable.
"""

from collections.abc import Sequence
from contextlib import ExitStack
from fractions import Fraction
from typing import Any, NamedTuple

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.program.c.condition import (
    Atom,
    Choice,
    Condition,
    Decision,
    choice,
    joined,
    negation,
)
from mechanics.program.c.function import BEYOND, Function, Parameter, Target, Written
from mechanics.program.c.index_polynomials import Whole, divided, plus, times, unknown, whole
from mechanics.program.c.library import ARITHMETIC, FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.program.c.literal import literal, rounded
from mechanics.program.c.parse import UNSIGNED, Source
from mechanics.program.c.select import chosen, latest
from mechanics.program.c.types import REALS, Type, declared, parameters, signature
from mechanics.program.c.values import (
    INTEGERS,
    Address,
    Array,
    Pointer,
    Real,
    Truth,
    Value,
    Variable,
    as_condition,
    as_decision,
    compared,
    of_decision,
    words,
)

DEEPEST = 8
"""Calls of own functions inside each other."""

MOST_TURNS = 4096
"""Of a loop with constant bounds."""

MOST_TURNS_IN_ALL = 20_000
"""Of all loops together: five that nest ask for a trillion."""


class Guard(NamedTuple):
    """A condition under which statements run, and whether the other way is run too."""

    condition: Condition
    both: bool


class Block(NamedTuple):
    """Lanes from `first` on: `bound` of them, at most `size`."""

    first: Whole
    bound: Whole
    size: int


def read_function(
    source: Source, name: str, given: Sequence[Parameter], target: Target
) -> Function:
    """Read a C function.

    Parameters
    ----------
    given : sequence of Parameter
        What its arguments are, in order.
    target : Target
        Where its operations go.

    Raises
    ------
    ExpressionError
        For a construct that is not supported, or arguments of other types; by file and line.
    """
    if name not in source.functions:
        raise ExpressionError(f"{source.file}: there is no function {name}")
    function = source.functions[name]
    declarations = {signature(p.type) for p in source.prototypes[name]}
    if len(declarations) > 1:
        raise ExpressionError(
            f"{function.coord}: {name} is declared as {' and as '.join(sorted(declarations))}"
        )
    reader = Reader(source, target)
    arrays = reader.arguments(function, given)
    result = reader.body(function)
    returns = declared(_returned(function)).kind
    outputs = {
        (array.place, entry): tuple(written)
        for array in arrays
        if array.place is not None and not array.constant
        for entry, written in array.entries.items()
    }
    status = None if returns == "void" else as_decision(result, function.coord)
    late, beyond = tuple(reader.late), tuple(reader.beyond)
    return Function(name, outputs, status, beyond, late, reader.counted, reader.named)


def _returned(function: Any) -> Any:
    return c_ast.Typename(None, [], None, function.decl.type.type, function.coord)


class Reader:
    """Runs the statements of a function once.

    Attributes
    ----------
    unsigned : bool
        Whether the text has unsigned integers.
    scopes : list of dict of str to Variable or Array
        The innermost last.
    guards : list of Guard
        Under which the statement at hand runs.
    beyond, late : list of str
        As in `Function`.
    written : bool
        Whether an output was written already.
    counted : str
        The argument that counts the lanes, once a loop over them was read.
    block : Block or None
        The block of lanes at hand.
    lane : Whole or None
        Which lane is at hand, inside the loop over them.
    lane_scope : int
        Number of scopes outside of the loop over lanes or blocks.
    depth, turns : int
        Calls inside each other, and turns of loops.
    """

    def __init__(self, source: Source, target: Target) -> None:
        self.source, self.target = source, target
        self.unsigned = source.has_unsigned
        self.scopes: list[dict[str, Variable | Array]] = [{}]
        self.guards: list[Guard] = []
        self.beyond: list[str] = []
        self.late: list[str] = []
        self.written = False
        self.counted = ""
        self.block: Block | None = None
        self.lane: Whole | None = None
        self.lane_scope = 0
        self.depth = self.turns = 0
        self.named: dict[int, tuple[str, str]] = {}

    def arguments(self, function: Any, given: Sequence[Parameter]) -> list[Array]:
        """Declare the arguments of the function that is read; arrays in order."""
        known = parameters(function.decl.type)
        where = function.coord
        if len(known) != len(given):
            raise ExpressionError(
                f"{where}: {function.decl.name} has {len(known)} arguments,"
                f" {len(given)} are expected: {', '.join(p.name for p in given)}"
            )
        arrays: list[Array] = []
        for place, (p, declaration) in enumerate(zip(given, known, strict=True)):
            kind = declared(declaration)
            expected = "int" if p.kind == "size_t" else p.kind
            if kind.kind != expected or kind.depth != (0 if expected == "int" else 1):
                raise ExpressionError(
                    f"{where}: argument {place + 1}, {declaration.name}, is {kind.words}:"
                    f" {p.name} of type {p.kind} is expected"
                )
            if kind.depth and (p.output is kind.constant or kind.size not in (None, p.size)):
                raise ExpressionError(
                    f"{where}: argument {place + 1}, {declaration.name}, is declared as"
                    f" {kind.words} with {kind.size} entries: {p.name} has {p.size}, and is"
                    f" {'written' if p.output else 'read'}"
                )
            if not kind.depth:
                counter = Variable(declaration.name, kind, unknown(p.name))
                self.declare(declaration.name, counter, where)
                continue
            array = Array(declaration.name, kind.kind, p.size, place, p.stride, not p.output)
            self.declare(declaration.name, array, where)
            arrays.append(array)
        return arrays

    def body(self, function: Any) -> Value | None:
        """Run the statements of a function; what it returns."""
        *statements, last = function.body.block_items or [c_ast.EmptyStatement()]
        for statement in statements:
            self.statement(statement)
        if isinstance(last, c_ast.Return) and last.expr is not None:
            returned = declared(_returned(function))
            return self.converted(self.value(last.expr), returned, last.coord)
        if not isinstance(last, c_ast.Return):
            self.statement(last)
        if declared(_returned(function)).kind != "void":
            raise ExpressionError(f"{function.coord}: {function.decl.name} returns nothing")
        return None

    def declare(self, name: str, thing: Variable | Array, where: Any) -> None:
        """Add to the innermost scope."""
        if name in self.scopes[-1]:
            raise ExpressionError(f"{where}: {name} is declared twice")
        thing.guards = len(self.guards)
        self.scopes[-1][name] = thing

    def converted(self, value: Value | None, kind: Type, where: Any) -> Value:
        """A value as a variable of a type holds it."""
        if UNSIGNED & set(kind.words.split()):
            self._natural(where, value)
        if kind.depth == 0 and kind.kind in REALS:
            return Real(self.real(value, kind.kind, where), kind.kind)
        if kind.depth == 0 and kind.kind == "int":
            if isinstance(value, Whole):
                return value
            return of_decision(as_decision(value, where))
        if kind.depth == 1 and isinstance(value, Pointer) and value.array.kind == kind.kind:
            if value.array.constant and not kind.constant:
                raise ExpressionError(f"{where}: {value.array.name} must not be changed")
            return value
        raise ExpressionError(f"{where}: {kind.words} cannot hold this value")

    # ------------------------------------------------------------------ statements

    def statement(self, node: Any) -> None:
        """Run one statement."""
        if isinstance(node, c_ast.Decl):
            self._declaration(node)
        elif isinstance(node, c_ast.DeclList):
            for declaration in node.decls:
                self._declaration(declaration)
        elif isinstance(node, c_ast.Assignment):
            self._assignment(node)
        elif isinstance(node, c_ast.If):
            self._if(node)
        elif isinstance(node, c_ast.For):
            self.loop(node)
        elif isinstance(node, c_ast.Compound):
            self._block(node)
        elif isinstance(node, c_ast.FuncCall):
            self.call(node)
        elif isinstance(node, c_ast.Cast) and declared(node.to_type).words == "void":
            self._ignored(node.expr)
        elif not isinstance(node, c_ast.EmptyStatement):
            raise ExpressionError(f"{node.coord}: {type(node).__name__} is not supported")

    def _ignored(self, node: Any) -> None:
        if not isinstance(node, c_ast.ID):
            raise ExpressionError(f"{node.coord}: only a name may be ignored")
        self.find(node.name, node.coord)

    def _block(self, node: Any) -> None:
        self.scopes.append({})
        depth = len(self.guards)
        with ExitStack() as under:
            for statement in node.block_items or ():
                if _is_skip(statement):
                    # What follows runs where this does not hold.
                    skipped = self.condition(self.value(statement.cond), statement.coord)
                    condition = negation(skipped)
                    if condition is not True:
                        self.guards.append(Guard(condition, False))
                        under.enter_context(self.target.under(condition))
                else:
                    self.statement(statement)
        del self.guards[depth:]
        self.scopes.pop()

    def _declaration(self, node: Any) -> None:
        kind = declared(node)
        if isinstance(node.type, c_ast.ArrayDecl):
            self._local_array(node, kind)
            return
        if "static" in (node.storage or ()):
            raise ExpressionError(f"{node.coord}: {node.name} keeps its value between calls")
        variable = Variable(node.name, kind)
        if node.init is not None:
            variable.value = self.converted(self.value(node.init), kind, node.coord)
            self._name(variable, node.coord)
        elif kind.constant and not kind.depth:
            raise ExpressionError(f"{node.coord}: the constant {node.name} has no value")
        self.declare(node.name, variable, node.coord)

    def _local_array(self, node: Any, kind: Type) -> None:
        if kind.kind not in REALS or kind.size is None:
            raise ExpressionError(f"{node.coord}: the array {node.name} is not supported")
        if "static" in (node.storage or ()) and not kind.constant:
            raise ExpressionError(f"{node.coord}: {node.name} keeps its value between calls")
        array = Array(node.name, kind.kind, kind.size, constant=kind.constant)
        if node.init is not None:
            if not isinstance(node.init, c_ast.InitList) or len(node.init.exprs) > kind.size:
                raise ExpressionError(f"{node.coord}: these values of {node.name} are unknown here")
            for i in range(kind.size):
                # What is left out is zero.
                given = self.value(node.init.exprs[i]) if i < len(node.init.exprs) else whole(0)
                number = self.real(given, kind.kind, node.coord)
                array.entries[i] = [Written(True, number)]
        self.declare(node.name, array, node.coord)

    def _assignment(self, node: Any) -> None:
        value = self.value(node.rvalue)
        if node.op != "=":
            old = self.value(node.lvalue)
            value = self.combined(node.op[:-1], old, value, node.coord)
        if isinstance(node.lvalue, c_ast.ID):
            target = self.find(node.lvalue.name, node.coord)
            if isinstance(target, Variable):
                gathers = node.op == "|=" and target.type.kind == "int"
                self.assign(target, value, node.coord, gathers)
                return
        elif isinstance(node.lvalue, c_ast.ArrayRef):
            self.store(self.element(node.lvalue), value, node.coord)
            return
        elif isinstance(node.lvalue, c_ast.UnaryOp) and node.lvalue.op == "*":
            at = self.value(node.lvalue.expr)
            if isinstance(at, Pointer):
                self.store(at, value, node.coord)
                return
        raise ExpressionError(f"{node.coord}: this assignment is not supported")

    def assign(self, variable: Variable, value: Value, where: Any, gathers: bool = False) -> None:
        """Set a variable; `gathers` where a flag gathers what all lanes say."""
        if variable.type.constant and not variable.type.depth:
            raise ExpressionError(f"{where}: the constant {variable.name} is changed")
        if not gathers and not self.is_own(variable):
            raise ExpressionError(f"{where}: {variable.name} is carried from lane to lane")
        guards = [guard for guard in self.guards[variable.guards :] if guard.condition is not True]
        skipped = [guard.condition for guard in guards if not guard.both]
        if skipped and not gathers:
            raise ExpressionError(f"{where}: {variable.name} is set under a condition only")
        if skipped and variable.value is not None:
            # What a skipped lane does not say, the flag does not gather.
            condition: Condition = True
            for guard in skipped:
                condition = joined(True, condition, guard)
            sides = (as_decision(side, where) for side in (value, variable.value))
            value = of_decision(choice(condition, *sides))
        variable.value = self.converted(value, variable.type, where)
        self._name(variable, where)

    def _name(self, variable: Variable, where: Any) -> None:
        if isinstance(variable.value, Real):
            self.named.setdefault(variable.value.node, (variable.name, str(where)))

    def store(self, at: Pointer, value: Value, where: Any) -> None:
        """Set an entry of an array."""
        array, entry = at.array, self.entry(at, where)
        if array.constant:
            raise ExpressionError(f"{where}: {array.name} must not be changed")
        if entry is None:
            raise ExpressionError(
                f"{where}: {array.name}[{at.offset}] is beyond its {array.size} entries"
            )
        outside = array.place is not None
        if self.lane and outside and not array.stride:
            raise ExpressionError(f"{where}: {array.name} is written by every lane")
        condition = self._under(array)
        written = Written(condition, self.real(value, array.kind, where))
        if condition is not False:
            before = [] if condition is True else array.entries.get(entry, [])
            array.entries[entry] = [*before, written]
            self.written = self.written or outside

    def _under(self, array: Array) -> Condition:
        """The condition under which the statement at hand runs, where the array is declared."""
        condition: Condition = True
        for guard in self.guards[array.guards :]:
            condition = joined(True, condition, guard.condition)
        return condition

    def _if(self, node: Any) -> None:
        condition = self.condition(self.value(node.cond), node.coord)
        variables = [v for s in self.scopes for v in s.values() if isinstance(v, Variable)]
        before = [v.value for v in variables]
        ends: list[list[Value | None]] = []
        written, outputs = self.written, False
        # What is never run has to be known, too.
        for branch, holds in ((node.iftrue, condition), (node.iffalse, negation(condition))):
            for variable, value in zip(variables, before, strict=True):
                variable.value = value
            self.written = written
            if branch is not None:
                self.guards.append(Guard(holds, True))
                with self.target.under(holds):
                    self._block(c_ast.Compound([branch]))
                self.guards.pop()
            ends.append([v.value for v in variables])
            outputs = outputs or self.written
        self.written = outputs
        for variable, yes, no in zip(variables, *ends, strict=True):
            if isinstance(condition, bool):
                variable.value = yes if condition else no
            elif yes != no and variable.type.kind in REALS and not variable.type.depth:
                variable.value = self._merged(condition, variable, yes, no, node.coord)
            elif yes != no:
                sides = (as_decision(side, node.coord) for side in (yes, no))
                variable.value = of_decision(choice(condition, *sides))

    def _merged(
        self, condition: Condition, variable: Variable, yes: Value | None, no: Value | None,
        where: Any,
    ) -> Value | None:  # fmt: skip
        """A real number after both branches; it has none where one of them gives it none."""
        if yes is None or no is None:
            return None
        kind = variable.type.kind
        first, second = (self.real(side, kind, where) for side in (yes, no))
        return Real(self.target.choose(condition, first, second, kind, where), kind)

    # ------------------------------------------------------------------ loops

    def loop(self, node: Any) -> None:
        """Run a loop."""
        where = node.coord
        counter = node.init.decls[0] if isinstance(node.init, c_ast.DeclList) else None
        if counter is None or len(node.init.decls) != 1 or declared(counter).kind != "int":
            raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")
        step = self._step(node.next, counter.name, where)
        cond = node.cond
        if not (isinstance(cond, c_ast.BinaryOp) and cond.op == "<" and _is(cond.left, counter)):
            raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")
        first, last = self.value(counter.init), self.value(cond.right)
        if not isinstance(first, Whole) or not isinstance(last, Whole) or first.known is None:
            raise ExpressionError(f"{where}: the bounds of this loop are not supported")
        if last.known is None:
            if first.known != 0:
                raise ExpressionError(f"{where}: a loop over lanes begins with the first, 0")
            if step == 1:
                self._over_lanes(node, counter, last)
            else:
                self._over_blocks(node, counter, last, step)
            return
        if last.known - first.known > MOST_TURNS:
            raise ExpressionError(f"{where}: more than {MOST_TURNS} turns of a loop")
        for turn in range(first.known, last.known, step):
            self.turns += 1
            if self.turns > MOST_TURNS_IN_ALL:
                raise ExpressionError(f"{where}: more than {MOST_TURNS_IN_ALL} turns of all loops")
            self._turn(node, counter, whole(turn))
            if self.value(cond.right) != last:
                raise ExpressionError(f"{where}: a loop that changes its bound is not supported")

    def _step(self, node: Any, counter: str, where: Any) -> int:
        """1 for ``++i``, n for ``i += n``."""
        if isinstance(node, c_ast.UnaryOp) and node.op in ("++", "p++"):
            if getattr(node.expr, "name", None) == counter:
                return 1
        elif isinstance(node, c_ast.Assignment) and node.op == "+=":
            step = self.value(node.rvalue)
            known = step.known if isinstance(step, Whole) else None
            if getattr(node.lvalue, "name", None) == counter and known is not None and known > 0:
                return known
        raise ExpressionError(f"{where}: a loop is expected as for (int i = 0; i < n; ++i)")

    def _turn(self, node: Any, counter: Any, value: Whole) -> None:
        kind = Type("int", True, 0, None, "const int")
        variable = Variable(counter.name, kind, value, len(self.guards))
        self.scopes.append({counter.name: variable})
        self.statement(node.stmt)
        self.scopes.pop()

    def _over_lanes(self, node: Any, counter: Any, last: Whole) -> None:
        """The body once, for a lane that stands for all of them."""
        if self.lane is not None:
            raise ExpressionError(f"{node.coord}: a loop over lanes inside of another")
        if self.block is None:
            self._count(last, node.coord)
        elif last != self.block.bound:
            raise ExpressionError(f"{node.coord}: {last} lanes are not all of this block")
        own = unknown(f"lane {counter.name}")
        self.lane = plus(self.block.first, own) if self.block else own
        outer, self.lane_scope = self.lane_scope, len(self.scopes)
        self._turn(node, counter, own)
        self.lane, self.lane_scope = None, outer

    def _over_blocks(self, node: Any, counter: Any, last: Whole, size: int) -> None:
        """The body once, for a block that stands for all of them."""
        if self.lane is not None or self.block is not None or self.guards:
            raise ExpressionError(f"{node.coord}: a loop over blocks inside of another")
        self._count(last, node.coord)
        first = unknown(f"block {counter.name}")
        self.block = Block(first, unknown(f"lanes of block {counter.name}"), size)
        outer, self.lane_scope = self.lane_scope, len(self.scopes)
        self._turn(node, counter, first)
        self.block, self.lane_scope = None, outer

    def _count(self, last: Whole, where: Any) -> None:
        """All lanes are counted by one argument."""
        name = str(last)
        if len(last.terms) != 1 or self.counted not in ("", name):
            raise ExpressionError(f"{where}: {last} is not the number of lanes")
        self.counted = name

    def is_own(self, variable: Variable) -> bool:
        """Whether a variable belongs to the lane or block at hand alone."""
        if self.lane is None and self.block is None:
            return True
        return any(variable in scope.values() for scope in self.scopes[self.lane_scope :])

    # ------------------------------------------------------------------ expressions

    def find(self, name: str, where: Any) -> Variable | Array:
        """The variable or array of a name."""
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        raise ExpressionError(f"{where}: {name} is not declared")

    def value(self, node: Any) -> Value:
        """Value of an expression."""
        if isinstance(node, c_ast.Constant):
            return self._literal(node)
        if isinstance(node, c_ast.ID):
            return self._named(node)
        if isinstance(node, c_ast.ArrayRef):
            return self.read(self.element(node), node.coord)
        if isinstance(node, c_ast.BinaryOp):
            return self._binary(node)
        if isinstance(node, c_ast.UnaryOp):
            return self._unary(node)
        if isinstance(node, c_ast.TernaryOp):
            return self._ternary(node)
        if isinstance(node, c_ast.Cast):
            return self._cast(node)
        if isinstance(node, c_ast.FuncCall):
            found = self.call(node)
            if found is None:
                raise ExpressionError(f"{node.coord}: {node.name.name} gives no value")
            return found
        raise ExpressionError(f"{node.coord}: {type(node).__name__} is not supported")

    def real(self, value: Value | None, kind: str, where: Any) -> int:
        """The node of a real number of a type.

        Raises
        ------
        ExpressionError
            If it has another type, so that C would convert it.
        """
        if isinstance(value, Real):
            if value.kind != kind:
                wrong = f"a {value.kind} stands where a {kind} is expected"
                raise ExpressionError(f"{where}: {wrong}: precisions are mixed")
            return value.node
        if isinstance(value, Truth | Choice):
            return chosen(self.target, as_decision(value, where), kind, where)
        if isinstance(value, Whole) and value.known is not None:
            if rounded(Fraction(value.known), kind) != value.known:
                raise ExpressionError(f"{where}: no {kind} holds the integer {value.known}")
            return self.target.number(Fraction(value.known), kind)
        raise ExpressionError(f"{where}: a {kind} is expected, {words(value)} found")

    def element(self, node: Any) -> Pointer:
        """The place in an array that ``a[i]`` names."""
        base, index = self.value(node.name), self.value(node.subscript)
        if not isinstance(base, Pointer) or not isinstance(index, Whole):
            raise ExpressionError(f"{node.coord}: an array and an integer are expected")
        return Pointer(base.array, plus(base.offset, index))

    def entry(self, at: Pointer, where: Any) -> int | None:
        """Entry of an array, of this lane where it has lanes; None beyond its end.

        Raises
        ------
        ExpressionError
            If it is no entry of this lane.
        """
        array = at.array
        if array.stride:
            rest = dict(plus(at.offset, self.lane or whole(0), -1).terms)
            found = rest.pop((array.stride,), 0)
            if self.lane is None or rest:
                raise ExpressionError(
                    f"{where}: {array.name}[{at.offset}] is no entry of the lane"
                    f" {self.lane or '(outside of the loop over lanes)'}:"
                    f" k * {array.stride} + lane is expected"
                )
        elif at.offset.known is None:
            raise ExpressionError(f"{where}: {array.name}[{at.offset}] is no entry that is known")
        else:
            found = at.offset.known
        return found if 0 <= found < array.size else None

    def read(self, at: Pointer, where: Any) -> Value:
        """Value of an entry."""
        array, entry = at.array, self.entry(at, where)
        if array.kind not in REALS:
            raise ExpressionError(f"{where}: arrays of {array.kind} are not supported")
        if entry is None:
            self.beyond.append(f"{where}: {array.name}[{at.offset}]")
            node = self.target.input(BEYOND, len(self.beyond) - 1, array.kind)
            return Real(node, array.kind)
        if array.place is None or not array.constant:
            written = array.entries.get(entry, ())
            last = latest(self.target, written, self._under(array), array.kind, where)
            if last is None:
                words = "is set under a condition only" if written else "is read before it is set"
                raise ExpressionError(f"{where}: {array.name}[{entry}] {words}")
            return Real(last, array.kind)
        if self.written:
            self.late.append(f"{where}: {array.name}[{at.offset}]")
        return Real(self.target.input(array.place, entry, array.kind), array.kind)

    def _literal(self, node: Any) -> Value:
        if node.type in ("char", "string"):
            raise ExpressionError(f"{node.coord}: {node.value} is not supported")
        kind, value = literal(node.value)
        return whole(int(value)) if kind == "int" else Real(self.target.number(value, kind), kind)

    def _named(self, node: Any) -> Value:
        found = self.find(node.name, node.coord)
        if isinstance(found, Array):
            return Pointer(found, whole(0))
        if found.value is None:
            raise ExpressionError(f"{node.coord}: {node.name} is read before it is set")
        return found.value

    def _unary(self, node: Any) -> Value:
        if node.op == "&":
            found = self.find(node.expr.name, node.coord) if type(node.expr) is c_ast.ID else None
            if isinstance(found, Variable):
                return Address(found)
            if isinstance(node.expr, c_ast.ArrayRef):
                return self.element(node.expr)
            raise ExpressionError(f"{node.coord}: this address is not supported")
        value = self.value(node.expr)
        if node.op == "-" and isinstance(value, Whole):
            result = times(whole(-1), value)
            if not (isinstance(node.expr, c_ast.Constant) and "unsigned" not in node.expr.type):
                self._natural(node.coord, value, result)
            return result
        if node.op == "!":
            return Truth(negation(self.condition(value, node.coord)))
        if node.op == "*" and isinstance(value, Pointer):
            return self.read(value, node.coord)
        if node.op == "+":
            return value
        if node.op == "-" and isinstance(value, Real):
            return Real(self.target.apply("negate", (value.node,), value.kind), value.kind)
        raise ExpressionError(f"{node.coord}: {node.op} of {words(value)} is not supported")

    def condition(self, value: Value, where: Any) -> Condition:
        """A value that decides; a real number does by being zero or not."""
        if isinstance(value, Real):
            zero = self.target.number(Fraction(0), value.kind)
            return Atom("==", (value.node, zero), False)
        return as_condition(value, where)

    def _binary(self, node: Any) -> Value:
        # a + b + c is as deep as it has terms: left sides are taken one after the other.
        chain: list[Any] = []
        seen = False
        while isinstance(node, c_ast.BinaryOp):
            chain.append(node)
            if node.op in ("&&", "||"):
                self.unwritten(node.right)
            elif not (seen or isinstance(node.right, c_ast.Constant)):
                # C may begin with either side.
                self.unwritten(node.left, node.right)
                seen = True
            node = node.left
        value = self.value(node)
        for outer in reversed(chain):
            value = self._joined(outer, value)
        return value

    def _joined(self, node: Any, left: Value) -> Value:
        """An operation whose left side is known."""
        if node.op not in ("&&", "||"):
            return self.combined(node.op, left, self.value(node.right), node.coord)
        both, first = node.op == "&&", self.condition(left, node.coord)
        # C looks at the right side only where the left one does not decide.
        with self.target.under(first if both else negation(first)):
            second = self.condition(self.value(node.right), node.coord)
        return Truth(joined(both, first, second))

    def combined(self, op: str, left: Value, right: Value, where: Any) -> Value:
        """left op right; no integer of it is negative beside unsigned ones."""
        result = self._operated(op, left, right, where)
        if not (isinstance(left, Real) or isinstance(right, Real)):
            self._natural(where, left, right, result)
        return result

    def _operated(self, op: str, left: Value, right: Value, where: Any) -> Value:
        if isinstance(left, Whole) and isinstance(right, Whole):
            return _integer(op, left, right, where)
        if isinstance(left, Pointer) and isinstance(right, Whole) and op in "+-":
            return Pointer(left.array, plus(left.offset, right, 1 if op == "+" else -1))
        kinds = {side.kind for side in (left, right) if isinstance(side, Real)}
        if not kinds and op in INTEGERS:
            return of_decision(compared(op, as_decision(left, where), as_decision(right, where)))
        if not kinds:
            raise ExpressionError(f"{where}: {words(left)} {op} {words(right)} is not supported")
        if len(kinds) > 1:
            raise ExpressionError(f"{where}: a float stands beside a double: precisions are mixed")
        (kind,) = kinds
        x, y = self.real(left, kind, where), self.real(right, kind, where)
        if op in ARITHMETIC:
            return Real(self.target.apply(ARITHMETIC[op], (x, y), kind), kind)
        if op in (">", ">="):
            x, y, op = y, x, op.replace(">", "<")
        if op in ("<", "<=", "=="):
            return Truth(Atom(op, (x, y)))
        if op == "!=":
            return Truth(Atom("==", (x, y), False))
        raise ExpressionError(f"{where}: {op} of real numbers is not supported")

    def _ternary(self, node: Any) -> Value:
        self.unwritten(node.iftrue, node.iffalse)
        if (least := self._least(node)) is not None:
            self._natural(node.coord, least)
            return least
        condition = self.condition(self.value(node.cond), node.coord)
        with self.target.under(condition):
            yes = self.value(node.iftrue)
        with self.target.under(negation(condition)):
            no = self.value(node.iffalse)
        kinds = {side.kind for side in (yes, no) if isinstance(side, Real)}
        if not kinds:
            decisions = (as_decision(side, node.coord) for side in (yes, no))
            result = of_decision(choice(condition, *decisions))
            self._natural(node.coord, result, yes, no)
            return result
        kind = kinds.pop()
        x, y = (self.real(side, kind, node.coord) for side in (yes, no))
        return Real(self.target.choose(condition, x, y, kind, node.coord), kind)

    def _least(self, node: Any) -> Whole | None:
        """``left < right ? left : right`` of integers; None for another choice."""
        if not (isinstance(node.cond, c_ast.BinaryOp) and node.cond.op == "<"):
            return None
        left, right = self.value(node.cond.left), self.value(node.cond.right)
        if not (isinstance(left, Whole) and isinstance(right, Whole)):
            return None
        if (self.value(node.iftrue), self.value(node.iffalse)) != (left, right):
            return None
        block, x, y = self.block, left.known, right.known
        if (
            block is not None
            and y == block.size
            and left == plus(unknown(self.counted), block.first, -1)
        ):
            return block.bound  # the lanes that are left of a block
        if x is None or y is None:
            raise ExpressionError(
                f"{node.coord}: which of {left} and {right} is less is not supported"
            )
        return whole(min(x, y))

    def _cast(self, node: Any) -> Value:
        kind, value = declared(node.to_type), self.value(node.expr)
        if kind.depth == 0 and kind.kind in REALS:
            return Real(self.real(value, kind.kind, node.coord), kind.kind)
        if kind.depth == 0 and kind.kind == "int" and isinstance(value, Whole):
            if UNSIGNED & set(kind.words.split()):
                self._natural(node.coord, value)
            return value
        raise ExpressionError(
            f"{node.coord}: a cast of {words(value)} to {kind.words} is not supported"
        )

    # ------------------------------------------------------------------ calls

    def call(self, node: Any) -> Value | None:
        """A call of the library, of what stands in for it, or of another function of the file."""
        name = getattr(node.name, "name", "")
        given = node.args.exprs if node.args else []
        if any(name in scope for scope in self.scopes):
            raise ExpressionError(f"{node.coord}: {name} is a variable here, and is called")
        if name == "isfinite" and len(given) == 1 and name not in self.source.functions:
            value = self.value(given[0])
            if isinstance(value, Real):
                return Truth(Atom("finite", (value.node,)), exact=False)
        elif name in FAR and len(given) == 1:
            angle = self.real(self.value(given[0]), FAR[name], node.coord)
            return Truth(Atom("far", (angle,)))
        elif name in SINCOS and len(given) == 3:
            self._sincos(node, SINCOS[name])
            return None
        elif name in FUSED and len(given) == 3:
            kind = FUSED[name]
            x, y, z = (self.real(self.value(g), kind, node.coord) for g in given)
            product = self.target.apply("multiply", (x, y), kind)
            return Real(self.target.apply("add", (product, z), kind), kind)
        elif name in FUNCTIONS and len(given) == FUNCTIONS[name].arity:
            operation, _, kind = FUNCTIONS[name]
            nodes = tuple(self.real(self.value(g), kind, node.coord) for g in given)
            return Real(self.target.apply(operation, nodes, kind), kind)
        elif name in self.source.functions:
            return self._own(self.source.functions[name], given, node.coord)
        raise ExpressionError(
            f"{node.coord}: the call {name}() is not supported: put the function into the file, or"
            " leave the call out if it changes nothing"
        )

    def unwritten(self, *nodes: Any) -> None:
        """Refuse calls that write where C may leave them out, or reorder them."""
        waiting = list(nodes)
        while waiting:
            node = waiting.pop()
            name = getattr(node.name, "name", "") if isinstance(node, c_ast.FuncCall) else ""
            if name in SINCOS or (name in self.source.functions and self._writes(name)):
                raise ExpressionError(f"{node.coord}: {name}() may write, inside an expression")
            waiting += [child for _, child in node.children()]

    def _writes(self, name: str) -> bool:
        kinds = [declared(p) for p in parameters(self.source.functions[name].decl.type)]
        return any(kind.depth and not kind.constant for kind in kinds)

    def _sincos(self, node: Any, kind: str) -> None:
        angle, *targets = node.args.exprs
        x = self.real(self.value(angle), kind, node.coord)
        for operation, target in zip(("sin", "cos"), targets, strict=True):
            at = self.value(target)
            real = Real(self.target.apply(operation, (x,), kind), kind)
            if isinstance(at, Address):
                self.assign(at.variable, real, node.coord)
            elif isinstance(at, Pointer):
                self.store(at, real, node.coord)
            else:
                raise ExpressionError(f"{node.coord}: an address is expected")

    def _own(self, function: Any, given: Sequence[Any], where: Any) -> Value | None:
        known = parameters(function.decl.type)
        if self.depth == DEEPEST or len(known) != len(given):
            raise ExpressionError(f"{where}: the call {function.decl.name}() is not supported")
        scope: dict[str, Variable | Array] = {}
        for declaration, argument in zip(known, given, strict=True):
            kind = declared(declaration)
            value = self.converted(self.value(argument), kind, where)
            guards = len(self.guards)
            scope[declaration.name] = Variable(declaration.name, kind, value, guards)
        # The scopes of the caller are out of sight.
        outer, self.scopes = self.scopes, [scope]
        inside, self.lane_scope = self.lane_scope, 0
        self.depth += 1
        result = self.body(function)
        self.depth -= 1
        self.scopes, self.lane_scope = outer, inside
        return result

    # ------------------------------------------------------------------ integers

    def _natural(self, where: Any, *values: Value | None) -> None:
        """Refuse negative integers in a text with unsigned ones."""
        if self.unsigned and any(_is_negative(value) for value in values):
            raise ExpressionError(
                f"{where}: a negative integer in a text with unsigned integers, beside which C"
                " makes it 4294967296 larger: write int, without u"
            )


def _is_skip(node: Any) -> bool:
    """``if (...) continue;``."""
    if not isinstance(node, c_ast.If) or node.iffalse is not None:
        return False
    return isinstance(node.iftrue, c_ast.Continue)


def _is(node: Any, counter: Any) -> bool:
    return isinstance(node, c_ast.ID) and bool(node.name == counter.name)


def _integer(op: str, left: Whole, right: Whole, where: Any) -> Value:
    if op in ("+", "-"):
        return plus(left, right, 1 if op == "+" else -1)
    if op == "*":
        return times(left, right)
    try:
        if op in ("/", "%"):
            return divided(left, right, op == "%")
    except ExpressionError as error:
        raise ExpressionError(f"{where}: {error}") from None
    x, y = left.known, right.known
    far = op in ("<<", ">>") and y is not None and not 0 <= y < 32
    if x is None or y is None or far or op not in INTEGERS:
        raise ExpressionError(f"{where}: {left} {op} {right} is not supported")
    return whole(int(INTEGERS[op](x, y)))


def _is_negative(value: Value | None) -> bool:
    if isinstance(value, Choice):
        return _least(value) < 0
    return isinstance(value, Whole) and value.known is not None and value.known < 0


def _least(decision: Decision) -> int:
    if isinstance(decision, Choice):
        return min(_least(decision.yes), _least(decision.no))
    return decision
