"""A motion as GIF, for slides and pages that take no SVG.

Each sample is the same drawing that the SVG shows, in the light colours of the pages. resvg draws
it, with the STIX fonts that Matplotlib brings, so that all machines give the same picture.
"""

import re
from collections.abc import Mapping
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from mechanics.errors import InputError
from mechanics.report.animation import XMLNS, frames
from mechanics.report.drawing import HEIGHT, WIDTH
from mechanics.report.style import colours, drawing_rules
from mechanics.scene import Scene

RATE = 20
"""Pictures a second: players show no more than 50, and keep time in steps of 10 ms."""
PIXELS = 690
"""Width, in pixels."""
SHOWN = 5
"""Pictures that the colours are taken from."""


def renderer(name: str) -> ModuleType:
    """The library that draws SVG.

    Raises
    ------
    InputError
        Where it is not installed.
    """
    try:
        import resvg_py
    except ImportError:
        raise InputError(
            f"{name}: GIF needs resvg-py, which is not installed: run"
            " pip install 'mechanics[gif]', or write .svg or .html"
        ) from None
    return resvg_py


def write_gif(
    scene: Scene,
    times: NDArray[np.float64],
    coordinates: Mapping[str, NDArray[np.float64]],
    path: Path,
) -> None:
    """A motion that repeats for ever, in the time that it takes."""
    from matplotlib import get_data_path
    from PIL import Image

    resvg = renderer(f"file {path.name}")
    fonts = Path(get_data_path()) / "fonts" / "ttf"
    files = [str(fonts / f"STIXGeneral{style}.ttf") for style in ("", "Italic", "Bol", "BolIta")]
    corner, parts = frames(scene, times, coordinates, RATE)
    begin = (
        f'<svg{XMLNS} class="drawing" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}"><style>{_style()}'
        f'</style><rect class="sheet" width="{WIDTH:.0f}" height="{HEIGHT:.0f}"/>{corner}'
    )
    images = [
        Image.open(
            BytesIO(
                resvg.svg_to_bytes(
                    svg_string=f"{begin}{''.join(part)}</svg>",
                    width=PIXELS,
                    skip_system_fonts=True,
                    font_files=files,
                    serif_family="STIXGeneral",
                )
            )
        ).convert("RGB")
        for part in parts
    ]
    together = Image.new("RGB", (PIXELS, SHOWN * images[0].height))
    for k, image in enumerate(images[:: -(-len(images) // SHOWN)]):
        together.paste(image, (0, k * image.height))
    palette = together.quantize()
    # What is rounded at one picture is made up for at the next.
    ends = np.linspace(0, float(times[-1]), len(images) + 1)
    durations = [10 * max(round(100 * b) - round(100 * a), 2) for a, b in pairwise(ends)]
    first, *rest = (image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images)
    first.save(path, "GIF", save_all=True, append_images=rest, duration=durations, loop=0)


def _style() -> str:
    """The rules of drawings in the CSS that resvg reads: no variables, media and lists."""
    values = dict(re.findall(r"(--[\w-]+): *([^;]+);", colours()[0]))
    rules = f"{drawing_rules()} .sheet {{ fill: var(--sheet); }}"
    rules = re.sub(r"@media[^{]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}", "", rules)
    rules = re.sub(r"([^{},]*):is\(([^)]*)\)", _listed, rules)
    return re.sub(r"var\((--[\w-]+)\)", lambda match: values[match[1]], rules)


def _listed(match: re.Match[str]) -> str:
    return ", ".join(match[1] + name.strip() for name in match[2].split(","))
