"""What should be on the screen, tested without one."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import LinearNDInterpolator

from app.model.view_state import ChainsBy, Heatmap, ScaleChoice, ViewState
from app.scene.chain_colours import FEW, chain_colours, hues
from app.scene.chain_table import ChainTable, chain_box, chain_table
from app.scene.coarse import coarse_of
from app.scene.content import content_of
from app.scene.distribution import Distributions, distribution_of, distributions_of
from app.scene.furniture import colour_bar, legend
from app.scene.geometry import geometry_of, middle_height
from app.scene.profile import profile_of
from app.scene.quiet_colours import palette
from app.scene.scene import heatmap_colours, scene_of, united_colours
from app.scene.ticks import round_down, ticks
from app.scene.values import Trust, trust_of, values_of
from surfcmp_core.colours.maps import ABOVE, BELOW, WITHIN, colour_map, spread
from surfcmp_core.colours.scale import Scale, coloured, round_up
from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.triangulation import triangulate
from tests.window.builders import comparison_of, hills

STATE = ViewState()


def heat(comparison: Comparison, state: ViewState) -> np.ndarray:
    return heatmap_colours(comparison, state.heatmap, state.colours, state.brush, state.dark)


def test_zero_is_the_middle_of_a_signed_scale():
    table = colour_map("vik")
    colours = spread(np.array([0.0]), -3.0, 3.0, table, (1, 2, 3))
    assert (colours[0] == table[128]).all()


def test_beyond_the_scale_and_no_data_are_told_apart():
    values = np.array([-1.01, -1.0, 1.0, 1.01, np.nan])
    colours = spread(values, -1.0, 1.0, colour_map("vik"), (9, 9, 9))
    assert tuple(colours[0]) == BELOW
    assert tuple(colours[3]) == ABOVE
    assert tuple(colours[4]) == (9, 9, 9)
    kinds = {tuple(colour) for colour in colours.tolist()}
    assert len(kinds) == 5


def test_a_tolerance_itself_is_within():
    scale = Scale(9.0, (0.5, 1.0), signed=True)
    values = np.array([-0.5, 0.0, 0.5, np.nextafter(0.5, 1), np.nextafter(-0.5, -1)])
    colours = [tuple(colour) for colour in coloured(values, scale, (9, 9, 9)).tolist()]
    assert colours[:3] == [WITHIN] * 3
    assert colours[3] != WITHIN
    assert colours[4] not in {WITHIN, colours[3]}


def test_bands_of_a_signed_scale_mirror_each_other():
    scale = Scale(9.0, (0.5, 1.0, 2.0), signed=True)
    values = np.array([0.7, 1.5, 3.0])
    up, down = coloured(values, scale, (0, 0, 0)), coloured(-values, scale, (0, 0, 0))
    assert len({tuple(c) for c in np.vstack([up, down]).tolist()}) == 6


def test_the_heatmap_is_grey_exactly_where_nothing_is_compared(small: Comparison):
    grey = palette(False).no_data
    colours = heat(small, STATE)
    assert ((colours == grey).all(axis=1) == ~small.compared).all()
    assert 0 < (~small.compared).sum() < len(colours)


def test_representative_only_greys_the_clouts(small: Comparison):
    values = values_of(small, Heatmap.REPRESENTATIVE)
    assert (np.isfinite(values) == (small.united.representative & small.compared)).all()


def test_trust_says_what_a_triangle_rests_on(small: Comparison):
    trust = trust_of(small)
    labels = small.united.label[small.united.triangles]
    for kind, nodes in ((Trust.ONLY_1, {1}), (Trust.ONLY_2, {2}), (Trust.BOTH, {1, 2})):
        found = labels[trust == kind]
        assert len(found)
        assert all(set(row) == nodes for row in found.tolist())


def test_a_brush_fades_what_is_outside_it(small: Comparison):
    plain = heat(small, STATE)
    brushed = heat(small, replace(STATE, brush=(0.2, 1.0)))
    inside = (small.mean_signed >= 0.2) & (small.mean_signed <= 1.0)
    assert 0 < inside.sum() < len(inside)
    assert ((brushed == plain).all(axis=1) == inside).all()


def test_closed_chains_are_warm_and_open_ones_cool():
    closed = np.tile([True, False], 40)
    colours = hues(closed).astype(int)
    red, blue = colours[:, 0], colours[:, 2]
    assert (red[closed] > blue[closed]).all()
    assert (red[~closed] < blue[~closed]).all()
    assert len(np.unique(colours, axis=0)) == len(colours)


def test_every_chain_has_one_colour_and_clouts_have_the_surfaces(small: Comparison):
    colours = united_colours(small, chain_table(small), ChainsBy.ROLE, 1.0, None, False)
    for chain in range(len(small.united.chain_closed)):
        assert len(np.unique(colours[small.united.chain == chain], axis=0)) == 1
    labels = small.united.label[small.united.triangles]
    clouts = (labels == 1).all(axis=1)
    assert (colours[clouts] == palette(False).surface_1).all()


def test_a_chosen_chain_stands_out(small: Comparison):
    how = small, chain_table(small), ChainsBy.ROLE, 1.0
    plain, chosen = united_colours(*how, None, False), united_colours(*how, 0, False)
    same = (plain == chosen).all(axis=1)
    assert (same == (small.united.chain == 0)).all()


def test_the_map_and_the_relief_share_their_arrays(small: Comparison):
    content = content_of(small)
    relief = scene_of(content, STATE)
    flat = scene_of(content, replace(STATE, relief=False))
    for one, two in zip(relief.layers, flat.layers, strict=True):
        assert one.patch is two.patch
        assert one.relief
        assert not two.relief
    assert relief.layers[3].colours is flat.layers[3].colours
    assert [layer.shaded for layer in flat.layers] == [True, True, False, False]


def test_nothing_is_lost_far_from_the_origin(clouds):
    from tests.window.builders import comparison_of

    far = np.array([4e5, 5e6, 100.0])
    geometry = geometry_of(comparison_of(clouds[0] + far, clouds[1] + far))
    near = geometry_of(comparison_of(*clouds))
    for one, two in zip(geometry.patches[:2], near.patches[:2], strict=True):
        assert np.allclose(one.points, two.points, atol=1e-5)


def test_t_lies_half_way_between_the_surfaces(small: Comparison):
    middle = middle_height(small)
    assert np.isfinite(middle).all()
    both = np.isfinite(small.z1) & np.isfinite(small.z2)
    assert np.allclose(middle[both], (small.z1 + small.z2)[both] / 2)


def test_normals_point_up_and_have_unit_length(small: Comparison):
    for patch in geometry_of(small).patches:
        assert np.allclose(np.linalg.norm(patch.normals, axis=1), 1.0, atol=1e-5)
        assert (patch.normals[:, 2] > 0).all()


def test_the_colour_bar_is_symmetric_when_signed(small: Comparison):
    bar = colour_bar(small, replace(STATE, scale=ScaleChoice(limit=2.0)))
    assert bar is not None
    places = [place for place, _ in bar.ticks]
    assert [value for _, value in bar.ticks] == [-2.0, -1.0, 0.0, 1.0, 2.0]
    assert np.allclose(places, [1 - place for place in reversed(places)])
    assert bar.below == BELOW
    assert bar.above == ABOVE


def test_the_scale_of_absolute_differences_begins_at_zero(small: Comparison):
    bar = colour_bar(small, replace(STATE, heatmap=Heatmap.ABSOLUTE, scale=ScaleChoice(limit=2.0)))
    assert bar is not None
    assert bar.ticks[0] == (0.0, 0.0)
    assert bar.below is None


def test_a_banded_bar_changes_colour_at_its_ticks(small: Comparison):
    scale = ScaleChoice(tolerances=(0.5, 1.0, 2.0), banded=True)
    state = replace(STATE, scale=scale)
    bar = colour_bar(small, state)
    assert bar is not None
    assert [value for _, value in bar.ticks] == [-2.0, -1.0, -0.5, 0.5, 1.0, 2.0]
    for place, value in bar.ticks:
        k = round(place * len(bar.colours))
        below, above = (
            coloured(np.array([value + e]), state.colours, (0, 0, 0)) for e in (-1e-9, 1e-9)
        )
        assert (bar.colours[k - 1] == below[0]).all()
        assert (bar.colours[k] == above[0]).all()


@pytest.fixture(scope="module")
def many() -> Comparison:
    """Give a comparison with chains of every kind."""
    return comparison_of(hills(1500, 1), hills(700, 2, lift=3.0))


def test_the_legend_counts_the_chains(many: Comparison, small: Comparison):
    content = content_of(many)
    found = {swatch.text: swatch.count for swatch in legend(content, STATE, 2)}
    kinds = content.chains.counts
    assert len(content.chains.closed) > FEW
    assert found["rings round one node: {}"] == kinds["rings"] > 0
    assert found["longer closed chains: {}"] == kinds["longer"] > 0
    assert found.get("open chains: {}", 0) == kinds["open"]
    assert sum(kinds.values()) == len(many.united.chain_closed)
    for by in set(ChainsBy) - {ChainsBy.ROLE}:
        (swatch,) = legend(content, replace(STATE, chains_by=by), 2)[2:]
        assert swatch.count == len(many.united.chain_closed)
    few = {swatch.text: swatch.count for swatch in legend(content_of(small), STATE, 2)}
    assert few["closed chains: {}"] == small.counts["chains_closed"]
    assert few["open chains: {}"] == small.counts["chains_open"]
    assert legend(content, STATE, 3) == ()
    assert len(legend(content, replace(STATE, heatmap=Heatmap.TRUST), 3)) == 4


def test_a_ring_runs_round_one_node(many: Comparison):
    table, united = chain_table(many), many.united
    for chain in range(len(table.closed)):
        common = set.intersection(*map(set, united.triangles[united.chain == chain].tolist()))
        assert table.ring[chain] == (bool(common) and bool(table.closed[chain]))


def test_chains_are_coloured_by_their_role_or_a_number(many: Comparison):
    table = chain_table(many)
    role = chain_colours(table, ChainsBy.ROLE, 1.0, dark=False).astype(int)
    assert (role[table.ring] == palette(False).ring).all()
    longer = np.flatnonzero(table.closed & ~table.ring)
    by_length_ = longer[np.argsort(table.triangles[longer])]
    assert (np.diff(role[by_length_].sum(axis=1)) <= 2).all()  # ever darker
    mean = chain_colours(table, ChainsBy.MEAN, 1.0, dark=False)
    least, most = np.nanargmin(table.mean_abs), np.nanargmax(table.mean_abs)
    assert mean[least].astype(int).sum() > mean[most].astype(int).sum()
    order = chain_colours(table, ChainsBy.ORDER, 1.0, dark=False)
    assert len(np.unique(order, axis=0)) > 0.9 * min(len(order), 256)
    few = ChainTable(*(getattr(table, name)[:10] for name in ChainTable.__slots__))
    assert len(np.unique(chain_colours(few, ChainsBy.ROLE, 1.0, dark=True), axis=0)) == 10


@pytest.mark.parametrize(
    ("value", "up", "down"),
    [(0.9, 1, 0.5), (1.0, 1, 1), (1.01, 2, 1), (4.2, 5, 2), (7e-4, 1e-3, 5e-4), (30, 50, 20)],
)
def test_round_limits(value: float, up: float, down: float):
    assert round_up(value) == pytest.approx(up)
    assert round_down(value) == pytest.approx(down)


@pytest.mark.parametrize("limit", [0.1, 0.3, 1.0, 2.0, 7.0, 1234.0, 1e-6])
def test_ticks_are_few_and_contain_zero(limit: float):
    found = ticks(-limit, limit)
    assert 3 <= len(found) <= 7
    assert 0.0 in found
    assert max(map(abs, found)) <= limit * (1 + 1e-9)


def test_the_fitting_limit_leaves_a_hundredth_of_the_area_beyond():
    def limit(values: list[float]) -> float:
        found = distribution_of(np.array(values), np.ones(len(values)))
        return Distributions(found, found).fitting_end

    assert limit([0.4] * 99 + [50.0]) == 0.5
    assert limit([0.4] * 98 + [50.0] * 2) == 50.0
    assert limit([np.nan]) == 1.0
    assert limit([0.0] * 3) == 1.0


def test_a_histogram_adds_up_to_the_area_within_the_range(small: Comparison):
    signed = distributions_of(small).signed
    edges = np.linspace(-3.0, 5.0, 33)
    shares = signed.histogram(edges)
    values, areas = small.mean_signed, np.nan_to_num(small.area)
    for k in range(len(shares)):
        inside = (values > edges[k]) & (values <= edges[k + 1])
        assert shares[k] == pytest.approx(areas[inside].sum() / areas.sum(), abs=1e-12)
    inside = (values >= -0.5) & (values <= 1.5)
    assert signed.within(-0.5, 1.5) == pytest.approx(areas[inside].sum() / areas.sum())
    assert signed.within(2.0, -2.0) == 0.0


def test_chains_add_up_to_the_interface(small: Comparison):
    table = chain_table(small)
    inside = small.united.chain >= 0
    assert table.triangles.sum() == inside.sum()
    volume = small.mean_abs * small.area
    assert table.area.sum() == pytest.approx(np.nansum(small.area[inside]))
    assert table.share.sum() == pytest.approx(np.nansum(volume[inside]) / np.nansum(volume))
    for chain in range(len(table.closed)):
        low, high = chain_box(small, geometry_of(small), chain)
        assert (high >= low).all()


def test_a_cloud_is_pale_beyond_its_longest_edge(clouds):
    comparison = comparison_of(*clouds, hole=25.0)
    content = content_of(comparison)
    data = content.geometry.patches[1].data
    assert data is not None
    scene = scene_of(content, STATE)
    colours = scene.layers[1].colours
    assert (np.all(colours == palette(False).surface_2, axis=1) == data).all()


def test_a_coarse_patch_keeps_the_outline_and_points_at_the_patch():
    rng = np.random.default_rng(3)
    points = np.column_stack([rng.uniform(0, 10, (60_000, 2)), np.zeros(60_000)])
    points = points[np.lexsort((points[:, 1], np.floor(points[:, 0] * 20)))]
    triangles = triangulate(np.ascontiguousarray(points[:, :2])).triangles
    hull = np.array([points[:, 0].argmin(), points[:, 0].argmax()], dtype=np.int32)
    coarse = coarse_of(points, triangles, hull)
    assert coarse is not None
    assert len(coarse.nodes) < 20_000
    assert np.isin(hull, coarse.nodes).all()
    nodes = triangles[coarse.source]
    assert (nodes == coarse.nodes[coarse.triangles[:, :1]]).any(axis=1).all()
    assert coarse_of(points[:100], triangles[:0], hull[:0]) is None


@pytest.mark.parametrize("relief", [True, False])
def test_lines_are_drawn_over_all_views(small: Comparison, relief: bool):
    from app.jobs.region_measures import region_of
    from app.model.region import Region, Stroke

    region = Region("a", (1, 2, 3), strokes=(Stroke(((0.0, 0.0),), 20.0),))
    number = region_of(small, (region,))
    content = content_of(small, None, number, [(1, 2, 3)])
    state = replace(STATE, relief=relief, section=(-40.0, 0.0, 40.0, 5.0))
    layers = scene_of(content, state).layers
    assert len(layers[0].lines) == len(layers[0].line_colours) > 10
    assert all(len(layer.lines) == len(layers[0].lines) for layer in layers)
    assert np.array_equal(layers[2].lines, layers[3].lines)
    assert np.array_equal(layers[0].lines, layers[2].lines) != relief
    assert np.isfinite(layers[0].lines).all()
    assert (np.ptp(layers[0].lines[..., 2]) > 0) == relief
    border = content.borders[0][0]
    ends, counts = np.unique(border, return_counts=True)
    assert (counts % 2 == 0).all()  # closed
    assert len(ends) > 5


def test_a_section_follows_both_surfaces(small: Comparison):
    line = (-45.0, -30.0, 45.0, 35.0)
    profile = profile_of(small, line)
    assert len(profile.along) > 10
    assert (np.diff(profile.along) > 0).all()
    towards = np.array([90.0, 65.0]) / np.hypot(90.0, 65.0)
    places = np.array(line[:2]) + profile.along[:, None] * towards
    triangulation = LinearNDInterpolator(small.united.nodes, np.stack([small.z1, small.z2], 1))
    oracle = triangulation(places)
    known = np.isfinite(oracle).all(axis=1) & np.isfinite(profile.difference)
    assert known.sum() > 5
    spread = np.ptp(small.z1[np.isfinite(small.z1)])
    assert np.median(np.abs(profile.z1 - oracle[:, 0])[known]) < 1e-9 * spread
    assert np.median(np.abs(profile.z2 - oracle[:, 1])[known]) < 1e-9 * spread
    assert len(profile_of(small, (900.0, 0.0, 901.0, 0.0)).along) == 0
    assert len(profile_of(small, (0.0, 0.0, 0.0, 0.0)).along) == 0
