"""The language: straight-line programs over one table of operations.

Builder --> Program --> interpret(program, domain)
"""

from mechanics.program.builder import Builder, Node, Obligation
from mechanics.program.interpret import Domain, interpret
from mechanics.program.operations import OPERATIONS, Operation
from mechanics.program.program import Program

__all__ = [
    "OPERATIONS",
    "Builder",
    "Domain",
    "Node",
    "Obligation",
    "Operation",
    "Program",
    "interpret",
]
