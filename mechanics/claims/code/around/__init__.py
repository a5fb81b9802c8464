"""Lines around judged functions: what they do with what the functions return."""
