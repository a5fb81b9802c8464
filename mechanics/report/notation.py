r"""Expressions as a textbook sets them.

    x_ddot -> \ddot{x}      I_C -> I_{C}      L*M*g*sin(theta)/2 -> \tfrac{1}{2} M g L \sin \theta

Factors stand in the order number, masses and stiffnesses, gravity, lengths, brackets, coordinates,
rates, functions; terms with accelerations stand first.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from html import escape
from typing import Any

from latex2mathml.converter import convert
from sympy import (
    Add,
    Basic,
    Derivative,
    Expr,
    Float,
    MatrixBase,
    Mul,
    Pow,
    Rational,
    S,
    Symbol,
    sstr,
)
from sympy.core.function import AppliedUndef
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.printing.conventions import split_super_sub
from sympy.printing.latex import LatexPrinter, tex_greek_dictionary, translate
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pretty.pretty_symbology import greek_unicode

DOTTED = re.compile(r"(?P<base>.+)_(?P<dots>d{1,3})ot$")
DOTLESS = "0.72em"
"""Height of a letter without its dots."""
DOTTED_BASE = re.compile(r"(<msup>|<msubsup>)(<mover>(?:(?!</?mover>).)*</mover>)")
# A letter with a subscript that has no mark: a component Ax, Ty1, Ixx; mB, IBx.
LETTERED = re.compile(r"([A-Z](?=[xyz]{1,2}\d*$)|[a-z](?=[A-Z])|I(?=[A-Z][a-z]))([A-Za-z]+\d*)")
WORD = 3
"""Letters of a subscript that is a word, upright."""
ACCENTS = ("", r"\dot", r"\ddot", r"\dddot")
GREEK = frozenset(greek_unicode)
# A drawing has the letters of formulas: LaTeX's phi is the straight one.
LETTERS = {**greek_unicode, "phi": "\N{GREEK PHI SYMBOL}", "varphi": greek_unicode["phi"]}
# Bits of the precision of a number that was typed without regard to its digits.
DOUBLE = 53
SUB, SMALL = 0.28, 0.72
"""How much lower a subscript stands, in its em, and its size in that of the letter."""
COMBINING = ("", "\u0307", "\u0308", "\u20db")
# Accelerations of gravity stand after masses, lengths after both; everything else before.
UNIT_ORDER = {"m/s^2": 1, "m": 2, "1": 3, "rad": 3}
FUNCTION = re.compile(r"(^|[^({\[])?(\\(?:sin|cos|tan|exp|log))(\^\{[^{}]*\})? ?(?=(\\left)?)")


@lru_cache(maxsize=4096)
def split_name(name: str) -> tuple[str, int, str]:
    """Letter, number of dots and subscript of a plain name: theta1_dot gives theta, 1, "1"."""
    found = DOTTED.match(name)
    stem, dots = (found["base"], len(found["dots"])) if found else (name, 0)
    lettered = LETTERED.fullmatch(stem)
    if lettered:
        return lettered[1], dots, lettered[2]
    base, supers, subs = split_super_sub(stem)
    return base, dots, ",".join(supers + subs)


@lru_cache(maxsize=4096)
def latex_name(name: str) -> str:
    """A plain name in LaTeX."""
    base, dots, sub = split_name(name)
    letter = translate(base)
    if letter == base and len(base) > 1:
        letter = rf"\mathrm{{{base}}}"
    if dots:
        letter = f"{ACCENTS[dots]}{{{letter}}}"
    return f"{letter}_{{{','.join(map(_subscript, sub.split(',')))}}}" if sub else letter


def _subscript(part: str) -> str:
    letter = tex_greek_dictionary.get(part, translate(part) if len(part) > 1 else part)
    word = letter == part and len(part) >= WORD and part.isalpha() and part.islower()
    return rf"\mathrm{{{part}}}" if word else letter


def svg_name(name: str) -> str:
    """A plain name as the content of an SVG text element: a letter with dots and a subscript."""
    base, dots, sub = split_name(name)
    letter = escape(LETTERS.get(base, base)) + COMBINING[dots]
    style = "font-style:italic" if len(base) == 1 or base in greek_unicode else ""
    text = f'<tspan style="{style}">{letter}</tspan>'
    if sub:
        small = escape(LETTERS.get(sub, sub))
        text += f'<tspan dy="{SUB}em" font-size="{SMALL:.0%}">{small}</tspan>'
    return text


def svg_row(pieces: Iterable[str]) -> str:
    """Names and signs beside each other: what follows a subscript is back on the line."""
    drawn = ""
    for piece in filter(None, pieces):
        below = drawn.rpartition("<tspan")[2].startswith(f' dy="{SUB}em"')
        drawn += f'<tspan dy="-{SUB * SMALL:.3f}em">{piece}</tspan>' if below else piece
    return drawn


class Notation(LatexPrinter):
    """LaTeX printer for plain symbols and for dynamic symbols alike."""

    def _print_Symbol(self, expr: Symbol, style: str = "plain") -> str:
        return latex_name(expr.name)

    def _print_Function(self, expr: Any, exp: str | None = None) -> str:
        if isinstance(expr, AppliedUndef):
            name = latex_name(expr.func.__name__)
            return f"{name}^{{{exp}}}" if exp else name
        if isinstance(expr, TrigonometricFunction):
            (argument,) = expr.args
            inner = self._print(argument)
            if argument.is_Add or argument.has(Pow) or argument.could_extract_minus_sign():
                inner = rf"\left({inner}\right)"
            power = f"^{{{exp}}}" if exp else ""
            return rf"\{expr.func.__name__}{power} {inner}"
        return str(super()._print_Function(expr, exp))

    def _print_Derivative(self, expr: Derivative) -> str:
        inner, ((variable, order),) = expr.expr, expr.variable_count
        if isinstance(inner, AppliedUndef) and order <= 3:
            return latex_name(f"{inner.func.__name__}_{'d' * int(order)}ot")
        t, power = self._print(variable), f"^{{{order}}}" if order > 1 else ""
        body = self._print(inner)
        body = f"{{{body}}}" if body[0] == "-" else body
        return rf"\frac{{d{power}}}{{d{t}{power}}}\left[{body}\right]"

    def _print_Add(self, expr: Add, order: Any = None) -> str:
        first, *others = self.pieces(expr)
        # In braces a minus is a sign; after an opening bracket it would be spaced as a difference.
        return " ".join([f"{{{first}}}" if first[0] == "-" else first, *others])

    def pieces(self, expr: Expr) -> list[str]:
        """Terms of a sum in textbook order, every one after the first with its sign in front."""
        printed = []
        for term in Add.make_args(expr):
            text = self._print(term)
            negative = text.startswith("-")
            body = text[1:].lstrip() if negative else text
            factors = 0 if term.is_number else len(Mul.make_args(term))
            printed.append(((-_derivatives(term), negative, factors, body), negative, body))
        printed.sort()
        return [
            (f"- {body}" if negative else f"+ {body}") if n else (f"-{body}" if negative else body)
            for n, (_, negative, body) in enumerate(printed)
        ]

    def _print_Mul(self, expr: Mul) -> str:
        number, rest = expr.as_coeff_Mul()
        sign, number = ("-", -number) if number.is_negative else ("", number)
        over, under = [], []
        for factor in _join_roots(Mul.make_args(rest)):
            if factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative:
                under.append(factor.base**-factor.exp)
            else:
                over.append(factor)
        if under:
            top, bottom = (number.p, number.q) if number.is_Rational else (number, 1)
            return rf"{sign}\frac{{{self._row(top, over)}}}{{{self._row(bottom, under)}}}"
        return sign + self._row(number, over)

    def _row(self, number: Any, factors: list[Expr]) -> str:
        texts = [] if number == 1 and factors else [self._number(number)]
        alone = number == 1 and len(factors) == 1
        for factor in sorted(factors, key=_place):
            bare = alone or isinstance(factor, Derivative)
            text = self._print(factor) if bare else self.parenthesize(factor, PRECEDENCE["Mul"])
            clash = texts and text[:1].isdigit()
            # Upright letters side by side would be one word.
            apart = texts and r"\mathrm" in text[:7] + texts[-1][:7]
            texts.append(rf"\cdot {text}" if clash else rf"\, {text}" if apart else text)
        return " ".join(texts)

    def _print_Float(self, expr: Float) -> str:
        # A number that a source rounds keeps the digits that it prints: 1.0000.
        rounded = expr._prec < DOUBLE
        return str(sstr(expr, full_prec=True)) if rounded else str(super()._print_Float(expr))

    def _print_Rational(self, expr: Rational) -> str:
        sign = "-" if expr.p < 0 else ""
        return rf"{sign}\tfrac{{{abs(expr.p)}}}{{{expr.q}}}" if expr.q != 1 else str(expr.p)

    def _number(self, number: Any) -> str:
        return str(self._print(number)) if isinstance(number, Basic) else str(number)


def _derivatives(term: Expr) -> int:
    """Highest number of dots in a term."""
    dots = [split_name(symbol.name)[1] for symbol in term.free_symbols]
    dots += [int(d.variable_count[0][1]) for d in term.atoms(Derivative)]
    return max(dots, default=0)


def _join_roots(factors: Sequence[Expr]) -> list[Expr]:
    """The factors with sqrt(k) / sqrt(m) written as one root."""
    roots = [f for f in factors if f.is_Pow and abs(f.exp) == S.Half and not f.base.is_number]
    if len(roots) < 2:
        return list(factors)
    joined = Pow(Mul(*(root**2 for root in roots)), S.Half, evaluate=False)
    return [factor for factor in factors if factor not in roots] + [joined]


def in_order(factors: Sequence[Expr]) -> list[Expr]:
    """Factors as a textbook writes them: masses before lengths, coordinates after both."""
    return sorted(factors, key=_place)


def _place(factor: Expr) -> tuple[int, int, str]:
    """Where a factor stands in a product."""
    base = factor.base if factor.is_Pow else factor
    name = str(getattr(base, "name", "")) or str(base)
    if base.is_number:
        return 0, 0, name
    if isinstance(base, Symbol) and not DOTTED.match(base.name):
        unit = UNIT_ORDER.get(getattr(base, "unit", ""), 0)
        return (1, unit, name) if base.is_positive else (4, 0, name)
    if base.is_Add:
        return 2 + bool(_derivatives(base)), 0, name
    if isinstance(base, Symbol | AppliedUndef | Derivative):
        return 5, _derivatives(base), name
    return 6, 0, name


PRINTER = Notation({"mat_delim": "[", "mat_str": "matrix"})


def latex(expr: Any) -> str:
    """An expression or matrix in LaTeX, in plain or in dynamic symbols."""
    return str(PRINTER.doprint(expr))


def pieces(expr: Any) -> list[str]:
    """LaTeX of the terms of an expression, so that a page can break a line between them.

    A 3 x 1 matrix is a vector along the unit vectors u_x, u_y, u_z.
    """
    if isinstance(expr, MatrixBase) and expr.shape == (3, 1):
        return _vector(expr)
    return PRINTER.pieces(expr) if isinstance(expr, Add) else [latex(expr)]


def _vector(column: MatrixBase) -> list[str]:
    found: list[str] = []
    for entry, axis in zip(column, "xyz", strict=True):
        unit = rf"\vec{{u}}_{{{axis}}}"
        if entry == 0:
            continue
        if isinstance(entry, Add):
            first, *others = pieces(entry)
            first = f"{{{first}}}" if first[0] == "-" else first
            terms = [rf"\bigl[ {first}", *others]
            terms[-1] += rf" \bigr] {unit}"
            terms[0] = f"+ {terms[0]}" if found else terms[0]
        else:
            text = f"{latex(entry)} {unit}" if abs(entry) != 1 else f"{latex(entry)[:-1]}{unit}"
            terms = [text if not found else f"- {text[1:]}" if text[0] == "-" else f"+ {text}"]
        found += terms
    return found or [r"\vec{0}"]


@lru_cache(maxsize=65536)
def mathml(source: str) -> str:
    """One inline MathML element in display style."""
    spaced = FUNCTION.sub(_space, source)
    text: str = convert(spaced, display="inline")
    text = text.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")
    text = text.replace(r">\{<", ">{<").replace(r">\}<", ">}<")
    text = text.replace('display="inline"', 'displaystyle="true"', 1)
    text = re.sub(r'(?:<mi mathvariant="normal">(\w)</mi>){2,}', _upright, text)
    # As in TeX, an exponent stands beside the letter and not above its dots.
    text = DOTTED_BASE.sub(rf'\1<mpadded height="{DOTLESS}">\2</mpadded>', text)
    if source[:2] in ("+ ", "- ", "= "):
        # The piece continues a line, so its sign is spaced as one between two terms.
        text = text.replace("<mo>", '<mo form="infix">', 1)
    return text


def _space(found: re.Match[str]) -> str:
    """Thin spaces around a function, except at a bracket."""
    before, name, power, bracket = found.groups()
    lead = "" if before is None else rf"{before}\,"
    return lead + name + (power or "") + ("" if bracket else r"\,")


def _upright(letters: re.Match[str]) -> str:
    return "<mi>" + re.sub(r"<[^>]*>", "", letters[0]) + "</mi>"


def operations(expr: Any, limit: int) -> int:
    """Number of nodes of an expression, counted up to a limit."""
    return sum(1 for _ in zip(range(limit), _nodes(expr), strict=False))


def _nodes(expr: Any) -> Iterator[Any]:
    stack = [expr]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(getattr(node, "args", ()))
