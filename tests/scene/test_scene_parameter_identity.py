"""Parameters of the same name in two scenes stay apart, also in SymPy's caches."""

import pickle

from sympy import Symbol, cos

from mechanics.scene import parameters


def test_the_cache_of_sympy_does_not_exchange_parameters() -> None:
    (first,) = parameters("l1", units="m", typical="0.1", meanings=("length of the crank",))
    (second,) = parameters("l1", units="m", typical="1", meanings=("length of link 2",))
    angle = Symbol("q1", real=True)
    products = [length * cos(angle) for length in (first, second)]
    found = [next(iter(p.free_symbols - {angle})) for p in products]
    assert [p.typical for p in found] == [first.typical, second.typical]


def test_a_parameter_declared_twice_alike_is_one() -> None:
    (first,), (second,) = (parameters("m", units="kg", typical="2") for _ in range(2))
    assert first == second
    assert hash(first) == hash(second)
    assert first - second == 0


def test_a_parameter_survives_pickling() -> None:
    (mass,) = parameters("m", units="kg", typical="2", meanings=("mass",))
    copy = pickle.loads(pickle.dumps(mass))
    assert copy == mass
    assert copy.typical == mass.typical
