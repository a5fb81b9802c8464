"""Whatever was typed, and wherever an edit says that it belongs, there is an answer."""

from html.parser import HTMLParser

from hypothesis import given, settings
from hypothesis import strategies as st
from rich.cells import cell_len

from mechanics.blame.result import Blame, Difference, Edit, Mistake, Repair
from mechanics.claims.names import Naming, Vocabulary
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding, Verdict, Witness
from mechanics.report.answer.formulas import Hand, block, equation, formula
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.marks import pieces
from mechanics.report.answer.places import applied, placed
from mechanics.report.answer.terminal import answer, plain
from systems import elastic_pendulum

NAMING = Naming(Vocabulary(elastic_pendulum.scene()))
WORDS = (
    r"\frac", r"\left(", r"\right)", "{", "}", "^", "_", r"\ddot", r"\theta", "x", "M", "+", "-",
    "=", "*", "**", "(", ")", "'", "/", "12", "2.5", " ", "\n", "&", r"\\", r"\text", r"\href",
    "<script>", '"', r"\tag{6}", "sin", r"\sin", "theta", ",", "[", ";", "]", "\x1b[31m", "力",
    "\u0308", ".", "e", "+/-",
)  # fmt: skip
TYPED = st.lists(st.sampled_from(WORDS), max_size=25).map("".join) | st.text(max_size=40)
SPANS = st.none() | st.tuples(st.integers(-2, 60), st.integers(-2, 60))
EDITS = st.lists(st.builds(Edit, st.sampled_from(Mistake), TYPED, TYPED, SPANS), max_size=3)
HANDS = st.sampled_from([Hand("latex", None), Hand("text", NAMING), Hand("code", NAMING)])


class Balanced(HTMLParser):
    """Elements that are open, and those that nobody typed on purpose."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.tags.add(tag)
        if tag != "wbr":
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: object) -> None:
        self.tags.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@settings(max_examples=40, deadline=None)
@given(TYPED, EDITS, st.integers(20, 120))
def test_the_terminal_has_an_answer(source: str, edits: list[Edit], width: int) -> None:
    witness = Witness(((source, source),), source, source)
    finding = Finding("", Verdict.REFUTED, source, witness=witness)
    repair = Repair(tuple(edits), source, finding)
    rows = (Difference(source, source, source, (source,)),)
    blame = Blame(rows, (repair, repair), (source,), source)
    entry = Judged(Statement(None, source, source), finding, (source,), blame)
    text = plain(answer([entry]), width)
    assert text.startswith("REFUTED")
    assert all(character.isprintable() or character == "\n" for character in text)
    assert max(map(cell_len, text.splitlines())) <= max(width, 24)


@settings(max_examples=80, deadline=None)
@given(TYPED, EDITS, HANDS)
def test_the_page_has_an_answer(source: str, edits: list[Edit], hand: Hand) -> None:
    for shown in (equation(source, hand, edits), formula(source, hand), block(source, hand)):
        page = Balanced(str(shown))
        assert page.open == []
        strange = {tag for tag in page.tags if not tag.startswith("m")}
        assert strange <= {"div", "p", "code", "del", "ins", "wbr"}


@settings(max_examples=80, deadline=None)
@given(TYPED, EDITS)
def test_pieces_are_the_source_again(source: str, edits: list[Edit]) -> None:
    assert "".join(piece.text for piece in pieces(source, edits)) == source


@settings(max_examples=80, deadline=None)
@given(TYPED, EDITS)
def test_places_hold_what_is_to_be_changed(source: str, edits: list[Edit]) -> None:
    loose = [Edit(edit.mistake, edit.written, edit.right) for edit in edits]
    for edit in placed(source, loose, applied(source, edits)):
        if edit.span is not None:
            assert source[slice(*edit.span)] == edit.written
