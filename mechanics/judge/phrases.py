"""What sentences say of a scene, as data: words, and what is said by them.

NAME IS THE half|twice THE length        how long the scene's name is: a convention
FEATURES: friction, gravity, springs     there are some, or none

Texts come here with ⟨l⟩ for a name by itself and ⟨= ...⟩ for any other formula. In patterns words
in capitals stand for what `SLOTS` has.
"""

import re

from mechanics.claims.counting_words import NUMBERED
from mechanics.claims.foreign_units import (
    ANGLES,
    ENERGIES,
    FORCES,
    GRADIANS,
    LENGTHS,
    MASSES,
    RATES,
    REVOLUTIONS,
    TORQUES,
    any_of,
)
from mechanics.claims.prose import SYMBOL

SLOTS = {
    "NAME": r"⟨(?P<name>[A-Za-z]\w*)⟩",
    "IS": (
        r"(?: ?(?:is|are|be|being|denotes?|means?|stands? for|,|:|\||[-\u2013\u2014]{1,3}(?= )"
        r"|=(?= ?[a-z]{2})))?"
    ),
    "THE": r"(?:(?:the|an?|its) )?",
    "COUNTED": r"(?:measured|counted|counts|taken|reckoned)",
    "SENSE": r"(?:(?P<sense>(?:counter|anti)-?clockwise|clockwise|c?cw\+?) )?",
    "PLAIN": r"(?!(?:(?:counter|anti)-?)?clockwise\b|c?cw\b)[\w']+",
    "VERTICAL": (
        r"(?:(?:downward|upward)s? vertical"
        r"|vertical(?= (?:down|up)|, (?:down|up)| \((?:down|up))[, (]+(?:down|up)(?:wards?)?\)?)"
    ),
    "ENDS": (
        r"(?:upright|hanging|horizontal|(?:un)?stable equilibrium|lowest|highest|top|bottom"
        r"|below|above"
        r"|(?:negative|positive) [xyz][- ]axis)"
    ),
    "FIXED": (
        r"(?:the )?(?!(?:the|vertical|horizontal|upright|downward|upward|equilibrium|static|rest"
        r"|wall|ground|inertial|fixed|its|origin|earth|undeformed|position)\b)"
    ),
    "CENTRE": (
        r"(?:cent(?:re|er) of (?:mass|gravity|inertia)|mass cent(?:re|er)|centroid|CoM)"
    ),
    "LINK": (
        r"(?:(?:rod|pole|link|bar|stick|arm|beam|pendulum|string)s?|tiges?|fils?|varillas?|barras?"
        r"|cuerdas?|hilos?|ast[ae]|fil[oi]|Stangen?|St[aä]be?n?|F[aä]den)"
    ),
    "MASSLESS": (
        r"(?:mass-?less|weightless|of negligible mass|without mass|sans masse"
        r"|de masse négligeable|sin masa|de masa despreciable|senza massa|di massa trascurabile"
        r"|masselos\w*)"
    ),
    "ACTS": (
        r"(?: ?(?:,|\)|:|when|if|is|acts?|acting|applied|measured|counted|taken|positive|turns?"
        r"|increases|grows|directed|pushes|pulls|points|in|the|a|that|which|torque|moment|force|cart|carriage|trolley"
        r"|block|body))+"
    ),
    "SOLID": r"(?:mass(?:es)?|lengths?|springs?|stiffness(?:es)?|rods?|links?|bodies)",
}  # fmt: skip


def phrase(pattern: str) -> re.Pattern[str]:
    """A pattern with its slots filled."""
    for name, words in SLOTS.items():
        pattern = pattern.replace(name, words)
    return re.compile(pattern, re.IGNORECASE)


NAMED = re.compile("⟨(\\w+)⟩")
"""A name by itself."""


def words(text: str) -> frozenset[str]:
    """Words between blanks."""
    return frozenset(text.split())


