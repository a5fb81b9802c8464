"""`mechanics serve-mcp`: the tools of `mechanics.cli.tools`, by the Model Context Protocol."""

from collections.abc import Callable
from functools import wraps
from importlib import import_module
from typing import Annotated, Any

import typer

from mechanics.cli.tools import Tools
from mechanics.cli.worker import GIGABYTES, SECONDS, Worker
from mechanics.errors import InputError
from mechanics.scene.json.schema import schema

TOOLS = ("example", "derive", "check", "crosscheck", "compare", "codegen", "verify")
SCHEMA = "mechanics://scene.schema.json"
INSTRUCTIONS = (
    "Equations of motion, derived by four routes and proved. A scene is an object as the resource"
    f" {SCHEMA} says (`example` gives one), the name of a built-in system, or the id of a scene"
    " that was sent before, which answers fastest. Statements are LaTeX, text or C; nothing is run."
)


def serve_mcp(
    seconds: Annotated[
        int, typer.Option(min=1, help="Processor time of a call; beyond it there is no verdict.")
    ] = SECONDS,
    memory: Annotated[
        float, typer.Option(min=0.5, metavar="GB", help="Memory of a call.")
    ] = GIGABYTES,
) -> None:
    """Serve derive, check, crosscheck, compare, codegen and verify to agents, over stdio.

    `mechanics serve-mcp`

    `mechanics serve-mcp --seconds 20 --memory 2`

    No code of the caller is run: scenes are JSON (docs/scene.schema.json); statements are LaTeX,
    text or C, which are only read. A separate process answers the calls; a call that passes a limit
    is stopped and gets no verdict. Install it with the extra `mcp`.
    """
    worker = Worker(seconds, memory)
    made = server(worker)
    worker.start()
    try:
        made.run("stdio")
    finally:
        worker.stop()


def server(worker: Worker) -> Any:
    """The server with its tools.

    Raises
    ------
    InputError
        Where the package is missing.
    """
    try:
        mcp = import_module("mcp.server")
        refused = import_module("mcp.server.mcpserver.exceptions").ToolError
    except ImportError:
        raise InputError("serve-mcp needs the extra: pip install 'mechanics[mcp]'") from None
    made = mcp.MCPServer("mechanics", instructions=INSTRUCTIONS, log_level="WARNING")
    for name in TOOLS:
        made.tool(name=name)(_sent(worker, name, refused))
    made.resource(SCHEMA, name="scene", mime_type="application/schema+json")(schema)
    return made


def _sent(worker: Worker, name: str, refused: type[Exception]) -> Callable[..., Any]:
    """A tool that the worker answers; its refusals are one line."""

    @wraps(getattr(Tools(), name))
    def call(**arguments: Any) -> Any:
        try:
            return worker.call(name, arguments)
        except InputError as error:
            raise refused(str(error)) from None

    return call
