"""Calls of judged functions of a Python file, argument by argument.

rate(th, w, g, l)        odeint(rate, y0, t, args=(g, l))        partial(rate, g=g, l=l)
rate(w, th, g, l)        odeint(rate, y0, t, args=(l, g))        rate(th, w, -g, l)    say otherwise
"""

import ast
from collections.abc import Collection, Iterable, Mapping, Sequence

from mechanics.claims.code.python_steps import Called
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import key
from mechanics.scene.symbols import plain_symbol

Defined = ast.FunctionDef | ast.AsyncFunctionDef
DEFINED = (ast.FunctionDef, ast.AsyncFunctionDef)
ARITHMETIC = (ast.BinOp, ast.UnaryOp, ast.AugAssign)
Slot = tuple[str, str, int]
"""The name of an argument, its role, and which coordinate it is."""
TIMES = ("t", "time", "ti", "t0", "tn", "t_i", "t_n", "tk", "_t", "_")
KEEPING = ("array", "asarray", "float", "copy", "radians", "deg2rad", "list", "tuple", "ravel",
           "flatten", "squeeze", "tolist", "item", "float64", "zeros", "ones", "zeros_like", "full",
           "concatenate", "hstack", "append")  # fmt: skip
"""Functions that leave an argument what it is."""
TIME_FIRST = ("solve_ivp", "RK45", "RK23", "DOP853", "Radau", "BDF", "LSODA", "ode")
STATE_FIRST = ("odeint",)


def word(node: ast.AST) -> str:
    """The last name of a name or attribute."""
    return getattr(node, "id", "") or getattr(node, "attr", "")


def words_in(node: ast.AST) -> set[str]:
    """Names and attributes in a tree."""
    return {*map(word, ast.walk(node))} - {""}


