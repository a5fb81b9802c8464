"""The text of the inline sine and cosine: its error is proved, for all numbers."""

from mechanics.compiled.translation_validation.sine.proof import MOST, verify_sine

__all__ = ["MOST", "verify_sine"]
