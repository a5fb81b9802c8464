"""Verdicts and findings, by the name under which this package had them."""

from mechanics.kernel.finding import Finding, Verdict, Witness

__all__ = ["Finding", "Verdict", "Witness"]
