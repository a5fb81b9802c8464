"""The pictures of the documentation, each made anew by a name or all.

    python -m benchmarks.pictures pendulum answer extremes work_precision

`tests/test_pictures.py` compares: the motion and the map of errors with what is drawn now, the
errors and words of the work-precision plot with what is measured now, and the page of an answer by
the digest that its picture carries, for a picture of text is another one with other fonts.
"""

import hashlib
import re
import struct
import sys
import zlib
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import mechanics
from benchmarks.drawings import browser, photograph
from mechanics.cli.extremes import walked
from mechanics.crosscheck import derive
from mechanics.report.animation import animation
from mechanics.report.answer.page import check_html
from mechanics.report.extremes_plot import heat_plot
from mechanics.report.trade_plot import standalone
from mechanics.trade import trade
from systems import elastic_pendulum, rolling_disc

DOCS = Path(__file__).parents[1] / "docs"
IMAGES = DOCS / "images"
SIZE = 1200, 905
"""Of the picture of a page, in pixels."""
HORIZON = 10.0
"""Of the work-precision plot, in s: that of `mechanics trade`."""
KEYWORD = b"page"
"""Of the digest in a PNG file."""


def block(page: str, name: str) -> str:
    """A file as a page of the documentation shows it."""
    text = (DOCS / "tutorials" / page).read_text(encoding="utf-8")
    found = re.search(rf"<!-- file: {re.escape(name)} -->\n```\w*\n(.*?)```", text, re.DOTALL)
    assert found is not None, f"{page} shows no file {name}"
    return found[1]


def pendulum() -> str:
    """The motion of the tutorial's pendulum."""
    names: dict[str, Any] = {"__name__": "pendulum"}
    exec(compile(block("pendulum.md", "pendulum.py"), "pendulum.py", "exec"), names)
    scene = names["scene"]()
    motion = mechanics.simulate(
        mechanics.compile(mechanics.derive(scene, "kane")), 2.666, samples=501
    )
    return animation(scene, motion.times, motion.coordinates)


def answer() -> str:
    """The page about the homework: its wrong equation (7) after the right (6)."""
    right, wrong = block("homework.md", "mended.tex"), block("homework.md", "homework.tex")
    typed = right.splitlines()[0] + "\n" + wrong
    return check_html(mechanics.check(elastic_pendulum.scene(), typed, notation="latex"))


def errors() -> str:
    """The map of errors of the rolling disc."""
    return heat_plot(walked((rolling_disc.scene(), "rolling_disc", ()), "kane", ()))


def work_precision() -> str:
    """The plot of all integrators, which measures times."""
    by = partial(derive, route="kane")
    return standalone(trade(by(elastic_pendulum.scene()), HORIZON, derive=by))


def digest(page: str) -> str:
    """What tells one page from another."""
    return hashlib.sha256(page.encode()).hexdigest()


def with_digest(png: bytes, page: str) -> bytes:
    """The file with the digest of its page, as a text chunk before the first data."""
    body = b"tEXt" + KEYWORD + b"\0" + digest(page).encode()
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    at = png.index(b"IDAT") - 4
    return png[:at] + chunk + png[at:]


def digest_of(png: bytes) -> str:
    """The digest that a file carries; empty without one."""
    found = re.search(rb"tEXt" + KEYWORD + rb"\0([0-9a-f]{64})", png)
    return found[1].decode() if found else ""


def _picture_of_page(page: str, target: Path) -> None:
    source = target.with_suffix(".html")
    source.write_text(page, encoding="utf-8")
    try:
        photograph(browser(), source, target, *SIZE)
    finally:
        source.unlink()
    target.write_bytes(with_digest(target.read_bytes(), page))


DRAWN: dict[str, tuple[str, Callable[[], str]]] = {
    "pendulum": ("pendulum.svg", pendulum),
    "answer": ("answer.png", answer),
    "extremes": ("extremes.svg", errors),
    "work_precision": ("work_precision.svg", work_precision),
}


def main(names: list[str]) -> None:
    """Make pictures anew."""
    for name in names or DRAWN:
        file, make = DRAWN[name]
        target = IMAGES / file
        if target.suffix == ".png":
            _picture_of_page(make(), target)
        else:
            target.write_text(make(), encoding="utf-8")
        print(target)


if __name__ == "__main__":
    main(sys.argv[1:])
