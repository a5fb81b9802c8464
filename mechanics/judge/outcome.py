"""What comes of a sentence beside the scene.

empty words    as the scene has it          Unsettled   statements are others than those read
words          the scene has it otherwise   None        the scene does not tell
conventions    the scene counts otherwise
"""

import re
from dataclasses import dataclass

from mechanics.claims.declared_conventions import Declared

Said = re.Match[str]


@dataclass(frozen=True)
class Unsettled:
    """What makes statements others than those that are read, in words."""

    words: str


Outcome = str | tuple[Declared, ...] | Unsettled | None
