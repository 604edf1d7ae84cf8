"""Sessions as files: whole, and back as they were."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.document import Document, Motion
from app.model.history import History
from app.model.region import Region
from app.model.session_file import from_text, to_text, write
from app.model.view_state import Heatmap, Place, Scale, ViewState
from surfcmp_core.comparison import Options
from surfcmp_core.errors import InputError

number = st.floats(-1e9, 1e9)
positive = st.floats(1e-6, 1e6)
place = st.builds(Place, st.integers(0, 10**6), st.tuples(number, number, number))
documents = st.builds(
    Document,
    paths=st.tuples(*[st.none() | st.just(Path("/data/a b ü.ply"))] * 2),
    options=st.builds(
        Options,
        domain=st.sampled_from(["data", "hull", "plane"]),
        max_edge=st.none() | positive,
        exact=st.booleans(),
        tolerances=st.tuples(positive, positive),
    ),
    motion=st.builds(Motion, method=st.text(), residual=positive, pairs=st.integers(0, 99)),
    unit=st.sampled_from(["", "mm", "m"]),
    regions=st.lists(
        st.builds(
            Region,
            name=st.text(),
            colour=st.tuples(*[st.integers(0, 255)] * 3),
            weight=positive,
            polygons=st.tuples(st.tuples(st.tuples(number, number), st.tuples(number, number))),
            discs=st.tuples(st.tuples(number, number, positive)),
        ),
        max_size=2,
    ).map(tuple),
)
states = st.builds(
    ViewState,
    relief=st.booleans(),
    heatmap=st.sampled_from(list(Heatmap)),
    scale=st.builds(Scale, positive, st.tuples(positive), st.booleans(), st.booleans()),
    picked=st.none() | place,
    probes=st.lists(place, max_size=2).map(tuple),
    brush=st.none() | st.tuples(number, number),
    chain=st.none() | st.integers(0, 99),
    dark=st.booleans(),
)


@given(documents, states)
def test_a_session_comes_back_as_it_was(document: Document, state: ViewState):
    text = to_text(document, state, ("a", "b"), Path("/data"))
    again, seen, hashes = from_text(text, Path("/data"), "x.surfcmp")
    assert again == document
    assert seen == state
    assert hashes == ("a" if document.paths[0] else "", "b" if document.paths[1] else "")


def test_inputs_that_moved_along_are_found_beside_the_session(tmp_path: Path):
    old, new = tmp_path / "old", tmp_path / "new"
    for folder in (old, new):
        folder.mkdir()
    file = old / "a.xyz"
    text = to_text(Document((file, None)), ViewState(), ("", ""), old)
    (new / "a.xyz").write_text("0 0 0")
    document, _, _ = from_text(text, new, "x.surfcmp")
    assert document.paths == (new / "a.xyz", None)


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"kind": "surfcmp session", "version": 99}', "\0", '"text"']
)
def test_what_is_no_session_is_refused_in_one_line(text: str):
    with pytest.raises(InputError) as fault:
        from_text(text, Path(), "x.surfcmp")
    assert str(fault.value).startswith("x.surfcmp: ")
    assert "\n" not in str(fault.value)


def test_a_session_is_written_whole_or_not_at_all(tmp_path: Path):
    path = tmp_path / "x.surfcmp"
    write(path, "one")
    with pytest.raises(UnicodeEncodeError):
        write(path, "two \ud800")
    assert path.read_text() == "one"
    assert list(tmp_path.iterdir()) == [path]


def test_undo_and_redo_walk_along_the_documents():
    one, two, three = (Document(unit=unit) for unit in ("mm", "cm", "m"))
    history = History(one)
    assert not history.push(one)
    assert history.push(two)
    assert history.undo() == one
    assert history.redo() == two
    assert history.redo() == two
    assert history.undo() == one
    assert history.push(three)
    assert not history.can_redo
    assert history.drop() == one
    assert not history.can_undo


def test_another_file_is_no_longer_moved():
    moved = Document((Path("/a"), Path("/b")), motion=Motion(method="by hand"))
    assert moved.with_path(1, Path("/c")).motion == Motion()
    assert moved.swapped().paths == (Path("/b"), Path("/a"))
    assert replace(moved, unit="m").motion == moved.motion
