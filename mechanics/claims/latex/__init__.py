"""LaTeX as people write it, as trees."""
