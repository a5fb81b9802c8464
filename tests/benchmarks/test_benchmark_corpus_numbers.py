"""The numbers that decide: each right statement of the corpus holds, each wrong one fails."""

import pytest

from benchmarks.corpus.load import HERE, Case, cases
from benchmarks.corpus.numbers import Truth, holds, table

CASES = list(cases())
ROWS = table("decide.toml")
QUICK = (
    "taylor_pendulum/energy", "taylor_pendulum/energy_constant", "taylor_hoop/hamiltonian_sign",
    "landau_kapitza/lagrangian_sine", "studentroom_wire/motion", "atwood_pulley/power",
)  # fmt: skip


def _rows(case: Case) -> list[str]:
    source, _, name = case.name.partition("/")
    return ROWS[source][name]


def _place(case: Case) -> str:
    shipped = not case.scene.is_relative_to(HERE) or not case.scene.exists()
    return case.scene.name if shipped else f"{case.scene.name}:{case.function}"


def test_each_statement_has_its_numbers() -> None:
    truths = table("truths.toml")
    assert {f"{source}/{name}" for source, rows in ROWS.items() for name in rows} == {
        case.name for case in CASES
    }
    assert {_place(case) for case in CASES} == set(truths)


def test_the_motion_is_that_of_a_pendulum() -> None:
    of = Truth({"q": "theta", "T": "m*l**2*theta_d**2/2", "V": "-m*g*l*cos(theta)"})
    assert str(of.motion[0]) == "g*l*m*sin(theta) + l**2*m*theta_dd"


@pytest.mark.parametrize("name", QUICK)
def test_numbers_agree(name: str) -> None:
    (case,) = (case for case in CASES if case.name == name)
    assert holds(_place(case), _rows(case)) is case.right


@pytest.mark.campaign
@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_all_numbers_agree(case: Case) -> None:
    assert holds(_place(case), _rows(case)) is case.right


def test_at_least_two_in_five_are_wrong() -> None:
    assert sum(not case.right for case in CASES) >= 0.4 * len(CASES)
