"""Words that documents are made of, by notation: what the mutator puts in, and its tokens."""

import re

TOKENS: dict[str, re.Pattern[bytes]] = {
    "latex": re.compile(rb"\\[A-Za-z]+\*?|\\.|[A-Za-z]+|\d+|\s+|.", re.DOTALL),
    "text": re.compile(rb"[^\W\d]\w*|\d+\.?\d*(?:e[+-]?\d+)?|\*\*|==|\.\w+|\s+|.", re.DOTALL),
    "c": re.compile(rb"[^\W\d]\w*|\.?\d[\w.]*|//[^\n]*|[-+*/<>=!&|]{2}|\s+|.", re.DOTALL),
}

LATEX = rb"""
\frac \dfrac \frac12 \dot \ddot \dddot \dot{x} \ddot{\theta} { } ( ) [ ] ^ _ ^{2} ^2 _{1} _{C}
\left( \right) \left[ \right] \left| \right| \left. \sin \cos \tan \sin^2 \sin^{-1} \theta x M m L
k g f(t) I_C N1 T N & && &= \\ \\[2pt] = + - / \cdot \times 2 3 0 0.5 . , ; d t \mathrm{d} dt
\frac{d}{dt} \frac{d^2x}{dt^2} ' '' \prime ^\prime \tag{1} \tag*{(6)} \begin{pmatrix} \end{pmatrix}
\begin{align} \end{align} \begin{equation} \end{equation} \begin{array}{cc} \end{array} \sqrt
\sqrt[3]{x} \bar \bar{x} \hat \text{and} \text{where} $ $$ \[ \] \( \) \operatorname{sign} \{ \}
| \pi e e^{x} \quad \, % \label{a} \varphi \omega \exp \ln \arctan \mathrm{M} \boldsymbol{q}
\displaystyle \nonumber \equiv \\hline \max \min \begin{cases} \end{cases} 99999999999999999999
"""
TEXT = rb"""
x theta M m L k g f I_C N1 T N t 2 0 1 0.5 1e3 1e300 ( ) [ ] , ; = == + - * / ** ^ .* ./ .^
.diff(t) .diff(t,2) .diff( ' '' x' theta'' xdd x_ddot theta_dot sin( cos( tan( atan2( sqrt( log(
exp( abs( sign( Max( Eq( Rational( x(t) Derivative(x(t),t) Derivative( Matrix( .T .' ... % # : \
diff( sp. sympy. np. **60 **-1 **(1/2) **0.5 1/2 pi
"""
C = rb"""
double int float void const static inline return if else for while ( ) { } [ ] ; , = + - * / < > ==
<= && || ! ? : += *= -- ++ & x theta x_dot theta_dot M m L k g q u state out[0] out[1] q[0] u[1] 0
1 2 0.5 1e308 1e-300 0x1p-3 1.0f 3u sin( cos( sqrt( pow( fabs( atan2( exp( log( fmax( #define
#include #include<math.h> "/etc/passwd" #if #ifdef #endif #else #pragma /* */ // ??= \ \n 'a' "s"
struct typedef sizeof goto break continue switch case default do enum union unsigned long char
volatile restrict __attribute__ asm _Pragma extern register 4.0/3.0
"""

LETTERS = tuple(s.encode() for s in ("\u03b8", "\u00b2", "\u03b8\u0308", "\u2212", "\u0661"))

WORDS: dict[str, tuple[bytes, ...]] = {
    "latex": (*LATEX.split(), *LETTERS, b" ", b"\n", b"\n\n"),
    "text": (*TEXT.split(), *LETTERS, b" ", b"\n"),
    "c": (*C.split(), b" ", b"\n", b"\n#define A ", b"\n#define A B\n"),
}
