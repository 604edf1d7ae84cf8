"""The whole comparison: the paper's general algorithm, stage by stage (section 3.2)."""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparison import Comparison, Domain, Options, Weight
from surfcmp_core.domain import Footprint, footprint_of_cloud, footprint_of_mesh
from surfcmp_core.domain.compared import Reason, reasons
from surfcmp_core.domain.footprint import DATA, OUTSIDE, states_at, states_of_triangles
from surfcmp_core.errors import InputError
from surfcmp_core.grid import Duplicates, Grid, box_of, grid_of, safe_scale, shared_nodes
from surfcmp_core.interface import kernels_are_ready
from surfcmp_core.interpolation import interpolate
from surfcmp_core.localisation import locate_along_tree
from surfcmp_core.measures import (
    LinearSurface,
    hausdorff,
    measure,
    measure_exactly,
    triangle_areas,
)
from surfcmp_core.progress import Progress, silent
from surfcmp_core.spanning_tree import spanning_tree, tree_ends
from surfcmp_core.surface import Surface
from surfcmp_core.triangulation import Triangulation, triangulate
from surfcmp_core.triangulation.half_edges import leaving_edges
from surfcmp_core.united import United, unite


class _Clock:
    """Wall time of each stage, told to the progress callback as it begins."""

    def __init__(self, progress: Progress, read_seconds: float) -> None:
        self.seconds = {
            "read": read_seconds,
            "triangulate": 0.0,
            "spanning_trees": 0.0,
            "locate": 0.0,
            "interpolate": 0.0,
            "interface": 0.0,
            "measures": 0.0,
        }
        self._progress = progress
        self._stage = ""
        self._begin = perf_counter()

    def begin(self, stage: str, fraction: float) -> None:
        self._progress(stage.replace("_", " "), fraction)
        self.end()
        self._stage = stage

    def end(self) -> None:
        now = perf_counter()
        if self._stage:
            self.seconds[self._stage] += now - self._begin
        self._begin = now

    def finish(self) -> dict[str, float]:
        self.end()
        self._progress("done", 1.0)
        return {**self.seconds, "total": sum(self.seconds.values())}


def _explained(progress: Progress) -> Progress:
    """Say so where the first use of the program compiles its kernels, which takes its time."""
    if kernels_are_ready():
        return progress
    return lambda stage, share: progress(f"{stage} (compiling, on first use only)", share)


def _both[A, B](work: Callable[[A], B], first: A, second: A, threads: int) -> tuple[B, B]:
    """Do the same for either surface, at once where two threads are allowed."""
    if threads < 2:
        return work(first), work(second)
    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(work, second)
        return work(first), other.result()


def _placed(surface: Surface, motion: NDArray[np.float64]) -> Surface:
    if len(surface.points) < 3:
        raise InputError(f"{surface.name}: {len(surface.points)} nodes; at least 3 are needed")
    if np.array_equal(motion, np.eye(4)):
        return surface
    return replace(surface, points=surface.points @ motion[:3, :3].T + motion[:3, 3])


def _warnings(first: Surface, second: Surface) -> tuple[str, ...]:
    return tuple(
        f"{surface.name}: {note}"
        for surface in (first, second)
        for note in (
            *(f"{count} {what}" for what, count in surface.changed.items()),
            *(["the file states no unit; mm is assumed"] if surface.unit is None else []),
        )
    )


def _footprint(
    grid: Grid,
    triangulation: Triangulation,
    tree: NDArray[np.int32],
    max_edge: float | None,
    scale: float,
) -> Footprint:
    if grid.faces is not None:
        found = footprint_of_mesh(triangulation, grid.faces)
    else:
        limit = None if max_edge is None else max_edge * scale
        found = footprint_of_cloud(triangulation, tree, limit)
    return replace(found, area=found.area / scale / scale, max_edge=found.max_edge / scale)


