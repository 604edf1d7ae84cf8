"""Controllers, tied to stand-ins for workbench, display, panels and dialogs: no screen."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QObject, QSettings, Signal

from app.controllers.chain_choice import ChainChoice
from app.controllers.colour_range import Scaling
from app.controllers.marking import Regions
from app.controllers.opening import Opening
from app.controllers.probing import Places
from app.controllers.sectioning import Section
from app.jobs.comparing import Compared
from app.model.document import Document
from app.model.region import Region, Stroke
from app.model.tool import Tool
from app.model.view_state import ChainsBy, Place, ScaleChoice
from app.scene.content import content_of
from app.scene.pick import reading_at
from tests.app.mocks import MockAsking, MockDisplay, MockTelling, MockWorkbench
from tests.window.builders import comparison_of, hills

ONE, TWO = Path("/one.ply"), Path("/two.ply")


@pytest.fixture(scope="module", autouse=True)
def qt(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Signals need an application, but no screen."""
    folder = str(tmp_path_factory.mktemp("settings"))
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, folder)
    application = QCoreApplication.instance() or QCoreApplication([])
    yield
    del application


@pytest.fixture(scope="module")
def result() -> Compared:
    """A small comparison, ready to be shown."""
    comparison = comparison_of(hills(60, 1), hills(40, 2, lift=3.0))
    document = Document((ONE, TWO))
    return Compared(document, comparison, {}, content_of(comparison), ())


class Panel(QObject):
    """A panel that remembers what it was shown."""

    keep_asked = Signal()
    remove_asked = Signal(int)
    clear_asked = Signal()
    chosen = Signal(object)
    colours_asked = Signal(object)
    brushed = Signal(object)
    changed = Signal(object)
    fit_asked = Signal()
    tool_asked = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.seen: dict[str, tuple[object, ...]] = {}

    def show_readings(self, *shown: object) -> None:
        self.seen["readings"] = shown

    def show_chains(self, *shown: object) -> None:
        self.seen["chains"] = shown

    def show_colours(self, *shown: object) -> None:
        self.seen["colours"] = shown

    def show_state(self, *shown: object) -> None:
        self.seen["state"] = shown

    def show_tool(self, *shown: object) -> None:
        self.seen["tool"] = shown

    def show_profile(self, *shown: object) -> None:
        self.seen["profile"] = shown


def test_a_picked_place_is_kept_and_let_go(result: Compared) -> None:
    display, panel = MockDisplay(), Panel()
    places = Places(display, panel)
    panel.keep_asked.emit()  # nothing is picked
    assert display.state.probes == ()
    display.set_content(result.content, "mm", ScaleChoice())
    first, second = Place(0, (1.0, 0.0, 0.0)), Place(1, (0.2, 0.3, 0.5))
    display.change(picked=first)
    panel.keep_asked.emit()
    assert display.state.probes == (first,)
    assert display.state.picked is None
    display.change(picked=second)
    places.keep()
    kept, picked, unit = panel.seen["readings"]
    readings = [reading_at(result.comparison, place) for place in (first, second)]
    assert [(one.x, one.y) for one in kept] == [(one.x, one.y) for one in readings]
    assert picked is None
    assert unit == "mm"
    panel.remove_asked.emit(0)
    assert display.state.probes == (second,)
    panel.clear_asked.emit()
    assert display.state.probes == ()


def test_a_chain_that_is_chosen_stands_out_and_is_flown_to(result: Compared) -> None:
    workbench, display, panel = MockWorkbench(), MockDisplay(), Panel()
    chains = ChainChoice(workbench, display, panel)
    chains.fly_to(0)  # nothing is shown yet
    assert display.looked_at == []
    workbench.finish(result)
    display.set_content(result.content, "mm", ScaleChoice())
    assert panel.seen["chains"] == (result.content.chains, "mm")
    panel.colours_asked.emit(ChainsBy.LENGTH)
    assert display.state.chains_by is ChainsBy.LENGTH
    by, colours = panel.seen["colours"]
    assert by is ChainsBy.LENGTH
    assert len(colours) == len(result.content.chains.closed)
    panel.chosen.emit(0)
    assert display.state.chain == 0
    ((low, high),) = display.looked_at
    assert (low < high).any()


