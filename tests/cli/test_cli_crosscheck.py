"""`mechanics crosscheck`: exit codes and JSON, with a person's own file."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

SCHEMA: dict[str, Any] = {
    "name": str,
    "ok": bool,
    "routes": {"seconds": float, "operations": int, "form": str, "forward_dynamics": int,
               "absent": str},
    "findings": {"subject": str, "verdict": str, "evidence": str, "error_bound": float,
                 "witness": dict},
    "published": {"tag": str, "label": str, "verdict": str, "evidence": str},
    "witnesses": {"subject": str, "verdict": str, "evidence": str},
    "compiled": {"subject": str, "max_eps": float, "states": int},
}  # fmt: skip
VERDICTS = {"PROVED", "CERTIFIED", "SUPPORTED", "REFUTED", "UNDECIDED"}


def test_all_shown_is_exit_code_zero_and_the_json_has_its_schema(run: Any, pendulum: Any) -> None:
    ran = run("crosscheck", pendulum(), "--json", "-", "--states", 50)
    assert ran.code == 0, ran.err
    (system,) = json.loads(ran.out)["systems"]
    assert set(system) == set(SCHEMA)
    assert system["name"] == "my_pendulum"
    assert system["ok"] is True
    routes = {"free_body", "moving_point", "kane", "lagrange"}
    assert set(system["routes"]) == routes | {"kane_sympy", "lagrange_sympy"}
    for key in ("findings", "witnesses", "published", "compiled"):
        assert system[key]
        for entry in system[key]:
            for name, kind in SCHEMA[key].items():
                assert entry[name] is None or isinstance(entry[name], kind), (key, name, entry)
    for route in system["routes"].values():
        assert {name: type(value) for name, value in route.items()} == SCHEMA["routes"]
    verdicts = {entry["verdict"] for key in ("findings", "published") for entry in system[key]}
    assert verdicts <= VERDICTS
    assert {entry["verdict"] for entry in system["witnesses"]} == {"SUPPORTED"}


@pytest.mark.campaign
def test_a_wrong_row_is_exit_code_one_with_a_witness(run: Any, pendulum: Any) -> None:
    wrong = pendulum(("+ g * sin(theta)", "- g * sin(theta)"))
    ran = run("crosscheck", wrong, "--states", 0)
    assert ran.code == 1
    assert "REFUTED" in ran.out
    assert "theta = " in ran.out
    ran = run("crosscheck", wrong, "--states", 0, "--json", "-")
    assert ran.code == 1
    (row,) = json.loads(ran.out)["systems"][0]["published"]
    assert row["verdict"] == "REFUTED"
    assert set(row["witness"]) == {"state", "solved", "left", "right"}
    assert "theta" in row["witness"]["state"]


def test_what_is_undecided_is_exit_code_three(run: Any, pendulum: Any) -> None:
    # log(m l) = log m + log l is true, but the field knows a logarithm by congruence only.
    doubt = pendulum(
        ("import sin", "import log, sin"),
        ("+ g * sin(theta), 0", "+ g * sin(theta) + log(m * l) - log(m) - log(l), 0"),
    )
    ran = run("crosscheck", doubt, "--states", 0)
    assert ran.code == 3, ran.out
    assert "UNDECIDED" in ran.out
    # The verdict comes last.
    assert re.fullmatch(r"1 of \d+ checks did not pass\.", ran.out.splitlines()[-1])


@pytest.mark.campaign
def test_json_and_report_go_to_files(run: Any, pendulum: Any, tmp_path: Any) -> None:
    page, data = tmp_path / "report.html", tmp_path / "result.json"
    ran = run("crosscheck", pendulum(), "--states", 0, "--report", page, "--json", data)
    assert ran.code == 0
    assert "simple pendulum" in page.read_text(encoding="utf-8")
    assert json.loads(data.read_text(encoding="utf-8"))["systems"][0]["ok"] is True
    assert "published rows" in ran.out


def test_chosen_routes_only(run: Any, pendulum: Any) -> None:
    ran = run("crosscheck", pendulum(), "--routes", "kane,lagrange", "--states", 0, "--json", "-")
    assert ran.code == 0
    columns = ["kane", "kane_sympy", "lagrange", "lagrange_sympy"]
    assert list(json.loads(ran.out)["systems"][0]["routes"]) == columns


@pytest.mark.campaign
def test_equations_stand_above_the_verdict_and_timings_behind_an_option(
    run: Any, pendulum: Any
) -> None:
    asked = ("crosscheck", pendulum(), "--routes", "lagrange", "--states", 0)
    short, long = run(*asked), run(*asked, "-v")
    lines = [line.rstrip() for line in short.out.splitlines() if line.strip()]
    assert re.search(r"^  .*_ddot.* = ", lines[1])
    assert re.fullmatch(r"All \d+ checks passed\.", lines[-1])
    assert "seconds" not in short.out
    assert "seconds" in long.out


@pytest.mark.campaign
def test_systems_lists_every_system(run: Any) -> None:
    from systems import ALL

    ran = run("systems")
    assert ran.code == 0
    assert all(system.name in ran.out for system in ALL)


@pytest.mark.campaign
def test_residuals_of_a_scene_with_constraints_are_measured_on_them(run: Any) -> None:
    """Off the constraints the published power balance of the four-bar linkage does not hold."""
    ran = run(
        "crosscheck", "four_bar", "--routes", "kane,free_body", "--states", 200, "--json", "-"
    )
    assert ran.code == 0, ran.err
    rows = json.loads(ran.out)["systems"][0]["compiled"]
    assert {row["subject"].split(":")[0] for row in rows} == {"kane", "free_body"}
    assert len(rows) == 4 and all(row["states"] == 200 for row in rows)
    assert all(0 < row["max_eps"] < 1e6 for row in rows)


@pytest.mark.campaign
def test_a_cross_check_prints_the_cause_below_what_is_refuted(tmp_path: Path, run: Any) -> None:
    path = tmp_path / "slider.py"
    path.write_text(
        "import sympy.physics.mechanics as me\n"
        "from sympy import symbols\n"
        "def make_model():\n"
        "    (q, u), m, N = me.dynamicsymbols('q u'), symbols('m'), me.ReferenceFrame('N')\n"
        "    O, P, H = me.Point('O'), me.Point('P'), me.Point('H')\n"
        "    P.set_pos(O, q * N.x), H.set_pos(P, 0)\n"
        "    O.set_vel(N, 0), P.set_vel(N, q.diff() * N.x), H.set_vel(N, u * N.x)\n"
        "    mass = me.Particle('mass', P, m)\n"
        "    loads = [(P, -q * N.x), (H, m * N.x)]\n"
        "    return me.LagrangesMethod(me.Lagrangian(N, mass), [q], loads, [mass], N)\n"
    )
    ran = run("crosscheck", f"{path}:make_model")
    said = " ".join(ran.out.split())
    assert ran.code == 1
    assert said.index("REFUTED SymPy's LagrangesMethod") < said.index(
        "PROVED the cause: LagrangesMethod drops the load load2_mass"
    )
