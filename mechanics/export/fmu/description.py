"""modelDescription.xml and buildDescription.xml."""

from collections.abc import Iterable, Mapping, Sequence
from xml.etree import ElementTree as Xml

import casadi as ca

from mechanics.export.fmu.functions import Functions
from mechanics.export.fmu.units import base_powers
from mechanics.export.fmu.variables import Variable, Variables

VERSION = "3.0"
CATEGORIES = {
    "logStatusWarning": "what ends a simulation early",
    "logStatusError": "what was refused, and why",
}


def model_description(
    identifier: str,
    words: Mapping[str, str],
    variables: Variables,
    known: Functions,
    experiment: Mapping[str, float],
) -> str:
    """Text of modelDescription.xml.

    Parameters
    ----------
    identifier : str
        Name of the library.
    words : mapping of str to str
        Further attributes of the root: modelName, instantiationToken, description and so on.
    known : Functions
        Whose sparsity tells what depends on what.
    experiment : mapping of str to float
        Attributes of DefaultExperiment.
    """
    root = Xml.Element("fmiModelDescription", {"fmiVersion": VERSION, **words})
    able = {
        "modelIdentifier": identifier,
        "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
        "providesDirectionalDerivatives": "true",
        "providesAdjointDerivatives": "true",
    }
    Xml.SubElement(root, "ModelExchange", {**able, "needsCompletedIntegratorStep": "true"})
    # An early return, events and intermediate updates are not offered, which is the default.
    Xml.SubElement(root, "CoSimulation", {**able, "canHandleVariableCommunicationStepSize": "true"})
    _units(root, variables.every)
    categories = Xml.SubElement(root, "LogCategories")
    for name, description in CATEGORIES.items():
        Xml.SubElement(categories, "Category", {"name": name, "description": description})
    times = {name: repr(value) for name, value in experiment.items()}
    Xml.SubElement(root, "DefaultExperiment", times)
    listed = Xml.SubElement(root, "ModelVariables")
    for variable in variables.every:
        Xml.SubElement(listed, "Float64", _attributes(variable))
    _structure(Xml.SubElement(root, "ModelStructure"), variables, known)
    return _text(root)


def _units(root: Xml.Element, variables: Iterable[Variable]) -> None:
    names = dict.fromkeys(variable.unit for variable in variables if variable.unit)
    if not names:
        return
    definitions = Xml.SubElement(root, "UnitDefinitions")
    for name in names:
        unit = Xml.SubElement(definitions, "Unit", {"name": name})
        powers = base_powers(name)
        if powers is not None:
            Xml.SubElement(unit, "BaseUnit", {b: str(power) for b, power in powers.items()})


def _attributes(variable: Variable) -> dict[str, str]:
    optional = {
        "description": variable.description,
        "initial": variable.initial,
        "unit": variable.unit,
        "min": "0" if variable.positive else "",
        "start": "" if variable.start is None else repr(variable.start),
        "derivative": "" if variable.derivative is None else str(variable.derivative),
    }
    return {
        "name": variable.name,
        "valueReference": str(variable.reference),
        "causality": variable.causality,
        "variability": variable.variability,
        **{key: value for key, value in optional.items() if value},
    }


def _structure(structure: Xml.Element, variables: Variables, known: Functions) -> None:
    """What is computed, and from which of the given variables."""
    needs = _dependencies(variables, known)
    constants = {variable.reference for variable in variables.parameters}
    outputs = [v for v in variables.every if v.causality == "output"]
    for variable in outputs:
        _unknown(structure, "Output", variable, set(needs[variable.reference]) - constants)
    for variable in variables.rates:
        changing = set(needs[variable.reference]) - constants
        _unknown(structure, "ContinuousStateDerivative", variable, changing)
    for variable in variables.wanted:
        _unknown(structure, "InitialUnknown", variable, set(needs[variable.reference]))
    for variable in variables.margins:
        changing = set(needs[variable.reference]) - constants
        _unknown(structure, "EventIndicator", variable, changing)


def _unknown(structure: Xml.Element, tag: str, variable: Variable, needs: set[int]) -> None:
    listed = " ".join(map(str, sorted(needs)))
    attributes = {"valueReference": str(variable.reference), "dependencies": listed}
    Xml.SubElement(structure, tag, attributes)


def _dependencies(variables: Variables, known: Functions) -> dict[int, Sequence[int]]:
    """For each variable the references of those that it is computed from; a state is itself."""
    found: dict[int, list[int]] = {v.reference: [v.reference] for v in variables.states}
    found |= {variable.reference: [] for variable in variables.wanted}
    first = variables.wanted[0].reference
    for name, at in (("rates", first), ("outputs", first + len(variables.rates))):
        pattern: ca.Sparsity = known.graphs[name].jac_sparsity(0, 0)
        for row, column in zip(*pattern.get_triplet(), strict=True):
            found[at + row].append(column)
    return {reference: tuple(needs) for reference, needs in found.items()}


def build_description(identifier: str, sources: Sequence[str], options: str) -> str:
    """Text of buildDescription.xml: how the sources become the library."""
    root = Xml.Element("fmiBuildDescription", {"fmiVersion": VERSION})
    build = Xml.SubElement(root, "BuildConfiguration", {"modelIdentifier": identifier})
    files = Xml.SubElement(
        build, "SourceFileSet", {"language": "C99", "compiler": "gcc", "compilerOptions": options}
    )
    for source in sources:
        Xml.SubElement(files, "SourceFile", {"name": source})
    Xml.SubElement(build, "Library", {"name": "m", "external": "true"})
    return _text(root)


def _text(root: Xml.Element) -> str:
    Xml.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + Xml.tostring(root, "unicode") + "\n"
