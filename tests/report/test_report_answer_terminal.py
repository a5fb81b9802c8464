"""The answer on a terminal: 80 columns, with and without colour, and what is hostile in it."""

from dataclasses import replace
from io import StringIO

import pytest
from rich.cells import cell_len
from rich.console import Console

from mechanics.blame.result import Blame, Difference, Edit, Mistake, Repair
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding, Verdict, Witness
from mechanics.report.answer.check import Check
from mechanics.report.answer.formulas import Hand
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.marks import pieces, printable, shortened
from mechanics.report.answer.segments import spoken
from mechanics.report.answer.terminal import answer, plain
from mechanics.report.answer.witness import short_state, short_values
from systems import elastic_pendulum

PROVED = Finding("", Verdict.PROVED, "both sides have the same normal form")
CERTIFIED = Finding(
    "",
    Verdict.CERTIFIED,
    "zero modulo a random 127-bit prime; chance of error below 2^-99",
    2.0**-99,
)
REFUTED = Finding(
    "",
    Verdict.REFUTED,
    "the enclosures at a real state are disjoint",
    witness=Witness(
        (("L", "211/64"), ("theta", "31/32")),
        "[3.01911975476323715 +/- 8.91e-18]",
        "0",
        (("theta_ddot", "-2.4825312345"),),
    ),
)


def judged(source: str, blame: Blame | None = None, finding: Finding = REFUTED) -> Judged:
    return Judged(Statement(None, source, "(7)"), finding, (), blame)


def wrong(source: str, written: str, right: str, mistake: Mistake = Mistake.TERM) -> Edit:
    at = source.index(written)
    return Edit(mistake, written, right, (at, at + len(written)))


def repair(source: str, *edits: Edit) -> Repair:
    return Repair(edits, source, PROVED)


def test_the_whole_answer_of_one_statement() -> None:
    source = "m*l**2*theta'' - m*g*l*cos(theta)"
    blame = Blame(
        (Difference("gravity", "-m*g*l*cos(theta)", "m*g*l*sin(theta)", ("load gravity",)),),
        (
            repair(
                "m*l**2*theta'' + m*g*l*sin(theta)",
                wrong(source, "-", "+", Mistake.SIGN),
                wrong(source, "cos", "sin", Mistake.FUNCTION),
            ),
        ),
        ("gravity reversed",),
    )
    entry = replace(judged(source, blame), right_if=("theta is measured from the other vertical",))
    assert plain(answer([entry])) == (
        "REFUTED  (7)\n"
        "    m*l**2*theta'' - m*g*l*cos(theta)\n"
        "                   ^       ^^^\n"
        "    write + for -: the sign is reversed\n"
        "    and write sin for cos: sine, cosine or tangent is the wrong one\n"
        "    then PROVED: m*l**2*theta'' + m*g*l*sin(theta)\n"
        "\n"
        "    group    written            right             comes from\n"
        "    gravity  -m*g*l*cos(theta)  m*g*l*sin(theta)  load gravity\n"
        "\n"
        "    because: gravity reversed\n"
        "    right if theta is measured from the other vertical\n"
        "    at this state 3.01912 is written and 0 derived: they differ\n"
        "    the state: L=211/64, theta=31/32\n"
        "    with theta_ddot=-2.48253\n"
        "    (how it is known: the enclosures at a real state are disjoint)"
    )


def test_rows_of_one_equation_and_notes_of_several_stand_once() -> None:
    rows = [
        Judged(Statement(None, "M u = f", f"(1) row {n}", "a.tex, line 1", ("ml is a product",)), f)
        for n, f in enumerate((PROVED, CERTIFIED, PROVED), start=1)
    ]
    assert plain(answer(rows)) == (
        "PROVED  (1) row 1  a.tex, line 1  M u = f\n"
        "CERTIFIED  (1) row 2\n"
        "    equal at random points of a finite field; the chance of a wrong verdict is\n"
        "      below 2^-99\n"
        "    (how it is known: zero modulo a random 127-bit prime)\n"
        "PROVED  (1) row 3\n"
        "\n"
        "2 PROVED, 1 CERTIFIED\n"
        "ml is a product"
    )


def test_words_of_the_arithmetic_stand_behind_plain_ones() -> None:
    evidence = (
        "not zero in a field of 127 bits, but none of the real states tried tells the sides apart"
        " (known by congruence only: besselj)"
    )
    text = plain(answer([judged("a = b", finding=Finding("", Verdict.UNDECIDED, evidence))]))
    assert text.splitlines()[1:3] == [
        "    the two sides seem to differ, but none of the states tried shows that they",
        "      do, because it holds besselj",
    ]
    assert "(how it is known: not zero in a field of 127 bits" in " ".join(text.split())


