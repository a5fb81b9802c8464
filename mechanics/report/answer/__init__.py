"""The answer to a person who asked whether equations are right: on a terminal, as a page."""
