"""Evidence beside generated code: what it was made from, as data, and what was shown about it."""
