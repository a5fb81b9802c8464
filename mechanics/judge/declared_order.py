r"""Places that a text counts in an order of its own: q = (theta, x)^T beside M_{11} and p_1.

M_11, p_1 and Q_1 are read by the order that the scene has. Where the text gives another one they
are not, and nothing is said of them.
"""

import re
from dataclasses import replace

from mechanics.claims.claim import Written
from mechanics.claims.names import Naming
from mechanics.judge.words_beside import written_or_comments
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene
from mechanics.scene.quantities import MassMatrix

COLUMN = re.compile(
    r"(?<![A-Za-z])\\?(?:(?:mathbf|boldsymbol|bm|vec)\s*\{?\s*)?q\s*\}?\s*(?:=|:=|\\equiv)\s*(?:&\s*)?"
    r"(?:\\left\s*)?(?:\(|\[|\\begin\s*\{[a-zA-Z]*(?:matrix|array)\*?\}(?:\{[^{}]*\})?)"
    r"(?P<entries>[^=$]{1,200}?)(?:\\right\s*)?(?:\)|\]|\\end\s*\{)",
    re.DOTALL,
)
NUMBERED = re.compile(
    r"(?<![A-Za-z])q_\{?(?P<place>\d)\}?\s*=\s*(?P<name>\\?[A-Za-z]\w*(?:_\{\w+\})?)"
)
APART = re.compile(r",|;|&|\\\\|\s\|\s")
BY_PLACE = re.compile(r"\s*\\?(?:[MDHBCGQp]|tau|pi|Gamma)\s*_\s*\{?\s*\d")
"""What a statement by place begins with."""


def in_declared_order(scene: Scene, entry: Judged) -> Judged:
    """The entry; undecided where it is of a place, and its text has another order.

    Parameters
    ----------
    scene : Scene
    entry : Judged
    """
    written = written_or_comments(scene, entry.statement)
    decided = entry.finding.shown or entry.verdict is Verdict.REFUTED
    row = entry.statement.row
    if written is None or not decided or row is None:
        return entry
    by_place = BY_PLACE.match(written.text, written.start) is not None
    if not (by_place or isinstance(row.quantity, MassMatrix)):
        return entry
    order = _order(written)
    if not order or order == [q.name for q in scene.q][: len(order)]:
        return entry
    doubt = f"the text counts the coordinates in the order {', '.join(order)}, which is not used"
    return replace(entry, finding=undecided(entry.finding.subject, doubt), right_if=())


def _order(written: Written) -> list[str]:
    """Coordinates in the order of a text; empty where it gives none."""
    for one in COLUMN.finditer(written.text):
        found = [_coordinate(part, written.naming) for part in APART.split(one["entries"])]
        if found and all(found):
            return found
    places = {
        int(one["place"]): _coordinate(one["name"], written.naming)
        for one in NUMBERED.finditer(written.text)
    }
    if places and all(places.values()) and [*sorted(places)] == [*range(1, len(places) + 1)]:
        return [places[k] for k in sorted(places)]
    return []


def _coordinate(text: str, naming: Naming) -> str:
    name = re.sub(r"[\\{}\s]|\(t\)", "", text).removeprefix("mathrm")
    found = naming.lookup(name)
    names = {q.name for q in naming.vocabulary.scene.q}
    return found[0] if found is not None and not found[1] and found[0] in names else ""
