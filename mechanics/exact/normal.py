"""Placeholder."""
def proves(experiment) -> bool:
    return False
