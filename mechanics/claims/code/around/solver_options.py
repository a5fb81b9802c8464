"""What a solver is told beside the law: options that leave the motion as it is, and others.

odeset('RelTol', 1e-8)                  how exactly it solves
odeset(key, M), ode45(f, s, y, opts)    anything, where nothing here says what key and opts are
solve(prob, Tsit5(), callback=bounce)   another motion, unless the file says what bounce is
solve(prob, FunctionMap())              no flow of the rates
"""

import re
from collections.abc import Iterator

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import root_of
from mechanics.claims.code.around.run import Run

MATLAB_OPTIONS = frozenset(
    ("reltol", "abstol", "maxstep", "initialstep", "minstep", "outputfcn", "outputsel", "stats",
     "refine", "events", "normcontrol", "bdf", "maxorder", "jpattern", "vectorized")
)  # fmt: skip
JULIA_OPTIONS = frozenset(
    ("reltol", "abstol", "saveat", "dt", "dtmax", "dtmin", "adaptive", "dense", "save_everystep",
     "save_start", "save_end", "save_on", "save_idxs", "maxiters", "tstops", "progress", "verbose",
     "u0", "tspan", "syms", "sensealg", "alg_hints", "force_dtmin", "progress_steps",
     "trajectories", "jac", "jac_prototype")
)  # fmt: skip
"""Options that leave the law as it is; an event's function is looked at itself."""
ALGORITHM = re.compile(
    r"(?!.*Map)[A-Z]\w*\d+[A-Z]*|(Implicit|Symplectic)?Euler|(Implicit)?Midpoint|Heun|Ralston"
    r"|Trapezoid|[QF]?NDF|FBDF|CVODE_\w+|ARKODE|VCABM|\w*Verlet\w*|\w*RK\w*|Rosenbrock\w*|IDA"
    r"|CompositeAlgorithm|AutoSwitch|DefaultODEAlgorithm|lsoda|radau\d*|rodas|seulex|odex|ddeabm"
    r"|NewtonRaphson|TrustRegion|DynamicSS|SSRootfind|LevenbergMarquardt|Ensemble\w+"
)
"""What follows the rates in time, or looks for where they vanish."""
CALLBACKS = re.compile(r"(VectorContinuous|Continuous|Discrete|PresetTime|Periodic|Saving)Callback"
                       r"|CallbackSet|TerminateSteadyState|SavedValues")  # fmt: skip
RUNS = frozenset(("solve", "init"))
MADE_BY_NAME = frozenset(("odeset", "optimset", "optimoptions"))


def is_solver_told_more(run: Run, call: Term) -> bool:
    """Whether a call of a solver, or of what keeps its options, may tell it another motion.

    Parameters
    ----------
    call : Term
    """
    if run.language.name == "MATLAB":
        return _is_matlab_told_more(run, call)
    if run.language.name != "Julia":
        return False
    if call.name in RUNS and any(not _is_plain(run, p) for p in given_by_place(call)[1:]):
        return True
    return any(not is_option(run, one) for one in given_by_name(call))


def _is_matlab_told_more(run: Run, call: Term) -> bool:
    if call.name == "odeset":
        odd = len(call.parts) % 2
        names = [p.text for p in call.parts[odd::2]]
        known = all(n[:1] in "'\"" and n.strip("'\"").lower() in MATLAB_OPTIONS for n in names)
        return not known or not all(_holds_options(run, p) for p in call.parts[:odd])
    if not call.name.startswith("ode"):
        return False
    return not all(_holds_options(run, p) for p in call.parts[3:4])


def _holds_options(run: Run, part: Term) -> bool:
    """Whether it is `[]`, or what `odeset` and fields of a record of options make."""
    if part.name in MADE_BY_NAME or (part.kind == "list" and not part.parts):
        return True
    lines = run.definitions.get(part.name, ()) if part.kind == "name" else ()
    return bool(lines) and all(_sets_options(run, line) for line in lines)


