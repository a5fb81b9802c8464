"""A class as one self-contained page, and as a table of comma-separated values."""

import csv
import io
from collections.abc import Sequence

from mechanics.grading.group import Group
from mechanics.report.environment import environment

COLUMNS = ("submission", "verdict", "score", "statements", "right", "missing", "change", "hint")


def group_html(found: Group, links: Sequence[str] = ()) -> str:
    """The page of a class.

    Parameters
    ----------
    links : sequence of str
        Where the page of each submission is, where there is one.
    """
    template = environment().get_template("grading.html")
    return template.render(found=found, scene=found.scene, links=links)


def group_csv(found: Group) -> str:
    """One line for each submission; what begins like a formula of a spreadsheet is quoted."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for one in found.grades:
        right = sum(line.verdict in ("PROVED", "CERTIFIED") for line in one.lines)
        score = "" if one.score is None else f"{one.score:.3f}"
        row = (
            one.name,
            one.verdict,
            score,
            len(one.lines),
            right,
            one.missing,
            one.change,
            one.hint,
        )
        writer.writerow([_harmless(str(entry)) for entry in row])
    return text.getvalue()


def _harmless(entry: str) -> str:
    return f"'{entry}" if entry[:1] in ("=", "+", "-", "@", "\t") else entry
