"""What a notebook shows of scenes, equations, results, models and motions.

IPython is told the names of their types when this package is imported in it, so that no class below
knows HTML. Everything is one element without scripts.
"""

import sys
from collections import Counter
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from markupsafe import Markup, escape

if TYPE_CHECKING:
    from mechanics.compiled import Model
    from mechanics.equations import Equations
    from mechanics.linear import Linear
    from mechanics.report.answer.check import Check
    from mechanics.report.result import SystemResult
    from mechanics.scene import Scene
    from mechanics.simulate import Trajectory

LARGEST = 8
"""States up to which matrices are written out."""


def register() -> None:
    """Tell the running IPython how things are shown; nothing happens in a plain interpreter."""
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    if shell is not None:
        html = shell.display_formatter.formatters["text/html"]
        for (module, name), show in SHOWN.items():
            html.for_type_by_name(module, name, show)


def scene_html(scene: "Scene") -> str:
    """The drawing at the example, and the table of symbols."""
    from mechanics.report.drawing import drawing, shape_words
    from mechanics.report.notation import latex_name
    from mechanics.report.sections import symbol_rows
    from mechanics.report.typeset import maths

    rows = [
        (maths(latex_name(row.name)), row.meaning, row.value)
        for row in symbol_rows(scene, scene.example)
    ]
    words = shape_words(scene)
    note = [Markup("<p>{}</p>").format(words)] if words else []
    return _element(Markup(drawing(scene, scene.example)), *note, _table(rows))


def equations_html(equations: "Equations") -> str:
    """The equations of motion, where they can be written out."""
    from mechanics.report.typeset import equation

    head = Markup("<p>{} by <code>{}</code></p>").format(equations.scene.name, equations.route)
    if equations.textbook is None:
        words = f"{len(equations.scene.u)} speeds: too long for formulas, kept as a program"
        return _element(head, Markup("<p>{}</p>").format(words))
    return _element(head, *(equation(line) for line in equations.result.lines))


def result_html(result: "SystemResult") -> str:
    """How many checks of each kind passed, as a table; what did not, by name."""
    from mechanics.report.words import chip

    count, open_ = len(result.claims), result.open
    words = f"All {count} checks passed." if result.ok else f"{len(open_)} checks did not pass."
    head = Markup("<p><strong>{}</strong>: {}</p>").format(result.name, words)
    counts = [
        (title, Markup(", ").join(Markup("{} {}").format(n, chip(v)) for v, n in verdicts.items()))
        for title, findings in result.groups.items()
        if (verdicts := Counter(finding.verdict for finding in findings))
    ]
    rows = [(chip(f.verdict), f.subject, f.evidence) for f in open_]
    return _element(head, _table(counts), *([_table(rows)] if rows else []))


def model_html(model: "Model") -> str:
    """The functions of a model and how they are called."""
    rows = []
    for name, function in model.casadi.items():
        takes = [function.name_in(i) for i in range(function.n_in())]
        gives = [function.name_out(i) for i in range(function.n_out())]
        rows.append(
            (Markup("<code>{}({})</code>").format(name, ", ".join(takes)), ", ".join(gives))
        )
    quantities = model.quantities
    vectors = [
        (Markup("<code>{}</code>").format(name), ", ".join(f"{q.symbol} [{q.unit}]" for q in group))
        for name, group in (("q", quantities.q), ("u", quantities.u), ("p", quantities.p))
    ]
    return _element(Markup("<p>{}</p>").format(repr(model)[1:-1]), _table(vectors), _table(rows))


def linear_html(linear: "Linear") -> str:
    """y' = A y + B w, where the matrices are small."""
    from mechanics.report.notation import latex
    from mechanics.report.typeset import maths

    head = Markup("<p>{}</p>").format(repr(linear)[1:-1])
    if len(linear.states) > LARGEST:
        return _element(head)
    # In braces, so that brackets are the first and last of their row, and grow with it.
    parts = [
        Markup("<p>{}</p>").format(maths(f"{name} = {{{latex(getattr(linear, name))}}}"))
        for name in ("A", "B")
    ]
    states = ", ".join(str(symbol) for symbol in linear.states)
    return _element(
        head, Markup("<p>states: {}</p>").format(states), *parts[: 1 + bool(linear.inputs)]
    )


def trajectory_html(motion: "Trajectory") -> str:
    """The scene as it moves, and its curves."""
    from mechanics.report.environment import environment
    from mechanics.report.motion import motion_charts, moving_figure

    parts = [Markup("<p>{}: {}</p>").format(motion.title, motion.note)]
    if motion.scene is not None:
        moving = moving_figure(motion.scene, motion.columns)
        charts = motion_charts(motion.scene, motion.columns, motion.units)
        shared: Any = environment().get_template("parts.html").module
        parts.append(shared.figures(moving, charts))
    return _element(*parts)


def check_html(check: "Check") -> str:
    """The page of an answer, in a frame of its own: its rules hold for nothing else."""
    from mechanics.report.answer.page import check_html as page

    style = "width: 100%; height: 40rem; border: 1px solid #8888; border-radius: 6px;"
    frame = '<iframe title="{}" style="{}" srcdoc="{}"></iframe>'
    return Markup(frame).format(repr(check)[1:-1], style, page(check))


def _table(rows: list[tuple[Any, ...]]) -> Markup:
    """Cells that are text are escaped."""
    lines = ("".join(f"<td>{escape(cell)}</td>" for cell in row) for row in rows)
    return Markup("<table>{}</table>").format(Markup("".join(f"<tr>{line}</tr>" for line in lines)))


OWN = """.mechanics.mechanics :is(table, tbody tr:nth-child(n), :not(pre) > code) {
 background: none; color: inherit; }
.mechanics.mechanics td { text-align: left; }
.mechanics math { font-family: var(--maths); }"""
"""JupyterLab colours rows and code for its own paper: these rules are as specific, and later."""


def _element(*parts: Markup) -> str:
    """One element with the colours of the pages, which hold for it alone."""
    from mechanics.report.style import colours, drawing_rules

    light, _ = colours()
    # On paper of its own, so that it is read in a dark notebook, too.
    frame = "max-width: 34rem; padding: .6rem; background: var(--paper); color: var(--ink);"
    style = f".mechanics {{{light} {frame}}} {OWN} {drawing_rules()}"
    return f'<div class="mechanics"><style>{style}</style>{"".join(parts)}</div>'


SHOWN: Mapping[tuple[str, str], Callable[[Any], str]] = {
    ("mechanics.scene.scene", "Scene"): scene_html,
    ("mechanics.equations", "Equations"): equations_html,
    ("mechanics.report.result", "SystemResult"): result_html,
    ("mechanics.compiled.model", "Model"): model_html,
    ("mechanics.linear.form", "Linear"): linear_html,
    ("mechanics.simulate.trajectory", "Trajectory"): trajectory_html,
    ("mechanics.report.answer.check", "Check"): check_html,
}
"""How a type is shown, by its module and name."""
