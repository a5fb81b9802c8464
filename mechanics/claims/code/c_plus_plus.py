"""C++ and Arduino's dialect in the words of C, line by line the same, as far as formulas need it.

    std::sin(x)   <cmath>   constexpr   auto s = ...   const std::array<double, 2>& y

    class Cart { double m = 1; double a(double u) const { return u/m; } };
    ->  double a(double u, double m) { return u/m; }

    std::array<double, 2> f(double x) { return {x, -x}; }
    ->  void f(double x, double out[2]) { out[0] = x; out[1] = -x; }

Fields of a class are arguments of its functions, so that what is judged holds for all their values.
"""

import re
from collections.abc import Sequence

from mechanics.errors import ExpressionError
from mechanics.program.c.tokens import blanked

SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".ino")

WORDS = (
    (r"#\s*include\s*(?:<cmath>|[<\"]Arduino\.h[>\"])", "#include <math.h>"),
    (r"#\s*include\s*(?:<[\w/.]+>|\"[^\"\n]*\")", ""),
    (r"#\s*pragma\s+once", ""),
    (r"\busing\s+[^;{}]*;", ""),
    (r"\bstd\s*::\s*", ""),
    (r"\bEigen\s*::\s*", ""),
    (r"\bVector([2-6])d\b", r"array<double, \1>"),
    (r"\bVectorX[df]\b", "vector<double>"),
    (r"\bMatrix(?:X|[2-4])[df]\b", "vector<double>"),
    (r"\bMatrix\s*<\s*(double|float)\s*,\s*(\w+)\s*,\s*1\s*>", r"array<\1, \2>"),
    (r"\bstatic\s+constexpr\b|\bconstexpr\b", "const"),
    (r"\bnoexcept\b|\binline\b|\[\[\w+\]\]|\boverride\b", ""),
    (r"\bstatic_cast\s*<\s*(double|float)\s*>", r"(\1)"),
    (r"\bconst\s+auto\b|\bauto\s+const\b", "const double"),
    (r"\bauto\b", "double"),
    (r"\bconst\s+array\s*<\s*(double|float)\s*,\s*(\d+)\s*>\s*&\s*(\w+)", r"const \1 \3[\2]"),
    (r"\bconst\s+(?:array|vector)\s*<\s*(double|float)\s*(?:,\s*\w+\s*)?>\s*&\s*", r"const \1 *"),
    (r"\b(?:array|vector)\s*<\s*(double|float)\s*(?:,\s*\w+\s*)?>\s*&\s*", r"\1 *"),
    (r"\bconst\s+(double|float)\s*&\s*", r"const \1 "),
    (r"\b(double|float)\s*\{\s*([^{};]*?)\s*\}", r"(\2)"),
    (r"\bthis\s*->\s*", ""),
)  # fmt: skip
"""What stands in place of words of C++."""

BINDING = re.compile(r"(?:const\s+)?double\s*&?\s*\[([\w\s,]+)\]\s*=\s*(\w+)\s*;")
"""What takes an array apart, once `auto` is gone."""
ARRAY = re.compile(
    r"\b(?:array|vector)\s*<\s*(?:double|float)\s*(?:,\s*(?P<size>\d+)\s*)?>\s+"
    r"(?P<name>\w+)\s*\((?P<arguments>[^(){};]*)\)\s*\{"
)
RETURN = re.compile(r"\breturn\s*\{(?P<values>[^;]*)\}\s*;\s*$")
"""The last line of a function."""

CLASS = re.compile(r"\b(?:class|struct)\s+(\w+)\s*(?:final\s*)?\{")
ACCESS = re.compile(r"\b(?:public|private|protected)\s*:")
FIELD = re.compile(r"\s*(const\s+|static\s+)*(?:double|float)\s+([^;(){}]+);")
FUNCTION = re.compile(r"\b(double|float|void|int)\s+(\w+)\s*\(([^(){};]*)\)\s*(?:const\s*)?\{")


def in_c(text: str, origin: str) -> str:
    """C++ without comments as C.

    Raises
    ------
    ExpressionError
        For classes in classes, or what is no number in one.
    """
    text = _flat(BRACED.sub(_assigned, CALLED.sub("rhs(", _with_aliases(text))))
    for pattern, words in WORDS:
        text = re.sub(pattern, words, text)
    if not re.search(r"\bt\b", text):
        text = UNNAMED.sub(r"\1 t", text, count=1)
    text = _globals_passed(_referred(_returned(_filled(BINDING.sub(_bound, text)))))
    for found in reversed([m for m in CLASS.finditer(text) if FUNCTION.search(_inside(text, m))]):
        inside = _inside(text, found)
        end = found.end() + len(inside)
        after = re.compile(r"\}\s*;").match(text, end)
        if after is None or CLASS.search(inside):
            line = text[: found.start()].count("\n") + 1
            raise ExpressionError(f"{origin}:{line}: class {found[1]} is not supported: write its"
                                  " function by itself, with its numbers as arguments")  # fmt: skip
        text = (
            text[: found.start()]
            + blanked(found[0])
            + _plain(inside, found[1])
            + text[after.end() :]
        )
    return text