def test_formulas_in_sentences_are_in_the_notation_of_the_person() -> None:
    scene = elastic_pendulum.scene()
    hand = Hand("latex", Naming(Vocabulary(scene)))
    words = "derived from it, the equations would differ by (0, 2*M*g*sin(theta)); and more"
    told = r"derived from it, the equations would differ by (0, 2 M g \sin \theta); and more"
    assert spoken(words, hand) == told
    assert spoken("q is taken as defined by: q &= 7 \\zeta", hand).endswith(": q = 7 \\zeta")
    assert spoken(words, replace(hand, notation="text")) == words


def test_a_name_that_stays_itself_is_said_to_be_what_it_is() -> None:
    names = (Match("t", "t", "the time"), Match("y", "x", "the only one left"))
    text = plain(answer([judged("a", finding=PROVED)], names))
    assert text.endswith("t is the time\ny is read as x: the only one left")


def test_missing_and_superfluous_terms_have_words_of_their_own() -> None:
    source = "a + b - c = 0"
    missing = Edit(Mistake.MISSING, "", "+ d", (9, 9))
    extra = wrong(source, "+ b", "", Mistake.EXTRA)
    text = plain(answer([judged(source, Blame((), (repair(source, extra, missing),)))]))
    assert "    a + b - c = 0\n      ^^^    ^\n" in text
    assert "leave out + b: a term is too many\n    and add + d: a term is missing" in text


def test_equal_edits_are_told_once() -> None:
    source = "x**2 + y*x"
    twice = (Edit(Mistake.SYMBOL, "x", "v", (0, 1)), Edit(Mistake.SYMBOL, "x", "v", (9, 10)))
    text = plain(answer([judged(source, Blame((), (repair(source, *twice),)))]))
    assert "\n    ^        ^\n    write v for x in 2 places: a wrong symbol stands here\n" in text


def test_every_alternative_is_shown_and_marked_where_the_words_do_not_say_where() -> None:
    source = "x + 2*x + 2*y"
    first = Edit(Mistake.FACTOR, "2", "3", (4, 5))
    second = Edit(Mistake.FACTOR, "2", "5", (10, 11))
    text = plain(answer([judged(source, Blame((), (repair("r", first), repair("s", second))))]))
    lines = text.splitlines()
    assert lines[2].index("^") == 4 + 4
    assert lines[3].strip() == "write 3 for 2: the factor is wrong"
    assert lines[5].strip() == "or write 5 for 2: the factor is wrong"
    assert lines[7].index("^") == 4 + 10


def test_what_was_searched_is_told_where_nothing_was_found() -> None:
    text = plain(answer([judged("a = b", Blame((), (), (), "208 edits were tried"))]))
    assert "\n    208 edits were tried\n" in text


@pytest.mark.parametrize("width", [40, 80, 120])
def test_no_line_is_wider_than_the_screen(answered: Check, width: int) -> None:
    text = plain(answer(answered.judged, answered.names, answered.remarks), width)
    assert max(map(cell_len, text.splitlines())) <= width
    assert not any(line != line.rstrip() for line in text.splitlines())


@pytest.mark.parametrize("width", [30, 50, 79])
def test_carets_stand_under_what_is_wrong_wherever_the_source_breaks(width: int) -> None:
    source = " + ".join(f"a_{n}*x" for n in range(40)) + " + WRONG + y"
    entry = judged(source, Blame((), (repair(source, wrong(source, "WRONG", "r")),)))
    lines = plain(answer([entry]), width).splitlines()
    (under,) = [n for n, line in enumerate(lines) if set(line.strip()) == {"^"}]
    marked = [c for c, mark in zip(lines[under - 1], lines[under], strict=False) if mark == "^"]
    assert "".join(marked) == "WRONG"


def test_carets_count_columns_not_characters() -> None:
    source = "力*θ̈ + WRONG"
    entry = judged(source, Blame((), (repair(source, wrong(source, "WRONG", "r")),)))
    above, under = plain(answer([entry])).splitlines()[1:3]
    assert under.index("^") == cell_len(above[: above.index("WRONG")])


def test_escape_sequences_of_a_source_do_not_reach_the_terminal() -> None:
    hostile = "x\x1b[2J\x07\u202e = \r\n\x9b31m"
    file = StringIO()
    Console(file=file, color_system=None).print(answer([judged(hostile)], (), (hostile,)))
    assert not set(file.getvalue()) & {"\x1b", "\x07", "\r", "\x9b", "\u202e"}
    assert len(printable(hostile)) == len(hostile)