def _sets_options(run: Run, line: Term) -> bool:
    target, value = line.parts
    if target.kind == "field":
        return target.name.lower() in MATLAB_OPTIONS
    itself = target.name == value.name and value.kind == "name"
    return target.kind == "name" and not itself and (
        _holds_options(run, value) or (value.kind == "call" and value.name == "struct")
    )  # fmt: skip


def given_by_place(call: Term) -> list[Term]:
    """Arguments of a call that have no name."""
    return [p for p in call.parts if p.kind != "set"]


def given_by_name(call: Term) -> Iterator[Term]:
    """What a call gives by name, after a semicolon, too."""
    for part in call.parts:
        inner = part.parts if part.kind in ("block", "other") else (part,)
        yield from (one for one in inner if one.kind == "set")


def is_option(run: Run, one: Term) -> bool:
    """Whether an option of a solver in Julia leaves the law as it is; parameters do if in order.

    Parameters
    ----------
    one : Term
        ``name=value``.
    """
    name, value = one.parts[0].name, one.parts[1]
    if name == "callback":
        return _is_known_callback(run, value)
    return name in JULIA_OPTIONS or name == "p"


def _is_known_callback(run: Run, value: Term) -> bool:
    """Whether the file says what a callback does: functions of it are looked at themselves."""
    if value.kind == "name":
        if value.name in run.own:
            return not _changes_motion(run.own[value.name].body)
        if value.name in ("nothing", "terminate"):
            return True
        lines = run.definitions.get(value.name, ())
        return bool(lines) and all(
            line.parts[1].kind != "name" and _is_known_callback(run, line.parts[1])
            for line in lines
        )
    if value.kind == "call":
        known = CALLBACKS.fullmatch(value.name.rpartition(".")[2]) or value.name in run.own
        return bool(known) and all(_is_known_callback(run, p) for p in given_by_place(value))
    if value.kind == "list":
        return all(_is_known_callback(run, part) for part in value.parts)
    return value.kind in ("number", "minus", "range") or (
        value.kind == "handle" and not _changes_motion(value)
    )


SETTERS = frozenset(
    ("set_u", "set_t", "set_p", "set_ut", "reinit", "copyto", "fill", "setindex", "setproperty")
)


def _changes_motion(body: Term) -> bool:
    """Whether a callback sets what a solver integrates: i.u[2] *= -1, set_u!(i, u)."""
    parts = [*body.all()]
    targets = [one.parts[0] for one in parts if one.kind == "set"]
    held = {
        part.name.rpartition(".")[2] for target in targets if target.kind != "name"
        for part in target.all() if part.kind in ("field", "name")
    }  # fmt: skip
    calls = {one.name.rstrip("!") for one in parts if one.kind == "call"}
    return bool({"u", "p", "t"} & held) or bool(SETTERS & calls)


def _is_plain(run: Run, part: Term) -> bool:
    """Whether an argument after the problem is an algorithm, or a known option without a value."""
    if part.kind in ("block", "other") and part.text.endswith("..."):
        return all(_is_spread(run, one) for one in part.parts)
    if part.kind == "other":
        return all(one.kind == "set" for one in part.parts)  # an option has a look of its own
    if part.kind == "call":
        own = part.name.rpartition(".")[2]
        return bool(ALGORITHM.fullmatch(own)) or part.name in run.own
    if part.kind != "name" or part.name in JULIA_OPTIONS or part.name == "nothing":
        return part.kind == "name"
    made = [line.parts[1] for line in run.definitions.get(part.name, ())]
    return bool(made) and all(one.kind == "call" and _is_plain(run, one) for one in made)


def _is_spread(run: Run, one: Term) -> bool:
    """Whether what is spread into options holds known ones only."""
    lines = run.definitions.get(root_of(one), ())
    return bool(lines) and one.kind == "name" and all(
        line.parts[1].kind == "list"
        and all(p.kind == "set" and is_option(run, p) for p in line.parts[1].parts)
        for line in lines
    )  # fmt: skip
