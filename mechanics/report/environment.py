"""What the templates of all pages know: verdicts as chips, equations as MathML, words."""

from types import CodeType

from jinja2 import BytecodeCache, Environment, PackageLoader, StrictUndefined
from jinja2.bccache import Bucket
from markupsafe import Markup

from mechanics.kernel import Verdict
from mechanics.report import charts, typeset, words
from mechanics.report.contacts import rolling_words
from mechanics.report.drawing import shape_words
from mechanics.report.notation import latex_name, svg_name
from mechanics.report.sections import ROUTES


class Compiled(BytecodeCache):
    """Code of templates by their text: compiled once a process, not once a page."""

    def __init__(self) -> None:
        self.codes: dict[tuple[str, str], CodeType] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        """Give a template its code, if it has been compiled."""
        bucket.code = self.codes.get((bucket.key, bucket.checksum))

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Keep the code of a template."""
        if bucket.code is not None:
            self.codes[bucket.key, bucket.checksum] = bucket.code


COMPILED = Compiled()


def environment() -> Environment:
    """An environment of Jinja that escapes everything and leaves no name undefined."""
    made = Environment(
        loader=PackageLoader("mechanics.report"),
        bytecode_cache=COMPILED,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=StrictUndefined,
    )
    made.globals.update(
        LEGEND=words.LEGEND,
        Markup=Markup,
        ROUTES=ROUTES,
        Verdict=Verdict,
        anchor=typeset.anchor,
        bar=lambda share: Markup(charts.bar(share)),
        bound=words.bound,
        as_published=typeset.published,
        chip=words.chip,
        count=words.count,
        duration=words.duration,
        equation=typeset.equation,
        inline=typeset.inline,
        prose=typeset.prose,
        ratio=words.ratio,
        rolling_words=rolling_words,
        shape_words=shape_words,
        tag=typeset.tag,
        symbol=lambda name: typeset.maths(latex_name(name)),
        svg_name=lambda name: Markup(svg_name(name)),
    )
    return made