@dataclass(frozen=True, slots=True, eq=False)
class _Side:
    """One surface among the nodes of T."""

    grid: Grid
    footprint: Footprint
    own: NDArray[np.int32]
    """Numbers in T of its nodes."""
    other: NDArray[np.int32]
    """Numbers in T of the other grid's nodes."""
    queries: NDArray[np.float64]
    """The other grid's nodes."""
    found: NDArray[np.int32]
    """Where those lie in its triangulation."""

    def values(self, count: int, domain: Domain) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """F̂ at all nodes of T, and where the surface has data."""
        triangulation = self.footprint.triangulation
        z = np.empty(count)
        z[self.other] = interpolate(
            triangulation, self.grid.z, self.queries, self.found, continued=domain == "plane"
        )
        z[self.own] = self.grid.z
        state = np.full(count, DATA)
        if domain == "hull":
            state[self.other[self.found >= triangulation.real]] = OUTSIDE
            state[self.own] = DATA
        elif domain == "data":
            state[self.other] = states_at(self.footprint, self.queries, self.found)
            state[self.own] = self.footprint.at_node
            without = state != DATA
            without[self.own] = False
            z[without] = np.nan
        return z, state

    def linear(self, domain: Domain) -> LinearSurface:
        """F̂ on the surface's own triangles; outside its hull nothing is integrated exactly."""
        triangulation = self.footprint.triangulation
        valid = np.ones(triangulation.real, bool)
        if domain == "data":
            valid = self.footprint.covered
        return LinearSurface(triangulation, self.grid.z, valid, self.found)

    def states(
        self, nodes: NDArray[np.float64], united: United, state: NDArray[np.uint8], domain: Domain
    ) -> NDArray[np.uint8]:
        """Where the surface has data for the triangles of T."""
        triangulation = self.footprint.triangulation
        hints = np.empty(len(nodes), np.int32)
        hints[self.other] = self.found
        hints[self.own] = leaving_edges(triangulation.start, len(triangulation.nodes)) // 3
        return states_of_triangles(
            self.footprint,
            nodes,
            united.triangles,
            state,
            hints,
            ask_centroids=domain == "data",
        )


