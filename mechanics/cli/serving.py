"""`mechanics serve-mcp`: the tools of `mechanics.cli.tools`, by the Model Context Protocol."""

from collections.abc import Callable
from functools import wraps
from importlib import import_module
from typing import Any

from mechanics.cli.tools import Tools
from mechanics.errors import InputError, MechanicsError
from mechanics.scene.json.schema import schema

TOOLS = ("example", "derive", "check", "crosscheck", "compare", "codegen", "verify")
SCHEMA = "mechanics://scene.schema.json"
INSTRUCTIONS = (
    "Equations of motion, derived by four routes and proved. A scene is an object as the resource"
    f" {SCHEMA} says (`example` gives one), the name of a built-in system, or the id of a scene"
    " that was sent before, which answers fastest. Statements are LaTeX, text or C; nothing is run."
)


def serve_mcp() -> None:
    """Serve derive, check, crosscheck, compare, codegen and verify to agents, over stdio.

    No code of the caller's is run: scenes are JSON (docs/scene.schema.json), statements LaTeX, text
    or C, which are only read. It needs the extra `mcp`.

    Examples
    --------
    `mechanics serve-mcp`
    """
    server().run("stdio")


def server() -> Any:
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
    tools = Tools()
    for name in TOOLS:
        made.tool(name=name)(_plain(getattr(tools, name), refused))
    made.resource(SCHEMA, name="scene", mime_type="application/schema+json")(schema)
    return made


def _plain(tool: Callable[..., Any], refused: type[Exception]) -> Callable[..., Any]:
    """A tool whose refusals are one line."""

    @wraps(tool)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return tool(*args, **kwargs)
        except MechanicsError as error:
            raise refused(" ".join(str(error).split())) from None
        except RecursionError:
            raise refused("nested too deeply") from None

    return call
