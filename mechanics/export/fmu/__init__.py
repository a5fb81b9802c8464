"""A model as a functional mock-up unit: FMI 3.0, model exchange and co-simulation.

    given, wanted = variables      wanted = g(given) in C      modelDescription.xml      NAME.fmu

The C of the interface is the same for every model and stands in the folder ``c``, as it is shipped;
what differs, ``model.c`` with the functions and ``tables.c`` with names and numbers, is generated.
"""

from mechanics.export.fmu.unit import Start, write_unit

__all__ = ["Start", "write_unit"]
