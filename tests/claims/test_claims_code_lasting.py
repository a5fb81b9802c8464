"""What a call changes beyond itself is found; code that only stores its results is proved."""

import itertools
import time
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from random import random

import numpy as np
import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()
NUMBER, SEEN, TICKS = 0, [], itertools.count()  # type: ignore[var-annotated]


def law(y, u, m, l, g, k=1.0):  # type: ignore[no-untyped-def]
    return [y[1], 3 * g / (2 * l) * np.sin(y[0]) * k + 3 * u / (m * l**2)]


def later(n: int) -> float:
    """A factor that is wrong after many calls only."""
    return 1.0 if n < 100_000 else 2.0


class Rod:
    calls = 0

    def __init__(self) -> None:
        self.m, self.l, self.g = 1.0, 2.0, 9.81
        self.number, self.rate = 0, 0.0
        self.last: list | None = None

    def counts(self, y, u):  # type: ignore[no-untyped-def]
        self.number += 1
        return law(y, u, self.m, self.l, self.g, later(self.number))

    def wears(self, y, u):  # type: ignore[no-untyped-def]
        found = law(y, u, self.m, self.l, self.g)
        self.m *= 0.99
        return found

    def keeps(self, y, u):  # type: ignore[no-untyped-def]
        if self.last is not None and y[0] > 100:
            return self.last
        self.last = law(y, u, self.m, self.l, self.g)
        return self.last

    def of_class(self, y, u):  # type: ignore[no-untyped-def]
        Rod.calls += 1
        return law(y, u, self.m, self.l, self.g, later(Rod.calls))

    def of_its_type(self, y, u):  # type: ignore[no-untyped-def]
        type(self).calls += 1
        return law(y, u, self.m, self.l, self.g, later(type(self).calls))

    @property
    def inertia(self):  # type: ignore[no-untyped-def]
        return self.m * self.l**2 / 3

    def _moment(self, angle):  # type: ignore[no-untyped-def]
        return self.m * self.g * self.l / 2 * np.sin(angle)

    def stores(self, y, u):  # type: ignore[no-untyped-def]
        rates = np.zeros(2)
        self.number += 1
        self.rate = (self._moment(y[0]) + u) / self.inertia
        rates[:] = y[1], self.rate
        return rates


class Slots:
    __slots__ = ("g", "l", "m", "number")

    def __init__(self) -> None:
        self.m, self.l, self.g, self.number = 1.0, 2.0, 9.81, 0

    def counts(self, y, u, m, l, g):  # type: ignore[no-untyped-def]
        self.number += 1
        return law(y, u, m, l, g, later(self.number))


CYCLE, BYTES = itertools.cycle([1.0] * 100_000 + [2.0]), bytearray(1)


def goes_round(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u, m, l, g, next(CYCLE))


def counts_in_bytes(y, u, m, l, g):  # type: ignore[no-untyped-def]
    BYTES[0] = min(BYTES[0] + 1, 255)
    return law(y, u, m, l, g, 1.0 if BYTES[0] < 250 else 2.0)


def changes_the_caller(y, u, p):  # type: ignore[no-untyped-def]
    p["l"] *= 2
    return law(y, u, p["m"], p["l"] / 2, p["g"])


def turns_the_caller(y, u, m, l, g):  # type: ignore[no-untyped-def]
    y[0] += 2 * np.pi
    return law(y, u, m, l, g)


def counts_in_the_file(y, u, m, l, g):  # type: ignore[no-untyped-def]
    global NUMBER
    NUMBER += 1
    return law(y, u, m, l, g, later(NUMBER))


def counts_in_a_list(y, u, m, l, g):  # type: ignore[no-untyped-def]
    SEEN.append(1)
    return law(y, u, m, l, g, later(len(SEEN)))


def ticks(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u, m, l, g, later(next(TICKS)))


def around() -> Callable:
    number = 0

    def counts(y, u, m, l, g):  # type: ignore[no-untyped-def]
        nonlocal number
        number += 1
        return law(y, u, m, l, g, later(number))

    return counts


