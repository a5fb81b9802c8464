"""What comes of a sentence beside the scene.

empty words    as the scene has it          Unsettled     statements are others than those read
words          the scene has it otherwise   Unverified    the scene does not tell, of a parameter
conventions    the scene counts otherwise   None          the scene does not tell
"""

import re
from dataclasses import dataclass

from mechanics.claims.declared_conventions import Declared

Said = re.Match[str]


@dataclass(frozen=True)
class Unsettled:
    """What makes statements others than those that are read, in words."""

    words: str


@dataclass(frozen=True)
class Unverified:
    """A parameter of which nothing of the scene tells whether it is what the text says."""

    name: str
    words: str


Outcome = str | tuple[Declared, ...] | Unsettled | Unverified | None
