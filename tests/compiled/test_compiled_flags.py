"""Compiler settings belong to the model: reported, part of what is cached, without side effects."""

import numpy as np
import pytest

from mechanics.compiled import compile as compile_model
from mechanics.compiled.machine.evaluator import FLAGS
from mechanics.errors import CompilerError


@pytest.mark.parametrize("flags", FLAGS)
def test_settings_are_reported_and_keep_accuracy(compiler, derived, modelled, flags: str) -> None:
    plain = modelled("elastic_pendulum", "kane")
    model = compile_model(derived("elastic_pendulum", "kane"), flags=flags)
    assert flags in model.backend
    random = np.random.default_rng(3)
    q, u = random.uniform(-2, 2, (2, 100, 2))
    found, expected = (m.forward_dynamics(q, u) for m in (model, plain))
    if "-ffast-math" in flags:
        assert np.allclose(found, expected, rtol=1e-12, atol=1e-12)
    else:
        # Every operation is rounded as it is written, whatever the level.
        assert np.array_equal(found, expected)


def test_fast_math_leaves_subnormal_numbers_to_others(compiler, derived) -> None:
    model = compile_model(derived("two_mass_chain", "kane"), flags=FLAGS[-1])
    model.forward_dynamics([1.0, 0.0], [0.0, 0.0])
    assert np.float64(2.0**-1022) / np.float64(4.0) == 2.0**-1024


def test_settings_that_the_compiler_refuses_are_told(compiler, derived) -> None:
    model = compile_model(derived("two_mass_chain", "kane"), flags="-Ono-such-level")
    with pytest.raises(CompilerError, match="refused the generated code"):
        model.forward_dynamics([1.0, 0.0], [0.0, 0.0])
