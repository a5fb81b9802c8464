"""Programs over lanes as C: one statement for each value of a block of motions.

Arithmetic is that of ``lanes.h``; a sine and the cosine of the same angle are computed together;
all else is written as the table of operations has it, lane by lane.
"""

from collections.abc import Mapping

from mechanics.compiled.c.source import literal
from mechanics.program.operations import (
    ARITY,
    BY_NAME,
    CONSTANT,
    COS,
    DIVIDE,
    INPUT,
    OPERATIONS,
    PI,
    SIN,
)
from mechanics.program.program import Program

ARITHMETIC = {
    BY_NAME["add"].code: "add({}, {})", BY_NAME["subtract"].code: "sub({}, {})",
    BY_NAME["multiply"].code: "mul({}, {})", BY_NAME["divide"].code: "over({}, {})",
    BY_NAME["negate"].code: "minus({})",
}  # fmt: skip


class Lanes:
    """Statements of a program without linear systems.

    Parameters
    ----------
    inputs : mapping of str to str
        What each input is in C.
    prefix : str
        Of the names of values.
    reciprocals : mapping of str to str, optional
        Of inputs that are divided by. With it other divisors get reciprocals, too, each computed
        once and kept: divisions become products.

    Attributes
    ----------
    lines : list of str
        Statements.
    inverses : list of str
        Variables, to be declared, of reciprocals.
    """

    def __init__(
        self,
        program: Program,
        inputs: Mapping[str, str],
        prefix: str,
        reciprocals: Mapping[str, str] | None = None,
    ) -> None:
        self.lines: list[str] = []
        self.inverses: list[str] = []
        self._program, self._prefix = program, prefix
        self._texts: list[str] = []
        self._inverse: dict[int, str] = {}
        self._waves: dict[tuple[int, int], str] = {}
        for number, code in enumerate(program.operations):
            place = program.operands[0][number]
            if code == CONSTANT:
                self._texts.append(f"all({literal(float(program.constants[place]), 'double')})")
            elif code == PI:
                self._texts.append(f"all({OPERATIONS[PI].c})")
            elif code == INPUT:
                name = program.inputs[place]
                self._texts.append(inputs[name])
                if reciprocals and name in reciprocals:
                    self._inverse[number] = reciprocals[name]
            elif code == DIVIDE and reciprocals is not None:
                above, below = program.operands_of(number)
                self._say(number, f"mul({self._texts[above]}, {self.inverse(below)})")
            else:
                self._operation(number, code)

    def values(self, output: str) -> list[str]:
        """Expressions of the entries of an output."""
        return [self._texts[number] for number in self._program.outputs[output]]

    def inverse(self, number: int) -> str:
        """The reciprocal of a value."""
        if number not in self._inverse:
            self._inverse[number] = name = f"inverse{len(self.inverses)}"
            self.inverses.append(name)
            self.lines.append(f"{name} = over(all(1.0), {self._texts[number]});")
        return self._inverse[number]

    def _say(self, number: int, value: str) -> None:
        self._texts.append(f"{self._prefix}{number}")
        self.lines.append(f"const L {self._texts[-1]} = {value};")

    def _operation(self, number: int, code: int) -> None:
        operands = self._program.operands_of(number)
        texts = [self._texts[operand] for operand in operands]
        if code in ARITHMETIC:
            self._say(number, ARITHMETIC[code].format(*texts))
        elif code in (SIN, COS):
            if (code, *operands) not in self._waves:
                sine, cosine = (f"{name}_{self._prefix}{number}" for name in ("sin", "cos"))
                self._waves[SIN, operands[0]], self._waves[COS, operands[0]] = sine, cosine
                self.lines += [f"L {sine}, {cosine};", f"waves({texts[0]}, &{sine}, &{cosine});"]
            self._texts.append(self._waves[code, operands[0]])
        else:
            name = f"{self._prefix}{number}"
            self.lines.append(f"L {name};")
            given = [f"{name}_{k}" for k in range(ARITY[code])]
            self.lines += [f"const L {a} = {text};" for a, text in zip(given, texts, strict=True)]
            call = OPERATIONS[code].c.format(*(f"LANE(&{a}, i)" for a in given))
            self.lines.append(f"for (int i = 0; i < LANES; ++i) LANE(&{name}, i) = {call};")
            self._texts.append(name)
