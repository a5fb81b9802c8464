"""C text: names, expressions, functions, statuses."""
