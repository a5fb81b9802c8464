"""How good `mechanics.check` is: mutants of right equations, and right ones written otherwise."""