LASTING = [
    changes_the_caller, turns_the_caller, counts_in_the_file, counts_in_a_list, ticks, around(),
    Rod().counts, Rod().wears, Rod().keeps, Rod().of_class,
    Rod().of_its_type, Slots().counts, goes_round, counts_in_bytes,
]  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize("function", LASTING)
def test_what_outlives_a_call_is_doubted(function: Callable) -> None:
    found = check(SCENE, function)
    assert {judged.finding.verdict for judged in found.judged} == {Verdict.UNDECIDED}
    assert "a call changes" in found.judged[0].finding.evidence


def test_what_is_written_before_it_is_read_is_proved() -> None:
    rod = Rod()
    found = check(SCENE, rod.stores)
    assert found.verdict is Verdict.PROVED
    assert (rod.number, rod.m) == (0, 1.0)


def by_chance(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u + 1e-12 * random(), m, l, g)


def by_numpy(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u + 1e-12 * np.random.randn(), m, l, g)


def by_the_clock(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u, m, l, g, later(time.time() - 4e9))  # type: ignore[arg-type]


def by_an_import(y, u, m, l, g):  # type: ignore[no-untyped-def]
    from random import random as chance

    return law(y, u + 1e-12 * chance(), m, l, g)


def by_a_hash(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u + 1e-12 * (hash("x") % 2), m, l, g)


def by_an_address(y, u, m, l, g):  # type: ignore[no-untyped-def]
    return law(y, u + 1e-30 * id(law), m, l, g)


REFUSED = [by_chance, by_numpy, by_the_clock, by_an_import, by_a_hash, by_an_address]


@pytest.mark.parametrize("function", REFUSED)
def test_chance_and_the_clock_are_refused(function: Callable) -> None:
    line = function.__code__.co_firstlineno + (3 if function is by_an_import else 1)
    words = f"^function {function.__name__}, in line {line}: it calls .* more than its arguments"
    with pytest.raises(InputError, match=words):
        check(SCENE, function)


HIDDEN = [
    "str(u) == '0.0'", "repr((u, m))[0] == '9'", "f'{u}' == '0.5'", "'%s' % u == '0.5'",
    "u.__str__() == '0.5'", "str(np.array([u])) == '[0.5]'", "getattr(u, 'hex', str)() == '0'",
    "json.dumps(u) == '0.5'", "len(inspect.stack()) > 3", "'mechanics' in sys.modules",
    "sys.argv[0] == 'x'", "__name__ == 'x'", "ValueError().__traceback__.tb_frame is None",
    "kept(u) == '0.5'",
]  # fmt: skip
HELD = """
import inspect, io, json, sys
import numpy as np
def kept(x):
    words = io.StringIO()
    print(x, file=words)
    return words.getvalue()
def f(y, u, m, l, g):
    print(u)
    sign = -1 if {} else 1
    return law(y, sign * u, m, l, g)
"""


@pytest.mark.parametrize("condition", HIDDEN)
def test_text_of_numbers_and_the_caller_are_refused(condition) -> None:
    names = {"law": law, "__name__": "mine"}
    exec(HELD.format(condition), names)
    with pytest.raises(InputError, match=r"^function f.*(hid|depends on|which class)"):
        check(SCENE, names["f"])


@pytest.mark.parametrize(
    ("lines", "read"),
    [
        ("try:\n  1/u\nexcept ZeroDivisionError:\n  u = 1", False),
        ("try:\n  1/u\nexcept (KeyError, Exception):\n  u = 1", False),
        ("try:\n  1/u\nexcept:\n  u = 1", False),
        ("try:\n  1/u\nfinally:\n  return law(y, 0, m, l, g)", False),
        ("with suppress(ZeroDivisionError):\n  1/u", False),
        ("with Quiet():\n  1/u", False),
        ("try:\n  k = {}['k']\nexcept KeyError:\n  k = 1", True),
        ("try:\n  k = 1\nfinally:\n  k = 2", True),
        ("with np.errstate(all='ignore'):\n  k = 1", True),
    ],
)
def test_what_numbers_raise_is_not_caught_unseen(lines: str, read: bool) -> None:
    body = "".join(f"    {line}\n" for line in lines.splitlines())
    text = f"def f(y, u, m, l, g):\n{body}    return law(y, u, m, l, g)"
    names = {"law": law, "np": np, "suppress": suppress, "Quiet": Quiet, "__name__": "mine"}
    exec(text, names)
    if read:
        assert check(SCENE, names["f"], blame=False).verdict is Verdict.PROVED
        return
    with pytest.raises(InputError, match="catches"):
        check(SCENE, names["f"])


