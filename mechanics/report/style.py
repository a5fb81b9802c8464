"""Rules of the pages for drawings, charts and plots that stand alone: in an SVG, in a notebook."""

import re
from importlib.resources import files

ROOT = re.compile(r":root \{(.*?)\}", re.DOTALL)
OF_PLOTS = re.compile(r"--(?:paper|ink|muted|line|sans): [^;]*;")


def colours() -> tuple[str, str]:
    """Declarations of the variables of the pages, under light and under dark."""
    blocks = [ROOT.findall(template(name))[:2] for name in ("style", "figures", "curves")]
    light, dark = (" ".join(" ".join(each).split()) for each in zip(*blocks, strict=True))
    return re.sub(r"color-scheme:[^;]*; ?", "", light), dark


def plot_colours() -> str:
    """The few variables of the pages that plots use."""
    light, dark = (
        " ".join(OF_PLOTS.findall(block)) for block in ROOT.findall(template("style"))[:2]
    )
    return f"svg {{ {light} }}\n@media (prefers-color-scheme: dark) {{ svg {{ {dark} }} }}\n"


def drawing_rules() -> str:
    """What drawings and charts look like, in terms of these variables."""
    rules = re.findall(
        r"^\.(?:drawing|chart|curve|s\d|keys?) ?[^{]*\{.*?\}",
        template("figures") + template("curves"), re.MULTILINE | re.DOTALL,
    )  # fmt: skip
    return " ".join(" ".join(rule.split()) for rule in rules)


def template(name: str) -> str:
    """The rules of a style sheet of the pages."""
    return (files("mechanics.report") / "templates" / f"{name}.css").read_text("utf-8")
