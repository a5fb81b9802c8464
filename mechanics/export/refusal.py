"""What is refuted is not written."""

from collections.abc import Sequence

from mechanics.errors import RefutedError
from mechanics.kernel import Finding, Verdict


def refuse_refuted(findings: Sequence[Finding], target: str) -> None:
    """Raise if one of the findings about what is to be written is REFUTED.

    Parameters
    ----------
    target : str
        The file or folder that is not written.

    Raises
    ------
    RefutedError
        With the first one, its witness, and the number of others.
    """
    refuted = [finding for finding in findings if finding.verdict is Verdict.REFUTED]
    if not refuted:
        return
    first, more = refuted[0], len(refuted) - 1
    where = ""
    if first.witness is not None:
        state = ", ".join(f"{name} = {value}" for name, value in first.witness.state)
        at = f", at {state}" if state else ""
        where = f"{at}: {first.witness.left} and {first.witness.right}"
    others = f", and {more} more" if more else ""
    raise RefutedError(
        f"REFUTED {first.subject}: {first.evidence}{where}{others}: {target} is not written"
    )
