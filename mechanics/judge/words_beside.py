"""A statement with the words beside it: of code its comments, which have no place of their own."""

from mechanics.claims.claim import Written
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.statement import Statement
from mechanics.scene import Scene


def written_or_comments(scene: Scene, statement: Statement) -> Written | None:
    """What a statement was read from; for code its comments, with the place behind them.

    Parameters
    ----------
    scene : Scene
    statement : Statement
    """
    written, comments = statement.written, statement.comments
    if not comments:
        return written
    naming = written.naming if written is not None else Naming(Vocabulary(scene))
    return Written((), (), naming, "code", comments, len(comments))
