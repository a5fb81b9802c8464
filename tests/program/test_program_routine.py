"""A routine is a program in the order of evaluation, and becomes the same program again."""

from mechanics.program import Builder
from mechanics.program.routine import built, nodes_of


def test_a_routine_becomes_its_program_again() -> None:
    b = Builder()
    q = [b.input(f"q[{k}]") for k in range(2)]
    wanted = [(q[0].sin() - q[1]) / (q[1] * q[1] + 2), q[0].sin()]
    shapes = (("ud", (2, 1)),)
    code = built("f", b, {"ud": wanted}, (("q", 2),), shapes)
    other = Builder()
    given = {"q": [other.input(f"q[{k}]") for k in range(2)]}
    again = nodes_of(other, code, given, code.outputs[0])
    assert other.program({"ud": again}) == b.program({"ud": wanted})
