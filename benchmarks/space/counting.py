"""How many operations a program costs, apart from those that depend on parameters only.

What depends on parameters only is computed once for all states.
"""

from collections.abc import Collection
from dataclasses import dataclass

from mechanics.program.operations import ADD, DIVIDE, ENTRY, INPUT, MULTIPLY, NEGATE, SUBTRACT
from mechanics.program.program import LEAVES, Program


@dataclass(frozen=True)
class Counts:
    """Operations after sharing.

    Attributes
    ----------
    multiplications, additions : int
        Divisions are multiplications; differences and changes of sign are additions.
    functions : int
        Everything else: sines, cosines, roots.
    parameters : int
        Operations of any kind on parameters and constants alone; in none of the others.
    """

    multiplications: int
    additions: int
    functions: int
    parameters: int

    @property
    def total(self) -> int:
        """What one state costs."""
        return self.multiplications + self.additions + self.functions


def count(program: Program, parameters: Collection[str] = ()) -> Counts:
    """Operations of a program.

    Parameters
    ----------
    parameters : collection of str
        Names of the inputs that are the same for all states.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> q, m, l = map(b.input, "qml")
    >>> count(b.program({"tau": [m * l * q.sin()]}), "ml")
    Counts(multiplications=1, additions=0, functions=1, parameters=1)
    """
    kinds = {MULTIPLY: 0, DIVIDE: 0, ADD: 1, SUBTRACT: 1, NEGATE: 1}
    found = [0, 0, 0, 0]
    constant: list[bool] = []
    for number, code in enumerate(program.operations):
        if code == INPUT:
            constant.append(program.inputs[program.operands[0][number]] in parameters)
            continue
        alone = all(constant[operand] for operand in program.operands_of(number))
        constant.append(alone)
        if code not in LEAVES and code != ENTRY:
            found[3 if alone else kinds.get(code, 2)] += 1
    return Counts(*found)
