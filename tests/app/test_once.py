"""What was found for the views is found once, and goes with what it was found for."""

import gc
import weakref
from dataclasses import replace

from app.model.view_state import Heatmap, ViewState
from app.scene.content import Content, content_of
from app.scene.scene import scene_of
from tests.window.builders import comparison_of, hills

STATE = ViewState(section=(-20.0, 0.0, 20.0, 1.0))


def some_content() -> Content:
    return content_of(comparison_of(hills(60, 1), hills(40, 2, lift=3.0)))


def test_what_is_shown_again_is_the_very_same() -> None:
    content = some_content()
    one = scene_of(content, STATE)
    scene_of(content, replace(STATE, heatmap=Heatmap.TRUST, dark=True))
    two = scene_of(content, replace(STATE, relief=False))
    for first, second in zip(one.layers, two.layers, strict=True):
        assert first.colours is second.colours
        assert first.nodes is second.nodes


def test_what_was_found_ends_with_its_content() -> None:
    content = some_content()
    found = [weakref.ref(layer.colours) for layer in scene_of(content, STATE).layers[2:]]
    found.append(weakref.ref(content.comparison.mean_abs))
    assert all(each() is not None for each in found)
    newer = replace(content, comparison=replace(content.comparison))
    scene_of(newer, STATE)
    del content
    gc.collect()
    assert found[0]() is None
    assert found[1]() is None
    assert found[2]() is not None  # the newer one has it still
