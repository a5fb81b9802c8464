"""Which term of an equation is wrong, what would mend it, and where such a term comes from."""
