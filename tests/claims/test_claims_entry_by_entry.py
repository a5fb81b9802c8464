"""What NumPy and MATLAB do entry by entry is no product of matrices; a, b = c, d is no b = c."""

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import two_mass_chain

CHAIN = derived(two_mass_chain.unequal())
MASSES = "M = [m1 0; 0 m2]\n"
FORCES = "[(k1 + k2)*x1 - k2*x2; k2*x2 - k2*x1]"


def verdicts(text: str) -> list[str]:
    found = mechanics.check(CHAIN, text, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    "text",
    [
        f"{MASSES}M*[x1dd; x2dd] + {FORCES} = 0",
        f"{MASSES}[x1dd; x2dd] + M^-1*{FORCES} = 0",
        f"{MASSES}[x1dd; x2dd] + 1/M*{FORCES} = 0",
        "m1.*x1dd + (k1 + k2).*x1 - k2.*x2 = 0",
        "x1dd + 1./m1.*((k1 + k2).*x1 - k2.*x2) = 0",
        "x1dd + m1.^-1.*((k1 + k2).*x1 - k2.*x2) = 0",
    ],
)
def test_products_of_matrices_and_of_numbers_are_read(text: str) -> None:
    assert set(verdicts(text)) == {"PROVED"}


@pytest.mark.parametrize(
    "text",
    [
        f"{MASSES}M.*[x1dd; x2dd] + {FORCES} = 0",
        f"{MASSES}[x1dd; x2dd] + M.^-1*{FORCES} = 0",
        f"{MASSES}[x1dd; x2dd] + 1./M*{FORCES} = 0",
        f"{MASSES}[x1dd; x2dd] + 2*1./M*{FORCES}/2 = 0",
        "np.array([[m1, 0], [0, m2]])*np.array([[x1dd], [x2dd]])"
        " + np.array([[(k1 + k2)*x1 - k2*x2], [k2*x2 - k2*x1]]) = 0",
    ],
)
def test_matrices_entry_by_entry_are_refused(text: str) -> None:
    with pytest.raises(InputError, match=r"text, line \d, column \d+: entry by entry"):
        verdicts(text)


def test_several_names_set_at_once_are_no_chain() -> None:
    """The comma between was an end, so that a right line was wrong: x2dd = the first of them."""
    both = ("((-k1 - k2)*x1 + k2*x2)/m1", "(k2*x1 - k2*x2)/m2")
    assert verdicts(f"x1dd, x2dd = {both[0]}, {both[1]}") == ["PROVED", "PROVED"]
    assert verdicts(f"x1dd, x2dd = {both[1]}, {both[0]}") == ["REFUTED", "REFUTED"]
    assert verdicts(f"x1dd = {both[0]}, x2dd = {both[1]}") == ["PROVED", "PROVED"]
    assert verdicts(f"x1dd - {both[0]}, x2dd - {both[1]}") == ["PROVED", "PROVED"]
