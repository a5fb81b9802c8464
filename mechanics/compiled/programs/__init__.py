"""Programs: the instructions of a graph as a list of values, and what is made of such lists."""