def test_tolerances_are_the_document_s_and_the_range_is_the_view_s(result: Compared) -> None:
    workbench, display, panel = MockWorkbench(), MockDisplay(), Panel()
    scaling = Scaling(workbench, display, panel)
    scale = ScaleChoice(limit=3.0, tolerances=(0.1, 0.2), pinned=True)
    panel.changed.emit(scale)
    assert workbench.document.options.tolerances == (0.1, 0.2)
    assert workbench.views == [{"scale": scale}]
    panel.fit_asked.emit()  # nothing is shown yet
    assert not display.state.scale.pinned
    display.set_content(result.content, "mm", ScaleChoice(limit=1e9))
    scaling.fit()
    assert display.state.scale.pinned
    largest = float(np.nanmax(np.abs(result.comparison.mean_abs)))
    assert 0.0 < display.state.scale.limit <= 2.0 * largest
    panel.brushed.emit((0.1, 0.4))
    assert display.state.brush == (0.1, 0.4)
    assert panel.seen["state"] == (display.content, display.state, "mm")


def test_a_section_has_a_profile_where_there_is_something_to_cut(result: Compared) -> None:
    display, panel = MockDisplay(), Panel()
    section = Section(display, panel)  # noqa: F841 - tied for as long as it lives
    assert panel.seen["profile"] == (None, "", False)
    display.change(section=(-20.0, 0.0, 20.0, 0.0))
    assert panel.seen["profile"][0] is None
    display.set_content(result.content, "mm", ScaleChoice())
    profile, unit, _ = panel.seen["profile"]
    assert profile is not None
    assert unit == "mm"
    panel.tool_asked.emit(Tool.SECTION)
    assert panel.seen["tool"] == (Tool.SECTION,)


def opening(document: Document | None = None, *answers: Path | None) -> tuple:
    """A controller of files, and all that it is tied to."""
    workbench, telling, asking = MockWorkbench(document), MockTelling(), MockAsking(*answers)
    sessions: list[Path] = []
    return (
        Opening(workbench, telling, asking, sessions.append),
        workbench,
        telling,
        asking,
        sessions,
    )


def test_files_find_their_place() -> None:
    taking, workbench, telling, asking, sessions = opening()
    taking.take([ONE])
    taking.take([ONE, TWO])
    assert workbench.opened == [([ONE], None), ([ONE, TWO], None)]
    taking.take([Path("/work.surfcmp")])
    assert sessions == [Path("/work.surfcmp")]
    taking.take([ONE, TWO, ONE])
    assert "3 files" in telling.said[-1][0]
    taking.take([])
    assert len(workbench.opened) == 2
    assert asking.asked == []


def test_one_more_file_asks_where_it_belongs() -> None:
    taking, workbench, _, asking, _ = opening(Document((ONE, TWO)))
    taking.take([Path("/three.ply")])
    assert workbench.opened == []
    assert asking.asked == [("three.ply",)]
    list(asking.offered.values())[1]()
    assert workbench.opened == [([Path("/three.ply")], 2)]


def test_the_file_that_is_missing_is_asked_for() -> None:
    taking, workbench, _, asking, _ = opening(Document((ONE, None)), TWO)
    taking.open_missing()
    assert workbench.opened == [([TWO], 2)]
    taking, workbench, _, asking, _ = opening(None, ONE, TWO)
    taking.open_missing()
    assert workbench.opened == [([ONE, TWO], None)]
    assert "*.ply" in asking.asked[0][1]
    taking, workbench, _, asking, _ = opening(None, None)
    taking.open_one(1)  # the user thinks better of it
    assert workbench.opened == []


def test_surfaces_are_exchanged_only_as_a_pair() -> None:
    taking, workbench, *_ = opening(Document((ONE, None)))
    taking.swap_surfaces()
    assert workbench.document.paths == (ONE, None)
    taking, workbench, *_ = opening(Document((ONE, TWO)))
    taking.swap_surfaces()
    assert workbench.document.paths == (TWO, ONE)


