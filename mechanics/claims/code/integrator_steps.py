"""Loops and functions that advance a state by themselves, with the judged function.

    y = y + h*rate(t, y, p)         after = integrator(rates, before, h)

The block is run once, on random numbers: what it makes of a state is compared, exactly, with what
each integrator makes of it, for each number in the block that may be its step.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice, product
from typing import Any

from mechanics.claims.code.integrators import INTEGRATORS, STEP
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.intermediate_form import Term
from mechanics.claims.code.interpreter import FAR, Interpreter
from mechanics.claims.code.interpreter_values import (
    FileFunction,
    Handle,
    NotFollowedError,
    Table,
    Unknown,
    rational,
    root_of,
    targets_of,
)

MOST_TRIED = 60
"""Places that may hold what the function does not ask for."""
Place = tuple[str, tuple[Any, ...]]
"""A name, and which entry of it."""


class IntegratorSteps(Interpreter):
    """Tells whether a block is a step of an integrator."""

    def steps(
        self, block: Term, env: dict[str, Any], counter: str = "",
        function: FileFunction | None = None,
    ) -> bool:  # fmt: skip
        """Whether a block advances a state as an integrator does, with the judged function.

        Parameters
        ----------
        block : Term
        env : dict of str to value
            What is known before.
        counter : str
            What the loop counts with.
        function : FileFunction, optional
            Whose body it is.
        """
        if not any(judged.gives for judged in self.judged.values()):
            return False
        sets = self._sets(block)
        kept = [one for one in self.before if root_of(one.parts[0]) in sets]
        return self._is_advanced(block, env, counter, function, []) or bool(
            kept and self._is_advanced(block, env, counter, function, kept)
        )

    def _sets(self, block: Term) -> set[str]:
        return {root_of(t) for one in block.all() if one.kind == "set"
                for t in targets_of(one.parts[0])}  # fmt: skip

    def _is_advanced(
        self, block: Term, env: dict[str, Any], counter: str, function: FileFunction | None,
        kept: Sequence[Term],
    ) -> bool:  # fmt: skip
        """Whether a block is a step that leaves true what some lines before it say: a = f(y)."""
        self._start()
        self._count += 1
        inside = {n: v for n, v in env.items() if not isinstance(v, Unknown)}
        self._forget(block, inside)
        for name in function.takes if function is not None else ():
            if not isinstance(inside.get(name), Handle):
                inside.pop(name, None)
        self.called_in = block.names()
        self._vectors(block, inside)
        for name in self.vectors:
            if isinstance(inside.get(name), Fraction):
                del inside[name]  # another thing of the same name
        if counter:
            inside[counter] = Fraction(FAR + 7)
        for one in block.all():
            apart = {*self.own, *self.language.shows, *self.judged}
            if one.kind == "entry" or (
                one.kind == "call" and self.brackets and one.name not in apart
            ):
                for place in one.parts[1:] if one.kind == "entry" else one.parts:
                    self.places |= {n.name for n in place.all() if n.kind == "name"}
        self.stepping = True
        try:
            for one in kept:
                self._run(one, inside)
            result = self._run(block, inside)
            if any(self._value(one.parts[1], inside) != inside[one.parts[0].name] for one in kept):
                return False
            if result is None and function is not None and function.gives:
                given = [self._read(n, (), inside) for n in function.gives]
                result = given[0] if len(given) == 1 else self._row(given)
        except (NotFollowedError, RecursionError, ZeroDivisionError):
            return False
        finally:
            self.stepping = False
        if self.misused or not self.called or self._parameters_change(block, inside):
            return False
        sets = self._sets(block)
        calls = [one for one in block.all() if one.kind == "call" and one.name in self.judged]
        if any(self.is_another(call, sets | {*STEPS}) for call in calls):
            return False
        for places in self._located(inside):
            if self._advances(places, inside, result):
                self.advanced = tuple(places.values())
                return True
        return False

    def _parameters_change(self, block: Term, env: Mapping[str, Any]) -> bool:
        """Whether a block leaves a parameter with another value."""
        sets = self._sets(block)
        apart = {"", *self.words.state, *self.words.inputs}
        words = {root: self._meaning(root) for root in sets & env.keys()}
        return any(
            not self._fits(word, env[root], word) for root, word in words.items()
            if word not in apart and word in self.words.parameters
        )  # fmt: skip

    advanced: tuple[Place, ...] = ()
    """Where the state is that the last block advances."""

    def _located(self, env: Mapping[str, Any]) -> Iterator[dict[str, Place]]:
        """Where the entries of the state are before the block."""
        found: dict[str, Place] = {}
        missing = []
        for word in self.words.state:
            value = self.called[0].get(word)
            place = self.initial.get(value) if value is not None else None
            if place is None and value is not None:
                here = (p for p in self.initial.values() if self._now(p, env) == value)
                place = next(here, None)
            if place is None:
                missing.append(word)
            else:
                found[word] = place
        if len(missing) > 2:
            return
        begun = {place: value for value, place in self.initial.items()}
        left = [
            p for p in begun if p not in found.values() and self._now(_later(p), env) != begun[p]
        ]
        for chosen in islice(product(left, repeat=len(missing)), MOST_TRIED):
            if len({*chosen}) == len(missing):
                yield {**found, **dict(zip(missing, chosen, strict=True))}

    def _now(self, place: Place, env: Mapping[str, Any]) -> Any:
        """What stands at a place, by now."""
        root, key = place
        value = env.get(root)
        return value.entries.get(key) if isinstance(value, Table) and key else value

    def _advances(self, places: Mapping[str, Place], env: dict[str, Any], result: Any) -> bool:
        begun = {place: value for value, place in self.initial.items()}
        if not all(place in begun for place in places.values()):
            return False
        start = {word: begun[place] for word, place in places.items()}
        after: dict[str, Any] = {}
        for word, place in places.items():
            after[word] = self._now(_later(place), env)
        choices = [after]
        returned = self._dense(result)
        if returned is not None and len(returned) == len(self.words.state):
            choices += [dict(zip(order, returned, strict=True)) for order in self._orders()]
        return any(self._is_step(start, one) for one in choices)

    def _is_step(self, start: Mapping[str, Fraction], after: Mapping[str, Any]) -> bool:
        if not all(isinstance(v, Fraction) for v in after.values()):
            return False
        symbols = self.words.symbols
        rates = {symbols[w]: self._rate(w) for w in self.words.state}
        begun = {symbols[w]: rational(start[w]) for w in self.words.state}
        wanted = {symbols[w]: rational(after[w]) for w in self.words.state}
        spans = [rational(h) for h in self.scalars if h > 0 and h not in start.values()]
        for advance in INTEGRATORS.values():
            made = advance(self.words, rates, begun)
            values = [(made[s].expand() if hasattr(made[s], "expand") else made[s], wanted[s])
                      for s in made]  # fmt: skip
            if any(all(one.subs(STEP, h) == other for one, other in values) for h in spans):
                return True
        return False


def _later(place: Place) -> Place:
    """The same place, a step of time later."""
    root, key = place
    return root, tuple(k + 1 if isinstance(k, int) and k >= FAR else k for k in key)
