"""Reports: what a cross-check found, as JSON and as one HTML page."""

from mechanics.report.html import to_html
from mechanics.report.json_report import to_json
from mechanics.report.result import (
    LedgerResult,
    Modes,
    Motion,
    ResidualResult,
    RouteResult,
    SystemResult,
)

__all__ = [
    "LedgerResult",
    "Modes",
    "Motion",
    "ResidualResult",
    "RouteResult",
    "SystemResult",
    "to_html",
    "to_json",
]
