"""The exported step in a loop, as a controller would call it: in place, one call a step."""

import functools
import subprocess
from pathlib import Path

import numpy as np
import pytest

from benchmarks.problems import pose
from mechanics.export import write_c as write_and_prove
from mechanics.simulate.integrators import INTEGRATORS, Setting

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

LOOP = """\
#include "{name}.h"

#include <stdio.h>

int main(void)
{{
    double q[] = {{{q}}}, u[] = {{{u}}}, p[] = {{{p}}}, h[] = {{{h}}};
    {inputs}
    int status = 0;
    for (int i = 0; i < {count}; ++i)
        status |= {name}_step(q, u, {given}p, h, q, u);
    for (unsigned i = 0; i < sizeof q / sizeof *q; ++i)
        printf("%.17g %.17g ", q[i], u[i]);
    return status;
}}
"""


@pytest.mark.sample(0)
@pytest.mark.parametrize(
    ("system", "inputs"), [("elastic_pendulum", {}), ("rocker", {}), ("four_bar", {"tau": 0.3})]
)
def test_a_loop_of_steps_is_the_motion(
    modelled, compiler: str, tmp_path: Path, system: str, inputs: dict[str, float]
) -> None:
    model, count, h = modelled(system, "kane"), 200, 2.0**-10
    problem = pose(model, [0.0, count * h], inputs=inputs)
    write_c(model, tmp_path, name=system, functions=["step"])
    n = len(model.quantities.q)
    held = problem.signals(0.0)

    def written(values: np.ndarray) -> str:
        return ", ".join(float(value).hex() for value in values)

    text = LOOP.format(
        name=system, q=written(problem.start[:n]), u=written(problem.start[n:]),
        p=written(problem.p), h=h.hex(), count=count,
        inputs=f"double inputs[] = {{{written(held)}}};" if held.size else "",
        given="inputs, " if held.size else "",
    )  # fmt: skip
    (tmp_path / "loop.c").write_text(text, encoding="ascii")
    program = tmp_path / "loop"
    sources = [str(tmp_path / f"{system}.c"), str(tmp_path / "loop.c")]
    command = [compiler, "-std=c99", "-O2", "-ffp-contract=off", *sources, "-o", str(program)]
    done = subprocess.run([*command, "-lm"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    run = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert run.returncode == 0
    found = np.array(run.stdout.split(), dtype=float).reshape(-1, 2).T.ravel()
    member = next(member for member in INTEGRATORS if member.name == "C RK4")
    expected = member.prepare(problem, Setting("C RK4", step=h))().states[-1]
    assert np.allclose(found, expected, rtol=1e-11, atol=1e-11)