REFERENCE = re.compile(r"(?<!const )\b(?:double|float)\s*&\s*(\w+)(?=\s*[,)])")
FILLED = re.compile(
    r"\b(?:array|vector)\s*<\s*(?:double|float)\s*(?:,\s*(?P<size>\d+)\s*)?>\s+(?P<name>\w+)"
    r"\s*(?:\(\s*(?P<count>\d+)\s*(?:,\s*0(?:\.0?)?\s*)?\)|\{\s*\})?\s*;"
)
"""An array of zeros that a function fills and returns."""
GLOBAL = re.compile(r"(?:static\s+|volatile\s+)*\b(?:double|float)\s+(\w+(?:\s*,\s*\w+)*)\s*;")


def _filled(text: str) -> str:
    """Functions that fill an array of their own, with an argument for it."""
    for found in reversed(list(ARRAY.finditer(text))):
        inside = _inside(text, found)
        local = FILLED.search(inside)
        size = (local["size"] or local["count"]) if local else None
        if local is None or size is None:
            continue
        name, given = local["name"], found["arguments"].strip()
        last = re.search(rf"\breturn\s+{name}\s*;\s*$", inside)
        if last is None or len(re.findall(r"\breturn\b", inside)) > 1:
            continue
        body = inside[: local.start()] + blanked(local[0]) + inside[local.end() : last.start()]
        body = _entries(name, body)
        arrays = "|".join([name, *re.findall(r"(?:\*\s*|\bdouble )(\w+)(?=\[|\s*[,)]|$)", given)])
        body = re.sub(rf"\b({arrays})\s*\(\s*(\d+)\s*\)", r"\1[\2]", body)
        arguments = ", ".join(filter(None, (given, f"double {name}[{size}]")))
        head = f"void {found['name']}({arguments}) {{"
        rest = text[found.end() + len(inside) :]
        text = text[: found.start()] + head + body + blanked(last[0]) + rest
    return text


def _entries(name: str, body: str) -> str:
    """``f << a, b;`` entry by entry."""

    def each(match: re.Match[str]) -> str:
        values = enumerate(_parts(match[1]))
        return "".join(f"{name}[{i}] = {value};" for i, value in values)

    return re.sub(rf"\b{name}\s*<<\s*([^;]*);", each, body)


def _referred(text: str) -> str:
    """Arguments that a function writes through a reference, as arrays of one entry."""
    for found in reversed(list(FUNCTION.finditer(text))):
        names = REFERENCE.findall(found[0])
        if not names:
            continue
        inside = _inside(text, found)
        head = REFERENCE.sub(r"double \1[1]", found[0])
        body = re.sub(rf"\b({'|'.join(names)})\b", r"\1[0]", inside)
        text = text[: found.start()] + head + body + text[found.end() + len(inside) :]
    return text


def with_variables_passed(text: str, names: Sequence[str]) -> str:
    """Functions of C that read variables without a value, with these as arguments."""
    return _plain(text, "", GLOBAL, names)


def _globals_passed(text: str) -> str:
    """Variables of the file without a value, which its function reads, as its arguments."""
    outside = [m for m in GLOBAL.finditer(text) if _depth(text, m.start()) == 0]
    if not outside or len(FUNCTION.findall(text)) != 1 or CLASS.search(text):
        return text
    return _plain(text, "", GLOBAL)


ALIAS = re.compile(
    r"\busing\s+(?P<new>\w+)\s*=\s*(?P<kind>[\w:]+\s*<[^;]*>|double|float)\s*;"
    r"|\btypedef\s+(?P<old>[\w:]+\s*<[^;]*>|double\b|float\b)\s*(?P<name>\w+)\s*;"
)
BRACED = re.compile(r"\b(?:double|float)\s+(?:\w+\s*\{[^{};]*\}\s*(?:,\s*|(?=;)))+;")
"""Variables with their values in braces, which are 0 in empty ones."""
UNNAMED = re.compile(r"(,\s*(?:const\s+)?(?:double|float))\s*(?=\))")
"""The time, which integrators pass last and the function does not read."""
CALLED = re.compile(r"\boperator\s*\(\s*\)\s*\(")
"""The function that an object is called as."""


def _assigned(match: re.Match[str]) -> str:
    return re.sub(r"(\w+)\s*\{([^{};]*)\}", lambda m: f"{m[1]} = {m[2].strip() or '0.0'}", match[0])