DIRECTIONS = (
    phrase(
        r"NAMEIS (?:(?:the )?angle,? (?:of (?:the )?\w+,? )?)?(?:COUNTED )?SENSEfrom THE"
        r"(?P<way>VERTICAL|upright|hanging|horizontal)\b"
    ),
    phrase(
        r"NAMEIS (?:the |its )?(?:angle|inclination|elevation) (?:(?!from\b)[\w']+ ){0,6}?"
        r"(?:with|and|to|above|from) THE(?P<way>VERTICAL|horizontal|floor|ground|rail|track)\b"
    ),
    phrase(r"NAMEIS (?:COUNTED )?from THE(?P<way>top|highest|bottom|lowest|below|above)\b"),
    phrase(
        r"NAME (?:is zero|is 0|vanishes|equals zero|equals 0) (?:when|if|where|for|at|in) THE"
        r"(?:(?!not\b)[\w']+ ){0,4}?(?P<way>hangs|hanging|upright|inverted|horizontal)\b"
    ),
    phrase(
        r"\b(?P<way>hangs|hanging|upright|inverted|horizontal) (?:(?:straight )?down )?"
        rf"(?:at|for|when|where|if) ⟨=\s?{SYMBOL}\s?=\s?0\s?⟩"
    ),
    phrase(
        rf"\b(?:at|for|where|when|if) ⟨=\s?{SYMBOL}\s?=\s?0\s?⟩,? THE\w+ (?:is |stands |points )?"
        r"(?:at |in )?THE(?P<way>hangs|hanging|upright|horizontal|lowest|highest|top|bottom)\b"
    ),
    phrase(
        rf"⟨=\s?{SYMBOL}\s?=\s?0\s?⟩ "
        r"(?:is|corresponds to|denotes|means|describes|in|at|being) THE"
        r"(?P<way>downward|upward|upright|inverted|hanging|horizontal)\b"
    ),
)
"""From where an angle is counted."""
DIRECTED = (
    phrase(
        r"(?:\bif )?NAME(?: ?[,:=(\u2013\u2014-])? ?(?:PLAIN,? ){0,8}?SENSE(?:PLAIN,? ){0,6}?"
        r"(?:from|with|to|and|between|against) THE(?P<way>VERTICAL|ENDS|vertical)\b"
        r"(?! (?:force|component|plane|direction|motion|speed|velocity|position of))"
    ),
    phrase(
        r"NAME ?[),:(]? ?(?:is )?(?:when |= ?)?(?:zero|0),? ?"
        r"(?:= ?|when |if |where |for |at |in |means )?(?:[\w']+ ){0,5}?"
        r"(?P<way>hangs|hanging|upright|inverted|horizontal|(?:un)?stable equilibrium|top|bottom"
        r"|lowest|highest|points? (?:straight |vertically )?(?:up|down)(?:wards?)?"
        r"|straight (?:up|down))\b"
    ),
)
"""The same with words between of which each is known: angle of the first pendulum from."""
THE_ANGLE = re.compile(
    r"\b(?:(?:the|its) )?(?:(?:rod|pole|pendulum|link|arm|bar|bob|deflection) )?angle"
    r"(?=,? (?:is |of the \w+ )?(?:measured|counted|from|with the)\b)", re.IGNORECASE,
)  # fmt: skip
"""Of a scene that has one."""
OPPOSITE = phrase(
    rf"⟨=\s?{SYMBOL}\s?=\s?\\?pi\s?⟩ (?:is|corresponds to|denotes|means|describes) THE"
    r"(?P<way>downward|upward|upright|inverted|hanging)\b"
)
"""Where an angle is half a turn."""
EVERY_ANGLE = phrase(
    r"(?:\b(?:both|all|the|absolute|with) |^)(?:(?:of )?the )?angles (?:are )?(?:COUNTED )?from THE"
    r"(?P<way>VERTICAL|ENDS|vertical)\b"
)
WAYS = {
    "downward": "hanging", "upward": "upright", "inverted": "upright", "top": "upright",
    "highest": "upright", "hangs": "hanging", "bottom": "hanging", "lowest": "hanging",
    "below": "hanging", "above": "upright",
    "floor": "horizontal", "ground": "horizontal", "rail": "horizontal", "track": "horizontal",
}  # fmt: skip
"""Ways as conventions call them."""
HALF = phrase(r"NAMEIS THE?half[ -](?:of )?THE(?:total |full |whole )?length\b")
TWICE = phrase(r"NAMEIS THE?twice (?:of )?THE(?:total |full |whole )?length\b")
DOUBLE = phrase(r"⟨=\s?2\s?\\?(?P<name>[A-Za-z]\w*)\s?⟩IS THE(?:\w+ )?length\b")
WHOLE = phrase(r"NAMEIS (?:the|its) (?:(?:full|total|whole|entire) length\b|length of the\b)")
TO_AN_END = phrase(
    r"NAMEIS THE(?:(?:total|full|whole) )?length (?:of (?:the |its )?\w+ )?from "
    r"(?:(?!and\b)[\w']+ ){1,4}?to (?:(?:the|its|other|free|outer|far|lower|upper) ){0,3}"
    r"(?:end|tip)\b"
)
TO_CENTRE = phrase(
    r"NAMEIS THE(?:distance|length) (?:(?:from (?:(?!and\b)[\w']+ ){1,6})?to"
    r"|between (?:(?!and\b)[\w']+ ){1,6}and|of) (?:the|its) (?:\w+(?:'s)? )?CENTRE\b"
)
NEGATIVE = phrase(
    r"NAMEIS (?:minus|the (?:negative|opposite)(?: of)?|opposite to) THE"
    r"(?:\w+ ){0,2}(?:torque|moment|force|input|control)\b"
)
TURNS = phrase(r"NAMEACTS (?P<way>(?:counter|anti)-?clockwise|clockwise)\b(?! from)")
PUSHES = phrase(r"NAMEACTS (?:to (?:the )?)?(?P<way>left|right|leftwards?|rightwards?)\b")

