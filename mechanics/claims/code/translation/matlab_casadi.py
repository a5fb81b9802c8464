"""A function of MATLAB that makes one of CasADi, as the function that it makes.

function [model, nx] = make()              function rhs = make(x, F)
import casadi.*                            p = x(1); v = x(2);
p = SX.sym('p'); v = ...; F = ...
rhs = vertcat(v, F/m);                     rhs = [v; F/m];
x = vertcat(p, v);
model = Function('f', {x, F}, {rhs});      end
"""

import re

IMPORT = re.compile(r"^[ \t]*import casadi\.\*;?[ \t]*$", re.MULTILINE)
HEAD = re.compile(
    r"^[ \t]*function[ \t]+(?:\[?(?P<out>[\w ,]+)\]?[ \t]*=[ \t]*)(?P<name>\w+)[ \t]*\([ \t]*\)",
    re.MULTILINE,
)
SYMBOL = re.compile(
    r"^([ \t]*)(\w+)[ \t]*=[ \t]*[SM]X\.sym\([ \t]*'\w+'[ \t]*\)[ \t]*;", re.MULTILINE
)
MADE = re.compile(
    r"^[ \t]*(?P<model>\w+)[ \t]*=[ \t]*Function\([ \t]*'\w+'[ \t]*,[ \t]*\{(?P<given>[\w ,]+)\}"
    r"[ \t]*,[ \t]*\{[ \t]*(?P<value>\w+)[ \t]*\}[^;\n]*\)[ \t]*;?[ \t]*$",
    re.MULTILINE,
)
STACK = re.compile(r"\bvertcat\(")
COLUMN = r"^[ \t]*{name}[ \t]*=[ \t]*(?:vertcat\((?P<a>[\w ,]+)\)|\[(?P<b>[\w ;]+)\])[ \t]*;[ \t]*$"


def as_it_makes(text: str) -> str:
    """The text with the function that one of CasADi's is made of; itself where it is another."""
    heads, made = list(HEAD.finditer(text)), list(MADE.finditer(text))
    if not IMPORT.search(text) or len(heads) != 1 or len(made) != 1:
        return text
    head, one = heads[0], made[0]
    if re.search(r"^[ \t]*\w+[ \t]*(?:\([^=\n]*\)[ \t]*)?=(?!=)", text[one.end() :], re.MULTILINE):
        return text  # what is set when the function is made says nothing of it
    symbols = [m[2] for m in SYMBOL.finditer(text)]
    unpacked, columns = [], []
    given = [name.strip() for name in one["given"].split(",")]
    for name in given:
        if name in symbols:
            continue
        found = list(re.finditer(COLUMN.format(name=re.escape(name)), text, re.MULTILINE))
        entries = re.findall(r"\w+", (found[0]["a"] or found[0]["b"]) if len(found) == 1 else "")
        if not entries or not {*entries} <= {*symbols} or len({*entries}) < len(entries):
            return text
        unpacked += [f"{entry} = {name}({k});" for k, entry in enumerate(entries, start=1)]
        columns.append(found[0][0])
    others = {n.strip() for n in re.split(r"[ ,]+", head["out"]) if n.strip()} - {one["model"]}
    for line in (*columns, one[0]):
        text = text.replace(line, "")
    for name in others - {one["value"]}:
        text = re.sub(rf"^[ \t]*{name}[ \t]*=[^\n]*$", "", text, flags=re.MULTILINE)
    text = SYMBOL.sub("", _stacked(text))
    text = text.replace(head[0], f"function {one['value']} = {head['name']}({', '.join(given)})")
    return IMPORT.sub(" ".join(unpacked), text)


def _stacked(text: str) -> str:
    """``vertcat(a, b)`` as ``[a; b]``."""
    while call := STACK.search(text):
        out, depth, at = ["["], 1, call.end()
        while depth and at < len(text):
            sign = text[at]
            depth += (sign in "([{") - (sign in ")]}")
            out.append("]" if not depth else ";" if sign == "," and depth == 1 else sign)
            at += 1
        text = text[: call.start()] + "".join(out) + text[at:]
    return text
