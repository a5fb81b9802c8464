"""Cross-check one system: derive by every route, prove, compile, measure."""

from mechanics.crosscheck.routes import ROUTES, Route, derive, derive_textbook, derive_with
from mechanics.crosscheck.system import CrossCheck, crosscheck

__all__ = [
    "ROUTES",
    "CrossCheck",
    "Route",
    "crosscheck",
    "derive",
    "derive_textbook",
    "derive_with",
]
