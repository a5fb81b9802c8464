"""Statements written in every form that `mechanics.check` reads."""
