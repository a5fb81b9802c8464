"""Other engines' answers beside ours, and the cause where they differ."""

from mechanics.compare.compare import Cause, Comparison, Row, compare
from mechanics.compare.engines import ENGINES, Engine, engine, installed
from mechanics.compare.ours import Ours, of_scene

__all__ = [
    "ENGINES",
    "Cause",
    "Comparison",
    "Engine",
    "Ours",
    "Row",
    "compare",
    "engine",
    "installed",
    "of_scene",
]
