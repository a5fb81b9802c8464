"""The commands, and what every one of them does with an error: a line, where it is, exit code 2.

What is refuted while something is written has exit code 1, as everything that is refuted.

An error that the program did not expect shows where it happened, with an exit code of its own.
"""

import gc
import re
import sys
import traceback
from functools import partial
from importlib import import_module
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.markup import escape
from typer.core import TyperGroup

from mechanics.cli.interrupts import end_in_order, told_when_stopped
from mechanics.cli.isolation import answered
from mechanics.errors import MechanicsError, RefutedError

# Typer brings its own copy of click, or uses click, depending on its version.
USAGE_ERROR: Any = typer.BadParameter.__base__

COMMANDS = {
    "Find out whether equations are right": {
        "crosscheck": "Derive systems by four routes and prove that they agree with each other and"
        " their source.",
        "check": "Check your own equations of motion, energies, reactions or mass matrix.",
        "grade": "Grade many submissions against one key, each in a process of its own within"
        " limits.",
        "compare": "Compare a model with other engines, and name the cause where they differ.",
    },
    "Derive and look": {
        "systems": "List the systems that come with the program.",
        "derive": "Print the equations of motion M u' = f + B lambda, A u' = b of one route.",
        "linearize": "Print the linear equations about rest or a steady motion, which is proved"
        " first.",
        "modes": "Print frequencies and shapes about rest or a steady motion, or poles over a"
        " parameter.",
    },
    "Simulate and measure": {
        "simulate": "Integrate the equations of motion; write the samples, or draw the motion.",
        "ensemble": "Integrate many motions, on one machine or on many; write them to a folder of"
        " Parquet.",
        "trade": "Measure what integrators, precisions, forms and simpler models cost and how"
        " far they err.",
        "extremes": "Find where compiled equations lose accuracy: along every parameter,"
        " coordinate and speed.",
    },
    "Export and serve": {
        "codegen": "Write the equations as C99: a folder that builds, tests and installs alone.",
        "reduce": "Find what may be left out of an output over a box, with a proved bound of the"
        " change.",
        "verify": "Prove the C in a folder again, from the physics to the machine code.",
        "fmu": "Write the equations as an FMU: FMI 3.0, for model exchange and co-simulation.",
        "serve-mcp": "Serve derive, check, crosscheck, compare, codegen and verify to agents, over"
        " stdio.",
    },
}
"""Commands by what somebody wants to do, and the first line of the help of each."""
MODULES = {
    "systems": "crosscheck", "linearize": "small_motions", "modes": "small_motions",
    "serve-mcp": "mcp_server",
}  # fmt: skip
"""Modules of commands that are not called like them. What is not called is not imported."""


class _OnDemand(TyperGroup):
    """Commands that are imported when they are called."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        name, _, rest = super().resolve_command(ctx, args)
        return name, command(str(name)), rest


def command(name: str) -> Any:
    """A command with its options, imported now."""
    single = typer.Typer(**_LOOKS)
    module = import_module(f"mechanics.cli.{MODULES.get(name, name)}")
    single.command(name)(told_when_stopped()(getattr(module, name.replace("-", "_"))))
    return typer.main.get_command(single)


def _nothing() -> None:
    """Stands for a command in the list of all."""


_LOOKS: dict[str, Any] = {
    "add_completion": False,
    "rich_markup_mode": "markdown",
    "pretty_exceptions_enable": False,
}

app = typer.Typer(
    name="mechanics",
    cls=_OnDemand,
    help="Know that equations of motion are right: derive them four ways, prove that they agree,"
    " compile them.",
    no_args_is_help=True,
    **_LOOKS,
)


def _tell_version(wanted: bool) -> None:
    if wanted:
        from mechanics.export.manifest import version_of

        typer.echo(f"mechanics {version_of('mechanics')}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_tell_version, is_eager=True, help="Print the version."),
    ] = False,
) -> None:
    """What stands before a command."""


for _group, _commands in COMMANDS.items():
    for _name, _help in _commands.items():
        app.command(_name, help=_help, rich_help_panel=_group)(_nothing)

COLLECTED = 1_000_000
"""New objects after which Python looks for cycles among them; its own default is 700."""

DEFECT = 70
"""Exit code after an error that nobody expected (EX_SOFTWARE of sysexits.h)."""


def main() -> None:
    """Entry point of the console command."""
    end_in_order()
    # Programs are millions of small objects without cycles: looking for these took a fifth of the
    # time of a cross-check.
    gc.set_threshold(COLLECTED)
    words = sys.argv[1:] or ["--help"]
    code = answered(partial(_run, words)) if _judges_code(words) else _run(words)
    if code is None:
        _refuse(None, "not judged: the code ended the process before there was a verdict")
        code = 2
    sys.exit(code)


def _judges_code(words: list[str]) -> bool:
    """Whether a person's Python is run to be judged."""
    return words[0] == "check" and any(CODE.search(word) for word in words)


CODE = re.compile(r"\.py(?::|\Z)")


def _run(words: list[str]) -> int:
    """The exit code of a command; its errors are told."""
    try:
        return app(words, prog_name="mechanics", standalone_mode=False) or 0
    except USAGE_ERROR as error:
        return _refuse(error, error.format_message() + _to_add(error))
    except RefutedError as error:
        return _refuse(error, str(error), 1)
    except (MechanicsError, OSError) as error:
        return _refuse(error, str(error))
    except Exception:
        # A defect of this program. Python's own exit code for it, 1, would read as a refutation.
        traceback.print_exc()
        raise SystemExit(DEFECT) from None


def _to_add(error: Any) -> str:
    """What to write where an argument or an option is missing, or an option is not there."""
    missing = getattr(error, "param", None)
    unknown = getattr(error, "option_name", None) and error.ctx is not None
    if unknown and not getattr(error, "possibilities", None):
        # Values are often called initial, or are given by their own names.
        taken = [name for param in error.ctx.command.params for name in param.opts]
        return ". Values are set by --set NAME=VALUE." if "--set" in taken else ""
    if missing is None or "Missing" not in error.format_message():
        return ""
    options = [name for name in missing.opts if name.startswith("--")]
    words = " ".join([*options, missing.metavar or "VALUE"])
    return f" Add {words}: {missing.help}"


def _refuse(error: BaseException | None, words: str, code: int = 2) -> int:
    from mechanics.cli.excerpt import excerpt

    one_line = " ".join(words.split())
    console = Console(stderr=True, soft_wrap=True, highlight=False)
    console.print(f"[bold red]error:[/] {escape(one_line)}")
    if error is not None and (place := excerpt(error, one_line, sys.argv[1:])):
        console.print(f"[dim]{escape(place)}[/]")
    return code
