"""A sum of hundreds of terms, which status and lanes of an arm of seven joints have, is read."""

import pytest

from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.text import read_text
from mechanics.export.evidence.texts import sources
from mechanics.program.c.parse import Source

TEXT = """\
int name_f(const double x[1], double y[1])
{{
    int s = 0;
    y[0] = {sum};
    if (!({finite})) s = 1;
#ifdef NAME_INLINE_SINE
    y[0] = y[0] + {last};
#else
    y[0] = y[0] + x[0];
#endif
    return s;
}}
"""
KERNEL = Kernel("f", "name_f", "name.c", "double")


@pytest.mark.campaign
@pytest.mark.parametrize("last", ["x[0]", "2.0 * x[0]"])
def test_a_sum_as_deep_as_it_has_terms_is_read_whatever_is_defined(last: str) -> None:
    long = {"sum": " + ".join(["x[0]"] * 600), "finite": " && ".join(["isfinite(x[0])"] * 600)}
    found = list(sources((KERNEL,), {"name.c": TEXT.format(last=last, **long)}).values())
    assert len(found) == 1 + (last != "x[0]")
    for source in found:
        assert isinstance(source, Source)
        assert len(read_text(KERNEL, source, [("x", 1)], [("y", 1)]).program) >= 600
