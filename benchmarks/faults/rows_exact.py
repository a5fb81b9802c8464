"""Faults in exact arithmetic: what it simplifies, and what it decides."""

from benchmarks.faults.fault import faults_in

FORMS = (
    *faults_in(
        "mechanics.exact.canonical",
        (
            "result.write(part) for part in parts], result.write(-rest)",
            "result.write(part) for part in parts], result.write(rest)",
            "the right side of a linear equation has the wrong sign",
        ),
        (
            "rest -= part * ring.gen(places[symbol])",
            "rest -= 2 * part * ring.gen(places[symbol])",
            "linear terms stay in the rest",
        ),
    ),
    *faults_in(
        "mechanics.exact.canonical_poly",
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
    *faults_in(
        "mechanics.exact.ring",
        ("sin**2 + cos**2 - 1)", "sin**2 - cos**2 + 1)", "s^2 = c^2 - 1"),
    ),
)

DECISIONS = (
    *faults_in(
        "mechanics.exact.decide",
        (
            "if outcome.answer is Answer.ZERO:",
            "if outcome.answer is not Answer.FAILED:",
            "whatever has a value is zero",
        ),
        (
            "if try_normal and proves(experiment):\n            return Finding("
            "subject, Verdict.PROVED, PROOF)\n        return _certified",
            "if try_normal:\n            return Finding("
            "subject, Verdict.PROVED, PROOF)\n        return _certified",
            "what is certified is called proved",
        ),
    ),
    *faults_in(
        "mechanics.exact.field_trial",
        (
            "zero = all(number.residue == 0 for number in differences)",
            "zero = any(number.residue == 0 for number in differences)",
            "one pair is enough",
        ),
        (
            "zero = all(number.residue == 0 for number in differences)",
            "zero = True",
            "every residue is zero",
        ),
        (
            "differences = [a.rational(0) + left - right for left, right in pairs]",
            "differences = [a.rational(0) + left - left for left, right in pairs]",
            "the left side is compared with itself",
        ),
    ),
    *faults_in(
        "mechanics.exact.field",
        (
            'self._bases["base", atom] = ((1 - t * t) * scale % p, 2 * t * scale % p)',
            'self._bases["base", atom] = ((1 + t * t) * scale % p, 0 * t)',
            "every angle of the field is zero",
        ),
        (
            "residue = self.source.randrange(1, self.prime)",
            "residue = 1",
            "every symbol of the field is one",
        ),
        (
            "c, s, degree = (c * x - s * y) % p, (s * x + c * y) % p",
            "c, s, degree = (c * x + s * y) % p, (s * x + c * y) % p",
            "angles of the field do not add up",
        ),
    ),
    *faults_in(
        "mechanics.exact.normal",
        (
            "bool(self.ring.reduced((self.rational(0) + number).numerator) == 0)",
            "True",
            "every normal form is zero",
        ),
        (
            "c, s = c * x - s * y, s * x + c * y",
            "c, s = c * x + s * y, s * x + c * y",
            "angles of the normal form do not add up",
        ),
    ),
    *faults_in(
        "mechanics.exact.normal_number",
        (
            "return self + -self._lift(other)",
            "return self + self._lift(other)",
            "the normal form adds where it subtracts",
        ),
    ),
    *faults_in(
        "mechanics.exact.balls",
        (
            "if number.arb < 0:\n            return Ball(arb.nan())",
            "if number.arb < 0:\n            return Ball(arb(0))",
            "balls: roots of negatives are zero",
        ),
    ),
    *faults_in(
        "mechanics.exact.witness",
        (
            "apart = [(x, y) for x, y in finite if not x.overlaps(y)]",
            "apart = [(x, y) for x, y in finite if x.overlaps(y)]",
            "what overlaps is apart",
        ),
        (
            "apart = [(x, y) for x, y in finite if not x.overlaps(y)]",
            "apart = []",
            "there is never a witness",
        ),
    ),
)

ROWS = (*FORMS, *DECISIONS)
