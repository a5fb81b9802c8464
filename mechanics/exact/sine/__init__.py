"""The text of the inline sine and cosine: its error is proved, for all numbers."""
