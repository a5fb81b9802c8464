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
LOADS = re.compile(
    r"\\(?:usepackage|RequirePackage|documentclass)\s*(?:\[[^\[\]]*\]\s*)?\{(?P<names>[^{}]*)\}"
)
LOADED = words("""
    article report book letter minimal amsart amsbook scrartcl scrreprt scrbook revtex4 revtex4-1
    revtex4-2 IEEEtran standalone beamer memoir elsarticle exam extarticle extreport llncs svjour3
    aastex631 mnras proc slides tufte-handout tufte-book scrlttr2 iopart
    amsmath amssymb amsfonts amsthm amsbsy amstext amsopn mathtools mathrsfs bm bbm dsfont esint
    physics physics2 derivative diffcoeff siunitx units nicefrac xfrac cancel empheq breqn cases
    tensor braket esvect esdiff commath accents wasysym stmaryrd latexsym textcomp gensymb upgreek
    nccmath mathptmx newtxmath newtxtext txfonts pxfonts lmodern times palatino helvet courier
    fourier kpfonts libertine mathpazo eucal euscript cmbright concmath unicode-math fontspec
    inputenc fontenc babel polyglossia csquotes microtype setspace parskip indentfirst ragged2e
    geometry fullpage a4wide fancyhdr lastpage titling titlesec tocloft appendix abstract authblk
    graphicx graphics xcolor color epsfig epstopdf subcaption subfigure subfig caption float
    wrapfig rotating pdfpages svg tikz pgf pgfplots circuitikz tkz-euclide asymptote pstricks
    tikz-cd array tabularx tabulary longtable booktabs multirow multicol makecell diagbox colortbl
    dcolumn enumerate enumitem paralist listings minted verbatim fancyvrb algorithm algorithmic
    algorithmicx algpseudocode algorithm2e hyperref url cleveref xurl doi cite natbib biblatex
    backref footmisc footnote lineno comment todonotes soul ulem framed mdframed tcolorbox lipsum
    blindtext xspace ifthen etoolbox xparse calc environ chngcntr afterpage placeins pdflscape
    lscape needspace relsize scalerel adjustbox changepage varwidth hyphenat ctex xeCJK CJKutf8
    german ngerman french t1enc type1cm exsymath psfrag overpic import subfiles datetime
    mathdots polynom systeme mhchem chemformula nomencl glossaries acronym makeidx
""")
"""Classes and packages of LaTeX, which leave the names of mathematics what they are."""
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
TABLE = re.compile(
    r"\\begin\s*\{(?P<kind>tabular[xy]?|longtable)\*?\}.*?\\end\s*\{(?P=kind)\*?\}", re.DOTALL
)
CELLS = re.compile("(?P<mark>\u27e8[^\u27e9]*\u27e9)" r"|(?<!\\)&|\\\\(?:\s*\[[^\[\]]*\])?")
ITEM = re.compile(r"\\item\b\s*(?:\[(?P<label>[^\[\]]*)\])?")
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
    for load in LOADS.finditer(text):
        for name in load["names"].split(","):
            if name.strip() and name.strip() not in LOADED:
                yield f"the package {name.strip()!r}"
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
    """The words of a text alone, with its marks for formulas; rows and items are sentences."""
    text = TABLE.sub(lambda table: CELLS.sub(_cell, table[0]), text)
    text = ITEM.sub(lambda item: f". {item['label']}: " if item["label"] else ". ", text)
    return PARTS.sub(lambda part: part["mark"] or " ", text)


def _cell(found: re.Match[str]) -> str:
    return found["mark"] or (" | " if found[0] == "&" else ". ")


PARTS = re.compile(
    "(?P<mark>\u27e8[^\u27e9]*\u27e9)|"
    + "|".join(
        re.sub(r"\((?!\?)", "(?:", one.pattern) for one in (COLOURED, KEY, BRACED, COMMAND, ELEMENT)
    ),
)
