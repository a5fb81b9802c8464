"""Cross-check engine for equations of motion.

scene --> routes --> Equations --> checks --> report
                         |
                         +--> compile --> Model --> simulate, write_c

Declare: a Scene of Particle and RigidBody; a System adds its source.
    parameters          names, units and typical values
    pin slide weld ball universal cylindrical planar free roll rope  joints
    quaternion euler    rotations of ball and free
    gravity force torque spring damper torsion_spring                  loads
    holonomic nonholonomic condition    constraints, conditions of validity
    reaction reaction_couple            unknown forces and couples
    position orientation velocity       outputs
    published           an equation of the source (a row of its ledger)
    from_sympy from_urdf from_mjcf from_dh from_json    models of others
Derive and prove: a Finding has a Verdict; when refuted, a Witness.
    derive              Equations of one of the ROUTES
    crosscheck          a CrossCheck: all routes, each other and the source
    check               your own equations; a BlackBox is only called
    compare             other engines, with the cause where they differ
    to_html to_json check_html check_json to_sympy    results, written
Use: a MechanicsError says what was refused, and why.
    compile             a Model: mass_matrix, forward_dynamics, energy, ...
    simulate ensemble   one motion; many; Feedback: an input by the state
    trim linearize modes damped_modes   rest, steady motions, small motions
    trade extremes      what accuracy costs; where something breaks
    write_c write_fmu   C99; a unit of FMI 3.0

help(mechanics.pin) tells more, with an example; docs/ has tutorials.
"""

from __future__ import annotations

import sys
from importlib import import_module
from traceback import walk_stack
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mechanics.claims.code.black_box import BlackBox
    from mechanics.compare import compare
    from mechanics.compiled import Model
    from mechanics.crosscheck import ROUTES, CrossCheck, crosscheck, derive
    from mechanics.crosscheck.compiling import compile
    from mechanics.crosscheck.fmu import write_fmu
    from mechanics.equations import Equations
    from mechanics.errors import MechanicsError
    from mechanics.export import write_c
    from mechanics.extremes import extremes
    from mechanics.importers.dh import from_dh
    from mechanics.importers.mjcf import from_mjcf
    from mechanics.importers.sympy_scene import from_sympy
    from mechanics.importers.sympy_system import to_sympy
    from mechanics.importers.urdf import from_urdf
    from mechanics.judge.check import check
    from mechanics.judge.check_json import to_json as check_json
    from mechanics.kernel import Finding, Verdict, Witness
    from mechanics.linear import damped_modes, linearize, modes, trim
    from mechanics.report.answer.page import check_html
    from mechanics.report.html import to_html
    from mechanics.report.json_report import to_json
    from mechanics.scene import (
        Particle,
        RigidBody,
        Scene,
        ball,
        condition,
        cylindrical,
        damper,
        euler,
        force,
        free,
        gravity,
        holonomic,
        nonholonomic,
        orientation,
        parameters,
        pin,
        planar,
        position,
        quaternion,
        reaction,
        reaction_couple,
        roll,
        rope,
        slide,
        spring,
        torque,
        torsion_spring,
        universal,
        velocity,
        weld,
    )
    from mechanics.scene.json.read import from_json
    from mechanics.scene.published import published
    from mechanics.scene.system import System
    from mechanics.simulate import Feedback, ensemble
    from mechanics.trade import trade
    from mechanics.trade.accurate import simulate

__all__ = [
    "ROUTES",
    "BlackBox",
    "CrossCheck",
    "Equations",
    "Feedback",
    "Finding",
    "MechanicsError",
    "Model",
    "Particle",
    "RigidBody",
    "Scene",
    "System",
    "Verdict",
    "Witness",
    "ball",
    "check",
    "check_html",
    "check_json",
    "compare",
    "compile",
    "condition",
    "crosscheck",
    "cylindrical",
    "damped_modes",
    "damper",
    "derive",
    "ensemble",
    "euler",
    "extremes",
    "force",
    "free",
    "from_dh",
    "from_json",
    "from_mjcf",
    "from_sympy",
    "from_urdf",
    "gravity",
    "holonomic",
    "linearize",
    "modes",
    "nonholonomic",
    "orientation",
    "parameters",
    "pin",
    "planar",
    "position",
    "published",
    "quaternion",
    "reaction",
    "reaction_couple",
    "roll",
    "rope",
    "simulate",
    "slide",
    "spring",
    "to_html",
    "to_json",
    "to_sympy",
    "torque",
    "torsion_spring",
    "trade",
    "trim",
    "universal",
    "velocity",
    "weld",
    "write_c",
    "write_fmu",
]

_NAMES = {
    "mechanics.claims.code.black_box": "BlackBox",
    "mechanics.compare": "compare",
    "mechanics.compiled": "Model",
    "mechanics.crosscheck": "ROUTES CrossCheck crosscheck derive",
    "mechanics.crosscheck.compiling": "compile",
    "mechanics.crosscheck.fmu": "write_fmu",
    "mechanics.equations": "Equations",
    "mechanics.errors": "MechanicsError",
    "mechanics.export": "write_c",
    "mechanics.extremes": "extremes",
    "mechanics.importers.dh": "from_dh",
    "mechanics.importers.mjcf": "from_mjcf",
    "mechanics.importers.sympy_scene": "from_sympy",
    "mechanics.importers.sympy_system": "to_sympy",
    "mechanics.importers.urdf": "from_urdf",
    "mechanics.judge.check": "check",
    "mechanics.judge.check_json": "check_json=to_json",
    "mechanics.kernel": "Finding Verdict Witness",
    "mechanics.linear": "damped_modes linearize modes trim",
    "mechanics.report.answer.page": "check_html",
    "mechanics.report.html": "to_html",
    "mechanics.report.json_report": "to_json",
    "mechanics.scene": (
        "Particle RigidBody Scene ball condition cylindrical damper euler force free gravity "
        "holonomic nonholonomic orientation parameters pin planar position quaternion reaction "
        "reaction_couple roll rope slide spring torque torsion_spring universal velocity weld"
    ),
    "mechanics.scene.json.read": "from_json",
    "mechanics.scene.published": "published",
    "mechanics.scene.system": "System",
    "mechanics.simulate": "Feedback ensemble",
    "mechanics.trade": "trade",
    "mechanics.trade.accurate": "simulate",
}
_MODULES = {
    name: (module, attribute or name)
    for module, names in _NAMES.items()
    for name, _, attribute in (word.partition("=") for word in names.split())
}
"""Where each public name comes from: imported when asked for, what needs little starts at once."""


class _Package(ModuleType):
    """This package; its functions keep their names when modules of the same name are imported."""

    def __getattr__(self, name: str) -> Any:
        if name not in _MODULES:
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        module, attribute = _MODULES[name]
        value = getattr(import_module(module), attribute)
        super().__setattr__(name, value)
        return value

    def __setattr__(self, name: str, value: Any) -> None:
        if not (name in _MODULES and isinstance(value, ModuleType)):
            super().__setattr__(name, value)

    def __dir__(self) -> list[str]:
        # pydoc has no other hook: it prints the docstring of each name that dir() gives, 2,300
        # lines. For it there are none, so that help() is the docstring above.
        if any(frame.f_globals.get("__name__") == "pydoc" for frame, _ in walk_stack(None)):
            return []
        return sorted({*super().__dir__(), *__all__})


sys.modules[__name__].__class__ = _Package

if "IPython" in sys.modules:
    from mechanics.notebook import register

    register()