UNIT = phrase(
    r"(?:NAME|\b(?P<all>time|angle|length|mass|force|torque)(?:e?s)?)(?: is| are| be| being|,|:)? ?"
    r"(?:(?!in\b|not\b)[a-z]+,? ){0,5}?"
    r"(?:measured |given |taken |expressed )?in (?P<unit>(?:N ?[mck]m"
    r"|(?:newton[ -])?(?:centi|milli|kilo(?!gram))\w+|minutes|hours"
    rf"|{any_of(*ANGLES, *GRADIANS, *LENGTHS, *FORCES, *TORQUES, *MASSES, *RATES)})\b"
    r"|°|⟨= \^\s?\{?\s?\\circ\s?\}?⟩)"
)
"""A unit that is not the scene's."""
FACTOR = phrase(
    r"NAMEIS (?P<size>half|twice|double|two times|one third|a third) (?:of )?THE"
    r"(?:(?:total|full|whole|applied|driving) )?(?P<what>mass|torque|force|moment)\b"
)
OF_LENGTH = phrase(
    r"\b(?:of|with|has|have|having|and) THE(?:(?:total|full|whole|overall) )?length NAME"
)
EXTENSION = phrase(
    r"NAMEIS (?:THE(?:\w+ )?(?:extension|elongation|stretch|compression)"
    r"(?! of (?:the )?(?:rod|arm))"
    r"|how (?:much|far) (?:the )?spring is (?:stretched|extended|elongated))\b"
)
SPRING_LENGTH = phrase(
    r"NAMEIS THE(?:(?:current|instantaneous|total|stretched|actual) )?length of (?:the )?spring\b"
)
UPWARD = phrase(
    r"NAME(?:[- ](?:axis|direction|coordinate))?IS (?:(?:the|a|its|taken|as|and|is|height|position"
    r"|displacement|coordinate|distance|way|path|of|mass|body|bob|cart|block|load|⟨\w+⟩),? ){0,6}"
    r"(?:COUNTED|positive|points?|pointing|directed|increas(?:es|ing)|grows)? ?(?:as )?"
    r"(?:positive |vertically |straight )?(?P<way>(?:down|up)ward|(?<=pointing )(?:down|up)"
    r"|(?<=points )(?:down|up)|(?<=vertically )(?:down|up))s?\b(?! vertical)"
)
HEIGHT = phrase(
    r"NAMEIS THE(?:vertical |instantaneous |current )?(?P<way>height|elevation|altitude|depth) "
    r"(?:of|above|below|over)\b(?![^.;]*\b(?:fall\w*|fell|drop\w*|lost|through|sink\w*|sank))"
)
CALLED = phrase(
    r"\b(?P<words>peak[- ]to[- ]peak amplitude|diameter|compliance|flexibility)\)? NAME"
)
"""What a name is, before it, that others are taken for."""
INERTIAL = phrase(
    r"NAME[^⟨.;]{0,80}?\b(?:laboratory|lab|inertial|space-?fixed|non-?rotating|stationary|ground"
    r"|world|absolute) (?:reference )?(?:frame|(?:coordinate )?system|coordinates)\b"
)
SLOPE = phrase(
    r"(?:NAME[^⟨.;]{0,30}?|\bangle (?:of )?⟨(?P<of>\w+)⟩ )\b(?:with|to|from|against) (?:the )?"
    r"(?P<way>vertical|horizontal)\b"
)
"""A parameter that is an angle."""
ROUND = r"(?:hoop|ring|pipe|dis[ck]|cylinder|tube|shell|sphere|ball)"
SHAPE = (
    phrase(
        r"\bthe (?P<body>\w+) (?:is|being|be|has the form of) (?:modell?ed as |taken as )?"
        rf"(?:an? )?(?P<shape>(?:[a-z-]+ ){{0,3}}{ROUND})\b"
    ),
    phrase(rf"\b(?P<shape>(?:[a-z-]+ ){{0,2}}{ROUND}) ?(?:,? (?:of|with)(?: the| a)? mass|,) NAME"),
    phrase(rf"^(?:for|take|consider) an? (?P<shape>(?:[a-z-]+ ){{0,2}}{ROUND}) ?(?=[:,]|$|we )"),
)
"""A body that is round, by its name or its mass."""
DENOTED = phrase(
    r"NAMEIS (?:(?:the|an?|its) )(?P<words>"
    r"(?:(?!\b(?:and|which|that|where|with|while|but|when|if)\b)[^⟨.;:,()|]){3,80})(?=(?P<formula>⟨?))"
)
COUNTS = re.compile(
    r"\b(?:minus|negative|positive|opposite|(?:counter|anti)?-?clockwise|left|right|up|down|upwards?"
    r"|downwards?|from|measured|counted|direction|same)\b", re.IGNORECASE
)  # fmt: skip
"""Words for how something counts."""
FROM = re.compile(
    r"\b(?:measured|counted|reckoned|relative to|with respect to|distance (?:between|of)"
    r"|(?<!away )(?<!hangs )(?<!hanging )(?<!hung )(?<!suspended )from(?! which| whom))\b",
    re.IGNORECASE,
)
"""Words for from where something counts."""
WAY = re.compile(
    FROM.pattern + r"|\b(?:relative|c?cw|clockwise|(?:counter|anti)-?clockwise|upwards?|downwards?"
    r"|left|right(?!-hand side)|positive|negative|opposite|revers\w+|against|towards?|backwards?"
    r"|inwards?|outwards?|uphill|downhill|hangs|hanging|upright|aligned"
    r"|inverted(?! (?:pendulum|rod|pole))"
    r"|zero (?:when|if|where|at|for|in|means)|sinks?|rises?|climbs?|descend\w*|ascend\w*"
    r"|(?:comes?|gone|goe?s?|moved?s?|slides?|runs?) (?:up|down)"
    r"|(?:with|to|above|between|and|about|around|of|at) (?:(?:the|its|their|static) ){0,2}"
    r"(?:vertical|horizontal|equilibrium)(?! (?:diameter|axis|plane|circle|motion|component))"
    r")\b", re.IGNORECASE,
)  # fmt: skip
"""The same, and for which way."""
PASSING = re.compile(
    r"\b(?:energ(?:y|ies)|moment(?:um|a)|equations?(?: of motion)?|derivatives?|functions?|terms"
    r"|components?|accelerations?|velocit(?:y|ies)|speeds?|rates?) (?:of|for|in|to|by) (?:the )?"
    r"⟨\w+⟩(?:(?:,| and|, and) ⟨\w+⟩)*|\b(?:divid|multipl|solv)\w* (?:\w+ )?(?:by|for) ⟨\w+⟩"
    r"|(?:⟨\w+⟩(?:,| and|, and)? )+(?:is|are) (?:all |both )?"
    r"(?:(?:constants?|given|known|parameters?|fixed)\b"
    r"(?! (?:to|in|on|when|if|for|towards?|up|down|left|right|clock|counter|anti))"
    r"|positive(?= ?(?:[.,;:)]|$|(?:and|or|real|numbers?|constants?|parameters?|quantities)\b)))"
    r"|⟨\w+⟩[- ](?:position|coordinate|axis|direction|component|velocity|speed|acceleration)\b"
    r"|\b(?:eliminat|cancel|substitut)\w* ⟨\w+⟩|⟨\w+⟩ (?:cancels|drops out|vanishes)"
    r"|\b(?:deriv|differentiat)\w*[^.;]{0,40}? with respect to ⟨\w+⟩(?:(?:,| and|, and) ⟨\w+⟩)*"
    r"|(?:\bangles? (?:is|are) (?:all )?measured in (?:rad|radians)"
    r"|⟨\w+⟩ (?:is|are) measured in"
    r" (?:kg|N|rad|s|⟨m⟩|newton met(?:er|re)s"
    r"|(?:kilogram|newton|met(?:er|re)|second|radian|joule)s?)"
    r"|\bmeasured in SI units)(?= *(?:[.,;:)]|$))"
    r"|^From |\bfrom (?:the )?(?:\w+ )?(?:equations?|geometry|figure|laws?|lagrangian|energy)\b",
    re.IGNORECASE,
)
"""What only names whose an equation is."""
BESIDE_A_UNIT = re.compile(
    r"[(\[][kgNradsJ.*·/^\d²³\u207b -]{0,10}⟨m⟩[kgNradsJ.*·/^\d²³\u207b -]{0,10}[)\]]"
    r"|\bin (?:kg|N|rad|s)? ?[*·/]? ?⟨m⟩[/*^\d]*|⟨m⟩ ?/ ?s"
)
"""A letter that is a unit there."""
THING_AND_WAY = re.compile(
    r"\b(?:it|they|both) (?:acts?|points?|counts?|pushes|pulls|grows?|increases?)\b|"
    r"\b(?:angles?|positions?|displacements?|deflections?|coordinates?|heights?|forces?|torques?"
    r"|extensions?|x|y|z|axis|axes)\b[^.;]{0,60}?\b"
    r"(?:(?:is|are|being|as|taken|,|\() ?(?:\w+ ){0,2}?"
    r"(?:measured|counted|reckoned|clockwise|(?:counter|anti)-?clockwise|positive|negative|upwards?"
    r"|downwards?|zero)\b|from (?:the )?(?:(?:downward|upward)s? )?(?:vertical|horizontal|upright"
    r"|hanging|top|bottom|wall|ground|floor|pivot|equilibrium)\b)",
    re.IGNORECASE,
)
"""The same of what has no name there."""
LETTERS = (("radius", "rRaA"), ("length", "lL"))
"""With which names of lengths begin."""
OF_TWO = re.compile(r" ?and (?:(?:the|its|a) )?(?=[a-z])")
SHARED = re.compile(
    r"(?:^| )(?:and|with|plus|including) (?:(?:the|its|a) )?(?:first|second|third|upper|lower|other"
    r"|(?:rod|pole|pendulum|bar|link|arm|cart|carriage|trolley|bob|ball|bead|mass|body|load|wheel)s?)\b"
)
"""What a quantity is said to be of, too."""
HANGING_PREPOSITION = re.compile(
    r" (?:from|by|on|in|at|with|to|of|in (?:kg|m|rad|met(?:er|re)s|kilograms|radians))$"
)
POSITION_OF = re.compile(
    r"(?:\w+ )?(?:position|displacement|coordinate) of (?:the |its )?"
    r"(?P<part>tip|end|top|bottom|middle|midpoint|hinge|pivot|joint|edge|rim)\b"
)
INNER = re.compile(r"\b(?:small(?:er)?|rolling|moving|inner (?!radius|surface))\b", re.IGNORECASE)
OUTER = re.compile(
    r"\b(?:hollow|outer|larger?|big(?:ger)?|fixed|stationary|bowl|track|pipe|tube|surface)\b",
    re.IGNORECASE,
)
"""What moves in something, and that."""
PER = phrase(
    r"NAME[^⟨.;]{0,60}?\b(?P<words>(?:revolutions?|turns|cycles|rotations|degrees) (?:per|a) "
    r"(?:second|minute)|in (?:rpm|hertz|Hz|rev/s))\b"
)
AGAINST = phrase(
    r"NAME[^⟨.;]{0,40}?\b(?P<words>(?:of|towards) decreasing|opposite (?:to|in)|opposing|opposes"
    r"|against (?:the )?(?:motion|rotation|direction))\b"
)
RELATIVE = phrase(
    r"NAME[^⟨.;]{0,60}?\b(?:relative to FIXED|between the (?:two |both )?(?=\w+s\b)"
    r"|between the (?=(?:first|upper|second|lower)\b)"
    r"|from (?:the )?(?:first|upper|previous|preceding|inner) "
    r"|(?:makes|made|forms|formed|encloses) with (?:the )?"
    r"(?=(?:first|upper|previous|preceding|other|inner|second|lower|LINK)\b)"
    r"|(?:from|with|to) (?:the )?(?:extension|prolongation|continuation|line|axis|direction) of"
    r" FIXED"
    r"(?!(?:gravity|motion|travel|symmetry|rotation|the)\b)(?:(?:first|upper|previous|other) )?)"
    r"(?P<to>\w+)"
)
KINDS_OF_ANGLE = (
    phrase(
        r"NAME(?:(?: and|,) ⟨(?P<more>\w+)⟩)?IS (?:the |an? )?(?:\w+ )?"
        r"(?P<kind>relative|absolute|joint) (?:angle|rotation|orientation)s?\b"
    ),
    phrase(
        r"\b(?:both|all|the)(?: the| of the)? angles are (?:all )?"
        r"(?P<kind>relative|absolute|joint)\b"
    ),
)
ALIGNED = tuple(
    phrase(
        rf"{zero} (?:when|if|where|for|means that) (?:[\w']+ ){{0,6}}"
        r"(?P<to>aligned|in line|collinear)\b(?! with the (?:vertical|horizontal|axis|[xyz]\b))"
    )
    for zero in (
        r"NAME (?:is zero|is 0|vanishes|equals zero|equals 0)", rf"⟨=\s?{SYMBOL}\s?=\s?0\s?⟩",
    )
)  # fmt: skip
"""Where an angle between two bodies is zero."""
ABSOLUTE = phrase(
    r"NAME[^⟨.;]{0,40}?\b(?:from|with|relative to) (?:the )?(?:(?:down|up)wards? )?"
    r"(?P<to>vertical|horizontal|wall|ground)\b"
)
AT_REST = ("equilibrium", "unstretched", "undeformed", "relaxed")
FROM_EQUILIBRIUM = phrase(
    r"NAME(?: and ⟨(?P<more>\w+)⟩)?IS THE(?:displacements?|deflections?|positions?|coordinates?)"
    r"(?: COUNTED)? (?:from|about|relative to) (?:(?:the|its|their|static) ){0,2}"
    r"(?:equilibrium|unstretched|undeformed|relaxed)\b"
)
ABOUT = phrase(r"NAME(?: and ⟨\w+⟩)?[^⟨.;]{0,60}?\babout (?:the |its |their )?(?P<to>\w+)")
OF_SYMMETRY = ("figure", "symmetry", "spin", "body", "same", "other")
CENTRAL = phrase(r"CENTRE\b")
OUTSIDE = re.compile(r"(?:pivot|hinge|joint|pin|support|suspension|end|foot)\b", re.IGNORECASE)
"""What is no mass centre."""
_SI = (
    r"kg|N|⟨?m⟩?|s|rad|J|kilograms?|newtons?|met(?:er|re)s?|seconds?|radians?|joules?"
    r"|(?<=per )(?:kilogram|met(?:er|re)|second|radian)"
)
OTHER_UNIT = (
    rf"°|{any_of(*ANGLES, *GRADIANS, *REVOLUTIONS, *LENGTHS, *FORCES, *TORQUES)}"
    rf"|{any_of(*MASSES, *ENERGIES, *RATES)}|g|h|min"
)
"""One that no scene counts in; a gram, an hour and a minute in a product only."""
STATED_UNIT = phrase(
    rf"NAME(?:(?! in (?:{_SI}|{OTHER_UNIT})\b)[^⟨.;)\]]){{0,60}}?(?P<before> in |, ?| ?[(\[|] ?)"
    rf"(?P<unit>(?:(?:{OTHER_UNIT}|{_SI})(?:\^?-?\d|[²³])?(?: per |[ */·])?){{1,6}})"
    r"(?=[)\],.;|]| *$)"
)
"""A unit at the end of what is said of a name, or in brackets."""
LONG_UNITS = {"kilogram": "kg", "newton": "N", "metre": "m", "meter": "m", "second": "s",
              "radian": "rad", "joule": "J"}  # fmt: skip
