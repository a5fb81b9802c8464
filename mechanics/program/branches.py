"""Build expressions of another language in a builder, each branch under its condition.

An expression is taken apart once for each condition it stands under: what a branch shares with the
rest is demanded without the condition, too. Nothing is recursive, so that depth costs nothing.
"""

from collections.abc import Callable, Hashable, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import partial
from typing import Any, NamedTuple

from mechanics.errors import ExpressionError
from mechanics.program.builder import Builder, Node
from mechanics.program.operations import Sign


class Parts(NamedTuple):
    """An expression that is computed from others.

    Attributes
    ----------
    operands : sequence of expressions
    build : callable
        From the numbers of the operands to that of the node.
    """

    operands: Sequence[Any]
    build: Callable[..., int]


class Choice(NamedTuple):
    """One of two expressions.

    Attributes
    ----------
    condition, if_true : expressions
    if_false : expression or None
        None where there is no value.
    """

    condition: Any
    if_true: Any
    if_false: Any


Expand = Callable[[Any], Parts | Choice]


def build(
    builder: Builder,
    expressions: Sequence[Hashable],
    expand: Expand,
    leaves: Mapping[Any, Node] | None = None,
) -> tuple[Node, ...]:
    """Nodes of expressions; what they share is built once in each branch.

    Parameters
    ----------
    expressions : sequence
        Anything hashable but callables made by `functools.partial`.
    expand : callable
        Takes one apart.
    leaves : mapping of expressions to Node, optional
        What is not taken apart.

    Raises
    ------
    ExpressionError
        If no case of an expression holds, whatever the inputs are.
    """
    return Walk(builder, expand, leaves or {}).nodes(expressions)


class Walk:
    """What is still to be done, and what is known in the branch and outside of it.

    What has been built outside of branches is known to later expressions, too.
    """

    def __init__(self, builder: Builder, expand: Expand, leaves: Mapping[Any, Node]) -> None:
        self.builder, self.expand = builder, expand
        self.scopes: list[dict[Any, int]] = [{leaf: node.number for leaf, node in leaves.items()}]
        self.conditions: list[AbstractContextManager[None]] = []
        self.tasks: list[Any] = []

    def nodes(self, expressions: Sequence[Hashable]) -> tuple[Node, ...]:
        """The nodes of expressions."""
        try:
            self.run(expressions)
        except Exception:
            self.tasks.clear()
            while self.conditions:
                self.scopes.pop()
                self.conditions.pop().__exit__(None, None, None)
            raise
        return tuple(Node(self.builder, self.number(expression)) for expression in expressions)

    def run(self, expressions: Sequence[Hashable]) -> None:
        """Expressions are built, tasks are called, the last one first."""
        tasks = self.tasks
        tasks.extend(reversed(expressions))
        while tasks:
            task = tasks.pop()
            if task.__class__ is partial:
                task()
            elif self.find(task) is None:
                parts = self.expand(task)
                if isinstance(parts, Choice):
                    tasks += (partial(self.choose, task, parts), parts.condition)
                else:
                    self.apply(task, *parts)

    def find(self, expression: Any) -> int | None:
        """The node of an expression, if it has been built here or outside of the branch."""
        number = self.scopes[-1].get(expression)
        if number is None:
            for scope in self.scopes[-2::-1]:
                number = scope.get(expression)
                if number is not None:
                    break
        return number

    def number(self, expression: Any) -> int:
        """The node of an expression that has been built."""
        number = self.find(expression)
        assert number is not None  # its task was run before
        return number

    def apply(self, expression: Any, operands: Sequence[Any], function: Any) -> None:
        """Build it, when its operands are there."""
        known, find = self.scopes[-1], self.find
        numbers = [known.get(o) or find(o) for o in operands]
        if None not in numbers:
            known[expression] = function(*numbers)
            return
        self.tasks.append(partial(self.apply, expression, operands, function))
        pairs = zip(operands, numbers, strict=True)
        self.tasks.extend([operand for operand, number in pairs if number is None][::-1])

    def choose(self, expression: Any, choice: Choice) -> None:
        """Build one branch or both, now that the condition is there."""
        condition = Node(self.builder, self.number(choice.condition))
        known = condition.constant
        branches = [(True, choice.if_true), (False, choice.if_false)]
        if choice.if_false is None:
            if known == 0:
                raise ExpressionError("an expression by cases of which none holds has no value")
            self.builder.demand(Sign.NONZERO, condition, "select")
            branches.pop()
        if known is not None:
            branch = branches[0][1] if known else choice.if_false
            self.apply(expression, [branch], lambda number: number)
            return
        values: list[int] = []
        self.tasks.append(partial(self.join, expression, condition, values))
        for truth, branch in reversed(branches):
            self.tasks += (
                partial(self.leave, branch, values), branch, partial(self.enter, condition, truth)
            )  # fmt: skip

    def enter(self, condition: Node, truth: bool) -> None:
        """Build what follows where the condition has that truth."""
        under = self.builder.under(condition, truth)
        under.__enter__()
        self.conditions.append(under)
        self.scopes.append({})

    def leave(self, branch: Any, values: list[int]) -> None:
        """Keep the value of a branch, and forget what else was built in it."""
        values.append(self.number(branch))
        self.scopes.pop()
        self.conditions.pop().__exit__(None, None, None)

    def join(self, expression: Any, condition: Node, values: Sequence[int]) -> None:
        """Select among the values of the branches."""
        first, last = (Node(self.builder, n) for n in (values[0], values[-1]))
        self.scopes[-1][expression] = condition.choose(first, last).number
