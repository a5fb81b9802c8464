"""The commands, and what every one of them does with an error: one line, exit code 2."""

import sys

import typer
from rich.console import Console

from mechanics.cli import checking, deriving, small_motions, using
from mechanics.errors import MechanicsError

app = typer.Typer(
    name="mechanics",
    help="Know that equations of motion are right: derive them four ways, prove that they agree,"
    " compile them.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    pretty_exceptions_enable=False,
)
app.command("systems")(checking.systems)
app.command("crosscheck")(checking.crosscheck)
app.command("derive")(deriving.derive)
app.command("simulate")(using.simulate)
app.command("codegen")(using.codegen)
app.command("linearize")(small_motions.linearize)
app.command("modes")(small_motions.modes)


def main() -> None:
    """Entry point of the console command."""
    try:
        app()
    except (MechanicsError, OSError) as error:
        words = " ".join(str(error).split())
        Console(stderr=True, soft_wrap=True, highlight=False).print(
            f"[bold red]error:[/] {_escaped(words)}"
        )
        sys.exit(2)


def _escaped(text: str) -> str:
    from rich.markup import escape

    return escape(text)