def test_markup_of_a_source_is_text(answered: Check) -> None:
    text = plain(answer([judged("[bold]x[/] = :smile:", finding=PROVED)]))
    assert text == "PROVED  (7)  [bold]x[/] = :smile:"


def test_colour_says_nothing_that_words_do_not(answered: Check) -> None:
    group = answer(answered.judged, answered.names, answered.remarks)
    file = StringIO()
    console = Console(file=file, force_terminal=True, width=80, highlight=False)
    console.print(group)
    coloured = file.getvalue()
    assert "\x1b[" in coloured
    stripped = Console(file=StringIO(), width=80, record=True, force_terminal=True, highlight=False)
    stripped.print(group)
    bare = [line.rstrip() for line in stripped.export_text().splitlines()]
    assert "\n".join(bare) == plain(group)


def test_names_remarks_and_counts_stand_at_the_end(answered: Check) -> None:
    assert plain(answer(answered.judged, answered.names, answered.remarks)).endswith(
        "\n\n1 PROVED, 1 CERTIFIED, 1 SUPPORTED, 3 REFUTED, 1 UNDECIDED\n"
        "names as given: phi=theta\n"
        "y is read as x: the only coordinate left\n"
        "I_B is taken as defined by: I_B = 1"
    )


def test_long_sources_keep_what_is_wrong() -> None:
    source = "a + " * 300 + "WRONG" + " + b" * 300
    kept = shortened(pieces(source, (wrong(source, "WRONG", "r"),)))
    assert [piece.text for piece in kept if piece.edit] == ["WRONG"]
    assert sum(len(piece.text) for piece in kept) < 800


def test_edits_that_do_not_fit_the_source_cut_nothing() -> None:
    edits = (
        Edit(Mistake.TERM, "a", "b", None),
        Edit(Mistake.TERM, "a", "b", (3, 99)),
        Edit(Mistake.TERM, "a", "b", (0, 2)),
        Edit(Mistake.TERM, "a", "b", (1, 3)),
    )
    found = pieces("abcd", edits)
    assert "".join(piece.text for piece in found) == "abcd"
    assert [piece.text for piece in found if piece.edit] == ["ab"]


@pytest.mark.parametrize(
    ("left", "right", "shown"),
    [
        ("[3.01911975476323715 +/- 8.91e-18]", "0", ("3.01912", "0")),
        ("[1.0000000001 +/- 1e-20]", "1", ("1.0000000001", "1")),
        ("1.25 +/- 1e-30", "-1.25 +/- 1e-30", ("1.25", "-1.25")),
        ("[+/- 1e-30]", "-5.50", ("0 +/- 1e-30", "-5.5")),
        ("[+/- 1e-30]", "nan", ("[+/- 1e-30]", "nan")),
        ("[9.5 +/- 1e+1]", "99", ("[9.5 +/- 1e+1]", "99")),
        ("[-0.5 +/- 1e-3]", "0.5", ("[-0.5 +/- 1e-3]", "0.5")),
        ("2.52.5", ".", ("2.52.5", ".")),
        ("1e400", "2", ("1e400", "2")),
        ("1e-400", "2", ("1e-400", "2")),
        ("0.3", "0.30000000000000004", ("0.3", "0.30000000000000004")),
    ],
)
def test_values_keep_the_digits_that_tell_them_apart(
    left: str, right: str, shown: tuple[str, str]
) -> None:
    assert short_values(left, right) == shown


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("211/64", "211/64"),
        ("2758454771764429/281474976710656", "9.8"),
        ("100000000000/300000000001", "100000000000/300000000001"),
        ("123456789012/0", "123456789012/0"),
        (f"1{'0' * 400}/3", f"1{'0' * 400}/3"),
        ("x/y/z and more", "x/y/z and more"),
    ],
)
def test_values_of_a_state_stay_exact(text: str, shown: str) -> None:
    assert short_state(text) == shown


def test_what_follows_from_a_state_is_told_as_far_as_the_statement_holds_it(
    answered: Check,
) -> None:
    entry = answered.judged[1]
    assert entry.finding.witness is not None
    assert {"N", "T", "x_ddot"} <= {name for name, _ in entry.finding.witness.solved}
    assert "    with x_ddot=" in str(answered)
    assert ", theta_ddot=" in str(answered)
    assert "N1=" not in str(answered)


def test_repr_is_one_line_and_str_the_answer(answered: Check) -> None:
    assert repr(answered) == (
        "<Check of pendulum on elastic support: 1 PROVED, 1 CERTIFIED, 1 SUPPORTED, 3 REFUTED,"
        " 1 UNDECIDED>"
    )
    assert str(answered) == plain(answer(answered.judged, answered.names, answered.remarks))
    assert repr(replace(answered, judged=())).endswith(": nothing was checked>")
