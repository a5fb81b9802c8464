"""Plain text in the notation of SymPy or MATLAB, as trees."""
