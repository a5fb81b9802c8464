"""Four routes from a scene to its equations of motion, none of which knows another."""
