"""C99 from a program for many states: a loop over lanes that compilers vectorise.

    entry k of state i = array[k * stride + i]            structure of arrays

The body of the loop is straight-line code without a branch. Sines and cosines are computed in pairs
by the inline text of `sine`; products that are added are one ``mechanics_fma``, the factors of
others are multiplied as they get ready; what depends on shared inputs alone is computed before the
loop. Every lane goes through the same operations, so the
result does not depend on where in the batch a state stands, nor on how long the vectors are.
"""

import textwrap
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from mechanics.compiled.c.flow import constant, looked_at, users
from mechanics.compiled.c.names import Namer
from mechanics.compiled.c.source import LINE, Entries, literal
from mechanics.compiled.c.source import constant as number
from mechanics.program.c_printer import PRIMARY, UNARY, Text, expression, numeric
from mechanics.program.operations import ADD, COS, DIVIDE, INPUT, MULTIPLY, SIN, SUBTRACT
from mechanics.program.routine import Node, Routine

SHARED = ("p",)
"""Inputs that all states of a batch have in common, unless told otherwise."""
INDEPENDENT = (
    "#if defined(__clang__)",
    "#pragma clang loop vectorize(assume_safety)",
    "#elif defined(__GNUC__)",
    "#pragma GCC ivdep",
    "#endif",
)
"""Tells the compiler that no state reads what another one writes."""
FAR, WILD = 1, 2
"""What the functions return; 0 is neither."""
_TURNS = (SIN, COS)
_LONG = 24
_LARGEST = {"double": float(np.finfo(np.float64).max), "float": float(np.finfo(np.float32).max)}


def arguments(code: Routine, kind: str, restrict: str = "") -> str:
    """``size_t count, size_t stride, const double *q, ..., double *ud``."""
    inputs = [f"const {kind} *{restrict}{group}" for group, size in code.inputs if size]
    outputs = [f"{kind} *{restrict}{out}" for out, (rows, cols) in code.shapes if rows * cols]
    return ", ".join(["size_t count, size_t stride", *inputs, *outputs])


def lanes_source(
    code: Routine,
    entries: Entries,
    kind: str,
    name: str,
    shared: Sequence[str] = SHARED,
    checked: bool = False,
) -> str:
    """Definition of ``static inline int name_lanes(...)``: the loop.

    It returns `FAR` where an angle of some state is too large for the inline sine, or no number;
    with `checked`, plus `WILD` where a value of another state has to be finite and may not be: what
    the inline sine makes of an angle that is too large tells nothing.
    """
    writer = _Writer(code, entries, kind, name, shared)
    unsigned = "uint32_t" if kind == "float" else "uint64_t"
    flags, result = [writer.far], f"{writer.far} != 0"
    if checked:
        flags.append(writer.check())
        result = f"({result}) | ({flags[1]} != 0) << 1"
    head = wrapped(f"static inline int {name}_lanes({arguments(code, kind, 'restrict ')})", "")
    return "\n".join([
        *head,
        "{",
        *writer.ignored,
        *writer.before,
        *(f"    {unsigned} {flag} = 0;" for flag in flags),
        *INDEPENDENT,
        f"    for (size_t {writer.lane} = 0; {writer.lane} < count; ++{writer.lane}) {{",
        *writer.inside,
        "    }",
        f"    return {result};",
        "}",
        "",
    ])  # fmt: skip


