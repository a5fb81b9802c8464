"""Words that derivations are told in, and that say nothing of what is derived.

A sentence of these and of names, of the scene's own nouns and of what the rows of `phrases` have
compared with the scene cannot say otherwise than the scene; any other may, and is told as not read.
So there is no word here that denies, limits, compares, counts, or places anything.
"""

import re
from collections.abc import Collection
from difflib import get_close_matches


def words(text: str) -> frozenset[str]:
    """Words between blanks."""
    return frozenset(text.split())


TALK = words("""
    a an the this that these those it its we us our i my one which who whose what as so then
    thus hence therefore because since and or to of in on at for from with by about into through
    along via per if when where here there also again now next finally first lastly let us be is
    are was were been being has have had having do does can may could will would shall should
    must such both all any each every same itself themselves they them their how why just like
    e.g i.e etc cf vs ok re ve ll lot things simply directly clear clearly altogether after
    before while upon within between according respectively get gets got give gives given giving
    obtain obtains obtained find finds found finding write writes written writing read reads
    reading take takes taking taken use uses used using apply applies applied applying derive
    derives derived deriving derivation compute computes computed computing calculate calculated
    calculating substitute substitutes substituted substituting substitution insert inserting
    inserted plug plugging put putting solve solves solved solving solution solutions eliminate
    eliminating eliminated collect collecting rearrange rearranging rearranged simplify
    simplifies simplified simplifying simplification expand expanding expands differentiate
    differentiating differentiated integrate integrating divide dividing multiply multiplying
    add adding subtract subtracting combine combining express expressing expressed define
    defines defined defining definition definitions denote denotes denoted call called introduce
    introducing consider considering considered start starting begin beginning follow follows
    following followed result results resulting become becomes became reduce reduces reduced
    lead leads leading yield yields yielding govern governs governing describe describes
    described describing describe show shows shown showing see note recall remember know known
    need needs want make makes making state states stated proceed look looks go goes going come
    comes involve involves involved include includes represent represents linearize linearized
    linearizing linearization linearise linearised cause causes contain contains appear appears
    enter enters mean means choose choosing chosen evaluate evaluating say says set setting
    think draw drawing balance balancing explicit explicitly implicit final general deduce
    deduces deduced assume assumes assuming assumed suppose corrected modeled modelled equals
    equation equations expression expressions formula formulas formulae term terms side sides
    hand form forms matrix matrices vector vectors row rows column columns component components
    entry entries variable variables parameter parameters coefficient coefficients function
    functions notation symbol symbols shorthand derivative derivatives partial differential
    ordinary order system systems model models case cases part parts section chapter figure fig
    table page example problem answer step method approach procedure textbook book lecture paper
    appendix theorem principle law laws summary description setup work name names nonlinear
    linear coupled homogeneous standard above below previous explicit relevant complete
    determinant const constant constants conjugate cyclic dot dots prime primes standard pair
    sin cos tan shm approx difference ratios conservation direction directions due derivate user
    effect effects problems ode odes result approximation mass masses length lengths angle
    angles angular position positions coordinate coordinates displacement displacements velocity
    velocities speed speeds acceleration accelerations force forces torque torques moment
    moments inertia momentum momenta energy energies kinetic potential mechanical motion motions
    dynamics dynamic dynamical kinematics kinematic kinematical generalized generalised reaction
    reactions tension tensions time rate rates frequency frequencies natural period oscillation
    oscillations vibration vibrations libration librations oscillates oscillate amplitude
    amplitudes pivot hinged correct usual but pitch roll yaw near respect satisfy satisfies
    equilibria floor bear plane planes surface ground track wall small equilibrium radial
    tangential axis radius gravity gravitational lagrangian lagrange hamiltonian hamilton newton
    euler kane alembert conserved control input inputs output metre metres meter meters kilogram
    kilograms seconds newtons radian radians rad kg si units unit
""")
"""In English."""
OTHER_TALK = words("""
    die der das den dem ein eine einer ist sind mit und für um wir es also damit daraus folgt
    ergibt sich nach aus gilt erhält man bewegungsgleichung bewegungsgleichungen gleichung
    gleichungen funktion hamilton lagrange lautet lauten liefert energie kinetische potentielle
    gesamtenergie kleine ausschläge schwingungen drallsatz impulssatz lösung aufgabe ableitung
    einsetzen somit winkel masse länge kraft moment zeit
    le la les du de des et est sont un une donc avec on où en par pour ce cette ces ainsi alors
    nous obtient équation équations mouvement système lagrangien hamiltonien énergie énergies
    cinétique potentielle mécanique totale cas dans ordre pendule écrivons ecrivons coordonnée
    coordonnées cyclique petites ont pulsation cte radiale angulaire conservation solution
    exercice théorème vitesse accélération masse longueur angle force moment
    il lo i gli da dove quindi per su sarà sono un una di del della con allora invece si ha
    abbiamo lagrangiana hamiltoniana energia cinetica potenziale totale equazione equazioni moto
    data momento inerzia rispetto soluzione massa lunghezza angolo forza
    el los las para con y se por lo que es son sistema ecuación ecuaciones movimiento finales
    paso final energía energías cinética potencial total lagrangiano lagrangiana edos edo
    sustituyendo obtenemos entonces donde solución ángulo masa longitud fuerza equação equações
    movimento energia governantes sendo onde
    運動エネルギー ポテンシャルエネルギー ラグランジアン ラグランジュの運動方程式 に代入
""")
"""In other languages the little words, and those for equations and quantities."""
COUNTED = (
    "order|laws?|derivatives?|equations?|terms?|rows?|components?|kind|parameters?|coordinates?"
    "|unknowns?|variables?|ordinary|degrees of freedom"
)
PHRASES = re.compile(
    rf"\b(?:(?:left|right)[- ]hand(?: sides?)?|left with|sum of(?: the)? angles|well[ -]known"
    rf"|initial conditions?|at rest|not conserved|not (?:hard|difficult|surprising)"
    rf"|steps? \d+|free[- ]body diagrams?|polar coordinates?|parallel axis theorem|ratio of"
    rf"|non[- ]?linear|(?:1st|2nd|first|second|third|fourth|one|two|three|four|five|six|both)"
    rf"(?:(?:[ -]|and|first|second|1st|2nd|four){{1,6}}(?:{COUNTED}))"
    rf"|horizontal(?:ly)? (?:track|force|surface|position|distance|displacement|direction|component"
    rf"|motion|speed|velocity|line|rail|axis of|and vertical)"
    rf"|(?:near|about|around|at) the (?:upright|inverted|lower|upper|stable|unstable|hanging)?"
    rf" ?(?:equilibrium(?: position| point)?|position)|acceleration (?:due to|of) gravity"
    rf"|tensions? (?:in|of) the (?:string|cord|rope|cable)s?"
    rf"|tensions differ|is not the (?:total )?energy|al punto fisso"
    rf"|about the (?:foot|hinge|pin|joint|contact|point)"
    rf"|(?:do|does) not (?:depend|occur|appear|enter)"
    rf"|relative (?:displacements?|equilibrium|velocity|motion)"
    rf"|(?:omitting|ignoring|dropping)(?: the| a)? (?:total (?:time )?derivat\w+(?: terms?)?"
    rf"|constants?)"
    rf"|total (?:kinetic |potential |mechanical )?(?:energy|energies|time derivatives?))\b",
    re.IGNORECASE,
)
"""Of words that say something by themselves."""
WORDS = re.compile(r"(?<!\w)[^\W\d_]+(?![\w(])")
MADE = re.compile(r"^(?:d{1,2}|sin|cos|tan)(?=.)")
SPACED = re.compile(r"(?<!\w)[A-Za-z](?:[ .{}]{1,4}[A-Za-z]){2,}(?!\w)")
"""Letters of a word apart."""
SIGN = re.compile(
    r"[^\w\s.,;:()\[\]{}'\"\u2018\u2019\u201c\u201d&*#+=%|<>/@\\^$!?\u2026~`\u2010-\u2015\u2022\u00b7\u2192\u21d2\u00b0\ufeff"
    r"\u3001\u3002\uff0c\uff1a\uff1b\uff08\uff09\u220e\u25a0\u25a1-]"
)
"""No letter, and no mark of plain prose."""
ENDINGS = re.compile(r"'s\b|['\u2019`]")


def strange(words: str, own: Collection[str]) -> list[str]:
    """The words that are neither of derivations nor of the scene, in order.

    Parameters
    ----------
    words : str
    own : collection of str
        Nouns of the scene and names, in lower case.
    """
    apart = [m[0] for form in (SPACED, SIGN) for m in form.finditer(words)]
    plain = PHRASES.sub(" ", ENDINGS.sub(" ", words))
    every = (word.lower() for word in WORDS.findall(plain))
    kept = TALK | OTHER_TALK
    open_words = (w for w in every if len(w) > 1 and w not in kept and not _named(w, own))
    return [*apart, *(w for w in open_words if not _misspelled(w))]


def _named(word: str, own: Collection[str]) -> bool:
    """Whether it is of the scene, or made of what is: dx, ddtheta, sintheta."""
    return word in own or MADE.sub("", word, count=1) in {*own, "x", "y", "z"}


def _misspelled(word: str) -> bool:
    """Whether it is all but one letter of a long word: "diffferential"."""
    return len(word) > 8 and bool(get_close_matches(word, LONG, 1, 0.93))


LONG = sorted(word for word in TALK if len(word) > 8)
