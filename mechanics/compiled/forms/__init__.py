"""Forms of forward dynamics: algebra that is equal and rounds differently."""

from mechanics.compiled.forms.choice import written
from mechanics.compiled.forms.members import FORMS, Form, named_form
from mechanics.compiled.forms.system import System

__all__ = ["FORMS", "Form", "System", "named_form", "written"]
