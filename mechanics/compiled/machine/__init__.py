"""What evaluates a program: machine code, or CasADi and NumPy where there is no compiler."""
