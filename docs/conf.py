"""How Sphinx makes the site: ``sphinx-build -W docs build/site``.

Pages are written by hand in Markdown, or are notebooks, which are run. Made here, so that they
cannot differ from the program: the gallery of all systems, the reference of the commands, the
changes, and formulas as MathML.
"""

import inspect
import os
import re
import sys
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

import systems
from mechanics.cli.app import COMMANDS, command
from mechanics.crosscheck import CrossCheck, crosscheck
from mechanics.report.drawing import drawing
from mechanics.report.html import to_html
from mechanics.report.notation import mathml
from mechanics.report.style import colours, drawing_rules
from mechanics.scene.system import System

sys.path.insert(0, str(Path(__file__).parent))
import notebook_pages

ROOT = Path(__file__).parents[1]
REPORTS = os.environ.get("REPORTS", "").split()
"""Systems whose reports the site holds, or ``all``: these take minutes, so the default is none."""

project = "mechanics"
html_title = "mechanics"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown", ".ipynb": "markdown"}
myst_enable_extensions = ["attrs_block", "attrs_inline", "colon_fence", "dollarmath"]
myst_heading_anchors = 3
suppress_warnings = ["myst.header"]
html_theme = "furo"
html_math_renderer = "mathml"
html_static_path = ["stylesheets", "images", "scene.schema.json"]
html_css_files = ["site.css", "drawings.css"]
html_copy_source = html_show_copyright = html_show_sourcelink = html_show_sphinx = False
exclude_patterns = ["made/*"]
autodoc_default_options = {"members": False}
autodoc_typehints = "none"
add_module_names = False
napoleon_google_docstring = False
napoleon_use_rtype = False
# A `name` in a docstring is code.
default_role = "code"
# The colours of the reports, so that pages and reports are of one hand.
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#1d4f91",
        "color-brand-content": "#1d4f91",
        "color-brand-visited": "#1d4f91",
        "color-background-primary": "#fdfdfb",
        "color-background-secondary": "#f4f5f2",
        "color-foreground-primary": "#1b222c",
        "color-foreground-muted": "#5a6371",
    },
    "dark_css_variables": {
        "color-brand-primary": "#8fb8f2",
        "color-brand-content": "#8fb8f2",
        "color-brand-visited": "#8fb8f2",
        "color-background-primary": "#15181d",
        "color-background-secondary": "#1c2027",
        "color-foreground-primary": "#e3e6eb",
        "color-foreground-muted": "#9ba5b3",
    },
}


def setup(app: Sphinx) -> None:
    """What is added to Sphinx."""
    app.connect("source-read", fill)
    app.connect("build-finished", finish)
    app.add_html_math_renderer("mathml", (math, None), (math, None))


MADE = {"gallery": lambda: gallery(), "reference/commands": lambda: commands()}
"""Pages whose text follows what the file of that name says."""


def fill(app: Sphinx, page: str, source: list[str]) -> None:
    """Add to a page what the program knows; run a notebook."""
    path = Path(app.env.doc2path(page))
    if path.suffix == ".ipynb":
        source[0] = notebook_pages.page(path)
    if page in MADE:
        source[0] += MADE[page]()


MENDED = {
    'class="caption" role="heading"': 'class="caption" role="heading" aria-level="2"',
    "<pre>": '<pre tabindex="0">',
    '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper',
    '<th class="head"><p></p></th>': "<td></td>",
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="Pages">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="On this page">',
}
"""What the theme writes, and what those need who do not see the page or use no mouse."""


def finish(app: Sphinx, error: Exception | None) -> None:
    """Write the colours of drawings, and the reports; make the theme accessible."""
    if error:
        return
    for path in Path(app.outdir).rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        for written, mended in MENDED.items():
            text = text.replace(written, mended)
        path.write_text(text, encoding="utf-8")
    (Path(app.outdir) / "_static" / "drawings.css").write_text(drawing_style(), encoding="utf-8")
    for system in reported():
        page = to_html([crosscheck(system, CrossCheck(motion=True))])
        path = Path(app.outdir) / "reports" / f"{system.name}.html"
        path.parent.mkdir(exist_ok=True)
        path.write_text(page, encoding="utf-8")


def reported() -> list[System]:
    """Systems whose reports the site holds."""
    return [s for s in systems.EVERY if s.name in REPORTS or "all" in REPORTS]


def math(self: Any, node: Any) -> None:
    """A formula as MathML: nothing is fetched and no script runs."""
    latex = node.astext()
    number = re.search(r"\\tag\{(.*?)\}", latex)
    typeset = mathml(re.sub(r"\\tag\{.*?\}", "", latex).strip())
    if isinstance(node, nodes.math_block):
        tag = f'<span class="tag">({number[1]})</span>' if number else ""
        # What scrolls on a phone has to be reached by the keyboard.
        box = '<div class="formula" tabindex="0" role="group" aria-label="formula">'
        typeset = f"{box}{typeset}{tag}</div>"
    self.body.append(typeset)
    raise nodes.SkipNode


def drawing_style() -> str:
    """The rules of the reports for drawings, under the light and the dark colours of the theme."""
    light, dark = colours()
    auto = f'@media (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {{{dark}}} }}'
    return "\n".join(
        [f"body {{{light}}}", f'body[data-theme="dark"] {{{dark}}}', auto, drawing_rules()]
    )


def gallery() -> str:
    """Every system that is built in: its drawing, its freedoms, what its source publishes."""
    parts = []
    for title, group in systems.GROUPS:
        cards = "\n".join(_card(system) for system in group)
        parts.append(f"\n## {title[0].upper()}{title[1:]}\n")
        parts.append(f'```{{raw}} html\n<div class="gallery">{cards}</div>\n```\n')
    return "\n".join(parts)


def _card(system: System) -> str:
    scene = system.scene()
    text = (inspect.getdoc(system.scene) or scene.name).splitlines()[0]
    names = ", ".join(q.name for q in scene.q[:6]) + (", …" if len(scene.q) > 6 else "")
    facts = [f"{len(scene.bodies)} bod{'y' if len(scene.bodies) == 1 else 'ies'}", names]
    if system.published:
        facts.append(f"{len(system.published)} published equations")
    if system in reported():
        facts.append(f'<a href="reports/{system.name}.html">report</a>')
    return (
        f'<figure id="{system.name}">{drawing(scene, scene.example)}<figcaption>'
        f"<code>{system.name}</code> {text}"
        f'<span class="facts">{"; ".join(facts)}</span></figcaption></figure>'
    )


def commands() -> str:
    """Every command with its options and examples, as ``--help`` has them."""
    parts = []
    for name in (name for group in COMMANDS.values() for name in group):
        made = command(name)
        text, _, examples = inspect.cleandoc(made.help).partition("Examples\n--------\n")
        parts.append(f"\n## mechanics {name}\n\n{text.strip()}\n")
        lines = [line.strip("`") for line in examples.split("\n") if line.strip()]
        if lines:
            parts.append("```sh\n" + "\n".join(lines) + "\n```\n")
        options = [_option(option) for option in made.params if option.name != "help"]
        parts += ["| option | what it does |\n| --- | --- |", *options] if options else []
    return "\n".join(parts)


def _option(option: Any) -> str:
    shown = ", ".join(f"`{name}`" for name in option.opts if name.startswith("-"))
    value = f"`{option.metavar}`" if option.metavar else ""
    cells = ((shown + " " + value).strip() or f"`{option.name}`", option.help or "")
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"
