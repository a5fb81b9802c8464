"""The corpus of the fuzzers: every document keeps the law, and what it is."""

import json
from pathlib import Path

import pytest

from benchmarks.fuzz import corpus, law
from mechanics.judge.check import derived
from systems import elastic_pendulum

TRUTH = derived(elastic_pendulum.scene())
DOCUMENTS = [
    pytest.param(notation, entry.data, id=f"{notation} {number}")
    for notation in corpus.NOTATIONS
    for number, entry in enumerate(corpus.load(notation), start=1)
]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("notation", "data"), DOCUMENTS)
def test_the_corpus_keeps_the_law(notation: str, data: bytes) -> None:
    assert law.outcome(TRUTH, notation, data).broken == ""


@pytest.mark.parametrize("notation", corpus.NOTATIONS)
def test_documents_stand_once(notation: str) -> None:
    documents = [entry.data for entry in corpus.load(notation)]
    assert len(documents) == len(set(documents))


def test_any_bytes_can_be_kept(tmp_path: Path) -> None:
    (tmp_path / "text.jsonl").touch()
    data = bytes(range(256)) + "θ\ud800".encode("utf-8", "surrogatepass")
    assert corpus.add("text", [corpus.Entry("all bytes", data)], tmp_path) == 1
    assert corpus.add("text", [corpus.Entry("again", data)], tmp_path) == 0
    assert corpus.load("text", tmp_path) == [corpus.Entry("all bytes", data)]
    (line,) = (tmp_path / "text.jsonl").read_text(encoding="utf-8").splitlines()
    assert json.loads(line)["why"] == "all bytes"
