"""Workers within limits: values, errors in one line, and no end without an outcome."""

import os
import time

import pytest

from mechanics.errors import InputError
from mechanics.worker import Failed, Limits, Stopped, outcomes


def behave(how: str) -> object:
    if how == "loop":
        while True:
            pass
    if how == "swallow":
        while True:
            try:
                while True:
                    pass
            except Exception:
                continue
    if how == "sleep":
        time.sleep(3600)
    if how == "eat":
        return len(bytearray(10**10))
    if how == "die":
        os._exit(7)
    if how == "refuse":
        raise InputError("no")
    if how == "nest":
        return behave(how)
    return how.upper()


def test_values_errors_and_stops() -> None:
    asked = ["a", "loop", "eat", "die", "refuse", "b", "nest"]
    found = dict(outcomes(behave, asked, Limits(seconds=0.3), jobs=2))
    assert found[0] == "A"
    assert found[5] == "B"
    assert found[4] == Failed("no")
    assert found[1] == Stopped("it took more than 0.3 s")
    assert found[2] == Stopped("it took more than 500 MB")
    assert found[3] == Stopped("its process ended with code 7")
    assert found[6] == Stopped("it is nested too deeply")


@pytest.mark.parametrize("how", ["sleep", "swallow"])
def test_one_that_waits_or_ignores_its_signal_is_stopped(how: str) -> None:
    (found,) = outcomes(behave, [how], Limits(seconds=0.1))
    assert isinstance(found[1], Stopped)


def test_what_is_not_asked_for_leaves_no_process() -> None:
    found = outcomes(behave, ["a", "loop"], Limits(seconds=60), jobs=2)
    assert next(found)[1] == "A"
    found.close()
