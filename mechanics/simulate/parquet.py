"""pyarrow, where it is installed."""

from typing import Any

from mechanics.errors import InputError


def parquet(name: str, instead: str = "") -> tuple[Any, Any]:
    """``pyarrow`` and ``pyarrow.parquet``.

    Parameters
    ----------
    name : str
        What is to be written.
    instead : str
        What else can be done.

    Raises
    ------
    InputError
        Where it is not installed.
    """
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise InputError(
            f"{name}: Parquet needs pyarrow, which is not installed: run"
            f" pip install 'mechanics[parquet]'{instead}"
        ) from None
    return pyarrow, pyarrow.parquet