"""Symbols of units by their names."""
PLACE = (
    phrase(
        r"NAMEIS THE(?:horizontal |vertical |lateral )?"
        r"(?:position|displacement|coordinate|deflection) of (?:(?:the|its) )?"
        r"(?:CENTRE of (?:the )?)?(?P<body>\w+)"
    ),
    phrase(
        r"NAMEIS THE(?P<body>\w+)(?:'s)? (?:horizontal )?(?:position|displacement|coordinate)\b"
    ),
    phrase(r"\b(?P<body>\w+)(?:'s)? (?:position|displacement|coordinate) \(? ?NAME"),
)
ON_BODY = (
    phrase(
        r"NAMEIS THE(?:\w+ ){0,2}(?P<sort>force|torque|moment)(?: \w+)? (?:on|to) "
        r"(?:the |an? )?(?P<body>\w+)"
    ),
    phrase(
        r"\b(?:\w+ )?(?P<sort>force|torque|moment) NAME (?:\w+ ){0,2}\w+ (?:on|to) "
        r"(?:the |an? )?(?P<body>\w+)"
    ),
    phrase(
        r"\b(?:\w+ )?(?P<sort>force|torque|moment) NAME (?:pushes|pulls|drives|moves|turns) "
        r"(?:the |an? )?(?P<body>\w+)"
    ),
)
EXERTED = phrase(
    r"\b(?:motor|actuator|drive|engine|servo) (?:exerts|applies|delivers|produces|gives|with) "
    r"THE(?P<words>(?:\w+ )?(?:force|torque|moment)) NAME(?=[.,;)]|$| and\b)"
)
"""An input of which no more is said."""
DOTS = phrase(
    r"(?<!\\)\b(?:over)?(?:dots?|primes?)\b[^.;⟨⟩]{0,50}\b(?:with respect to|by|(?:is|are|means?"
    r"|denotes?)(?: the)?(?: derivatives?)?) (?:the )?"
    r"(?P<by>(?:dimensionless|non-?dimensional|scaled|normali[sz]ed|rescaled|proper) time"
    r"|⟨(?!t⟩|=)[^⟩]*⟩"
    r"|⟨= \\?[dt]?(?:frac)? ?\{?\\?(?:mathrm)?\{?d\}?\}? ?/? ?\{?d ?(?!t\b)\\?\w+\}?⟩"
    r"|(?:(?<=with respect to )|(?<= by ))⟨= (?!t\b)\\?\w+ ?=[^⟩]*⟩)"
)
PRIMED = re.compile(
    r"⟨= (?P<by>\\?[A-Za-z]+(?:_\{?\w+\}?)?)\s*(?:'|\^\s*\{?\s*\\prime\s*\}?)\s*(?::=|=|\\equiv)\s*"
    r"(?P=by)\s*[-+][^⟩='\\]*(?:\\[a-zA-Z]+[^⟩='\\]*)?⟩"
)
"""A prime that makes another letter: theta' = theta - pi."""
SCALED_TIME = re.compile(
    r"⟨= (?P<by>\\tau|\\(?:bar|hat|tilde)\s*\{?\s*t\s*\}?|t\^\s*\{?\*\}?|t'|s|T|\\xi) ?"
    r"(?:=|\\equiv) ?(?=[^⟩=]*(?<![A-Za-z\\])t(?![A-Za-z]))[^⟩=]*⟩"
)
"""Another time: tau = t sqrt(g/l)."""
NO_MASS = (
    phrase(r"\b(?:MASSLESS|light) (?:rigid )?(?P<body>LINK)\b"),
    phrase(r"\b(?P<body>\w+) (?:is|are) (?:\w+ )?MASSLESS"),
    phrase(r"\b(?P<body>LINK) (?:rigid[ea]?s? )?MASSLESS"),
    phrase(r"\bmasselose[nrs]? (?P<body>LINK)\b"),
    phrase(r"\b(?P<body>\w+) (?:has|have) (?:no|negligible|zero) (?:mass|inertia)\b"),
    phrase(
        r"\b(?P<body>LINK) (?:of|with) (?:(?!and\b)[\w⟨⟩]+ ){0,5}and (?:of )?(?:no|negligible|zero)"
        r" mass\b"
    ),
    phrase(r"\bmass(?:es)? of (?:the )?(?P<body>\w+) (?:is|are) (?:neglected|negligible|zero)"),
    phrase(r"\b(?:neglect|ignor)\w+ (?:the )?mass(?:es)? of (?:the )?(?P<body>\w+)"),
)
EQUAL = (
    phrase(r"\b(?P<how>identical|equal|same|different|unequal) (?P<what>SOLID)\b(?! cent)"),
    phrase(
        r"\b(?P<what>SOLID)(?: \w+){0,2}? are (?:all |both )?(?P<how>equal|identical|different)"
    ),
)
VALUE = phrase(
    r"\b(?P<what>mass|length|stiffness|radius|spring constant)(?:es)? (?:of )?"
    r"⟨=\s?(?P<factor>\d+)\s?\\?(?P<name>[A-Za-z]\w*)\s?⟩"
)
SORT = phrase(r"\b(?P<sort>physical|compound|simple|mathematical) pendulum\b")
FLAT = phrase(
    r"\b(?:in|on) (?:a|the) (?:smooth |frictionless )?(?:horizontal|level) (?:air )?"
    r"(?:plane|table)\b"
)
STILL = phrase(
    r"\b(?P<body>\w+) (?:is|are) (?:held |kept )?"
    r"(?:fixed|clamped|locked|screwed|bolted|glued|welded|nailed|at rest)\b"
)
ONLY_ONE = phrase(
    r"\bonly (?:the )?(?P<body>\w+) (?:moves|(?:has|have|possesses|contributes)"
    r"(?: to)? (?:any |a )?(?:changing |varying |variable )?"
    r"(?P<energy>(?:the )?potential energy))\b"
)
OF_INERTIA = re.compile(r"\bmoments? of inertia\b")
DRIVEN = phrase(
    r"\b(?P<what>pivot|point of support|support|suspension|base|hinge)\b[^⟨.;,]{0,80}?"
    r" (?:moves|oscillates|vibrates|accelerates|(?:is|being) (?:moved|accelerated|shaken|driven))\b"
    r"(?: (?P<way>horizontally|vertically|up and down|to and fro|sideways))?"
)

