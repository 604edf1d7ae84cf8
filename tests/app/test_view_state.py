"""A field of the view is declared once: undo, sessions and other surfaces follow from that."""

import json
from dataclasses import Field, asdict, fields, replace
from pathlib import Path
from typing import Any, get_type_hints

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.model.document import Document
from app.model.history import History, Step
from app.model.plain import read
from app.model.session_text import from_text, to_text
from app.model.view_state import Kept, Of, ViewState

KEPT = fields(Kept)
ALL = fields(ViewState)
SAVED = [part for part in ALL if part.name != "filled"]
FIRST = ViewState()


def other(part: Field[Any]) -> st.SearchStrategy[Any]:
    """Give values of a field that are not its first one (and none that differs from itself)."""
    values = st.from_type(get_type_hints(ViewState)[part.name])
    return values.filter(lambda value: value != part.default and "nan" not in repr(value))


def by_name(part: Field[Any]) -> str:
    return part.name


def through_a_session(state: ViewState) -> ViewState:
    text = to_text(Document(), state, ("", ""), Path("/"))
    return from_text(text, Path("/"), "x").state


@pytest.mark.parametrize("part", KEPT, ids=by_name)
@given(st.data())
def test_what_is_kept_is_a_step_and_comes_back(part: Field[Any], data: st.DataObject) -> None:
    state = replace(FIRST, **{part.name: data.draw(other(part))})
    assert state.kept != FIRST.kept
    history = History(Step(Document(), FIRST.kept))
    history.push(Step(Document(), state.kept))
    assert history.undoable is not None
    assert state.keeping(history.undo().view) == FIRST
    assert FIRST.keeping(history.redo().view) == state
    assert FIRST.kept.changed_as(FIRST.kept, state.kept) == state.kept


@pytest.mark.parametrize("part", [part for part in ALL if part not in KEPT], ids=by_name)
@given(st.data())
def test_what_passes_is_no_step(part: Field[Any], data: st.DataObject) -> None:
    assert replace(FIRST, **{part.name: data.draw(other(part))}).kept == FIRST.kept


@pytest.mark.parametrize("part", SAVED, ids=by_name)
@given(st.data())
def test_a_session_keeps_it(part: Field[Any], data: st.DataObject) -> None:
    state = replace(FIRST, **{part.name: data.draw(other(part))})
    assert through_a_session(state) == state


@pytest.mark.parametrize("part", ALL, ids=by_name)
@given(st.data())
def test_it_goes_with_what_it_belongs_to(part: Field[Any], data: st.DataObject) -> None:
    state = replace(FIRST, **{part.name: data.draw(other(part))})
    owner = part.metadata.get("of")
    for one in Of:
        assert state.without(one) == (FIRST if one is owner else state)
    assert state.in_window_of(FIRST) == (FIRST if owner is Of.WINDOW else state)


def test_a_session_opens_with_all_four_views() -> None:
    assert through_a_session(replace(FIRST, filled=2)) == FIRST


def test_fields_of_older_sessions_are_enough() -> None:
    text = json.loads(json.dumps(asdict(FIRST)))
    del text["landmarks"], text["chain"]
    assert read(ViewState, text) == FIRST


@pytest.mark.parametrize(
    "wrong",
    [
        {"edges": 1},
        {"heatmap": "of another kind"},
        {"section": [0.0, 0.0, 1.0]},
        {"brush": {"low": 1.0}},
        {"scale": []},
        {"scale": {"limit": "wide"}},
        {"probes": [{"triangle": 0.5, "weights": [1.0, 0.0, 0.0]}]},
        {"of a later version": 1},
    ],
    ids=lambda wrong: next(iter(wrong)),
)
def test_values_of_another_kind_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises((TypeError, ValueError)):
        read(ViewState, wrong)
