"""`python -m mechanics`: the command line."""

from mechanics.cli import main

main()