FEATURES = (
    (
        "friction",
        r"friction|damp|dashpot|viscous|\bdrag\b|resistance|dissipat"
        r"|fricci[oó]n|rozamiento|frottement|reibung|attrito|atrito",
    ),
    (
        "gravity",
        r"(?<!cent\w\w of )(?<!acceleration of )(?:gravity|gravitational)|gravedad|schwerkraft",
    ),
    ("springs", r"\bsprings?\b|\b(?:resorte|muelle|ressort|mola)s?\b|\bmolle?\b"),
)
"""What a scene has or has not, and words of it."""
ABSENT = re.compile(
    r"(?<!\\)\b(?:no|not|without|neglect\w*|ignor\w+|negligible|absen\w+|disregard\w*|free of"
    r"|never|nor|sin(?! *[(^])|sans|ohne|senza|sem)\b"
    r"|frictionless|undamped|gravity-free|-free\b",
    re.IGNORECASE,
)
OF_FREQUENCY = re.compile(
    r"\bundamped(?=\s+(?:(?:natural|angular|circular)\s+)*(?:\w*frequenc|period))"
    r"|(?<=frequency of the )undamped(?=\s+(?:system|oscillat|motion))"
    r"|\b(?:without|in the absence of)\s+(?:the\s+|any\s+)?(?:damping|friction)"
    r"(?=,?\s+(?:the|its)\s+(?:(?:natural|angular|circular)\s+)+(?:\w*frequenc|period))",
    re.IGNORECASE,
)
"""What says of a frequency which one it is, and nothing of the scene."""
PARTS = re.compile(r", |\b(?:but|so that|while|and)\b")
"""What sets parts of a sentence apart that say something each."""
DENIED = re.compile(r"\b(?:not|no|never|unlike|rather|instead|than|contrast)\b", re.IGNORECASE)
SORTS = re.compile(
    r"\b(velocity|speed|acceleration|mass|force|torque|moment|couple|stiffness|energy|momentum)"
    r"(?= *$)"
)
"""Last nouns that tell a place from what is none, and a force from a torque."""
PREDICATES = re.compile(
    r"\b(?:(?:kinetic|potential) energ(?:y|ies)|angles?|velocit(?:y|ies)|speeds?|positions?"
    r"|coordinates?|displacements?|motion|system)(?: (?:of|in|on) (?:the )?\w+){0,2}"
    r" (?:is|are|remains?|stays?) (?:\w+ )?(?:constant|conserved|small|linear|zero)\b",
    re.IGNORECASE,
)
"""What is said of a motion or a system, and nobody compares."""
CONDITION = re.compile(
    r"[<>\u226a\u226b\u2208\u2260\u2248]"
    r"|\\(?:ll|gg|in|to|infty|leq?|geq?|neq?|not|approx|simeq|sim|forall)(?![A-Za-z])"
)
"""What a formula limits."""
DENIES = re.compile(
    r"no|not|nor|non|never|none|nothing|nobody|without|\w+n't|cannot|unlike|rather|instead|contrast"
    r"|contrary|except|unless|until|only|provided|if|neglect\w*|ignor\w+|negligibl\w+|disregard\w*|absen\w+"
    r"|missing|otherwise|else|fail\w*|wrong\w*|false\w*|incorrect\w*|invalid|approximate\w*"
    r"|nicht|kein\w*|ohne|vernachlässigt?\w*|nur|falls|falsch\w*|ne|pas|sans|néglig\w*|seulement|faux"
    r"|sin|senza|sem|nunca|não|mai|trascur\w*|despreci\w*|desprez\w*|solo|sólo|fals[oa]",
    re.IGNORECASE,
)
"""Words that deny what they stand beside, or limit where it holds."""
THINGS = re.compile(
    r"\b(?:mass(?:es)?|rods?|poles?|pendulums?|bars?|links?|arms?|carts?|carriage|trolley|springs?"
    r"|hoop|ring|bead|bobs?|wheels?|disks?|discs?|cylinders?|spheres?|bodies|body|particles?)\b",
    re.IGNORECASE,
)
"""What quantities of a scene are of."""
ALIKE = (
    frozenset(("rod", "pole", "pendulum", "bar", "stick", "beam", "link", "arm")),
    frozenset(("cart", "carriage", "trolley", "car", "wagon")),
    frozenset(("bead", "bob", "particle", "ball", "load", "payload", "container", "cargo")),
    frozenset(("hoop", "ring", "circle")),
)
"""Words for one thing, in a scene that uses no two of them."""
VERTICALS = ("vertical", "horizontal")
POINTING = words("""
    positive points pointing directed increases increasing grows taken vertically straight axis
    direction height way path distance is
""")
PREVIOUS = frozenset(("previous", "preceding", "other"))
WITHOUT_A_BODY = re.compile(
    r"(?:pulley|string|rope|thread|cable|wire|spring|belt|axle|track|rail)s?", re.IGNORECASE
)
"""What has no mass where no body is called so."""
LINKS = ("rod", "string", "thread", "rope", "wire")
"""What angles are of; `ALIKE` has more words for the first."""
ORDINALS = {str(number): some for number, some in enumerate(NUMBERED, start=1)}
"""Words for the number in a name."""
AXIS = re.compile(r"(?P<sign>negative|positive) (?P<axis>[xyz]) axis")
GRAVITY = frozenset(("gravity", "gravitational", "acceleration", "due", "to", "constant"))
TURNING = frozenset(("torque", "moment", "couple"))
PUSHING = frozenset(("force", "thrust"))
PUSHES_ON = words("pushes pulls drives moves turns exerts is acts applied acting")
APPLIED = frozenset(("applied", "driving", "external", "motor", "control", "input", "disturbance"))
COUNTED = words("""
    is are be being counts against denotes denote means mean measured counted taken reckoned acts
    acting angle made makes with and from to on between relative zero when if where for at
    generalized coordinate position inclination rad radians that which deflection line centres
    centers point
""")
"""Words of how and from where something is counted, or acts."""
PLACES = frozenset(("angle", "position", "displacement", "displacements", "coordinate"))
ARTICLES = frozenset(("the", "a", "an", "its", "of", "in", "on"))
OTHERS = (
    (r"\bfirst\b", r"\bsecond\b"),
    (r"\bsecond\b", r"\bfirst\b"),
    (r"\bfront\b", r"\brear\b"),
    (r"\brear\b", r"\bfront\b"),
    (r"\bupper\b", r"\blower\b"),
    (r"\blower\b", r"\bupper\b"),
    (r"\bmass\b", r"\b(?:total|combined) mass of (?:the )?(?:system|both)\b"),
    (r"\bradius\b", r"\bdiameter\b"),
    (r"\beach\b", r"\b(?:total|combined|together|both|equivalent)\b"),
    (r"\bdiameter\b", r"\bradius\b"),
    (r"\b(?:length|radius|distance)\b", r"\bgyration\b"),
    (r"\blength\b", r"\bradius\b"),
    (r"\bstiffness\b", r"\b(?:compliance|flexibility)\b"),
    (r"\bamplitude\b", r"\bpeak[- ]to[- ]peak\b"),
    (r"\bhorizontal\b(?!.*vertical)", r"\bvertical\b(?!.*horizontal)"),
    (r"\bvertical\b(?!.*horizontal)", r"\bhorizontal\b(?!.*vertical)"),
)
"""What the scene says, and what is something else."""
SCALED = re.compile(
    r"\b(?:per unit (?:length|area|volume|mass|inertia)|divided by|multiplied by"
    r"|(?:square|inverse|reciprocal|logarithm) of)\b",
    re.IGNORECASE,
)
ENDPOINTS = frozenset((
    "pivot", "hinge", "end", "ends", "joint", "pin", "axis", "support", "tip", "mass", "origin",
    "hole", "suspension", "top", "bottom", "point", "centre", "center", "attachment", "hinged",
    "upper", "lower", "two",
))  # fmt: skip
"""Between which a length may be a distance."""
OF_AN_END = ENDPOINTS | words("is length total full whole from to free other outer far")
"""Words of a length to an end."""
TO_A_CENTRE = ENDPOINTS | words("is are denotes distance length from to between and of gravity com")
"""Words of a distance to a mass centre."""
A_CENTRE = re.compile(SLOTS["CENTRE"], re.IGNORECASE)
FAR_END = re.compile(r"\b(?:tip|(?:free|far|outer|other|distal|opposite) end)\b", re.IGNORECASE)
"""From where nobody counts a distance who counts from the joint."""
OF_QUANTITIES = words("""
    mass masses length inertia moment spring constant stiffness damping damper coefficient radius
    viscous friction for point rigid circle kg
""")
"""Words of what a parameter is, beside those for whose it is."""
PLURALS = (
    ("(?:point )?masses|bobs|beads|particles", ("kg",)),
    ("lengths|rods|links|strings|radii|diameters", ("m",)),
    ("springs|stiffnesses", ("N/m", "N*m", "N*m/rad")),
    ("compliances", ("m/N", "rad/(N*m)")),
)  # fmt: skip
"""Nouns of several things, and units of what is named behind them."""
SEVERAL = phrase(
    r"\b(?P<what>(?:point )?masses|bobs|beads|particles|lengths|rods|links|strings|radii|diameters"
    r"|springs|stiffnesses),? (?P<names>⟨\w+⟩(?:(?: ?,| and| ?, and) ?⟨\w+⟩)+)"
)
PLURAL = phrase(
    r"(?P<names>⟨\w+⟩(?:(?: ?,| and| ?, and) ?⟨\w+⟩)+) ?(?:are|denote|:|is|,) ?(?:the )?(?:\w+ )?"
    r"(?P<what>(?:point )?masses|lengths|radii|diameters|stiffnesses|compliances)\b"
)
INPUT_NOUN = phrase(
    r"NAMEIS THE(?P<words>(?:\w+ ){0,3}(?:force|torque|moment|thrust)"
    r"(?: of (?:the |a )?(?:motor|actuator|drive|engine|servo))?)"
    r"(?P<at> (?:at|in|about) (?:the |its )?"
    r"(?:pivot|hinge|joint|pin|axis|axle|base|support|shoulder))?"
    r"(?=,|;|\)| ?\(| and\b| in\b|\.?$)"
)
SMALL = re.compile(
    r"of|the|an?|its|from|to|in|at|on|for|about|by|this|that|each|our|is|are|total|whole|between"
)
IDIOMS = re.compile(
    r"\bnot (?:hard|difficult|surprising)\b|\bnon[- ]?linear\w*|\bwithout loss of generality\b"
    r"|\b(?:without|no) (?:slip(?:ping|page)?|sliding)\b|\b(?:sin|sem) desli[sz]a\w*"
    r"|\bsans gliss\w*|\bohne (?:zu )?(?:gleiten|rutschen)|\bsenza stris\w*"
    r"|\b(?:ignor|neglect|drop|discard|omit)\w* (?:all |any |the )?"
    r"(?:(?:(?:higher|second)[- ]order|quadratic) terms"
    r"|terms (?:of (?:higher|second) order|that (?:include|contain) this factor))"
    r"|\b(?:do|does) not (?:slip|slide|depend|occur|appear|enter)\b"
    r"|\bis not the (?:total )?energy\b"
    r"|\bnot conserved\b|\bconserved (?:only )?(?:if|when|where|unless|provided)\b"
    r"|\bfalls (?=[a-z]+\b)(?!der|die|das|man|es|ein|sich|die)"
    r"|\bif \u27e8\w+\u27e9 (?:is|denotes) the (?:(?:mass|length|position|displacement|radius) of"
    r"|distance (?:from|between|of)|angle (?:the|that|between|from|with|which|made|measured))\b"
    r"|[(\uff08]\s*\u2248\s*(?!0+(?:\.0*)?\D)\d[\d.]*[^()\d\uff08\uff09]{0,9}[)\uff09]"
    r"|(?<=[\u30a0-\u30ff])[\uff1d\u30a0](?=[\u30a0-\u30ff])"
    r"|\b(?:e\. ?g|i\. ?e|z\. ?b|d\. ?h|u\. ?a|s\. ?t|w\. ?r\. ?t|p\. ?ej|p\. ?es)\b\.?",
    re.IGNORECASE,
)
"""Where such a word neither denies nor limits a statement."""
UNDRIVEN = re.compile(
    r"\b(?:without|no) (?:(?:an|any) )?(?:external|applied|driving|control) "
    r"(?:force|torque|input)s?\b",
    re.IGNORECASE,
)
"""What a scene without inputs has."""
UNUSUAL = re.compile(
    r"[^\w\s.,;:()\[\]{}'\"\u2018\u2019\u201c\u201d&*#+=%|<>/@\\^$!?\u2026~`\u2010-\u2015\u2022\u00b7\u2192\u21d2\u00b0\ufeff"
    r"\u00a1\u00ab\u00bb\u3001\u3002\u3008-\u3011\u3014-\u301b\uff0c\uff0e\uff1a\uff1b\uff08\uff09\uff61"
    r"\U0001f4cc\U0001f4cd\U0001f4d0\U0001f4d6\U0001f4d8\U0001f4da\U0001f4dd\u220e\u25a0\u25a1-]"
    r"|(?<!\w)[A-Za-z](?:[ .{}]{1,4}[A-Za-z]){2,}(?!\w)"
)
"""A sign that is no mark of plain prose, or letters of a word apart."""
CONNECTIVES = words("""
    a an the this that these it its we us our which as so then thus hence therefore because since
    and or to of in on at for from with by into where here there also again now next finally let
    is are be has have obtain obtains get gets give gives giving find write reads read yield yields
    follow follows become becomes see using lagrange newton euler
""")
"""Function words, and the verbs that lead from one formula to the next."""
PART_OF_DOCUMENT = re.compile(
    r"\b(?:(?:figure|fig|table|section|chapter|part|step|example|problem|exercise|equation|eq)s?\.?"
    r" \(?\d+(?:\.\d+)*\)?(?!\w)|equations? of motion)"
    r"|^\W*(?:introduction|abstract|derivation|solution|answer|proof|summary|result|equations?"
    r"|appendix|references)\W*$",
    re.IGNORECASE,
)
"""What names a part of a document."""
GIVEN = re.compile(
    r"(?:^|\\\[|[\n,;:$({&]|\\q?quad\b|\\\\|\\begin\{\w+\*?\}|\b(?:with|where|and|for|let|if|here|take|set|double|float|const|constexpr|auto"
    r"|Real|[A-Z]\w*(?:\.[A-Z]\w*)+)\b)[ \t]*\}?[ \t]*(?:\w+\.)*\\?(?P<name>[A-Za-z]\w*)"
    r"(?:[ \t]*\([^()\n]*=[^()\n]*\))?[ \t]*&?=[ \t]*"
    r"(?:\\(?:SI|qty|num)\s?\{)?[ \t]*"
    r"(?P<number>[-\u2212]?[ \t]*\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)[fF]?"
    r"(?:(?=(?:\\[,;:! ]|~|\s)*\\(?:mathrm|text|textrm|rm|unit|si|mathsf|operatorname)\b)"
    r"|(?=[ \t\n]*\\(?:[\])\\]|end\b|q?quad\b))|(?![ \t]*[\w*^/(\\.+-]))"
)
"""A parameter that is a number, as it is or in a unit."""
DENIAL = re.compile(
    r"\b(?:is|are|was|were|be) (?:\w+ly )?"
    r"(?:wrong|false|incorrect|erroneous|not (?:true|correct|right))\b"
    r"|\bnot (?:true|correct|right|the case) that\b"
    r"|\b(?:wrong|incorrect|erroneous|false|mistaken) "
    r"(?:equation|result|expression|formula|answer)s?\b"
    r"|\b(?:incorrectly|wrongly|mistakenly|erroneously|falsely)\b"
    r"|\b(?:a|the|an?other) (?:common|frequent|typical|usual) (?:mistake|error) (?:is|would be)\b"
    r"|\bdisprov\w+|\b(?:must|has to|have to) be (?:rejected|discarded)\b"
    r"|\bleads? to a contradiction\b|\ban? (?:sign (?:error|mistake)|mistake in)\b"
    r"|\bup to (?:the|an?) (?:overall )?(?:sign|factor)\b|\bthe (?:negative|opposite) of(?= \u2026)"
    r"|\bis not what\b|\b(?:do(?:es)?|did) not (?:hold|apply)\b"
    r"|\b(?:fails? to hold|is invalid|cannot be right)\b",
    re.IGNORECASE,
)
"""What denies an equation."""
FLAWED = re.compile(
    r"\b(?:FIXME|XXX|BUG|HACK)\b|(?i:\b(?:wrong\w*|incorrect\w*|invalid|buggy|bugs?|broken|flawed"
    r"|does(?:n't| not) work|do(?:n't| not) (?:use|trust)|deprecated|untested"
    r"|(?:only|just) (?:valid|true|correct|holds?|applies|for|near|around|when|where|if|work\w*)"
    r"|(?:valid|true|correct|holds?|applies|works?) only|small[- ]angles?"
    r"|sign (?:error|mistake))\b)"
)
"""What denies or limits code where a comment has it."""
FOREIGN_UNIT = re.compile(
    rf"(?<![\w/*.])(?:(?:{any_of(*ANGLES, *REVOLUTIONS, *LENGTHS)}"
    r"|\u00b0|turn|revolution|in|lbf?|kN)\s*/\s*(?:s|sec|min|hr?)(?![a-z])"
    r"|(?:rad|rev)\s*/\s*(?:min|h|hr|hours?|ms)\b|(?:rpm|mph)\b)"
    r"|(?m:\[(?:1|m)\s*/\s*(?:min|h|hr|hours?|ms)\]"
    rf"|^\W*(?:units?\b\W*)?(?:{any_of(*ANGLES, *LENGTHS, *TORQUES, *MASSES)}"
    r"|\u00b0|kN|lbf|kgf|N ?[cm]m|(?:1|m)\s*/\s*(?:min|h|hr|hours?|ms))\W*$)"
)
"""A unit that no scene has, in a comment of code: deg/s^2; cm where it says nothing else. 1/h and
m/h are formulas, too, and units in brackets or alone.
"""
