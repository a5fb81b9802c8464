"""A model as a functional mock-up unit that starts where `mechanics.simulate` does."""

from collections.abc import Mapping
from pathlib import Path

from mechanics.compiled import Model
from mechanics.errors import InputError, wanted
from mechanics.export.fmu import Start, write_unit
from mechanics.scene.actions import frictions
from mechanics.simulate.domain import own_values
from mechanics.simulate.exits import at_the_start
from mechanics.simulate.run import begin


def write_fmu(
    model: Model,
    path: str | Path,
    *,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, float] | None = None,
    step: float | None = None,
    beyond_domain: bool = False,
    prove: bool = True,
) -> Path:
    """Write a model as a unit of FMI 3.0, for model exchange and co-simulation.

    Its states are the coordinates and speeds, dependent ones of a constrained scene included: the
    multipliers are solved for, and an output tells how far each constraint is off.

    Parameters
    ----------
    model : Model
        With a compiler the unit has the library for this machine, compiled with the model's flags;
        the sources are always in it.
    path : str or Path
        ``NAME.fmu``; replaced when everything is proved.
    initial, parameters, inputs : mapping of str to float, optional
        Start values of the unit, read as by `mechanics.simulate`: those of a constrained scene are
        made consistent. All can be set in the importer, too.
    step : float, optional
        Longest internal step of co-simulation, in s; by default it is chosen so that a step errs by
        less than 1e-10 along the motion from the start values. The importer can set it.
    beyond_domain : bool
        Whether to go on where a condition of validity of the scene does not hold; otherwise the
        unit asks the importer to end the simulation there, and says why.
    prove : bool
        Whether graphs are compared with what was derived, and the C text with the graphs, before
        the unit is written.

    Returns
    -------
    Path

    Raises
    ------
    InputError
        For a name that does not exist, a value that is out of range, start values outside of the
        model's domain, a path that is no .fmu, or a platform that FMI does not name.
    ValueMissingError
        For a parameter that has no value.
    CompilerError
        If the compiler refuses the code.
    RefutedError
        If something is REFUTED: nothing is written then.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> model = compile(rod_pendulum.scene(), compiler=None)
    >>> write_fmu(model, "pendulum.fmu", inputs={"u": 0}).name
    'pendulum.fmu'
    """
    wanted(model, Model, "write_fmu", "pass compile(derive(scene, route))")
    start = unit_start(model, initial, parameters, inputs, step, beyond_domain)
    write_unit(model, path, start, model.compiler, prove)
    return Path(path)


def unit_start(
    model: Model,
    initial: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, float] | None = None,
    step: float | None = None,
    beyond_domain: bool = False,
) -> Start:
    """Where a unit starts; arguments and errors as for `write_fmu`."""
    for name, value in (inputs or {}).items():
        if callable(value):
            raise InputError(
                f"input {name}: a function cannot be exported: give a number, and connect"
                " the function in the importer"
            )
    scene = model.equations.scene
    if frictions(scene) and not beyond_domain:
        raise InputError(
            f"{scene.name}: load {frictions(scene)[0].name} is friction while something slides,"
            " and a unit does not watch where that ends: accept it by --beyond-domain, or"
            " beyond_domain=True"
        )
    start = begin(model, initial, parameters, inputs)
    at_the_start(scene.name, start.domain, start.state, beyond_domain)
    known = model.quantities
    names = [entry.name for entry in (*known.q, *known.u, *known.p)]
    values = dict(zip(names, [*start.state.tolist(), *start.p.tolist()], strict=True))
    values |= {s.name: value for s, value in own_values(model, parameters or {}).items()}
    values |= {name: float(value) for name, value in (inputs or {}).items()}
    return Start(values, step, beyond_domain)
