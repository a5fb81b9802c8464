"""What still evaluates straight-line code number by number; programs take its place."""
