"""Known mistakes of derivations, each made in the scene's own derivation to see what it gives."""
