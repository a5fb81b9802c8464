"""The chain of custody: derived equations = graph = C text = binary, each step checked."""