MATRIX = re.compile(r"\bMatrix(?:X|([2-4]))[df]\s+(\w+)\s*(?:\(\s*(\d+)\s*,\s*(\d+)\s*\))?\s*;")


def _flat(text: str) -> str:
    """Matrices that a function fills, row by row."""
    for found in MATRIX.finditer(text):
        rows, columns = (int(found[1] or found[k] or 0) for k in (3, 4))
        if rows * columns == 0:
            continue
        name = found[2]
        text = text.replace(found[0], f"array<double, {rows * columns}> {name};")

        def entry(match: re.Match[str], name: str = name, columns: int = columns) -> str:
            return f"{name}[{int(match[1]) * columns + int(match[2])}]"

        text = re.sub(rf"\b{name}\s*\(\s*(\d+)\s*,\s*(\d+)\s*\)", entry, text)
    return text


def _with_aliases(text: str) -> str:
    """The text with types in place of the names that it gives to them."""
    for found in ALIAS.finditer(text):
        name, kind = found["new"] or found["name"], found["kind"] or found["old"]
        text = text.replace(found[0], blanked(found[0]))
        text = re.sub(rf"\b{name}\b", kind, text)
    return text


def _bound(match: re.Match[str]) -> str:
    """Each name of a structured binding as an entry, on as many lines."""
    names = [name.strip() for name in match[1].split(",")]
    entries = ", ".join(f"{name} = {match[2]}[{i}]" for i, name in enumerate(names))
    return f"const double {entries};" + "\n" * match[0].count("\n")


def _returned(text: str) -> str:
    """Functions that return a list of numbers, which C writes where an argument says."""
    for found in reversed(list(ARRAY.finditer(text))):
        inside = _inside(text, found)
        last = RETURN.search(inside)
        if last is None or len(re.findall(r"\breturn\b", inside)) > 1:
            continue
        values = _parts(last["values"])
        size = len(values)
        if found["size"] is not None and int(found["size"]) != size:
            continue
        lines = "".join(f"out[{i}] = {value};" for i, value in enumerate(values))
        arguments = ", ".join(filter(None, (found["arguments"].strip(), f"double out[{size}]")))
        head = f"void {found['name']}({arguments}) {{"
        rest = text[found.end() + len(inside) :]
        text = text[: found.start()] + head + inside[: last.start()] + lines + rest
    return text


def _parts(values: str) -> list[str]:
    """What commas outside of brackets part."""
    parts, depth = [""], 0
    for character in values:
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(character, 0)
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return parts if parts[-1].strip() else parts[:-1]


def _inside(text: str, opening: re.Match[str]) -> str:
    depth = 1
    for place in range(opening.end(), len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return text[opening.end() : place]
    return ""


def _plain(
    inside: str, name: str, declared: re.Pattern[str] = FIELD, known: Sequence[str] = ()
) -> str:
    """Functions of a class, with its fields as arguments; of a file, with its variables."""
    inside = ACCESS.sub(lambda m: blanked(m[0]), inside)
    if name:
        made = re.compile(rf"\b(?:explicit\s+)?{name}\s*\([^{{}};]*\)\s*(?::[^;]*?)?\{{[^{{}}]*\}}")
        inside = made.sub(lambda m: blanked(m[0]), inside)
    fields = list(known)

    def field(match: re.Match[str]) -> str:
        if "{" in inside[: match.start()] and _depth(inside, match.start()):
            return match[0]
        names = match[match.lastindex or 0].split(",")
        fields.extend(part.split("=")[0].strip() for part in names)
        return blanked(match[0])

    inside = inside if known else declared.sub(field, inside)
    functions = [m[2] for m in FUNCTION.finditer(inside)]
    passed = "".join(f", {name}" for name in fields)

    def head(match: re.Match[str]) -> str:
        own = ", ".join(f"double {name}" for name in fields)
        arguments = ", ".join(filter(None, (match[3].strip(), own)))
        return f"{match[1]} {match[2]}({arguments}) {{"

    called = [re.compile(rf"\b{name}\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)") for name in functions]
    pieces, at = [], 0
    for match in FUNCTION.finditer(inside):
        pieces += [_called(inside[at : match.start()], called, passed), head(match)]
        at = match.end()
    return "".join((*pieces, _called(inside[at:], called, passed)))


def _called(text: str, functions: list[re.Pattern[str]], passed: str) -> str:
    """Calls of functions of the class with its fields passed on."""
    for function in functions:
        text = function.sub(
            lambda m: m[0][:-1] + (passed if m[1].strip() else passed[2:]) + ")", text
        )
    return text


def _depth(text: str, at: int) -> int:
    return text.count("{", 0, at) - text.count("}", 0, at)
