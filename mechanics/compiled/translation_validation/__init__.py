"""Translation validation: derived equations = graph = C text = binary, each step checked."""
