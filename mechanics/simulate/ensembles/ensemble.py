"""Many motions at once: ``ensemble(model, duration, initial={...arrays...}) -> Ensemble``.

names and numbers --> Motions --> a method over lanes, in C --> Ensemble
                              --> the same in parts, by the workers of an executor
                              --> one motion after the other, where there is no compiler
"""

from collections.abc import Mapping
from concurrent.futures import Executor
from typing import Any

from numpy.typing import ArrayLike

from mechanics.compiled.model import Model
from mechanics.errors import InputError, wanted
from mechanics.simulate.ensembles.library import Library
from mechanics.simulate.ensembles.motions import Motions, read_motions
from mechanics.simulate.ensembles.one_by_one import one_by_one
from mechanics.simulate.ensembles.outcome import Ensemble
from mechanics.simulate.ensembles.parts import spread
from mechanics.simulate.ensembles.run import SOURCES, Method, Run, integrated, run_of
from mechanics.simulate.ensembles.settings import (
    AUTO,
    BUDGET,
    read_method,
    read_times,
    refuse_conditions,
    task_of,
    whole,
)


def ensemble(
    model: Model,
    duration: float,
    *,
    initial: Mapping[str, Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    inputs: Mapping[str, Any] | None = None,
    times: ArrayLike | None = None,
    tolerance: float | None = None,
    step: float | None = None,
    method: str = AUTO,
    threads: int = 1,
    budget: int = BUDGET,
    beyond_domain: bool = False,
    executor: Executor | None = None,
) -> Ensemble:
    """Integrate many motions from t = 0, several of them in every operation of the processor.

    Parameters
    ----------
    model : Model
        From `mechanics.compile`.
    duration : float
        In s.
    initial, parameters, inputs : mapping of str to float or array, shape (batch,)
        By plain name, as `mechanics.simulate` takes them. Arrays have one length, the number of
        motions; numbers are shared. What is not given is taken from the scene's example and the
        typical values; a parameter that is defined by others follows them.
    times : array, shape (N,), optional
        When states are wanted, in s: increasing from 0 to the duration. By default 0 and the end.
    tolerance : float
        For adaptive methods; 1e-9 unless a step is given. The error of one step, relative to each
        entry of the state, is kept below a thousandth of it, so that a thousand steps stay within
        it where the motion itself does not magnify errors. With ``method="dop853"`` it is the
        relative and absolute error of a step, as in SciPy.
    step : float
        For fixed steps: their length in s, shortened so that steps end at the times.
    method : str
        Adaptive: ``"taylor"`` (series of an order that suits the tolerance; for equations without
        comparisons, magnitudes and roundings) or ``"dop853"``. With fixed steps: ``"rk4"``,
        ``"rk5"``, ``"rk8"``. ``"auto"`` takes Taylor series where they exist and are the cheaper
        ones by counted operations, else DOP853; rk4 for a step.
    threads : int
        On how many processors; the result is the same to the last bit.
    budget : int
        Steps that may be tried for one motion.
    beyond_domain : bool
        In a scene with conditions of validity: that they are not watched has to be accepted.
    executor : concurrent.futures.Executor, optional
        Where parts of the motions are integrated: a ``ProcessPoolExecutor``, Dask's
        ``client.get_executor()``, an ``MPIPoolExecutor`` of mpi4py's. The result is the same to the
        last bit on processors and compilers of one kind. Workers need this package and a compiler.

    Returns
    -------
    Ensemble
        A motion that cannot be continued ends early, says why, and disturbs no other.

    Raises
    ------
    WrongKindError
        For what is no model.
    InputError
        For a name that does not exist, a value that is no number or out of range, arrays of
        different length, or initial values that no configuration satisfies.
    ValueMissingError
        For a parameter that has no value.
    ExpressionError
        If ``"taylor"`` is asked for and an operation has no series; it is named.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(rod_pendulum.scene())
    >>> motions = ensemble(model, 1.0, initial={"theta": [2.9, 3.0, 3.1]}, inputs={"u": 0})
    >>> motions.states.shape
    (3, 2, 2)
    """
    wanted(model, Model, "ensemble", "pass compile(equations)")
    grid = read_times(duration, times)
    by = read_method(method, tolerance, step, budget, grid)
    whole("threads", threads)
    if executor is not None and (threads != 1 or not hasattr(executor, "submit")):
        raise InputError(
            f"executor: {type(executor).__name__} found with {threads} threads: give an Executor of"
            " concurrent.futures, and leave threads to it"
        )
    scene = model.equations.scene
    refuse_conditions(model, beyond_domain)
    motions = read_motions(model, grid, initial or {}, parameters or {}, inputs or {})
    run = _run(motions, by, min(threads, max(1, len(motions))), executor)
    names = tuple(entry.name for entry in (*model.quantities.q, *model.quantities.u))
    return Ensemble(
        scene.name, grid, run.states, names, run.status, run.reached, run.steps, run.evaluations,
        run.method,
    )  # fmt: skip


def _run(motions: Motions, method: Method, threads: int, executor: Executor | None) -> Run:
    model = motions.model
    if executor is None and model.compiler is None:
        return one_by_one(motions, method)
    task, rows = task_of(model, method, motions.times), motions.rows
    if executor is not None:
        found = spread(executor, task, *rows)
    else:
        source = SOURCES[task.method.name]
        library = Library(task.held, task.moving, model.compiler or "", source)
        found = integrated(library, task.method, *rows, task.times, threads)
    return run_of(found, task.method, task.moving)
