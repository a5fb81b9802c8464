"""A parameter of C without a name: nothing can say what it is."""

import pytest

from mechanics import check
from mechanics.errors import InputError
from systems import rod_pendulum


def test_a_parameter_without_a_name_is_refused() -> None:
    code = "double acc(double, double u, double m, double l, double g) { return 3*u/(m*l*l); }"
    with pytest.raises(InputError, match="a parameter of acc has no name"):
        check(rod_pendulum.scene(), code, notation="c", blame=False)
