"""Sessions as files: whole, and back as they were."""

import json
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.jobs.session_files import open_session, save_session
from app.model.document import Document
from app.model.landmark import Landmark
from app.model.region import Region, Stroke
from app.model.session_text import Eye, from_text, regions_from, regions_text, to_text, write
from app.model.view_state import Heatmap, Place, ScaleChoice, ViewState
from surfcmp_core.alignment.fit import FIT_KEYS
from surfcmp_core.comparing.options import Motion, Options
from surfcmp_core.errors import Cancelled, InputError
from surfcmp_core.system.progress import silent

number = st.floats(-1e9, 1e9)
positive = st.floats(1e-6, 1e6)
triple = st.tuples(number, number, number)
place = st.builds(Place, st.integers(0, 10**6), triple)
strokes = st.builds(
    Stroke,
    st.lists(st.tuples(number, number), min_size=1, max_size=3).map(tuple),
    st.just(0.0) | positive,
    st.booleans(),
)
regions = st.builds(
    Region,
    name=st.text(),
    colour=st.tuples(*[st.integers(0, 255)] * 3),
    weight=positive,
    strokes=st.lists(strokes, max_size=3).map(tuple),
)
documents = st.builds(
    Document,
    paths=st.tuples(*[st.none() | st.just(Path("/data/a b ü.ply"))] * 2),
    options=st.builds(
        Options,
        domain=st.sampled_from(["data", "hull", "plane"]),
        max_edge=st.none() | positive,
        exact=st.booleans(),
        tolerances=st.tuples(positive, positive),
        align=st.builds(Motion, method=st.text(), residual=positive, pairs=st.integers(0, 99)),
        unit=st.sampled_from([None, "mm", "m"]),
        project=st.sampled_from(["z", "auto", "view:1,2,3"]),
    ),
    regions=st.lists(regions, max_size=2).map(tuple),
)
states = st.builds(
    ViewState,
    relief=st.booleans(),
    heatmap=st.sampled_from(list(Heatmap)),
    scale=st.builds(ScaleChoice, positive, st.tuples(positive), st.booleans(), st.booleans()),
    picked=st.none() | place,
    probes=st.lists(place, max_size=2).map(tuple),
    brush=st.none() | st.tuples(number, number),
    chain=st.none() | st.integers(0, 99),
    landmarks=st.lists(st.builds(Landmark, st.none() | triple, st.none() | triple)).map(tuple),
    dark=st.booleans(),
)


@given(documents, states, st.none() | st.tuples(triple, triple, triple, st.tuples(positive)))
def test_a_session_comes_back_as_it_was(document: Document, state: ViewState, eye: Eye | None):
    text = to_text(document, state, ("a", "b"), Path("/data"), eye)
    saved = from_text(text, Path("/data"), "x.surfcmp")
    assert saved.document == document
    assert saved.state == state
    assert saved.camera == eye
    hashes = tuple("" if scan is None else scan.sha256 for scan in saved.scans)
    assert hashes == ("a" if document.paths[0] else "", "b" if document.paths[1] else "")


@given(st.lists(regions, max_size=2).map(tuple))
def test_regions_come_back_as_they_were(found: tuple[Region, ...]):
    assert regions_from(regions_text(found), "x.json") == found


def test_regions_of_the_first_version_are_read():
    old = {"name": "nose", "colour": [1, 2, 3], "weight": 2.0}
    old |= {"polygons": [[[0, 0], [1, 0], [0, 1]]], "discs": [[3, 4, 0.5]]}
    (region,) = regions_from(json.dumps([old]), "x.json")
    assert region.strokes == (Stroke(((0, 0), (1, 0), (0, 1))), Stroke(((3, 4),), 0.5))


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"kind": "surfcmp session", "version": 99}', "\0", '"text"']
)
def test_what_is_no_session_is_refused_in_one_line(text: str):
    with pytest.raises(InputError) as fault:
        from_text(text, Path(), "x.surfcmp")
    assert str(fault.value).startswith("x.surfcmp: ")
    assert "\n" not in str(fault.value)


def test_a_text_is_written_whole_or_not_at_all(tmp_path: Path):
    path = tmp_path / "x.surfcmp"
    write(path, "one")
    with pytest.raises(UnicodeEncodeError):
        write(path, "two \ud800")
    assert path.read_text() == "one"
    assert list(tmp_path.iterdir()) == [path]


@pytest.fixture
def pair(tmp_path: Path) -> Document:
    """Give two files in a folder of their own."""
    folder = tmp_path / "scans of a person"
    folder.mkdir()
    paths = folder / "a.xyz", folder / "b.xyz"
    for k, path in enumerate(paths):
        path.write_text(f"0 0 {k}\n" * 100)
    return Document(paths)


def saved(document: Document, path: Path, *, embed: bool) -> Path:
    return save_session(path, document, ViewState(relief=False), ("", ""), None, embed, silent)


@pytest.mark.parametrize("embed", [True, False])
def test_a_session_finds_its_scans_where_they_were(pair: Document, tmp_path: Path, embed: bool):
    path = saved(pair, tmp_path / "x.surfcmp", embed=embed)
    opened = open_session(path, tmp_path / "scans", {}, silent)
    assert opened.fault is None
    assert opened.document == pair
    assert not opened.state.relief
    assert not (tmp_path / "scans").exists()
    assert zipfile.is_zipfile(path) == embed


def test_a_session_with_its_scans_needs_no_other_file(pair: Document, tmp_path: Path):
    path = saved(pair, tmp_path / "x.surfcmp", embed=True)
    data = [file.read_bytes() for file in pair.paths]
    pair.paths[0].unlink()
    pair.paths[1].write_text("1 2 3\n")  # another content is not taken for the scan
    opened = open_session(path, tmp_path / "scans", {}, silent)
    assert opened.fault is None
    assert [file.read_bytes() for file in opened.document.paths] == data
    assert [file.name for file in opened.document.paths] == ["a.xyz", "b.xyz"]
    assert all(file.is_relative_to(tmp_path / "scans") for file in opened.document.paths)


