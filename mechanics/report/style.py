"""Rules of the pages for drawings and charts that stand alone: in an SVG, in a notebook."""

import re
from importlib.resources import files


def colours() -> tuple[str, str]:
    """Declarations of the variables of the pages, under light and under dark."""
    blocks = [re.findall(r":root \{(.*?)\}", text, re.DOTALL)[:2] for text in _texts()]
    light, dark = (" ".join(" ".join(both).split()) for both in zip(*blocks, strict=True))
    return re.sub(r"color-scheme:[^;]*; ?", "", light), dark


def drawing_rules() -> str:
    """What drawings and charts look like, in terms of these variables."""
    rules = re.findall(
        r"^\.(?:drawing|chart|curve|s\d|keys?) ?[^{]*\{.*?\}", _texts()[1], re.MULTILINE | re.DOTALL
    )
    return " ".join(" ".join(rule.split()) for rule in rules)


def _texts() -> list[str]:
    templates = files("mechanics.report") / "templates"
    return [(templates / name).read_text("utf-8") for name in ("style.css", "figures.css")]
