"""Chromium, as tests of pages call it: what it shows, and what it prints.

A page is shown in a frame of a given width; a script of the test, outside of the frame, measures it
and writes what it found into the document that Chromium prints.
"""

import json
import os
import re
import shutil
import subprocess
import zlib
from dataclasses import dataclass
from html import escape, unescape
from pathlib import Path
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
OPTIONS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-sync",
    "--disable-component-update",
    "--no-first-run",
    "--enable-logging=stderr",
    "--v=0",
    "--virtual-time-budget=20000",
    # Names of hosts lead nowhere; what the page asks for is seen all the same.
    "--host-resolver-rules=MAP * ~NOTFOUND",
)


@dataclass(frozen=True)
class Sight:
    """What Chromium found: measurements, and the lines of its console."""

    found: dict[str, Any]
    console: list[str]


@dataclass(frozen=True)
class Sheet:
    """A printed page: how many pieces of text it has, and how many of them are light."""

    texts: int
    light: int


def chromium() -> str:
    """Path of a browser; without one the test is skipped, except in CI, where it fails."""
    for name in NAMES:
        path = shutil.which(name)
        if path:
            return path
    if os.environ.get("MECHANICS_CI"):
        pytest.fail("Chromium is missing: install Debian's package chromium")
    pytest.skip("Chromium is not installed")


def look(page: str, folder: Path, width: int, dark: bool, script: str) -> Sight:
    """Show a page in a frame of that width, and measure it by a script."""
    wrapper = folder / "wrapper.html"
    wrapper.write_text(
        '<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">'
        f'<pre id="found"></pre><script>{script}</script>'
        f'<iframe style="width:{width}px;height:900px;border:0" srcdoc="{escape(page)}"></iframe>',
        encoding="utf-8",
    )
    done = _run(folder, dark, "--dump-dom", "--window-size=1400,1000", wrapper.as_uri())
    text = re.search(r'<pre id="found">(.*?)</pre>', done.stdout, re.DOTALL)
    assert text is not None, done.stderr[-2000:]
    console = [line for line in done.stderr.splitlines() if ":CONSOLE" in line]
    return Sight(json.loads(unescape(text[1])), console)


def printed(page: str, folder: Path, dark: bool) -> list[Sheet]:
    """Print a page."""
    source, target = folder / "page.html", folder / "page.pdf"
    source.write_text(page, encoding="utf-8")
    _run(folder, dark, f"--print-to-pdf={target}", "--no-pdf-header-footer", source.as_uri())
    return [_sheet(text) for text in _contents(target.read_bytes())]


def _run(folder: Path, dark: bool, *arguments: str) -> subprocess.CompletedProcess[str]:
    scheme = f"--blink-settings=preferredColorScheme={0 if dark else 1}"
    command = [chromium(), *OPTIONS, f"--user-data-dir={folder / 'profile'}", scheme, *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)


def _contents(pdf: bytes) -> list[bytes]:
    """What is drawn on each page, as the operators of PDF."""
    objects = dict(re.findall(rb"^(\d+) 0 obj\n(.*?)\nendobj", pdf, re.DOTALL | re.MULTILINE))
    pages = [body for body in objects.values() if re.search(rb"/Type\s*/Page\b", body)]
    numbers = [n for body in pages for n in re.findall(rb"/Contents (\d+) 0 R", body)]
    return [_unpacked(*objects[number].split(b"stream\n", 1)) for number in numbers]


def _unpacked(about: bytes, stream: bytes) -> bytes:
    return zlib.decompress(stream) if b"FlateDecode" in about else stream


def _sheet(drawn: bytes) -> Sheet:
    texts = light = 0
    bright = False
    for colour, shown in re.findall(rb"([\d.]+ [\d.]+ [\d.]+) rg|(T[jJ])\b", drawn):
        if shown:
            texts, light = texts + 1, light + bright
        else:
            bright = sum(map(float, colour.split())) / 3 > 0.55
    return Sheet(texts, light)
