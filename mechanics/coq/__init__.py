"""Findings as theorems for Coq, whose kernel checks them without trust in this program."""

from mechanics.coq.folder import Written, checked, write_coq

__all__ = ["Written", "checked", "write_coq"]
