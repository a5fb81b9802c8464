"""Cross-check one system: derive by every route, prove, compile, measure."""

from mechanics.crosscheck.routes import derive, derive_textbook
from mechanics.crosscheck.system import CrossCheck, crosscheck
from mechanics.routes.derivation import ROUTES, Route

__all__ = [
    "ROUTES",
    "CrossCheck",
    "Route",
    "crosscheck",
    "derive",
    "derive_textbook",
]