def wrapped(text: str, indent: str, at: str = ", ") -> list[str]:
    """Lines of at most `LINE` characters that break between arguments, or at another text."""
    glued = text.replace(at, f"{at[:-1]}\0").replace(" ", "~").replace("\0", " ")
    lines = textwrap.wrap(
        glued, LINE, initial_indent=indent, subsequent_indent=indent + "    ",
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip
    return [line.replace("~", " ") for line in lines]


class _Writer:
    """One pass over the nodes.

    Attributes
    ----------
    before, inside : list of str
        Lines before the loop and in it.
    ignored : list of str
        Casts of arguments that nothing reads.
    lane, far : str
        Names of the index and of the flag.
    """

    def __init__(
        self, code: Routine, entries: Entries, kind: str, name: str, shared: Sequence[str]
    ) -> None:
        self._code, self._kind = code, kind
        self._f = "f" if kind == "float" else ""
        groups = {group for group, _ in code.inputs} | {out for out, _ in code.shapes}
        namer = Namer({*groups, name, "count", "stride"})
        self._namer = namer
        self.lane, self.far = namer.local("i"), namer.local("far")
        self.before: list[str] = []
        self.inside: list[str] = []
        self._users = users(code)
        self._constant = constant(code, shared)
        self._fused = self._fusions()
        self._inverses: dict[int, Text] = {}
        self._texts: list[Text] = []
        self._angles: list[str] = []
        self._turned: dict[tuple[int, int], Text] = {}
        self._read(entries, shared)
        for k, node in enumerate(code.nodes):
            self._node(k, node)
        for (out, _), nodes in zip(code.shapes, code.outputs, strict=True):
            for entry, node_at in enumerate(nodes):
                text = numeric(self._texts[node_at], kind).code
                self.inside.append(f"        {out}[{self._place(entry)}] = {text};")
        read = {code.inputs[n.operands[0]][0] for k, n in self._inputs()}
        unread = [group for group, size in code.inputs if size and group not in read]
        if not any(" * stride" in line for line in self.inside):
            unread.append("stride")
        self.ignored = [f"    (void){argument};" for argument in unread]
        self._beyond = self._far_lane()

    def _far_lane(self) -> str:
        """Add to the loop whether an angle of this state is too large; the name of it, if any."""
        if not self._angles:
            return ""
        beyond = self._namer.local("beyond")
        unsigned = "uint32_t" if self._kind == "float" else "uint64_t"
        tests = " | ".join(f"mechanics_far{self._f}({angle})" for angle in self._angles)
        self.inside += wrapped(f"const {unsigned} {beyond} = {tests};", "        ", " | ")
        self.inside.append(f"        {self.far} |= {beyond};")
        return beyond

    def check(self) -> str:
        """Add to the loop whether values are finite; the name of the flag."""
        flag = self._namer.local("wild")
        texts = [numeric(self._texts[k], self._kind) for k in looked_at(self._code)]
        values = [t.code if t.level == PRIMARY else f"({t.code})" for t in texts]
        if values:
            # A sum is finite only where its terms are.
            total, limit = (
                " + ".join(dict.fromkeys(values)),
                literal(_LARGEST[self._kind], self._kind),
            )
            near = f"!{self._beyond} & " if self._beyond else ""
            self.inside.append(f"        {flag} |= {near}!(fabs{self._f}({total}) <= {limit});")
        return flag

    def _inputs(self) -> list[tuple[int, Node]]:
        return [
            (k, node)
            for k, node in enumerate(self._code.nodes)
            if node.operation == INPUT and self._users[k]
        ]

    def _read(self, entries: Entries, shared: Sequence[str]) -> None:
        """A name for every input entry that is used."""
        self._local: dict[tuple[int, ...], Text] = {}
        for _, node in sorted(self._inputs(), key=lambda pair: pair[1].operands):
            group, entry = self._code.inputs[node.operands[0]][0], node.operands[1]
            once = group in shared
            at = f"{group}[{entry}]" if once else f"{group}[{self._place(entry)}]"
            self._local[node.operands] = self._kept(
                at, self._namer.local(entries[group][entry]), once
            )

    def _place(self, entry: int) -> str:
        return self.lane if entry == 0 else f"{entry} * stride + {self.lane}"

    def _kept(self, text: str, name: str, once: bool) -> Text:
        lines, indent = (self.before, "    ") if once else (self.inside, "        ")
        lines.append(f"{indent}const {self._kind} {name} = {text};")
        return Text(name)

    def _node(self, k: int, node: Node) -> None:
        if node.constant is not None:
            self._texts.append(number(node.constant, self._kind))
            return
        if node.operation == INPUT:
            self._texts.append(self._local.get(node.operands, Text("")))
            return
        if node.operation in _TURNS and not self._constant[k]:
            self._texts.append(self._turn(node))
            return
        self._texts.append(self._expression(k, node))
        if k in self._fused.values():
            return
        # What is computed once has to stand before the loop.
        leaves = self._constant[k] and not all(self._constant[i] for i in self._users[k])
        if len(self._users[k]) > 1 or leaves or len(self._texts[k].code) > _LONG:
            self._texts[k] = self._named(k)

    def _named(self, k: int) -> Text:
        text = numeric(self._texts[k], self._kind)
        return self._kept(text.code, self._namer.value(), self._constant[k])

    def _turn(self, node: Node) -> Text:
        """Sine or cosine: both at once, the first time that one of them is asked for."""
        (operand,) = node.operands
        if (operand, node.operation) not in self._turned:
            angle = self._texts[operand]
            if angle.level != PRIMARY:
                angle = self._texts[operand] = self._named(operand)
            pair = [self._namer.local(f"{f}_{angle.code}") for f in ("sin", "cos")]
            self.inside += [
                f"        {self._kind} {pair[0]}, {pair[1]};",
                f"        mechanics_sincos{self._f}({angle.code}, &{pair[0]}, &{pair[1]});",
            ]
            self._angles.append(angle.code)
            for operation, name in zip(_TURNS, pair, strict=True):
                self._turned[operand, operation] = Text(name)
        return self._turned[operand, node.operation]

    def _expression(self, k: int, node: Node) -> Text:
        """One operation."""
        parts = [self._texts[i] for i in node.operands]
        if k in self._fused:
            return self._fusion(k, node)
        if node.operation == DIVIDE and not self._constant[k]:
            divisor = node.operands[1]
            if self._constant[divisor]:
                return expression(MULTIPLY, [parts[0], self._inverse(divisor)], self._kind)
        return expression(node.operation, parts, self._kind)

    def _inverse(self, k: int) -> Text:
        """1 over a value that all states share: one division before the loop."""
        if k not in self._inverses:
            one = number(Fraction(1), self._kind)
            text = expression(DIVIDE, [one, self._texts[k]], self._kind)
            self._inverses[k] = self._kept(text.code, self._namer.value(), True)
        return self._inverses[k]

    def _fusions(self) -> dict[int, int]:
        """For each sum the product in it that is fused with it: nothing else uses that."""
        found = {}
        for k, node in enumerate(self._code.nodes):
            if node.operation not in (ADD, SUBTRACT) or self._constant[k]:
                continue
            for i in reversed(node.operands):
                product = self._code.nodes[i].operation == MULTIPLY and not self._constant[i]
                if product and len(self._users[i]) == 1:
                    found[k] = i
                    break
        return found

    def _fusion(self, k: int, node: Node) -> Text:
        """a b + c, c - a b or a b - c as one operation."""
        product = self._code.nodes[self._fused[k]]
        last = node.operands[1] == self._fused[k]
        places = node.operands[0 if last else 1], *product.operands
        other, left, right = (numeric(self._texts[i], self._kind) for i in places)
        if node.operation == SUBTRACT:
            left, other = (_minus(left), other) if last else (left, _minus(other))
        return Text(f"mechanics_fma{self._f}({left.code}, {right.code}, {other.code})")


def _minus(text: Text) -> Text:
    """The same with the other sign."""
    if text.level == UNARY:
        return Text(text.code[1:])
    return Text(f"-{text.code}" if text.level == PRIMARY else f"-({text.code})", UNARY)
