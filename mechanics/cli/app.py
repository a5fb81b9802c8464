"""The commands, and what every one of them does with an error: one line, exit code 2.

What is refuted while something is written has exit code 1, as everything that is refuted.

An error that the program did not expect shows where it happened, with an exit code of its own.
"""

import sys
import traceback
from typing import Annotated, Any, NoReturn

import typer
from rich.console import Console
from rich.markup import escape

from mechanics.cli import (
    checking,
    crosschecking,
    deriving,
    extremes,
    fmu,
    small_motions,
    trading,
    using,
    verifying,
)
from mechanics.errors import MechanicsError, RefutedError
from mechanics.export.manifest import version_of

# Typer brings its own copy of click, or uses click, depending on its version.
USAGE_ERROR: Any = typer.BadParameter.__base__

app = typer.Typer(
    name="mechanics",
    help="Know that equations of motion are right: derive them four ways, prove that they agree,"
    " compile them.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    pretty_exceptions_enable=False,
)


def _tell_version(wanted: bool) -> None:
    if wanted:
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


app.command("systems")(crosschecking.systems)
app.command("crosscheck")(crosschecking.crosscheck)
app.command("check")(checking.check)
app.command("derive")(deriving.derive)
app.command("simulate")(using.simulate)
app.command("codegen")(using.codegen)
app.command("verify")(verifying.verify)
app.command("fmu")(fmu.fmu)
app.command("extremes")(extremes.extremes)
app.command("trade")(trading.trade)
app.command("linearize")(small_motions.linearize)
app.command("modes")(small_motions.modes)

DEFECT = 70
"""Exit code after an error that nobody expected (EX_SOFTWARE of sysexits.h)."""


def main() -> None:
    """Entry point of the console command."""
    try:
        code = app(sys.argv[1:] or ["--help"], prog_name="mechanics", standalone_mode=False)
    except USAGE_ERROR as error:
        _refuse(error.format_message())
    except RefutedError as error:
        _refuse(str(error), 1)
    except (MechanicsError, OSError) as error:
        _refuse(str(error))
    except Exception:
        # A defect of this program. Python's own exit code for it, 1, would read as a refutation.
        traceback.print_exc()
        raise SystemExit(DEFECT) from None
    else:
        sys.exit(code)


def _refuse(words: str, code: int = 2) -> NoReturn:
    one_line = escape(" ".join(words.split()))
    console = Console(stderr=True, soft_wrap=True, highlight=False)
    console.print(f"[bold red]error:[/] {one_line}")
    sys.exit(code)
