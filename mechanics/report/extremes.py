"""The map of a walk to the extremes as one self-contained HTML page."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from math import log2

from markupsafe import Markup

from mechanics.compiled import FORMS
from mechanics.extremes import CAUSES, Extremes, Reach, Visited
from mechanics.extremes.cause import Cause
from mechanics.extremes.result import PRECISIONS, STABLE
from mechanics.report.environment import environment
from mechanics.report.extremes_map import LEGEND, heat_map, sample, strip, unit_text, value_label

MAPS = 4


@dataclass(frozen=True)
class FormRow:
    """What one form did at all points."""

    name: str
    meaning: str
    default: bool
    worst: dict[str, float]
    shares: dict[str, list[tuple[Cause, int]]]


@dataclass(frozen=True)
class Strip:
    """How far one quantity goes in one precision."""

    reach: Reach
    picture: Markup


@dataclass(frozen=True)
class Figure:
    """One heat map with its caption."""

    form: str
    precision: str
    picture: Markup


@dataclass(frozen=True)
class PathRow:
    """One path: label, values, and figures of the default form."""

    label: str
    rows: list[tuple[str, float, float, float, Cause]]


@dataclass(frozen=True)
class Chapter:
    """One system."""

    number: int
    found: Extremes
    forms: list[FormRow]
    strips: list[tuple[Strip, Strip]]
    maps: list[tuple[str, list[Figure]]]
    paths: list[PathRow]

    @property
    def worst(self) -> dict[str, float]:
        """Largest backward error of the default form, by precision."""
        return next(row.worst for row in self.forms if row.default)

    @property
    def limits(self) -> list[Reach]:
        """Quantities whose range ends before the numbers do, in double precision."""
        reaches = [double.reach for double, _ in self.strips]
        return [r for r in reaches if {r.below.cause, r.above.cause} != {Cause.ACCURATE}]


def extremes_html(results: Sequence[Extremes]) -> str:
    """The report of walks to the extremes.

    Parameters
    ----------
    results : sequence of Extremes

    Returns
    -------
    str
        A whole page.
    """
    made = environment()
    made.globals.update(
        Cause=Cause,
        PRECISIONS=PRECISIONS,
        STABLE=STABLE,
        unit=lambda text: Markup(unit_text(text)),
        value=lambda number, unit: Markup(_html_value(number, unit)),
        legend=[(Markup(sample(name, letter)), text) for name, letter, text in LEGEND],
    )
    chapters = [_chapter(n, found) for n, found in enumerate(results, start=1)]
    return made.get_template("extremes.html").render(chapters=chapters)


def _html_value(number: float, unit: str) -> str:
    text = value_label(number, unit)
    return text.replace('<tspan class="power" dy="-.4em">', "<sup>").replace("</tspan>", "</sup>")


def _chapter(number: int, found: Extremes) -> Chapter:
    return Chapter(
        number=number,
        found=found,
        forms=[_form(found, form) for form in found.forms],
        strips=_strips(found),
        maps=[_maps(found, visited) for visited in telling(found, MAPS)],
        paths=[_path(found, visited) for visited in found.visited if visited.walk.kind == "path"],
    )


def _form(found: Extremes, form: str) -> FormRow:
    meaning = {known.name: known.meaning for known in FORMS}[form]
    shares = {}
    for precision in PRECISIONS:
        counts: Counter[int] = Counter()
        for visited in found.visited:
            counts.update(visited.figure(form, precision).causes.tolist())
        shares[precision] = [(cause, counts[i]) for i, cause in enumerate(CAUSES) if counts[i]]
    worst = {precision: found.worst(form, precision) for precision in PRECISIONS}
    return FormRow(form, meaning, form == found.default, worst, shares)


def _strips(found: Extremes) -> list[tuple[Strip, Strip]]:
    lines = {v.walk.names[0]: v for v in found.visited if v.walk.kind == "line"}
    rows = []
    for name, visited in lines.items():
        made = []
        for precision in PRECISIONS:
            reach = next(
                r for r in found.reaches
                if (r.name, r.form, r.precision) == (name, found.default, precision)
            )  # fmt: skip
            title = f"{name}, {precision} precision, from 1e-308 to 1e308"
            figures = visited.figure(found.default, precision)
            made.append(Strip(reach, Markup(strip(title, visited.walk.values[0], figures))))
        rows.append((made[0], made[1]))
    return rows


def telling(found: Extremes, count: int) -> list[Visited]:
    """The pairs whose maps tell most: many causes, and forms that differ.

    No quantity is in more than two of them, so that all are seen.
    """
    pairs = [v for v in found.visited if v.walk.kind == "pair"]
    pairs.sort(key=lambda v: -_told(found, v))
    chosen: list[Visited] = []
    uses: Counter[str] = Counter()
    for visited in pairs:
        if len(chosen) < count and all(uses[name] < 2 for name in visited.walk.names):
            chosen.append(visited)
            uses.update(visited.walk.names)
    return chosen


def _told(found: Extremes, visited: Visited) -> float:
    """Entropy of the causes in both precisions, and where forms differ."""
    total = 2 * _difference(found, visited, other_form(found, visited))
    for precision in PRECISIONS:
        causes = visited.figure(found.default, precision).causes
        counts = Counter(causes[causes != CAUSES.index(Cause.INPUT)].tolist())
        shares = [n / counts.total() for n in counts.values()]
        total -= sum(share * log2(share) for share in shares)
    return total


def _difference(found: Extremes, visited: Visited, form: str) -> float:
    """Share of the points at which a form fares differently from the default."""
    default, other = (visited.figure(f, "double").causes for f in (found.default, form))
    return float((default != other).mean())


def other_form(found: Extremes, visited: Visited) -> str:
    """The form whose map differs most from that of the default one."""
    return max(found.forms, key=lambda form: _difference(found, visited, form))


def _maps(found: Extremes, visited: Visited) -> tuple[str, list[Figure]]:
    walk = visited.walk
    units = [next(a.unit for a in found.axes if a.name == name) for name in walk.names]
    shown = [(found.default, "double")]
    if (other := other_form(found, visited)) != found.default:
        shown.append((other, "double"))
    shown.append((found.default, "single"))
    figures = []
    for form, precision in shown:
        title = f"{' and '.join(walk.names)}: form {form}, {precision} precision"
        picture = heat_map(title, walk.names, units, walk.values, visited.figure(form, precision))
        figures.append(Figure(form, precision, Markup(picture)))
    return " and ".join(walk.names), figures


def _path(found: Extremes, visited: Visited) -> PathRow:
    figures = visited.figure(found.default, "double")
    rows = [
        (f"{value:g}", figures.relative[i], figures.backward[i], visited.sensitivity[i],
         figures.cause(i))
        for i, value in enumerate(visited.walk.values[0])
    ]  # fmt: skip
    return PathRow(visited.walk.names[0], rows)
