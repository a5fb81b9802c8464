"""The server for agents, driven over stdio by the client of the `mcp` package."""

import asyncio
import json
import sys
from pathlib import Path
from typing import Any

import pytest

from mechanics.cli.load import built_in
from mechanics.cli.mcp_server import server
from mechanics.cli.tools import Tools
from mechanics.cli.worker import Worker, answer
from mechanics.errors import InputError
from mechanics.scene.json.schema import schema
from mechanics.scene.json.write import to_json
from systems import rod_pendulum

mcp = pytest.importorskip("mcp")
START = "import sys; sys.argv = ['mechanics', 'serve-mcp']; from mechanics.cli import main; main()"
RIGHT = r"\frac{m l^2}{3}\ddot\theta = \frac{m g l}{2}\sin\theta + u"
WRONG = r"\frac{m l^2}{12}\ddot\theta = \frac{m g l}{2}\sin\theta + u"


async def talk(server: Any) -> tuple[Any, ...]:
    """What an agent would ask."""
    async with mcp.Client(server) as client:
        tools = await client.list_tools()
        layout = await client.read_resource("mechanics://scene.schema.json")
        scene = (await client.call_tool("example", {"system": "rod_pendulum"})).content[0].text
        derived = await client.call_tool("derive", {"scene": json.loads(scene)})
        key = json.loads(derived.content[0].text)["scene"]
        statements = {"scene": key, "statements": [RIGHT, WRONG], "blame": True}
        checked = await client.call_tool("check", statements)
        python = {"scene": key, "statements": ["import os\nos.abort()"]}
        hostile = await client.call_tool("check", python)
        alive = await client.call_tool("check", {"scene": key, "statements": [RIGHT]})
    return tools, layout, derived, checked, hostile, alive


def assert_answers(
    tools: Any, layout: Any, derived: Any, checked: Any, hostile: Any, alive: Any
) -> None:
    """What it is told."""
    names = {tool.name for tool in tools.tools}
    assert names == {"example", "derive", "check", "crosscheck", "compare", "codegen", "verify"}
    assert json.loads(layout.contents[0].text) == schema()
    assert "theta_ddot" in json.loads(derived.content[0].text)["equations"]
    first, second = json.loads(checked.content[0].text)["statements"]
    assert first["verdict"] in ("PROVED", "CERTIFIED")
    assert second["verdict"] == "REFUTED"
    assert second["blame"]["repairs"]
    assert hostile.is_error
    assert "reading it would run it" in hostile.content[0].text
    assert json.loads(alive.content[0].text)["ok"]


def test_tools_are_told_without_a_worker() -> None:
    async def listed() -> dict[str, Any]:
        async with mcp.Client(server(Worker())) as client:
            return {tool.name: tool.input_schema for tool in (await client.list_tools()).tools}

    found = asyncio.run(listed())
    assert len(found) == 7
    assert set(found["derive"]["properties"]) == {"scene", "route", "form"}
    assert found["derive"]["required"] == ["scene"]


def endless() -> dict[str, Any]:
    """A scene whose equations nobody can wait for."""
    scene = Tools().example("rod_pendulum")
    tree: Any = "theta"
    for _ in range(13):
        tree = ["add", ["multiply", tree, tree], ["sin", tree]]
    scene["bodies"][0]["mass"] = ["exp", tree]
    return scene


@pytest.mark.campaign
@pytest.mark.skipif(sys.platform == "win32", reason="limits are those of POSIX")
def test_a_call_that_passes_its_limit_is_not_judged_and_the_next_one_is_answered() -> None:
    worker = Worker(seconds=2)
    try:
        with pytest.raises(InputError, match="derive: not judged: it took more than 2 s") as error:
            worker.call("derive", {"scene": endless()})
        assert "\n" not in str(error.value)
        assert "theta_ddot" in worker.call("derive", {"scene": "rod_pendulum"})["equations"]
        with pytest.raises(InputError, match="not known: the systems are"):
            worker.call("derive", {"scene": "nothing"})
    finally:
        worker.stop()


def test_too_much_memory_is_one_line() -> None:
    class Failing(Tools):
        def example(self, system: str = "") -> dict[str, Any]:
            raise {"memory": MemoryError, "deep": RecursionError}[system]

    told = {
        name: answer(Failing(), {"tool": "example", "arguments": {"system": name}})["refused"]
        for name in ("memory", "deep")
    }
    assert told["memory"].startswith("example: not judged")
    assert told["deep"] == "nested too deeply"
    assert "\n" not in "".join(told.values())


@pytest.mark.campaign
def test_an_agent_derives_and_checks_over_stdio(tmp_path: Path) -> None:
    root = str(Path(__file__).parents[2])
    start = mcp.StdioServerParameters(
        command=sys.executable, args=["-c", START], cwd=tmp_path, env={"PYTHONPATH": root}
    )
    assert_answers(*asyncio.run(talk(start)))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda t: t.check("rod_pendulum", ["a = b"] * 101), "101 found, at most 100"),
        (lambda t: t.check("rod_pendulum", ["x" * 20_001]), "20001 characters"),
        (lambda t: t.check("rod_pendulum", ["/etc/passwd.txt"]), "file"),
        (lambda t: t.derive("scene-0123456789abcdef"), "send the scene itself"),
        (lambda t: t.derive("/etc/my_system.py"), "is not known"),
        (lambda t: t.derive('{"format": 1}'), "expected"),
        (lambda t: t.verify("rod_pendulum", {"../x": ""}), "is no name of a file"),
        (lambda t: t.verify("rod_pendulum", {"a.c": "x" * (1 << 23) + "x"}), "are read"),
    ],
    ids=range(8),
)
def test_refusals_are_one_line(call: Any, words: str) -> None:
    with pytest.raises(InputError, match=words) as error:
        call(Tools())
    assert "\n" not in str(error.value)


@pytest.mark.campaign
def test_what_is_generated_is_verified_and_a_change_is_noticed() -> None:
    tools = Tools()
    scene = tools.example("rod_pendulum")
    assert tools.crosscheck(scene)["systems"][0]["ok"]
    made = tools.codegen(scene, outputs=["forward_dynamics"])
    files = made["files"]
    assert tools.verify(made["scene"], files)["outcome"] == "SHOWN"
    (name,) = (name for name in files if name.endswith(".c") and "test" not in name)
    changed = {**files, name: files[name].replace("sin(", "cos(")}
    assert changed != files
    assert tools.verify(made["scene"], changed)["outcome"] != "SHOWN"


def test_the_scene_of_another_person_is_the_one_that_ships() -> None:
    tools = Tools()
    assert (
        tools.derive(tools.example("rod_pendulum"))["equations"]
        == (tools.derive("rod_pendulum")["equations"])
    )
    assert rod_pendulum.scene().name in tools.derive("rod_pendulum")["equations"]


@pytest.mark.campaign
def test_a_crosscheck_judges_what_is_published_for_a_system() -> None:
    """By its name, and as JSON in which a published equation was changed."""
    tools, system = Tools(), built_in("rod_pendulum")
    (own,) = tools.crosscheck("rod_pendulum")["systems"]
    assert own["ok"]
    assert [row["tag"] for row in own["published"]] == [row.tag for row in system.published]
    wrong = to_json(system)
    wrong["published"][0]["sides"][1] = ["negate", wrong["published"][0]["sides"][1]]
    (changed,) = tools.crosscheck(wrong)["systems"]
    assert not changed["ok"]
    assert "REFUTED" in [row["verdict"] for row in changed["published"]]
