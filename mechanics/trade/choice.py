"""What can be chosen: how the right-hand side is written and compiled, and how it is integrated.

A choice is a variant of the model and a setting of an integrator. Only one of these axes is varied
at a time around the best, or there would be thousands.
"""

from dataclasses import dataclass, replace

from mechanics.compiled.machine.evaluator import FLAGS
from mechanics.simulate.integrators import Setting

NONLINEAR, LINEARIZED = "nonlinear", "linearized"


@dataclass(frozen=True)
class Variant:
    """A way to write and compile the right-hand side.

    Attributes
    ----------
    form : str
        Of forward dynamics: ``"auto"`` or one of `mechanics.compiled.FORMS`.
    flags : str
        Settings of the C compiler.
    model : str
        ``"nonlinear"`` or ``"linearized"``.
    """

    form: str = "auto"
    flags: str = FLAGS[0]
    model: str = NONLINEAR

    @property
    def plain(self) -> bool:
        """Whether it is what `mechanics.compile` makes without being asked."""
        return self == Variant()

    @property
    def careful(self) -> bool:
        """Whether NaN and infinity are still reported, which -ffast-math gives up."""
        return "-ffast-math" not in self.flags

    @property
    def words(self) -> str:
        """What differs from the plain one; empty where nothing does."""
        parts = [self.model] if self.model != NONLINEAR else []
        parts += [f"form {self.form}"] if self.form != "auto" else []
        parts += [self.flags] if self.flags != FLAGS[0] else []
        return ", ".join(parts)


@dataclass(frozen=True)
class Choice:
    """A variant of the model and a setting of an integrator."""

    variant: Variant
    setting: Setting

    @property
    def amount(self) -> float:
        """The tolerance, or the step in s."""
        tolerance, step = self.setting.tolerance, self.setting.step
        return float(tolerance if tolerance is not None else step or 0.0)

    @property
    def knob(self) -> str:
        """``"tolerance 2.3e-09"`` or ``"step 0.01 s"``."""
        if self.setting.tolerance is not None:
            return f"tolerance {self.setting.tolerance:.2g}"
        return f"step {self.setting.step:.4g} s"

    @property
    def words(self) -> str:
        """The choice in a line."""
        parts = [self.setting.integrator, self.knob]
        parts += ["single precision"] if self.setting.arithmetic == "single" else []
        parts += [self.variant.words] if self.variant.words else []
        return ", ".join(parts)

    def with_amount(self, amount: float) -> "Choice":
        """The same with another tolerance or step."""
        if self.setting.tolerance is not None:
            return replace(self, setting=replace(self.setting, tolerance=amount))
        return replace(self, setting=replace(self.setting, step=amount))

    def with_variant(self, variant: Variant) -> "Choice":
        """The same with another variant of the model."""
        return replace(self, variant=variant)
