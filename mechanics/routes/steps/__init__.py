"""How each route derives, step by step, for people, up to the common form."""