class Calls:
    """Judged functions, and how they are called.

    Parameters
    ----------
    tree : ast.Module
    own : mapping of str to ast.FunctionDef
        Judged functions and what they call, by name.
    naming : Naming
    """

    def __init__(self, tree: ast.Module, own: Mapping[str, Defined], naming: Naming) -> None:
        self.naming = naming
        scene = naming.vocabulary.scene
        self.coordinates = [plain_symbol(q).name for q in scene.coordinates]
        self.speeds = [plain_symbol(u).name for u, _ in scene.speeds]
        self.columns = {m.name: m.meaning.split() for m in naming.guessed if " " in m.meaning}
        self.nodes = own
        self.functions = {name: self._called(node) for name, node in own.items()}
        self.fixed = fixed_in(tree)
        started = (n.args[0] for n in ast.walk(tree) if isinstance(n, ast.Call)
                   and word(n.func) == "ode" and n.args)  # fmt: skip
        self.advanced = [self.functions[n] for n in map(word, started) if n in self.functions]
        self.moving = {
            name for called in self.functions.values() for name, role, _ in called.slots
            if role in ("q", "u", "state", "parameter")
        }  # fmt: skip

        self.parameters = {
            name for called in self.functions.values() for name, role, _ in called.slots
            if role == "parameter"
        }  # fmt: skip
        self.named = {name for called in self.functions.values() for name, _, _ in called.slots}

    def exchanged(self, name: str, value: ast.AST) -> bool:
        """Whether a value that a parameter of a judged function gets is another one, or changed."""
        if name not in self.parameters:
            return False
        if isinstance(value, ast.Name | ast.Attribute):
            return word(value) != name and word(value) in self.named
        return any(
            word(part) == name
            for one in ast.walk(value) if isinstance(one, ast.BinOp | ast.UnaryOp)
            for part in ast.walk(one)
        )  # fmt: skip

    def _called(self, node: Defined) -> Called:
        names = [a.arg for a in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)]
        names = [n for n in names if n not in ("self", "cls")]
        used = [word(n) for line in node.body for n in ast.walk(line) if isinstance(n, ast.Name)]
        slots = [(name, *self._role(name)) for name in names]
        if not any(role in ("q", "u", "state") for _, role, _ in slots):
            parted = _parted(node)
            slots = [(n, "state", 0) if n in parted and role == "other" else (n, role, k)
                     for n, role, k in slots]  # fmt: skip
        timed = any(role == "time" and n in used for n, role, _ in slots)
        return Called(node.name, tuple(slots), timed)

    def _role(self, name: str) -> tuple[str, int]:
        if name in self.columns:
            kinds = {self._kind(part)[0] for part in self.columns[name]}
            role = kinds.pop() if len(kinds) == 1 else "state"
            return (role, 0) if role in ("q", "u", "state") else ("other", 0)
        if name in TIMES:
            return "time", 0
        return self._kind(name)

    def _kind(self, name: str) -> tuple[str, int]:
        found = self.naming.lookup(name)
        if found is None:
            return "other", 0
        base, order = found
        if base in self.coordinates and order < 2:
            return ("q", "u")[order], self.coordinates.index(base)
        if base in self.speeds and order == 0:
            return "u", self.speeds.index(base)
        return ("parameter", 0) if base in self.naming.vocabulary.constants else ("other", 0)

    def wrong(self, node: ast.Call, step: bool, moving: Collection[str] = ()) -> bool:
        """Whether a call has arguments that are not what the function calls them.

        Parameters
        ----------
        step : bool
            Whether it is a part of an integrator's step, which moves what moves.
        moving : collection of str
            Places around the call that hold what moves.
        """
        name = word(node.func)
        if name in self.functions and any(
            role in ("parameter", "other") and place_of(arg) in moving
            for (_, role, _), arg in self._pairs(self.functions[name], node)
        ):
            return True
        if name == "set_f_params":
            return any(
                self._differ(called, called.slots[2:], node.args, node.keywords, False)
                for called in self.advanced
            )
        if name in self.functions:
            slots = self.functions[name].slots
            return self._differ(self.functions[name], slots, node.args, node.keywords, step)
        if not node.args or (first := word(node.args[0])) not in self.functions:
            return False
        called = self.functions[first]
        if name == "partial":
            return self._differ(called, called.slots, node.args[1:], node.keywords, False)
        if name not in (*TIME_FIRST, *STATE_FIRST):
            return False
        options = {k.arg: k.value for k in node.keywords}
        if name == "odeint" and len(node.args) > 3:
            options["args"] = node.args[3]
        early = name in TIME_FIRST or word_of_truth(options.get("tfirst"))
        roles = [role for _, role, _ in called.slots[:2]]
        if "time" in roles and roles.index("time") != (0 if early else 1):
            return True
        if len(roles) == 2 and "state" in roles and roles.index("state") != (1 if early else 0):
            return True
        given = self._resolved(options.get("args"))
        if isinstance(given, ast.Tuple | ast.List):
            return self._differ(called, called.slots[2:], given.elts, [], False)
        if given is not None and not isinstance(given, ast.Name | ast.Attribute | ast.Constant):
            inner = (
                given.args if isinstance(given, ast.Call) and word(given.func) == "tuple" else []
            )
            return not inner
        return False

    def _resolved(self, node: ast.expr | None) -> ast.expr | None:
        if isinstance(node, ast.Name):
            return self.fixed.get(node.id, node)
        return node

    def _differ(
        self, called: Called, slots: Sequence[tuple[str, str, int]], args: Sequence[ast.expr],
        keywords: Sequence[ast.keyword], step: bool,
    ) -> bool:  # fmt: skip
        """Whether some argument is not what its name says."""
        pairs = self._matched(called, slots, args, keywords)
        if not step and self._misplaced(pairs):
            return True
        return any(
            not self._is_same(called, slot, arg, step) or self._is_overridden(called, slot, arg)
            for slot, arg in pairs
        )

    def _is_overridden(self, called: Called, slot: Slot, argument: ast.expr) -> bool:
        """Whether an argument without a meaning gets another number than the one it is read as."""
        arguments = self.nodes[called.name].args
        placed = [*arguments.posonlyargs, *arguments.args]
        defaults = dict(zip([a.arg for a in placed][::-1], arguments.defaults[::-1], strict=False))
        pairs = zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
        defaults |= {a.arg: value for a, value in pairs if value is not None}
        default = defaults.get(slot[0])
        if slot[1] != "other" or default is None or number_of(default) is None:
            return False
        return number_of(argument) != number_of(default)

    def _pairs(self, called: Called, node: ast.Call) -> list[tuple[Slot, ast.expr]]:
        return self._matched(called, called.slots, node.args, node.keywords)

    def moved(self, inside: Iterable[ast.AST]) -> set[str]:
        """Places that calls of judged functions take for coordinates, speeds or the state."""
        found = {
            place_of(part)
            for one in inside if isinstance(one, ast.Call) and word(one.func) in self.functions
            for (_, role, _), arg in self._pairs(self.functions[word(one.func)], one)
            if role in ("q", "u", "state")
            for part in (arg.elts if isinstance(arg, ast.List | ast.Tuple) else [arg])
        }  # fmt: skip
        return found - {""}

    def reversed_by(self, function: ast.Lambda | Defined, early: bool) -> bool:
        """Whether a function that a solver calls takes the time for the state.

        Parameters
        ----------
        early : bool
            Whether the solver gives the time before the state.
        """
        names = [a.arg for a in (*function.args.posonlyargs, *function.args.args)]
        names = [n for n in names if n not in ("self", "cls")][:2]
        if len(names) < 2:
            return False
        time, state = names if early else reversed(names)
        body = function.body if isinstance(function.body, list) else [function.body]
        pairs = [
            pair for line in body for one in ast.walk(line)
            if isinstance(one, ast.Call) and word(one.func) in self.functions
            for pair in self._pairs(self.functions[word(one.func)], one)
        ]  # fmt: skip
        return any(
            place_of(arg) == (state if role == "time" else time)
            for (_, role, _), arg in pairs if role in ("time", "q", "u", "state")
        )  # fmt: skip

    def _matched(
        self, called: Called, slots: Sequence[Slot], args: Sequence[ast.expr],
        keywords: Sequence[ast.keyword],
    ) -> list[tuple[Slot, ast.expr]]:  # fmt: skip
        """Arguments with what they stand for."""
        pairs: list[tuple[Slot, ast.expr]] = []
        rest = [*slots]
        for arg in args:
            if isinstance(arg, ast.Starred):
                inner = self._resolved(arg.value)
                if not isinstance(inner, ast.Tuple | ast.List):
                    break
                pairs += zip(rest, inner.elts, strict=False)
                rest = rest[len(inner.elts) :]
            elif rest:
                pairs.append((rest.pop(0), arg))
        names = {slot[0]: slot for slot in called.slots}
        given = [pair for k in keywords for pair in self._given(k)]
        return pairs + [(names[k], value) for k, value in given if k in names]

    def _given(self, keyword: ast.keyword) -> list[tuple[str, ast.expr]]:
        """What an option of a call gives, or a table of such."""
        if keyword.arg is not None:
            return [(keyword.arg, keyword.value)]
        match self._resolved(keyword.value):
            case ast.Call(func=ast.Name(id="dict"), keywords=inner):
                return [(k.arg, k.value) for k in inner if k.arg]
            case ast.Dict(keys=keys, values=values):
                return [(k.value, v) for k, v in zip(keys, values, strict=True)
                        if isinstance(k, ast.Constant) and isinstance(k.value, str)]  # fmt: skip
        return []

    def exchanges(self, node: ast.Tuple | ast.List) -> bool:
        """Whether it has what a judged function is called with, in another order."""
        labels = [_label(part) for part in node.elts]
        for called in self.functions.values():
            names = [n for n, role, _ in called.slots if role in ("parameter", "other")]
            both = [n for n in names if n in labels]
            if isinstance(node.ctx, ast.Load) and len(both) > 1 and sorted(labels) == sorted(both):
                return labels != both
        return False

    def _is_same(
        self, called: Called, slot: tuple[str, str, int], arg: ast.expr, step: bool
    ) -> bool:
        name, role, _ = slot
        if step and role in ("q", "u", "state", "time"):
            return True
        if role == "time":
            return not isinstance(arg, ast.UnaryOp)
        if role == "other" and not isinstance(arg, ast.Name | ast.Attribute):
            return not self._remakes(arg, name)  # what a controller makes is an input
        if isinstance(arg, ast.List | ast.Tuple) and role in ("state", "q", "u"):
            parts = self._entries_of(called, name)
            plain = all(self._is_value(part) for part in arg.elts)
            return plain and not any(
                self._is_another(part, entry, parts)
                for part, entry in zip(arg.elts, parts, strict=False)
            )
        value = self._resolved(arg)
        if role == "parameter" and value is not None and self.excluded(name, value):
            return False
        if _is_number(arg):
            return True
        others = [n for n, _, _ in called.slots]
        return self._is_value(arg) and not self._is_another(arg, name, others)

    def _is_value(self, arg: ast.expr) -> bool:
        """Whether it is a thing as it is: a name, a part of one, a number, a copy."""
        if _is_number(arg) or isinstance(arg, ast.Name | ast.Constant | ast.Starred):
            return True
        if isinstance(arg, ast.Attribute):
            return self._is_value(arg.value)
        if isinstance(arg, ast.Subscript):
            steps = [s.step for s in ast.walk(arg.slice) if isinstance(s, ast.Slice)]
            return self._is_value(arg.value) and not any(steps)
        if isinstance(arg, ast.List | ast.Tuple):
            return all(map(self._is_value, arg.elts))
        if isinstance(arg, ast.Call):
            base = isinstance(arg.func, ast.Attribute) and word(arg.func.value) not in (
                "np",
                "math",
            )
            plain = [*arg.args, *([arg.func.value] if isinstance(arg.func, ast.Attribute) and base
                                  else [])]  # fmt: skip
            return word(arg.func) in KEEPING and all(map(self._is_value, plain))
        return False

    def _is_another(self, arg: ast.expr, name: str, others: Iterable[str]) -> bool:
        """Whether the name of an argument is that of another one, or means something else."""
        label = _label(arg)
        own = {key(label), key(label.rstrip("0"))} - {""}  # th0 is where th begins
        if not own or key(name) in own:
            return False
        if any(key(other) in own for other in others if other != name):
            return True
        meant, wanted = self._meaning(label), self._meaning(name)
        return meant is not None and wanted is not None and meant != wanted

    def _meaning(self, name: str) -> tuple[str, int] | None:
        if name in self.columns:
            return " ".join(self.columns[name]), 0
        bare = name.rstrip("0").rstrip("_")
        return self.naming.lookup(name) or (self.naming.lookup(bare) if bare else None)

    def _remakes(self, arg: ast.expr, name: str) -> bool:
        """Whether an argument is made of what already is the one that it stands for: -u, 2*u."""
        made = [n for n in ast.walk(arg) if isinstance(n, ast.BinOp | ast.UnaryOp)]
        parts = [word(n) for one in made for n in ast.walk(one)]
        meaning = self._meaning(name)
        return any(
            key(part) == key(name) or (meaning is not None and self._meaning(part) == meaning)
            for part in parts if part
        )  # fmt: skip

    def excluded(self, name: str, node: ast.expr) -> bool:
        """Whether a parameter of the scene cannot have the number that something is."""
        value = number_of(node)
        found = self.naming.lookup(name)
        constants = self.naming.vocabulary.constants
        if value is None or found is None or found[0] not in constants:
            return False
        positive = constants[found[0]].is_positive
        return (value <= 0 and bool(positive)) or (
            value < 0 and bool(constants[found[0]].is_nonnegative)
        )

    def _entries_of(self, called: Called, name: str) -> list[str]:
        """Names of the entries of a state in a function: th, w = y."""
        node = self.nodes[called.name]
        found: dict[int, str] = {}
        for one in ast.walk(node):
            match one:
                case ast.Assign(targets=[ast.Tuple(elts=parts)], value=ast.Name(id=same)) if (
                    same == name):  # fmt: skip
                    found |= {k: word(part) for k, part in enumerate(parts)}
                case ast.Assign(
                    targets=[ast.Name(id=part)],
                    value=ast.Subscript(value=ast.Name(id=same), slice=ast.Constant(value=int(k))),
                ) if same == name:
                    found[k] = part
        if not found and name in self.columns:
            return self.columns[name]
        return [found[k] for k in range(len(found)) if k in found]

    def _misplaced(self, pairs: Sequence[tuple[tuple[str, str, int], ast.expr]]) -> bool:
        """Whether entries of a state stand for coordinates and speeds in no usual order."""
        count = len(self.coordinates)
        places = {}
        for (_, role, k), arg in pairs:
            place = _component(arg)
            if role in ("q", "u") and place is not None:
                places[role, k] = place
        blocks = all(place == k + count * (role == "u") for (role, k), place in places.items())
        paired = all(place == 2 * k + (role == "u") for (role, k), place in places.items())
        return not (blocks or paired)

    def is_first_order(self, body: ast.expr) -> bool:
        """Whether it is the rate of a state of one coordinate: [y[1], accel(y[0], y[1])]."""
        if isinstance(body, ast.Call) and word(body.func) == "array" and len(body.args) == 1:
            body = body.args[0]
        match body:
            case (
                ast.List(elts=[speed, ast.Call() as call])
                | ast.Tuple(elts=[speed, ast.Call() as call])
            ):
                known = self.functions.get(word(call.func))
                return (
                    known is not None
                    and len(self.coordinates) == 1
                    and _component(speed) == 1
                    and any(role == "q" for _, role, _ in known.slots)
                )
        return False


