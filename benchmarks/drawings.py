"""The table of images: the drawing of every system on one page, and what a browser makes of it.

    python -m benchmarks.drawings FOLDER

writes FOLDER/drawings.html and, where Chromium is installed, pictures of it at 1280 and 390 pixels,
light and dark, and in print. They are there to be looked at; `tests/report` compares the drawings
with those that were looked at last.
"""

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from mechanics.report.coordinate_drawings import coordinate_drawings
from mechanics.report.drawing import drawing
from mechanics.report.style import colours, drawing_rules
from mechanics.scene.system import System
from systems import EVERY

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
OPTIONS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-sync",
    "--hide-scrollbars",
)
SHOTS = ((1280, False), (1280, True), (390, False), (390, True))
TALL = {1280: 4000, 390: 13600}
"""Pixels that all systems take, by the width."""


def drawings() -> Iterator[tuple[str, str]]:
    """Names of the systems, and their drawings at the state of their example."""
    for system in EVERY:
        yield system.name, picture(system)


def picture(system: System) -> str:
    """The drawings of one system, about a line for each element: its own, and of coordinates."""
    made = system.scene()
    scene = getattr(made, "scene", made)
    every = [drawing(scene, scene.example)]
    every += [svg for _, svg in coordinate_drawings(scene, scene.example)]
    return "\n".join(svg.replace("/><", "/>\n<") for svg in every) + "\n"


def page() -> str:
    """All of them, four beside each other where there is room."""
    light, dark = colours()
    figures = "".join(
        f"<figure><figcaption>{name}</figcaption>{svg}</figure>" for name, svg in drawings()
    )
    return (
        '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Drawings</title>'
        '<meta name="viewport" content="width=device-width"><style>'
        f":root {{{light} color-scheme: light dark}}"
        f" @media (prefers-color-scheme: dark) {{ :root {{{dark}}} }} {drawing_rules()}"
        " main { margin: 1rem; display: grid; gap: 1rem; background: var(--paper);"
        " grid-template-columns: repeat(auto-fill, minmax(18rem, 1fr)); color: var(--ink);"
        " font: 14px var(--sans); } figure { margin: 0; break-inside: avoid; }"
        " svg + svg { display: inline-block !important; width: calc(50% - .7rem) !important;"
        " margin: .3rem .3rem 0 0; } h1 { grid-column: 1 / -1; }"
        " body { margin: 0; background: var(--paper); } svg { break-inside: avoid; }"
        " figcaption { break-after: avoid; }"
        " @media print { figure { break-inside: auto; } }"
        f"</style><main><h1>Drawings</h1>{figures}</main></html>"
    )


def browser() -> str:
    """Path of Chromium; empty where it is not installed."""
    return next((path for name in BROWSERS if (path := shutil.which(name))), "")


def photograph(
    browser: str, source: Path, target: Path, width: int, height: int, dark: bool = False
) -> None:
    """A page as a browser shows it."""
    size, scheme = f"--window-size={width},{height}", f"preferredColorScheme={0 if dark else 1}"
    _run(browser, f"--screenshot={target}", size, f"--blink-settings={scheme}", source.as_uri())


def shoot(source: Path, browser: str) -> list[Path]:
    """What a browser makes of the page."""
    made = []
    for width, dark in SHOTS:
        target = source.with_name(f"drawings-{width}{'-dark' if dark else ''}.png")
        photograph(browser, source, target, width, TALL[width], dark)
        made.append(target)
    target = source.with_suffix(".pdf")
    _run(browser, f"--print-to-pdf={target}", "--no-pdf-header-footer", source.as_uri())
    return [*made, target]


def _run(browser: str, *arguments: str) -> None:
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, *OPTIONS, f"--user-data-dir={profile}", *arguments]
        subprocess.run(command, capture_output=True, timeout=120, check=True)


def main(folder: Path) -> None:
    """Write the page, and the pictures of it."""
    folder.mkdir(parents=True, exist_ok=True)
    source = (folder / "drawings.html").resolve()
    source.write_text(page(), encoding="utf-8")
    print(source)
    path = browser()
    if not path:
        print("no pictures: Chromium is not installed")
        return
    for target in shoot(source, path):
        print(target)


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "drawings"))