class Quiet:
    def __enter__(self) -> None:
        pass

    def __exit__(self, *_: object) -> bool:
        return True


def test_a_result_that_is_kept_and_changed_is_refused() -> None:
    @lru_cache
    def made(k: int) -> list[int]:
        return []

    def counts(y, u, m, l, g):  # type: ignore[no-untyped-def]
        made(0).append(1)
        return law(y, u, m, l, g, later(len(made(0))))

    with pytest.raises(InputError, match="keeps a result"):
        check(SCENE, counts)


def test_conditions_decide_wherever_they_are_looked_at() -> None:
    def found(condition: str):  # type: ignore[no-untyped-def]
        names = {"law": law, "__name__": "mine"}
        exec(HELD.format(condition), names)
        return check(SCENE, names["f"]).verdict.name

    for condition in ("str(u > 9) == 'True'", "{True: 1}.get(u > 9)", "u.real > 9"):
        assert found(condition) == "REFUTED"
    assert found("u.imag > 9") == "PROVED"


class Noisy:
    def __init__(self) -> None:
        self.chance = {"uniform": random, "normal": np.random.randn}

    def uniform(self, y, u, m, l, g):  # type: ignore[no-untyped-def]
        return law(y, u + 1e-12 * self.chance["uniform"](), m, l, g)

    def normal(self, y, u, m, l, g):  # type: ignore[no-untyped-def]
        return law(y, u + 1e-12 * self.chance["normal"](), m, l, g)


@pytest.mark.parametrize("function", [Noisy().uniform, Noisy().normal])
def test_chance_that_is_hidden_in_an_object_is_seen(function: Callable) -> None:
    found = check(SCENE, function)
    assert {judged.finding.verdict for judged in found.judged} == {Verdict.UNDECIDED}
    assert "a call changes random numbers" in found.judged[0].finding.evidence


def test_an_import_inside_and_defaults_of_entries() -> None:
    def rates(y, u, p):  # type: ignore[no-untyped-def]
        import math

        m, l = p.get("m", 1.0), p.get("l", 2.0)
        return [y[1], 3 * p["g"] / (2 * l) * math.sin(y[0]) + 3 * u / (m * l**2)]

    assert check(SCENE, rates).verdict is Verdict.PROVED


def test_a_change_in_place_by_a_parameter_is_a_change_of_the_argument() -> None:
    """NumPy fills the array itself, whatever stands behind *=."""

    def scaled(y, u, m, l, g):  # type: ignore[no-untyped-def]
        found = law(y, u, m, l, g)
        part = y[:1]
        part *= m
        return found

    calls = np.zeros(1)

    def counting(y, u, m, l, g, n=calls):  # type: ignore[no-untyped-def]
        n += m
        return law(y, u, m, l, g)

    def own(y, u, m, l, g):  # type: ignore[no-untyped-def]
        part = y.copy()
        part *= m
        return [y[1], 3 * g / (2 * l) * np.sin(part[0] / m) + 3 * u / (m * l**2)]

    (first, *_) = check(SCENE, scaled, blame=False).judged
    assert "a call changes its argument y" in first.finding.evidence
    with pytest.raises(InputError, match="a traced number has no value"):
        check(SCENE, counting, blame=False)
    assert check(SCENE, own, blame=False).verdict is Verdict.PROVED
