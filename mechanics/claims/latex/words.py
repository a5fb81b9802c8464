r"""Numbers, letters and the commands that print letters, as items.

ml    ->    m l        \mathrm{sin}    ->    the function        \varphi_1    ->    phi_1
"""

import re
from fractions import Fraction

from lark import Token

from mechanics.claims.conserved import CONSTANT
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.latex.item import DETERMINANT, Item, bare, letter_of
from mechanics.claims.latex.variants import NAME
from mechanics.claims.lines import PRODUCT
from mechanics.claims.names import GREEK, Naming
from mechanics.claims.place import Refused
from mechanics.claims.tree import Call, Name, Number, ended


def named(name: str, sub: str, at: int) -> Item:
    """A name with its subscript."""
    return Item("node", at, Name(at, f"{name}_{sub}" if sub else name))


SINES = ("sin", "cos", "tan")
"""Functions that people write without a backslash behind a factor: gsin(theta)."""

SUM = r"\sum"
ENERGIES = {"calL": "Lagrangian", "calH": "Hamiltonian", "calT": "E_k", "calV": "E_p",
            "calU": "E_p", "calK": "E_k", "calE": "E_tot"}  # fmt: skip
"""What letters of another font are beside the plain ones."""
LAGRANGIAN = "Lagr"
"""What pages call the script L that they define elsewhere."""


def summed(items: list[Item]) -> list[Item]:
    r"""The items; ``\sum F_x`` of a name is a name of the person, too.

    Raises
    ------
    Refused
        For a sum of anything else: what it runs over is not known.
    """
    found: list[Item] = []
    for item in items:
        if found and found[-1].kind == "sum":
            before, node = found.pop(), item.node
            if not isinstance(node, Name) or node.order:
                raise Refused(before.at, f"the command {SUM} is not supported")
            name = ended(Name(before.at, f"sum{node.name}"), node.end)
            item = Item("node", before.at, name, end=item.end)
        found.append(item)
    if found and found[-1].kind == "sum":
        raise Refused(found[-1].at, f"the command {SUM} is not supported")
    return found


class Words:
    """Reads tokens; how it read what can be read in two ways is noted."""

    def __init__(self, naming: Naming, notes: list[str]) -> None:
        self.naming, self.notes = naming, notes

    def of(self, token: Token, sub: str, at: int) -> list[Item]:
        """The items of a number, a run of letters, or a command that prints some."""
        text = token.value
        if token.type == "NUMBER":
            if sub:
                raise Refused(at, f"the subscript {sub} belongs behind a name")
            return [Item("node", at, Number(at, Fraction(text)))]
        if token.type == "WORD":
            return self._word(text, sub, at)
        if token.type == "FONT":
            inside = text[text.index("{") + 1 : -1] if "{" in text else text.split()[-1]
            inside = inside.replace(" ", "")
            if inside in FUNCTIONS and not self.naming.knows(inside):
                return [Item("function", at, text=inside)]
            return [named(inside, sub, at)]
        if token.type == "BARRED":
            (mark,) = re.match(r"\\(\w+?)(?=[^a-z]|$)", text).groups()  # type: ignore[union-attr]
            mark = {"overline": "bar", "widehat": "hat", "widetilde": "tilde"}.get(mark, mark)
            inside = bare(text[len(mark) + 1 :]) if f"\\{mark}" in text else bare(text[1:])
            return [named(inside + mark, sub, at)]
        command = text[1:]
        if command in FUNCTIONS and not sub:
            return [Item("function", at, text=command)]
        letter = letter_of(command)
        if command == LAGRANGIAN and not sub:
            length = self.naming.is_function("L") is False
            return [named("Lagrangian" if length else "L", sub, at)]
        if text == SUM and not sub:
            return [Item("sum", at)]
        if NAME.fullmatch(command):
            return [named(ENERGIES.get(command, command) if not sub else command, sub, at)]
        if letter not in GREEK and letter not in ("l", DETERMINANT):
            raise Refused(at, f"the command {text} is not supported")
        if letter == "pi" and not sub and not self.naming.knows("pi"):
            return [Item("node", at, Call(at, "pi", ()))]
        return [named(letter, sub, at)]

    def _word(self, word: str, sub: str, at: int) -> list[Item]:
        """A run of letters: one name of the scene, a function, or a product of letters."""
        whole = f"{word}_{sub}" if sub else word
        if len(word) == 1 or self.naming.knows(whole) or (word in CONSTANT and not sub):
            return [named(word, sub, at)]
        if word in FUNCTIONS and not sub:
            self.notes.append(f"{word} is read as the function, not as a product of letters")
            return [Item("function", at, text=word)]
        end = next((word[k:] for k in range(1, len(word) - 2) if word[k:] in SINES), "")
        if end and not sub and not self.naming.knows(end[0]):
            return [
                *self._word(word[: -len(end)], "", at),
                *self._word(end, "", at + len(word) - len(end)),
            ]
        letters = " ".join((*word[:-1], whole[len(word) - 1 :]))
        self.notes.append(f"{whole} {PRODUCT} {letters}")
        before = [named(letter, "", at + i) for i, letter in enumerate(word[:-1])]
        for i, item in enumerate(before):
            ended(item.node, at + i + 1)  # type: ignore[arg-type]
        return [*before, named(word[-1], sub, at + len(word) - 1)]
