"""Exceptions. Each names the object, what was found, what was expected and what to do next.

Every class also subclasses the builtin exception that describes it, so that callers who know only
Python's own exceptions can still catch it.
"""


class MechanicsError(Exception):
    """Base class of everything that this package raises on purpose."""


class SceneError(MechanicsError, ValueError):
    """A scene that cannot be right: the message names the body, load, reaction or coordinate."""


class ExpressionError(MechanicsError, ValueError):
    """An expression that cannot be evaluated or translated: the message names the operation."""


class ZeroDivisorError(ExpressionError, ZeroDivisionError):
    """A division by what is zero everywhere."""


class ValueMissingError(MechanicsError, KeyError):
    """A number is needed for a parameter that has none."""

    def __str__(self) -> str:
        # KeyError would print the repr of the message.
        return str(self.args[0]) if self.args else ""


class InputError(MechanicsError, ValueError):
    """Bad input from a person: an unknown name, a file that is no scene, a value out of range."""


class WrongKindError(MechanicsError, TypeError):
    """A function was given another kind of thing than it takes; the message says how to get it."""


class SingularError(MechanicsError, ArithmeticError):
    """A matrix that has to be regular is singular, at a state or everywhere."""


class RangeError(MechanicsError, OverflowError):
    """A value is beyond the largest number of the precision."""


class CompilerError(MechanicsError, RuntimeError):
    """A C compiler was found but refused the generated code; the message carries its words."""


class RefutedError(MechanicsError, ValueError):
    """What was to be written is refuted; nothing is written, and the message names a witness."""


def wanted(value: object, kind: type | tuple[type, ...], call: str, advice: str) -> None:
    """Refuse what is not of the kind that a function takes.

    Parameters
    ----------
    value : object
    kind : type or tuple of types
    call : str
        Name of the function.
    advice : str
        How to get what it takes.

    Raises
    ------
    WrongKindError
    """
    if not isinstance(value, kind):
        kinds = kind if isinstance(kind, tuple) else (kind,)
        names = " or ".join(k.__name__ for k in kinds)
        raise WrongKindError(f"{call}: {names} wanted, {type(value).__name__} found: {advice}")
