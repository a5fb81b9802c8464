"""The hand-optimised kernels beside the models that are held against them."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from benchmarks.c_kernels import FOLDER, CKernel, read
from mechanics.compiled import Model, compile
from mechanics.compiled.c.source import function_source
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from systems import SEED

Numbers = Mapping[str, str]


@dataclass(frozen=True)
class Peer:
    """A system with a kernel by hand.

    Attributes
    ----------
    name : str
        Of the system, the C file and its function; the function with fixed parameters is
        ``NAME_fixed``.
    fixed : mapping of str to str
        The values that the latter holds.
    dropped : mapping of str to str
        Parameters without which there still is something to compute.
    """

    name: str
    fixed: Numbers
    dropped: Numbers

    @property
    def source(self) -> str:
        """The C file."""
        return (FOLDER / f"{self.name}.c").read_text(encoding="utf-8")

    def kernel(self, suffix: str = "") -> CKernel:
        """The function by hand."""
        scene = self.equations().scene
        symbols = {"q": scene.q, "u": scene.u, "inputs": scene.input_symbols, "p": scene.parameters}
        return read(self.source, symbols)[self.name + suffix]

    def equations(self, route: str = "kane") -> Equations:
        """The equations of motion."""
        return _equations(self.name, route)

    def model(self, route: str = "kane", fixed: Numbers | None = None) -> Model:
        """Forward dynamics and nothing else."""
        return compile(self.equations(route), fixed=fixed, outputs=("forward_dynamics",))


PEERS: tuple[Peer, ...] = (
    Peer(
        "elastic_pendulum",
        {"M": "1", "m": "1", "L": "1", "k": "10", "g": "9.81"},
        {"m": "0", "g": "0"},
    ),
    Peer("rocker", {"M": "1", "I_C": "0.01", "R": "0.1", "g": "9.81"}, {"g": "0"}),
    Peer("two_mass_chain", {"m": "1", "k": "1"}, {"k": "0"}),
)


def counted(model: Model, function: str = "forward_dynamics") -> CKernel:
    """A generated function, read from its C by the same rule."""
    scene = model.equations.scene
    symbols = {
        group: tuple(entry.symbol for entry in getattr(model.quantities, group))
        for group in ("q", "u", "inputs", "p", "ud", "multipliers")
    }
    symbols["h"] = scene.ud[:1]
    code = model.program(function)
    return read(function_source(code, model.entries), symbols)[code.name]


@cache
def _equations(name: str, route: str) -> Equations:
    (system,) = (system for system in SEED if system.name == name)
    return derive(system.scene(), route)
