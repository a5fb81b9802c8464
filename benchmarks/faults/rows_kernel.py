"""Faults in normal forms, and in what the kernel decides."""

from benchmarks.faults.fault import faults_in

FORMS = (
    *faults_in(
        "mechanics.symbolic.canonical",
        (
            "rest -= part * ring.gen(places[symbol])",
            "rest -= 2 * part * ring.gen(places[symbol])",
            "linear terms stay in the rest",
        ),
    ),
    *faults_in(
        "mechanics.symbolic.canonical_poly",
        (
            "return sum(parts[1:], parts[0])",
            "return sum(parts[1:], -parts[0])",
            "the first term of a sum, wrong sign",
        ),
        (
            "base if top > 0 else self._inverse(base), abs(top))",
            "base if top > 0 else self._inverse(base), min(abs(top), 2))",
            "powers stop at the square",
        ),
        (
            "return c if isinstance(again, sympy.cos) else s",
            "return s if isinstance(again, sympy.cos) else c",
            "cosines are sines",
        ),
        (
            "self.read(sympy.sin(again.args[0]) / sympy.cos(again.args[0]))",
            "self.read(sympy.cos(again.args[0]) / sympy.sin(again.args[0]))",
            "tan is cot",
        ),
    ),
)

DECISIONS = (
    *faults_in(
        "mechanics.kernel.decide",
        (
            "if outcome.answer is Answer.ZERO and not outcome.off_boundaries:",
            "if outcome.answer is not Answer.FAILED:",
            "whatever has a value is certified",
        ),
        (
            "if outputs[LEFT] == outputs[RIGHT]:",
            "if len(outputs[LEFT]) == len(outputs[RIGHT]):",
            "as many entries are the same entries",
        ),
    ),
    *faults_in(
        "mechanics.kernel.trial",
        ("(x - y) % prime == 0 for", "(x - x) % prime == 0 for", "a side is compared with itself"),
        ("if not all(equal)", "if not any(equal)", "one equal pair is enough"),
        ("if is_proved():", "if True:", "what is zero at a point is proved"),
    ),
    *faults_in(
        "mechanics.kernel.field",
        (
            "c, s = (1 - t * t) * scale % p, 2 * t * scale % p",
            "c, s = 1, 0",
            "every angle of the field is zero",
        ),
        (
            "residue = 1 + self._draws.below(self.prime - 1)",
            "residue = 1",
            "every symbol of the field is one",
        ),
        (
            "return x * pow(y, -1, self.prime) % self.prime",
            "return x * y % self.prime",
            "the field multiplies where it divides",
        ),
    ),
    *faults_in(
        "mechanics.kernel.quotients",
        ("return bool(self.ring.reduced(x.numerator) == 0)", "return True", "every form is zero"),
        (
            "return self.add(x, self.negate(y))",
            "return self.add(x, y)",
            "the normal form adds where it subtracts",
        ),
        (
            "self._over(x, common) + self._over(y, common), common)",
            "self._over(x, common) + y.numerator, common)",
            "fractions are added without a common denominator",
        ),
    ),
    *faults_in(
        "mechanics.kernel.normal",
        ("Quotient(side * s, {})", "Quotient(s, {})", "sin(-x) = sin(x) in the normal form"),
        (
            "        return all(\n            domain.quotients.is_zero",
            "        return any(\n            domain.quotients.is_zero",
            "one entry with the same normal form is enough",
        ),
    ),
    *faults_in(
        "mechanics.kernel.ring",
        ("2, 1 - cos**2)", "2, cos**2 - 1)", "s^2 = c^2 - 1 in the normal form"),
    ),
    *faults_in(
        "mechanics.kernel.balls",
        (
            "if all(operand.is_finite() for operand in operands):",
            "if not all(operand.is_finite() for operand in operands):",
            "balls: no function has a value",
        ),
    ),
    *faults_in(
        "mechanics.kernel.witness",
        (
            "for x, y in finite if not x.overlaps(y)]",
            "for x, y in finite if x.overlaps(y)]",
            "what overlaps is apart",
        ),
        ("for x, y in finite if not x.overlaps(y)]", "for x, y in ()]", "there is no witness"),
    ),
    *faults_in(
        "mechanics.symbolic.arithmetic",
        (
            "return pivot_columns(columns, point.prime)",
            "return pivot_columns(columns, point.prime)[:-1]",
            "the last independent row is lost",
        ),
    ),
)

ROWS = (*FORMS, *DECISIONS)
