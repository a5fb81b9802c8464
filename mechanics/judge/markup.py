r"""What stands around formulas and shows them plainly; all other markup is told as not read.

\textbf{Hence} \begin{align} a &= b \end{align}        plain
\st{$a = b$}  \setbox0\hbox{$a = b$}  <details>        who reads it may not see a statement
"""

import re
from collections.abc import Iterator

from mechanics.claims.latex.prepare import COLOURS
from mechanics.judge.phrases import words

COMMANDS = words("""
    text textbf textit textrm textsf texttt textnormal textup emph underline bf it rm bfseries
    itshape mathrm mathbf part chapter section subsection subsubsection paragraph item caption
    footnote title author date maketitle tableofcontents par noindent indent centering
    raggedright newline linebreak newpage clearpage pagebreak smallskip medskip bigskip hfill
    quad qquad small large Large LARGE huge normalsize footnotesize LaTeX TeX ldots dots
    textwidth linewidth hline toprule midrule bottomrule today left right displaystyle boxed
    nonumber intertext hbox mbox fbox
    vec hat bar tilde dot ddot frac sqrt sin cos tan alpha beta gamma delta epsilon varepsilon zeta
    eta theta vartheta kappa lambda mu nu xi rho sigma tau phi varphi chi psi omega Delta Theta
    Omega Phi Psi
""")
"""That show their argument, and change nothing but its font or place."""
ENVIRONMENTS = words("""
    document equation align gather multline eqnarray flalign displaymath math dmath alignat
    IEEEeqnarray aligned gathered split array cases dcases matrix pmatrix bmatrix vmatrix
    subequations figure table tabular center flushleft itemize enumerate description abstract
    proof solution answer theorem lemma proposition definition corollary remark example minipage
    small
""")
ELEMENTS = words("""
    b i u em strong p br hr sub sup h1 h2 h3 h4 h5 h6 ul ol li div span center table thead tbody
    tr td th code pre a img font math
""")
COLOURED = re.compile(rf"\\(?:textcolor|color)\s*\{{\s*(?:{COLOURS})\s*\}}")
COMMAND = re.compile(r"\\([A-Za-z@]+)\*?")
BRACED = re.compile(r"\\(begin|end)\s*\{\s*([^{}]*?)\*?\s*\}(?:\s*\[[^\[\]]*\]|\s*\{[\w\s|.@]*\})*")
KEY = re.compile(
    r"\\(?:label|ref|eqref|[cC]ref|autoref|pageref|cite[pt]?|includegraphics|usepackage|hspace"
    r"|vspace|documentclass|bibliography)\*?\s*(?:\[[^\[\]]*\]\s*)?\{[^{}$\\\u27e8]*\}"
)
"""With a key or a length, which is no text."""
ELEMENT = re.compile(r"<\s*/?\s*([A-Za-z][\w-]*)\b([^<>]*)>")
HIDES = re.compile(r"\b(?:hidden|style|class|color|size|alt|title)\b", re.IGNORECASE)
MARKED = re.compile("\u27e8[^\u27e9]*\u27e9")
STRUCK = re.compile(r"~~[^~]+~~|\{(?:--|\+\+|~~|>>|==)(?=[^{}]*\})")
"""Also what CriticMarkup deletes, adds, replaces or remarks: {--...--}."""
UNSEEN = re.compile(r"<!--(?![\w\s-]*-->)|^\[//\]:", re.MULTILINE)
"""A comment that may hold more than words, such as ``<!--more-->``."""


def unread_markup(text: str) -> Iterator[str]:
    """What is no plain markup in the prose of a text, in words.

    Parameters
    ----------
    text : str
        With marks for formulas.
    """
    text = KEY.sub(" ", COLOURED.sub(" ", MARKED.sub("\u27e8\u27e9", text)))
    for command in BRACED.finditer(text):
        if command[2] not in ENVIRONMENTS:
            yield f"the environment {command[2]!r}"
    for command in COMMAND.finditer(BRACED.sub(" ", text)):
        if command[1] not in COMMANDS:
            yield f"the command {command[0]}"
    for element in ELEMENT.finditer(text):
        if element[1].lower() not in ELEMENTS or HIDES.search(element[2]):
            yield f"the element <{element[1]}>"
    if STRUCK.search(text) or UNSEEN.search(text):
        yield "what is struck out or commented out"


def without_markup(text: str) -> str:
    """The words of a text alone, with its marks for formulas."""
    return PARTS.sub(lambda part: part["mark"] or " ", text)


PARTS = re.compile(
    "(?P<mark>\u27e8[^\u27e9]*\u27e9)|"
    + "|".join(
        re.sub(r"\((?!\?)", "(?:", one.pattern) for one in (COLOURED, KEY, BRACED, COMMAND, ELEMENT)
    ),
)