def passed(name: str, inside: Iterable[ast.AST]) -> Called:
    """A function that is an argument of another one, by the first call of it."""
    slots: list[tuple[str, str, int]] = []
    for one in inside:
        if isinstance(one, ast.Call) and word(one.func) == name and not slots:
            for k, part in enumerate(one.args):
                names = {n.id for n in ast.walk(part) if isinstance(n, ast.Name)}
                timed = isinstance(part, ast.Constant) or names & {*TIMES}
                known = any(role == "state" for _, role, _ in slots)
                role = "time" if timed else "other" if known else "state"
                slots.append((f"argument {k}", role, 0))
    return Called(name, tuple(slots))


def fixed_in(tree: ast.Module) -> dict[str, ast.expr]:
    """Names of a file that are given a value once, in no loop."""
    stored = [n.id for n in ast.walk(tree) if isinstance(n, ast.Name)
              and isinstance(n.ctx, ast.Store)]  # fmt: skip
    again = {id(n) for one in ast.walk(tree) if isinstance(one, ast.For | ast.While)
             for n in ast.walk(one)}  # fmt: skip
    return {
        one.targets[0].id: one.value
        for one in ast.walk(tree)
        if isinstance(one, ast.Assign) and isinstance(one.targets[0], ast.Name)
        and id(one) not in again and stored.count(one.targets[0].id) == 1
    }  # fmt: skip


