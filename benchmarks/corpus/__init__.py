"""Statements about equations of motion as their authors typed them, right and wrong.

    python -m benchmarks.corpus

Each case has its source, a scene in its author's symbols, the statement, whether it is right, and
for a wrong one the mistake. Formulas are facts of their sources; they were typed here, not copied.
"""
