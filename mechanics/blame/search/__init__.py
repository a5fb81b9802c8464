"""The search for the smallest edit that makes a refuted statement right."""
