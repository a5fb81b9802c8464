"""C that does not depend on the program, from the files beside this one."""

from importlib.resources import files


def text(name: str) -> str:
    """The content of a file."""
    return files("mechanics.simulate.ensembles").joinpath(name).read_text(encoding="ascii")
