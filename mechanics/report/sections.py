"""What a section of the report shows of one system, taken from its result."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup
from sympy import Symbol

from mechanics.compiled.quantities import angles as angle_names
from mechanics.equations import Equations, Line, Step
from mechanics.kernel import Finding, Verdict
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.report import typeset
from mechanics.report.charts import Chart
from mechanics.report.coordinates import coordinate_words
from mechanics.report.free_body import arrows, free_body_diagram, marks
from mechanics.report.projection import View
from mechanics.report.result import LedgerResult, RouteResult, SystemResult
from mechanics.routes.multipliers import meaning_words, multipliers_of
from mechanics.routes.steps.form import has_common_form
from mechanics.routes.steps.writer import FULL
from mechanics.scene import Scene
from mechanics.scene.linear_quantities import LinearizedEquation
from mechanics.scene.quantities import EquationOfMotion, ReactionValue

ROUTES = {
    "free_body": "Free bodies",
    "moving_point": "Moving point",
    "kane": "Kane",
    "kane_sympy": "Kane by SymPy",
    "lagrange": "Lagrange",
    "lagrange_sympy": "Lagrange by SymPy",
}


@dataclass(frozen=True)
class SymbolRow:
    """A symbol of the scene, for the table beside the drawing."""

    name: str
    meaning: str
    value: str


@dataclass(frozen=True)
class Speed:
    """What a route took, and its shares of the longest and the largest."""

    route: str
    result: RouteResult
    time_share: float
    size_share: float


@dataclass(frozen=True)
class PublishedRow:
    """A row of the ledger with its sides typeset, and where it stands on the page."""

    anchor: str
    entry: LedgerResult
    equation: Markup


@dataclass(frozen=True)
class OpenRow:
    """What is neither proved nor certified, and where on the page it stands."""

    anchor: str
    tag: str
    words: str
    verdict: Verdict


@dataclass(frozen=True)
class ResidualRow:
    """One equation and precision: the largest residual of each route, None where not measured."""

    statement: str
    values: list[float | None]
    states: int


@dataclass(frozen=True)
class ShownStep:
    """A step of a derivation with its free-body diagrams: titles and drawings."""

    step: Step
    figures: tuple[tuple[str, Markup], ...]


@dataclass(frozen=True)
class Derivation:
    """How one route derives."""

    route: str
    steps: tuple[ShownStep, ...]


@dataclass(frozen=True)
class Section:
    """Everything that the page shows of one system."""

    number: int
    result: SystemResult
    tally: list[tuple[Verdict, int]]
    drawing: Markup
    coordinates: list[tuple[tuple[str, ...], Markup]]
    derivations: list[Derivation]
    marks: list[str]
    motions: list[LedgerResult]
    symbols: list[SymbolRow]
    matrix: list[tuple[str, list[Finding | None]]]
    speeds: list[Speed]
    reactions: list[tuple[str, list[Line]]]
    published: list[PublishedRow]
    open: list[OpenRow]
    doubtful: list[Finding]
    others: list[Finding]
    witnesses: list[Finding]
    residuals: list[ResidualRow]
    moving: tuple[str, Markup] | None
    swings: list[list[tuple[str, Markup]]]
    charts: list[Chart]

    @property
    def common(self) -> bool:
        """Whether states and inputs are parted in the equations on top."""
        return has_common_form(self.result.scene)

    @property
    def multipliers(self) -> str:
        """What the multipliers in the equations on top are, as a sentence."""
        terms = (line.right for line in self.result.form if isinstance(line.right, tuple))
        shown = {s.name for side in terms for term in side for s in term.value.free_symbols}
        formula = "$<<{name}>> = {sign}<<{reaction}>>$"
        said = meaning_words(lower(self.result.scene, Builder()), shown, formula)
        return f"Here {'; '.join(said)}." if said else ""

    @property
    def alike(self) -> Verdict | None:
        """The verdict on all pairs, where they have one and need no look."""
        verdicts = {finding.verdict for finding in self.result.pairs.values()}
        shown = all(finding.shown for finding in self.result.pairs.values())
        return verdicts.pop() if len(verdicts) == 1 and shown else None

    @property
    def long(self) -> bool:
        """Whether routes are folded until they are asked for."""
        return len(self.result.scene.u) > FULL

    @property
    def chapters(self) -> dict[str, str]:
        """Headings by their ids, of what there is."""
        result = self.result
        modes = result.modes[0].title if result.modes else ""
        found = {
            "form": ("Equations of motion", result.form),
            "motion": ("A motion", self.charts),
            "derivations": ("Derivations", self.derivations),
            "agreement": ("Do the routes agree?", result.pairs),
            "published": ("Published equations", self.published),
            "reactions": ("Reactions as functions of the state", self.reactions),
            "others": ("Other checks", self.others or self.doubtful or self.witnesses),
            "compiled": ("Compiled functions", result.compiled),
            "modes": (modes, result.modes),
            "timings": ("Timings", self.speeds),
            "remarks": ("Remarks", result.remarks),
        }
        return {key: title for key, (title, there) in found.items() if there}


def shown_state(result: SystemResult) -> dict[str, float]:
    """The first sample of the motion, else the example of the scene."""
    state = dict(result.scene.example)
    if result.motion is not None:
        columns = result.motion.columns
        state |= {q.name: float(columns[q.name][0]) for q in result.scene.q if q.name in columns}
    return state


def derivations(
    result: SystemResult, state: Mapping[str, float]
) -> tuple[list[Derivation], list[str]]:
    """The routes step by step, and the classes of the loads and reactions that are drawn."""
    found: list[Derivation] = []
    classes: dict[str, None] = {}
    view = View(result.scene, state)
    for name, route in result.routes.items():
        if route.steps:
            steps, own = shown_steps(route.equations, route.steps, view)
            found.append(Derivation(name, steps))
            classes |= own
    return found, list(classes)


def shown_steps(
    equations: Equations | None, steps: Sequence[Step], view: View
) -> tuple[tuple[ShownStep, ...], Mapping[str, None]]:
    """Steps with their drawings, and the classes of what is drawn."""
    if equations is None or not any(step.diagrams for step in steps):
        return tuple(ShownStep(step, ()) for step in steps), {}
    acting = arrows(equations, view)
    shown = tuple(
        ShownStep(
            step,
            tuple(
                (d.title, Markup(free_body_diagram(equations, view, acting, d)))
                for d in step.diagrams
            ),
        )
        for step in steps
    )
    return shown, marks(acting)


def motion_rows(result: SystemResult) -> list[LedgerResult]:
    """Published equations of motion, or where there are none linearized ones, each once."""
    kinds = (EquationOfMotion, LinearizedEquation)
    rows: list[LedgerResult] = []
    for kind in kinds:
        rows = rows or [e for e in result.published if isinstance(e.row.quantity, kind)]
    return list({typeset.published(entry.row): entry for entry in reversed(rows)}.values())[::-1]


def symbol_rows(scene: Scene, state: Mapping[str, float]) -> list[SymbolRow]:
    """Coordinates at a state, declared speeds, inputs and parameters."""
    turning, view = angles(scene), View(scene, state)
    rows = [
        SymbolRow(
            q.name,
            coordinate_words(view, q),
            _quantity(f"{state.get(q.name, 0.0):.4g}", unit_of(scene, turning, q)),
        )
        for q in scene.q
    ]
    if scene.speeds:
        rows += [SymbolRow(u.name, "speed", "") for u in scene.u]
    rows += [SymbolRow(f.name, "input, a given function of time", "") for f in scene.input_symbols]
    values = view.values
    for parameter in scene.parameters:
        unit = readable_unit(getattr(parameter, "unit", ""))
        known = parameter in scene.definitions or getattr(parameter, "typical", None) is not None
        value = f"{values[parameter]:.4g}" if known else ""
        meaning = getattr(parameter, "meaning", "") or "parameter"
        rows.append(SymbolRow(parameter.name, meaning, _quantity(value, unit)))
    return rows


def _quantity(value: str, unit: str) -> str:
    """A number that no line parts from its unit."""
    return f"{value}\u00a0{unit}".strip().replace("-", "\u2212")


def readable_unit(unit: str) -> str:
    """A unit with middle dots and raised powers: kg*m^2 gives kg·m²."""
    for plain, raised in (("^2", "²"), ("^3", "³"), ("^4", "⁴"), ("*", "·")):
        unit = unit.replace(plain, raised)
    return "" if unit == "1" else unit


def angles(scene: Scene) -> set[Symbol]:
    """Coordinates that are angles, as the compiled functions have them."""
    names = angle_names(lower(scene, Builder()))
    return {q for q in scene.q if q.name in names} - scene.quaternions


def unit_of(scene: Scene, turning: set[Symbol], coordinate: Symbol) -> str:
    """The unit of a coordinate, where none is declared."""
    if coordinate in scene.quaternions:
        return ""
    return "rad" if coordinate in turning else "m"


def matrix(result: SystemResult) -> list[tuple[str, list[Finding | None]]]:
    """For each route its findings against every route; None for itself and where there is none."""
    names = [name for name, column in result.columns.items() if not column.absent]
    both = {**result.pairs, **{(b, a): finding for (a, b), finding in result.pairs.items()}}
    return [(row, [both.get((row, column)) for column in names]) for row in names]


def speeds(result: SystemResult) -> list[Speed]:
    """Time and size of each route beside the others."""
    columns = result.columns
    longest = max((route.seconds for route in columns.values()), default=0) or 1.0
    largest = max((route.operations for route in columns.values()), default=0) or 1
    return [
        Speed(name, route, route.seconds / longest, route.operations / largest)
        for name, route in columns.items()
    ]


def reactions(result: SystemResult) -> list[tuple[str, list[Line]]]:
    """Reactions as functions of the state, by the routes that have them.

    Those that maintain constraints come first: the others hold them.
    """
    declared = {reaction.symbol for reaction in result.scene.reactions}
    found = []
    for name, route in result.routes.items():
        equations = route.equations
        if equations is None:
            continue
        # The steps by free bodies solve for them in front of the reader.
        values = [] if route.steps and name == "free_body" else list(equations.reactions)
        if equations.multipliers and declared.issuperset(equations.multipliers):
            values = [*multipliers_of(equations), *values]
        if values:
            found.append((name, [Line(symbol, value) for symbol, value in values]))
    return found


def published_rows(result: SystemResult, number: int) -> list[PublishedRow]:
    """The ledger, typeset; a reaction that is published as a value has its name before it."""
    found = []
    for i, entry in enumerate(result.published):
        row, sides = entry.row, entry.row.sides
        if isinstance(row.quantity, ReactionValue) and len(sides) == 1:
            row = replace(row, sides=(Symbol(row.quantity.name), *sides))
        anchor = f"row-{number}-{i + 1}"
        found.append(PublishedRow(anchor, entry, typeset.published(row)))
    return found


def open_rows(result: SystemResult, number: int) -> list[OpenRow]:
    """What a reader has to look at: published rows that do not stand, then other statements."""
    rows = [
        OpenRow(row.anchor, row.entry.row.tag, row.entry.row.label, row.entry.finding.verdict)
        for row in published_rows(result, number)
        if not row.entry.finding.shown
    ]
    published = {id(entry.finding) for entry in result.published}
    others = [finding for finding in result.open if id(finding) not in published]
    pairs = {id(finding) for finding in result.pairs.values()}
    for finding in others:
        place = "pairs" if id(finding) in pairs else "others"
        words = finding.subject.replace("_", " ")
        rows.append(OpenRow(f"{place}-{number}", "", words, finding.verdict))
    return rows


def other_findings(result: SystemResult) -> list[Finding]:
    """Findings that do not stand in the matrix, in their order."""
    shown = {id(finding) for finding in result.pairs.values()}
    return [finding for finding in result.findings if id(finding) not in shown]


def residual_rows(result: SystemResult) -> list[ResidualRow]:
    """Residuals of compiled functions, the routes side by side.

    The subject of a residual starts with its route; what does not stands in every column alike.
    """
    groups: dict[tuple[str, int], dict[str, float]] = {}
    for entry in result.compiled:
        route, _, statement = entry.subject.partition(": ")
        if route in result.routes:
            groups.setdefault((statement, entry.states), {})[route] = entry.max_eps
        else:
            alike = dict.fromkeys(result.routes, entry.max_eps)
            groups.setdefault((entry.subject, entry.states), {}).update(alike)
    return [
        ResidualRow(statement, [found.get(route) for route in result.routes], states)
        for (statement, states), found in groups.items()
    ]
