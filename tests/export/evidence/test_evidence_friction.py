"""A sign in generated code: the text is its graph, and another sign is not."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from mechanics.compiled.translation_validation.build import building
from mechanics.export.evidence.binaries import third_step
from mechanics.export.evidence.chain import Evidence, Read, second_step
from mechanics.export.evidence.read import read_folder
from mechanics.export.write_c import write_c
from mechanics.kernel import Verdict

pytestmark = pytest.mark.campaign

SIGN = "(x_dot > 0.0 ? 1.0 : (x_dot < 0.0 ? -1.0 : x_dot))"
NAME = "name_forward_dynamics"


@pytest.fixture(scope="module")
def rubbing(modelled: Any, tmp_path_factory: pytest.TempPathFactory) -> Evidence:
    folder: Path = tmp_path_factory.mktemp("friction")
    model = modelled("cartpole_friction", "free_body")
    asked = ("forward_dynamics", "step")
    write_c(
        model, folder, name="name", functions=asked, batch=False, prove=False, measure=False,
        system="cartpole_friction",
    )  # fmt: skip
    return read_folder(folder).evidence


def test_text_and_binary_of_a_sign_are_shown(rubbing: Evidence, compiler: str) -> None:
    assert SIGN in rubbing.texts["name.c"]
    read: list[Read] = []
    findings = list(second_step(rubbing, read))
    assert {f.verdict for f in findings} <= {Verdict.PROVED, Verdict.CERTIFIED}
    with building(rubbing.texts, ("name.c",), (compiler,), (("-O1",),)) as libraries:
        compared = third_step(rubbing, read, libraries())
    assert compared.findings
    assert {f.verdict for f in compared.findings} == {Verdict.SUPPORTED}


WRONG = {
    "the other way": "(x_dot > 0.0 ? -1.0 : (x_dot < 0.0 ? 1.0 : x_dot))",
    "one way": "(x_dot > 0.0 ? 1.0 : (x_dot < 0.0 ? 1.0 : x_dot))",
    "half": "(x_dot > 0.0 ? 1.0 : (x_dot < 0.0 ? -0.5 : x_dot))",
    "of another": SIGN.replace("x_dot", "theta_dot"),
    "of a shifted": SIGN.replace("x_dot >", "x_dot + 1.0 >"),
}


@pytest.mark.parametrize("attack", WRONG)
def test_another_sign_is_not(rubbing: Evidence, attack: str) -> None:
    text = rubbing.texts["name.c"].replace(SIGN, WRONG[attack])
    assert text != rubbing.texts["name.c"]
    kernels = tuple(k for k in rubbing.kernels if k.symbol == NAME)
    changed = replace(rubbing, kernels=kernels, texts=rubbing.texts | {"name.c": text})
    verdicts = {f.verdict for f in second_step(changed, []) if NAME in f.subject}
    assert verdicts & {Verdict.REFUTED, Verdict.UNDECIDED}
