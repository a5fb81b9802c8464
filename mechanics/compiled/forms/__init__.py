"""Forms of forward dynamics: algebra that is equal and rounds differently."""

from mechanics.compiled.forms.members import FORMS, Form, System, named_form

__all__ = ["FORMS", "Form", "System", "named_form"]
