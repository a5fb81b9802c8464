"""The command line: `mechanics --help`."""

from mechanics.cli.app import main

__all__ = ["main"]