def test_scans_that_moved_along_are_found_beside_the_session(pair: Document, tmp_path: Path):
    path = saved(pair, pair.paths[0].parent / "x.surfcmp", embed=False)
    new = tmp_path / "new"
    pair.paths[0].parent.rename(new)
    opened = open_session(new / path.name, tmp_path / "scans", {}, silent)
    assert opened.document.paths == (new / "a.xyz", new / "b.xyz")


@pytest.mark.parametrize("kind", ["missing", "changed"])
def test_a_scan_that_is_not_as_it_was_is_told_and_located(
    pair: Document, tmp_path: Path, kind: str
):
    path = saved(pair, tmp_path / "x.surfcmp", embed=False)
    two = pair.paths[1]
    copy = tmp_path / "copy.xyz"
    copy.write_bytes(two.read_bytes())
    if kind == "missing":
        two.unlink()
    else:
        two.write_text("other")

    def opened(located: dict[int, tuple[Path, bool]]):
        return open_session(path, tmp_path / "scans", located, silent)

    fault = opened({}).fault
    assert fault is not None
    assert (fault.number, fault.name, fault.kind) == (2, "b.xyz", kind)
    assert opened({2: (copy, False)}).document.paths == (pair.paths[0], copy)
    fault = opened({2: (pair.paths[0], False)}).fault
    assert fault is not None
    assert (fault.kind, fault.path) == ("another", pair.paths[0])
    assert opened({2: (pair.paths[0], True)}).document.paths == (pair.paths[0],) * 2


@pytest.mark.parametrize("embed", [True, False])
def test_saving_stops_without_a_trace(pair: Document, tmp_path: Path, embed: bool):
    path = tmp_path / "x.surfcmp"
    path.write_text("before")

    def stop(_stage: str, _fraction: float) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        save_session(path, pair, ViewState(), ("", ""), None, embed, stop)
    assert path.read_text() == "before"
    assert not [file for file in tmp_path.iterdir() if file.name.endswith(".part")]


def test_a_scan_that_changed_since_it_was_compared_is_not_put_in(pair: Document, tmp_path: Path):
    with pytest.raises(InputError, match=r"^a\.xyz: has changed"):
        save_session(tmp_path / "x.surfcmp", pair, ViewState(), ("0" * 64, ""), None, True, silent)
    assert not (tmp_path / "x.surfcmp").exists()


def test_every_damage_is_told_in_one_line(pair: Document, tmp_path: Path):
    path = saved(pair, tmp_path / "x.surfcmp", embed=True)
    for scan in pair.paths:
        scan.unlink()
    data = path.read_bytes()
    for cut in (0, 1, 10, len(data) // 2, len(data) - 1):
        path.write_bytes(data[:cut])
        with pytest.raises(InputError, match=r"^x\.surfcmp: [^\n]*$"):
            open_session(path, tmp_path / "scans", {}, silent)
    faults = []
    for place in range(0, len(data), 7):
        path.write_bytes(data[:place] + bytes([data[place] ^ 0x55]) + data[place + 1 :])
        try:
            opened = open_session(path, tmp_path / "scans", {}, silent)
            assert opened.fault or all(file and file.is_file() for file in opened.document.paths)
        except InputError as fault:
            faults.append(str(fault))
    assert len(faults) > 10
    assert all(fault.startswith("x.surfcmp: ") and "\n" not in fault for fault in faults)


def test_a_session_of_the_first_version_is_read(pair: Document, tmp_path: Path):
    text = json.loads(to_text(pair, ViewState(), ("", ""), tmp_path))
    text["version"] = 1
    del text["view"]["landmarks"]
    text["regions"] = [{"name": "r", "colour": [0, 0, 0], "weight": 1, "polygons": [], "discs": []}]
    path = tmp_path / "x.surfcmp"
    path.write_text(json.dumps(text))
    opened = open_session(path, tmp_path / "scans", {}, silent)
    assert opened.document == replace(pair, regions=(Region("r", (0, 0, 0)),))


def test_another_file_is_no_longer_moved():
    moved = Document((Path("/a"), Path("/b")), Options(align=Motion(method="by hand")))
    assert moved.with_path(1, Path("/c")).motion == Motion()
    assert moved.swapped().paths == (Path("/b"), Path("/a"))
    assert moved.asking(unit="m").motion == moved.motion


FIT = dict.fromkeys(FIT_KEYS, 0.5) | {
    "landmarks": ({"name": "1", "residual": 0.25},),
    "free": ("turn about x",),
    "doubts": ("as by chance",),
    "pairs": 12,
    "converged": True,
}


def test_what_a_fit_says_of_itself_comes_back(tmp_path: Path) -> None:
    document = Document(options=Options(align=Motion(method="best fit", fit=FIT)))
    text = to_text(document, ViewState(), ("", ""), tmp_path)
    assert from_text(text, tmp_path, "s").document.motion == document.motion


@pytest.mark.parametrize(
    "wrong", [{"pairs": "many"}, {"free": [3]}, {"landmarks": [{"name": "1"}]}, {"else": 1.0}]
)
def test_an_account_of_a_fit_that_is_none_is_refused(tmp_path: Path, wrong: dict) -> None:
    document = Document(options=Options(align=Motion(method="best fit", fit=FIT | wrong)))
    text = to_text(document, ViewState(), ("", ""), tmp_path)
    with pytest.raises(InputError, match="not a session"):
        from_text(text, tmp_path, "s")
