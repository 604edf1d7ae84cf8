"""A session as text: the document, how it was looked at, and which scans it is about."""

import json
import os
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, BinaryIO

from app.model.document import FIT_KEYS, Document, Motion
from app.model.landmark import Pair
from app.model.region import Region, Stroke
from app.model.view_state import Heatmap, Place, Scale, ViewState
from surfcmp_core.comparing.comparison import Options
from surfcmp_core.errors import InputError
from surfcmp_core.system.whole_files import write_all

KIND = "surfcmp session"
VERSION = 2
"""1 had regions without an order of their strokes, and never held scans."""
ENDING = ".surfcmp"


Eye = tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...], tuple[float]]
"""Of a camera: x, y, z of its focus, of the way back to the eye, of upwards; its height."""


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
    return json.dumps(
        {
            "kind": KIND,
            "version": VERSION,
            "inputs": inputs,
            "options": asdict(document.options),
            "motion": asdict(document.motion),
            "unit": document.unit,
            "project": document.project,
            "regions": [asdict(region) for region in document.regions],
            "view": {**asdict(state), "filled": None},
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
            options=Options(**_tuples(data["options"])),
            motion=_motion(data["motion"]),
            unit=str(data["unit"]),
            project=str(data["project"]),
            regions=tuple(_region(region) for region in data["regions"]),
        )
        return Saved(document, _state(data["view"]), (one, two), _eye(data.get("camera")))
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise InputError(f"{name}: not a session of this program ({error})") from error


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
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise InputError(f"{name}: no regions ({error})") from error


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
    motion = Motion(**_tuples(data))
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
    fields = _tuples(data)
    strokes = [Stroke(**stroke) for stroke in fields.pop("strokes", ())]
    strokes += [Stroke(path) for path in fields.pop("polygons", ())]  # version 1
    strokes += [Stroke(((x, y),), radius) for x, y, radius in fields.pop("discs", ())]
    for stroke in strokes:
        numbers = [float(number) for place in stroke.path for number in place]
        if not numbers or len(numbers) != 2 * len(stroke.path) or not stroke.radius >= 0:
            raise ValueError("a stroke without places")
    red, green, blue = fields["colour"]
    colour = int(red), int(green), int(blue)
    return Region(str(fields["name"]), colour, float(fields["weight"]), tuple(strokes))


def _state(data: dict[str, Any]) -> ViewState:
    fields = _tuples(data)
    picked = fields["picked"]
    return replace(
        ViewState(**fields),
        heatmap=Heatmap(fields["heatmap"]),
        scale=Scale(**fields["scale"]),
        picked=None if picked is None else Place(**picked),
        probes=tuple(Place(**place) for place in fields["probes"]),
        landmarks=tuple(Pair(**pair) for pair in fields.get("landmarks", ())),
    )


def _eye(given: Any) -> Eye | None:
    if given is None:
        return None
    focus, back, up, (height,) = (tuple(float(x) for x in part) for part in given)
    if not (len(focus) == len(back) == len(up) == 3 and height > 0):
        raise ValueError("a camera of another kind")
    return focus, back, up, (height,)


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


def _tuples(value: Any) -> Any:
    """Return JSON's lists as tuples, all the way down."""
    if isinstance(value, list):
        return tuple(_tuples(inner) for inner in value)
    if isinstance(value, dict):
        return {key: _tuples(inner) for key, inner in value.items()}
    return value
