"""From NumPy arrays to machine code and back: one state or many, checked or as they come."""
