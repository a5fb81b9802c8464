"""How the programs were written: the form of forward dynamics, and whether divisors are shared.

    scene  --form, reciprocals-->  forward dynamics  =  the program of the folder
    reciprocals      no program divides by one value twice
    no reciprocals   each program has the divisions of its graph

A manifest names both.
"""

from collections.abc import Iterator

from mechanics.compiled.forms import FORMS
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.programs.of_model import PARTS, WHOLE, Programs
from mechanics.compiled.programs.reciprocals import quotients
from mechanics.errors import InputError
from mechanics.export.evidence.read import Folder
from mechanics.export.folder import MANIFEST
from mechanics.kernel import Finding, refuted, same, undecided
from mechanics.program.routine import Routine

AUTO = "auto"
FORM, RECIPROCALS = f"{MANIFEST}: form", f"{MANIFEST}: reciprocals"


def prove_reciprocals(folder: Folder) -> Iterator[Finding]:
    """Decide whether divisors are shared as a manifest says."""
    stands = folder.manifest.get("reciprocals")
    if type(stands) is not bool:
        yield undecided(RECIPROCALS, f"refused: {str(stands)[:40]!r} is neither true nor false")
        return
    graphs = {name: g for name, g in folder.evidence.graphs.items() if name not in PARTS}
    others = [
        name
        for name, graph in graphs.items()
        if (
            max(quotients(graph.written).values(), default=0) > 1
            if stands
            else graph.written.divisions < graph.code.routine.divisions
        )
    ]
    if others:
        words = f"{stands} stands there, the program of {others[0]} was written otherwise"
        yield refuted(RECIPROCALS, words, str(stands), str(not stands))
    else:
        so = [name for name in graphs if name not in others]
        yield same(RECIPROCALS, list(graphs), so, "every program was written so")


def prove_form(folder: Folder, graphs: Graphs) -> Iterator[Finding]:
    """Decide about the form of forward dynamics that a manifest names.

    Parameters
    ----------
    graphs : Graphs
        Of the scene that was derived again, with what is fixed.
    """
    form, shared = (folder.manifest.get(key) for key in ("form", "reciprocals"))
    if WHOLE not in folder.evidence.graphs or graphs.reduced is not None:
        if form is not None:
            yield undecided(
                FORM, f"refused: there is no {WHOLE} of a form, and {str(form)[:40]!r} says how"
            )
        return
    if form not in [each.name for each in FORMS]:
        yield undecided(FORM, f"refused: there is no form {str(form)[:40]!r}")
        return
    written = folder.evidence.graphs[WHOLE].written
    # Numbers that are fixed may be put into a form afterwards, which only the search for one does.
    for asked in (form, AUTO):
        name, program = _program(graphs, asked, shared is not False)
        if program == written:
            words = f"it gives the program of {WHOLE}"
            other = f"{form} stands there, the program of {WHOLE} is that of {name}"
            yield (
                same(FORM, form, name, words) if name == form else refuted(FORM, other, form, name)
            )
            return
    yield undecided(FORM, f"refused: {form} does not give the program of {WHOLE}")


def _program(graphs: Graphs, form: str, shared: bool) -> tuple[str, Routine | None]:
    """Name of the form, and what it gives; nothing where it does not suit the equations."""
    try:
        made = Graphs(graphs.derived, form=form, fixed=graphs.fixed, outputs=(WHOLE,))
        return made.form, Programs(made, shared)[WHOLE]
    except InputError:
        return form, None