class RegionsMock(QObject):
    """The panel of the regions."""

    tool_asked = Signal(object)
    renamed = Signal(int, str)
    weighed = Signal(int, float)
    coloured = Signal(int, object)
    remove_asked = Signal(int)
    save_asked = Signal()
    load_asked = Signal()

    class Radius(QObject):
        changed = Signal(float)
        value = 4.0

        def show_value(self, value: float) -> None:
            self.value = value

    class Take:
        on = False

        def isChecked(self) -> bool:
            return self.on

    def __init__(self) -> None:
        super().__init__()
        self.radius, self.take, self.selected = self.Radius(), self.Take(), -1
        self.shown: list[object] = []

    def show_regions(self, *shown: object) -> None:
        self.shown.append(shown)

    def show_tool(self, tool: object) -> None:
        self.tool = tool


SQUARE = ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0))


def drawing(*answers: Path | None) -> tuple:
    """A controller of regions, and all that it is tied to."""
    workbench, display, panel = MockWorkbench(), MockDisplay(), RegionsMock()
    telling, asking = MockTelling(), MockAsking(*answers)
    regions = Regions(workbench, display, panel, telling, asking)
    return regions, workbench, display, panel, telling, asking


def test_each_lasso_is_a_region_and_a_brush_adds_to_the_chosen_one() -> None:
    regions, workbench, display, panel, telling, _ = drawing()
    display.path_drawn.emit(Tool.LASSO, SQUARE)
    display.path_drawn.emit(Tool.LASSO, SQUARE)
    display.path_drawn.emit(Tool.LASSO, SQUARE[:2])  # too short to go round anything
    names = [region.name for region in workbench.document.regions]
    assert names == ["Region 1", "Region 2"]
    panel.selected = 1
    regions.draw(Tool.BRUSH, SQUARE)
    assert [len(region.strokes) for region in workbench.document.regions] == [1, 2]
    assert workbench.document.regions[1].strokes[1].radius == 4.0
    panel.take.on, panel.selected = True, -1
    regions.draw(Tool.BRUSH, SQUARE)
    assert telling.said[-1][1] == "note"
    panel.selected = 0
    regions.draw(Tool.LASSO, SQUARE)
    assert workbench.document.regions[0].strokes[1] == Stroke(SQUARE, takes=True)
    display.path_drawn.emit(Tool.SECTION, SQUARE[:2])
    assert display.state.section == (0.0, 0.0, 9.0, 0.0)


def test_regions_are_named_weighed_coloured_and_removed() -> None:
    regions, workbench, _, panel, _, asking = drawing()
    workbench.document = replace(workbench.document, regions=(Region("nose", (1, 2, 3)),))
    panel.renamed.emit(0, "chin")
    panel.weighed.emit(0, 2.5)
    panel.weighed.emit(0, -1.0)  # refused
    panel.coloured.emit(0, None)
    assert workbench.document.regions == (Region("chin", (1, 2, 3), 2.5),)
    asking.tint = (7, 8, 9)
    panel.coloured.emit(0, None)
    panel.renamed.emit(0, "")
    assert workbench.document.regions == (Region("Region 1", (7, 8, 9), 2.5),)
    regions.remove(3)
    panel.remove_asked.emit(0)
    assert workbench.document.regions == ()


def test_regions_come_back_from_their_file(tmp_path: Path) -> None:
    file, bad = tmp_path / "regions.json", tmp_path / "bad.json"
    bad.write_text("{")
    _, workbench, _, panel, telling, _ = drawing(file, file, bad, None)
    kept = (Region("nose", (1, 2, 3), strokes=(Stroke(SQUARE),)),)
    workbench.document = replace(workbench.document, regions=kept)
    panel.save_asked.emit()
    panel.load_asked.emit()
    assert workbench.document.regions == kept * 2
    panel.load_asked.emit()
    assert telling.said[-1][0].startswith("bad.json: ")
    panel.save_asked.emit()  # the user thinks better of it
    assert workbench.document.regions == kept * 2


def test_a_first_result_sizes_the_brush(result: Compared) -> None:
    _, workbench, display, panel, _, _ = drawing()
    workbench.finish(result)
    assert display.brush == panel.radius.value == 5.0
    assert len(panel.shown) == 1