def compare(
    surface_1: Surface,
    surface_2: Surface,
    *,
    domain: Domain = "data",
    max_edge: float | None = None,
    exact: bool = False,
    tolerances: Sequence[float] = (0.5, 1.0, 2.0),
    weight: Weight | None = None,
    duplicates: Duplicates = "refuse",
    threads: int = 2,
    align: NDArray[np.float64] | None = None,
    frame: NDArray[np.float64] | None = None,
    progress: Progress = silent,
    read_seconds: float = 0.0,
) -> Comparison:
    """Compare two surfaces z = F(x, y).

    Parameters
    ----------
    surface_1, surface_2 : Surface
        n1 and n2 nodes, in one unit of length.
    domain : {"data", "hull", "plane"}
        Compare where both surfaces have data, inside both convex hulls, or over all of T with
        either surface continued by the nearest value of its hull.
    max_edge : float, optional
        Longest edge over which a cloud has data; derived from its spacing where not given, inf for
        no limit.
    exact : bool
        Also integrate exactly over the overlay of T1 and T2, within both hulls.
    tolerances : sequence of float
        Lengths for which to give the share of the area within.
    weight : callable, optional
        µ(x, y) ≥ 0, sampled at the nodes of T.
    duplicates : {"refuse", "mean", "max", "min"}
        What to do with nodes of equal (x, y) and different z.
    threads : int
        How many may work at once.
    align : (4, 4) float64, optional
        Motion of surface 2 onto surface 1, before `frame`.
    frame : (4, 4) float64, optional
        Motion of both surfaces into the plane of comparison, z along the view.
    progress : callable
        Told the stage and the share done; may raise `Cancelled`.
    read_seconds : float
        Time it took to read the surfaces, for the record.

    Returns
    -------
    Comparison

    Raises
    ------
    InputError
        The surfaces cannot be compared.
    Cancelled
        From `progress`.

    References
    ----------
    Stages 1 to 6 of the paper's section 3.2; formulas (1) to (3).
    """
    progress = _explained(progress)
    clock = _Clock(progress, read_seconds)
    view = np.eye(4) if frame is None else np.asarray(frame, np.float64)
    motion = view if align is None else view @ np.asarray(align, np.float64)

    clock.begin("triangulate", 0.0)
    first, second = _placed(surface_1, view), _placed(surface_2, motion)
    box = box_of(first, second)
    grids = _both(
        lambda surface: grid_of(surface, duplicates=duplicates, box=box), first, second, threads
    )
    scale = safe_scale(grids[0].nodes, grids[1].nodes)
    triangulations = _both(
        lambda grid: triangulate(grid.nodes * scale, name=grid.name, model=grid.faces),
        *grids,
        threads,
    )
    clock.begin("spanning_trees", 0.4)
    trees = _both(spanning_tree, *triangulations, threads)

    clock.begin("interface", 0.5)
    scaled = unite(
        *triangulations,
        *trees,
        shared_nodes(*grids),
        lambda share: progress("interface", 0.5 + 0.2 * share),
    )

    clock.begin("locate", 0.7)
    ends = tree_ends(triangulations[0], trees[0]), tree_ends(triangulations[1], trees[1])
    found_in_2, found_in_1 = _both(
        lambda job: locate_along_tree(*job),
        (triangulations[1], triangulations[0].nodes, ends[0]),
        (triangulations[0], triangulations[1].nodes, ends[1]),
        threads,
    )

    clock.begin("interpolate", 0.8)
    footprints = _both(
        lambda job: _footprint(*job, max_edge, scale),
        (grids[0], triangulations[0], ends[0]),
        (grids[1], triangulations[1], ends[1]),
        threads,
    )
    sides = (
        _Side(
            grids[0],
            footprints[0],
            scaled.node_1,
            scaled.node_2,
            triangulations[1].nodes,
            found_in_1,
        ),
        _Side(
            grids[1],
            footprints[1],
            scaled.node_2,
            scaled.node_1,
            triangulations[0].nodes,
            found_in_2,
        ),
    )
    (z1, at_1), (z2, at_2) = _both(
        lambda side: side.values(len(scaled.nodes), domain), *sides, threads
    )
    state_1, state_2 = _both(
        lambda job: job[0].states(scaled.nodes, scaled, job[1], domain),
        (sides[0], at_1),
        (sides[1], at_2),
        threads,
    )

    clock.begin("measures", 0.9)
    united = scaled
    if scale != 1.0:
        united = replace(scaled, nodes=scaled.nodes / scale)
        triangulations = (
            replace(triangulations[0], nodes=grids[0].nodes),
            replace(triangulations[1], nodes=grids[1].nodes),
        )
    reason = reasons(state_1, state_2, triangle_areas(united.nodes, united.triangles))
    compared = reason == Reason.COMPARED
    if not compared.any():
        raise InputError(f"{first.name} and {second.name}: no common area to compare")
    node_weight = None
    if weight is not None:
        node_weight = np.asarray(weight(united.nodes[:, 0], united.nodes[:, 1]), np.float64)
    points = [np.column_stack((grid.nodes, grid.z)) for grid in grids]
    farthest = _both(
        lambda job: hausdorff(*job),
        (points[0], points[1], triangulations[1].start[3 * found_in_2]),
        (points[1], points[0], triangulations[0].start[3 * found_in_1]),
        threads,
    )
    values, measures = measure(
        united.nodes,
        united.label,
        united.triangles,
        z1,
        z2,
        compared,
        tolerances=tolerances,
        node_weight=node_weight,
        footprint_1=footprints[0].area,
        footprint_2=footprints[1].area,
        hausdorff=farthest,
    )
    exact_values = None
    if exact:
        exact_values, exact_measures = measure_exactly(
            sides[0].linear(domain),
            sides[1].linear(domain),
            scaled,
            length=1.0 / scale,
            tolerances=tolerances,
            node_weight=node_weight,
            footprint_1=footprints[0].area,
            footprint_2=footprints[1].area,
            hausdorff=farthest,
            progress=lambda share: progress("exact measures", 0.92 + 0.08 * share),
        )
        measures = replace(measures, exact=exact_measures)
    seconds = clock.finish()
    return Comparison(
        (surface_1, surface_2),
        grids,
        triangulations,
        united,
        z1,
        z2,
        node_weight,
        reason,
        values.area,
        values.mean_abs,
        values.mean_signed,
        measures,
        Options(domain, max_edge, exact, tuple(tolerances), duplicates, threads),
        motion,
        (footprints[0].max_edge, footprints[1].max_edge),
        None if exact_values is None else exact_values.mean_abs,
        None if exact_values is None else exact_values.mean_signed,
        view,
        seconds,
        _warnings(first, second),
    )
