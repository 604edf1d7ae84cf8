"""A session as text: the document, how it was looked at, and which scans it is about."""

import json
import os
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, BinaryIO

from app.model.document import Document
from app.model.plain import read
from app.model.region import Region
from app.model.view_state import ViewState
from surfcmp_core.alignment.fit import FIT_KEYS
from surfcmp_core.comparing.options import Motion, Options
from surfcmp_core.errors import InputError
from surfcmp_core.system.whole_files import write_all

KIND = "surfcmp session"
VERSION = 2
"""1 had regions without an order of their strokes, and never held scans."""
ENDING = ".surfcmp"


_NUMBERS = ("domain", "max_edge", "exact", "tolerances", "duplicates", "threads")
"""Fields of `Options` under "options"; "motion", "unit" and "project" stand beside them."""

Three = tuple[float, float, float]
Eye = tuple[Three, Three, Three, tuple[float]]
"""Of a camera: x, y, z of its focus, of the way back to the eye, of upwards; its height."""

FAULTS = (ValueError, KeyError, TypeError, AttributeError, IndexError, OverflowError)
"""What data of another kind leads to."""


@dataclass(frozen=True, slots=True)
class Scan:
    """An input as the session knows it.

    Attributes
    ----------
    name : str
    sha256 : str
        Empty where unknown.
    places : tuple of Path
        Where it may lie: where it was, and beside the session.
    """

    name: str
    sha256: str
    places: tuple[Path, ...]


@dataclass(frozen=True, slots=True)
class Saved:
    """What a session says; the document's paths are where its scans were."""

    document: Document
    state: ViewState
    scans: tuple[Scan | None, Scan | None]
    camera: Eye | None = None


def to_text(
    document: Document,
    state: ViewState,
    hashes: tuple[str, str],
    folder: Path,
    camera: Eye | None = None,
) -> str:
    """Return the session as JSON.

    Parameters
    ----------
    hashes : (str, str)
        SHA-256 of the inputs, to notice when a file has changed; empty where unknown.
    folder : Path
        Where the session will lie: inputs are also named relative to it.
    camera : Eye or None
        Where it was looked from.
    """
    inputs = [
        None
        if path is None
        else {"file": str(path), "beside": _beside(path, folder), "sha256": sha}
        for path, sha in zip(document.paths, hashes, strict=True)
    ]
    options = document.options
    return json.dumps(
        {
            "kind": KIND,
            "version": VERSION,
            "inputs": inputs,
            "options": {name: getattr(options, name) for name in _NUMBERS},
            "motion": asdict(document.motion),
            "unit": options.unit or "",
            "project": options.project,
            "regions": [asdict(region) for region in document.regions],
            "view": asdict(state.saved),
            "camera": camera,
        },
        indent=1,
    )


def from_text(text: str, folder: Path, name: str) -> Saved:
    """Return what the session called `name`, in `folder`, says.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    try:
        data = json.loads(text)
        if data["kind"] != KIND:
            raise ValueError("of another kind")
        if data["version"] not in range(1, VERSION + 1):
            raise ValueError("of a later version of the program")
        one, two = (_scan(given, folder) for given in data["inputs"])
        document = Document(
            paths=(one.places[0] if one else None, two.places[0] if two else None),
            options=replace(
                read(Options, data["options"]),
                align=_motion(data["motion"]),
                unit=str(data["unit"]) or None,
                project=str(data["project"]),
            ),
            regions=tuple(_region(region) for region in data["regions"]),
        )
        state = read(ViewState, data["view"])
        return Saved(document, state, (one, two), _eye(data.get("camera")))
    except FAULTS as error:
        raise InputError(f"not a session of this program ({error})", where=(name,)) from error


def regions_text(regions: tuple[Region, ...]) -> str:
    """Return regions as JSON."""
    return json.dumps([asdict(region) for region in regions], indent=1)


def regions_from(text: str, name: str) -> tuple[Region, ...]:
    """Return the regions of a file.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    try:
        return tuple(_region(region) for region in json.loads(text))
    except FAULTS as error:
        raise InputError(f"no regions ({error})", where=(name,)) from error


def write(path: Path, text: str) -> None:
    """Write a file completely or not at all.

    Raises
    ------
    OutputError
        It cannot be written.
    """
    write_all({path: lambda stream: _put(text, stream)})


def _put(text: str, stream: BinaryIO) -> None:
    stream.write(text.encode())


def _motion(data: dict[str, Any]) -> Motion:
    motion: Motion = read(Motion, data)
    if motion.fit:
        rest = dict(motion.fit)
        words = (*rest.pop("free"), *rest.pop("doubts"))
        marks = [(mark["name"], mark["residual"]) for mark in rest.pop("landmarks")]
        words += tuple(name for name, _ in marks)
        numbers = [*rest.values(), *(residual for _, residual in marks)]
        right = all(isinstance(word, str) for word in words)
        right &= all(isinstance(number, float | int) for number in numbers)
        if not right or set(motion.fit) != FIT_KEYS:
            raise ValueError("the account of a fit is not one")
    return motion


def _region(data: dict[str, Any]) -> Region:
    first = {"polygons", "discs"}  # of version 1
    strokes = [*data.get("strokes", ())]
    strokes += [{"path": path} for path in data.get("polygons", ())]
    strokes += [{"path": [(x, y)], "radius": radius} for x, y, radius in data.get("discs", ())]
    rest = {name: part for name, part in data.items() if name not in first}
    region: Region = read(Region, rest | {"strokes": strokes})
    if not all(stroke.path and stroke.radius >= 0 for stroke in region.strokes):
        raise ValueError("a stroke without places")
    return region


def _eye(given: Any) -> Eye | None:
    eye: Eye | None = read(Eye | None, given)
    if eye is not None and not eye[3][0] > 0:
        raise ValueError("a camera of another kind")
    return eye


def _scan(given: dict[str, str] | None, folder: Path) -> Scan | None:
    if given is None:
        return None
    path, beside = Path(given["file"]), (folder / given["beside"]).resolve()
    places = (path,) if beside == path else (path, beside)
    name = given["file"].replace("\\", "/").rsplit("/", 1)[-1]
    return Scan(name, given["sha256"], places)


def _beside(path: Path, folder: Path) -> str:
    try:
        return os.path.relpath(path, folder)
    except ValueError:  # on another drive
        return path.name
