"""Functions of C: what a person's file needs before it is read as a program."""