def word_of_truth(node: ast.expr | None) -> bool:
    """Whether an option is set."""
    return isinstance(node, ast.Constant) and node.value is True


def _parted(node: Defined) -> set[str]:
    """Names of a function of which parts are taken."""
    found = set()
    for one in ast.walk(node):
        match one:
            case ast.Subscript(value=ast.Name(id=name)):
                found.add(name)
            case ast.Assign(targets=[ast.Tuple()], value=ast.Name(id=name)):
                found.add(name)
    return found


def number_of(node: ast.expr) -> float | None:
    """The number that an expression of numbers is."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return float(value)
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            size = number_of(inner)
            return None if size is None else -size
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() | ast.Div() as op,
                       right=right):  # fmt: skip
            one, other = number_of(left), number_of(right)
            if one is None or other is None:
                return None
            match op:
                case ast.Add():
                    return one + other
                case ast.Sub():
                    return one - other
                case ast.Mult():
                    return one * other
                case ast.Div() if other:
                    return one / other
    return None


def place_of(node: ast.expr) -> str:
    """Where a value stands: th of th[i], self.w of self.w; empty for what is made."""
    while isinstance(node, ast.Subscript) and not (
        isinstance(node.slice, ast.Constant) and isinstance(node.slice.value, str)
    ):
        node = node.value
    if isinstance(node, ast.Call) and len(node.args) == 1 and word(node.func) in KEEPING:
        return place_of(node.args[0])
    return ast.unparse(node) if isinstance(node, ast.Name | ast.Attribute | ast.Subscript) else ""


def _is_number(node: ast.AST) -> bool:
    """Whether it is made of numbers only."""
    plain = (ast.Constant, ast.BinOp, ast.UnaryOp, ast.operator, ast.unaryop)
    return all(
        isinstance(n, plain) or word(n) in ("pi", "np", "math") or isinstance(n, ast.expr_context)
        for n in ast.walk(node)
    )


def _component(node: ast.expr) -> int | None:
    """Which entry of a state it is, where it says so: y[1], sol.y[1], sol[:, 1]."""
    while isinstance(node, ast.Subscript):
        match node.slice:
            case ast.Constant(value=int(k)) if k >= 0:
                return k
            case ast.Tuple(elts=[ast.Slice(), ast.Constant(value=int(k))]) if k >= 0:
                return k
            case ast.Tuple(elts=[ast.Constant(value=int(k)), _]) if k >= 0:
                return k
        node = node.value
    return None


def _label(node: ast.expr) -> str:
    """What an argument is called: g of p.g, p["g"] and g, th of th[i]."""
    if isinstance(node, ast.Subscript):
        if isinstance(node.slice, ast.Constant):
            return node.slice.value if isinstance(node.slice.value, str) else ""
        return _label(node.value)
    if isinstance(node, ast.Call) and node.args:
        return _label(node.args[0])
    return word(node)
