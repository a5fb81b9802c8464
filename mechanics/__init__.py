"""Cross-check engine for equations of motion.

scene --> routes --> Equations --> checks --> report
                         |
                         +--> compile --> Model --> simulate, write_c
"""

from mechanics.compiled import Model, compile
from mechanics.crosscheck import ROUTES, CrossCheck, crosscheck, derive
from mechanics.crosscheck.fmu import write_fmu
from mechanics.equations import Equations
from mechanics.errors import MechanicsError
from mechanics.exact import Finding, Verdict, Witness
from mechanics.export import write_c
from mechanics.extremes import extremes
from mechanics.judge.check import check
from mechanics.judge.check_json import to_json as check_json
from mechanics.linear import damped_modes, linearise, modes
from mechanics.reading.code.black_box import BlackBox
from mechanics.report.answer.page import check_html
from mechanics.report.html import to_html
from mechanics.report.json_report import to_json
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    condition,
    damper,
    force,
    gravity,
    holonomic,
    nonholonomic,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torque,
    torsion_spring,
)
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
    "check",
    "check_html",
    "check_json",
    "compile",
    "condition",
    "crosscheck",
    "damped_modes",
    "damper",
    "derive",
    "ensemble",
    "extremes",
    "force",
    "gravity",
    "holonomic",
    "linearise",
    "modes",
    "nonholonomic",
    "parameters",
    "published",
    "reaction",
    "reaction_couple",
    "simulate",
    "spring",
    "to_html",
    "to_json",
    "torque",
    "torsion_spring",
    "trade",
    "write_c",
    "write_fmu",
]
