"""Colours and strokes of the work-precision plot as a file of its own."""

FAMILIES = ("heyoka", "C", "CasADi", "SUNDIALS", "SciPy")
"""Families of integrators, each with a colour of its own."""

STYLE = """
svg { --paper: #fdfdfb; --ink: #1b222c; --muted: #5a6371; --line: #d8dcdf; --band: #e3c25a;
  --heyoka: #7b4aa0; --C: #1d5fa8; --CasADi: #0f7c88; --SUNDIALS: #1f7a4d; --SciPy: #b4431a;
  background: var(--paper); font-family: system-ui, -apple-system, "Segoe UI", Roboto,
  "Liberation Sans", sans-serif; }
@media (prefers-color-scheme: dark) { svg { --paper: #15181d; --ink: #e3e6eb; --muted: #9ba5b3;
  --line: #323a45; --band: #8a6a00; --heyoka: #c9a2ee; --C: #7db2f5; --CasADi: #6ad0dc;
  --SUNDIALS: #7fd6a2; --SciPy: #ff9d6f; } }
text { font-size: 13px; fill: var(--muted); }
.power { font-size: 9.5px; }
.grid { stroke: var(--line); } .frame { stroke: var(--muted); }
.line { fill: none; stroke-width: 1.6; stroke-linejoin: round; }
.band { fill: none; stroke: var(--band); stroke-width: 11; stroke-linejoin: round;
  stroke-linecap: round; opacity: .38; }
.single { fill: var(--paper); } .cross { fill: none; }
.front { fill: none; stroke: var(--ink); stroke-width: 1.1; }
.target { stroke: var(--muted); stroke-dasharray: 1 4; stroke-width: 1.4; }
.target-name { fill: var(--ink); font-weight: 600; }
.pick { fill: var(--ink); stroke: var(--paper); stroke-width: 1.5; }
.pick-line { stroke: var(--ink); stroke-width: 1.4; }
.dot.noisy { fill: var(--paper); stroke: var(--muted); }
.leader { fill: none; stroke: var(--line); } .name { font-weight: 600; }
""" + "".join(
    f".line.{f}, .single.{f}, .cross.{f} {{ stroke: var(--{f}); }}"
    f" .dot.{f}, .name.{f} {{ fill: var(--{f}); }}\n"
    for f in FAMILIES
)
"""Of the plot; the page's own variables, where it has them, are the same."""
