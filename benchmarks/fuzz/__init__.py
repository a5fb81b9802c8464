"""Any bytes as LaTeX, text or C give a verdict, or one line with a line and a column.

    python -m benchmarks.fuzz --minutes 30          executions, coverage, findings

Atheris mutates documents of tests/claims/corpus; hypothesis makes them in tests/claims.
"""
