"""Many submissions against one key: a score, the smallest change, a hint, what is missing."""
