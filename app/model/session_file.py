"""A session as a file: the document, and how it was looked at."""

import json
import os
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from app.model.document import Document, Motion
from app.model.region import Region
from app.model.view_state import Heatmap, Place, Scale, ViewState
from surfcmp_core.comparison import Options
from surfcmp_core.errors import InputError

KIND = "surfcmp session"
VERSION = 1
ENDING = ".surfcmp"


def to_text(document: Document, state: ViewState, hashes: tuple[str, str], folder: Path) -> str:
    """Return the session as JSON.

    Parameters
    ----------
    hashes : (str, str)
        SHA-256 of the inputs, to notice when a file has changed; empty where unknown.
    folder : Path
        Where the session will lie: inputs are also named relative to it.
    """
    inputs = [
        None
        if path is None
        else {"file": str(path), "beside": os.path.relpath(path, folder), "sha256": sha}
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
        },
        indent=1,
    )


def from_text(text: str, folder: Path, name: str) -> tuple[Document, ViewState, tuple[str, str]]:
    """Return the document, the view state and the inputs' hashes of a session.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    try:
        data = json.loads(text)
        if data["kind"] != KIND or data["version"] != VERSION:
            raise ValueError("of another kind or version")
        document = Document(
            paths=tuple(_path(given, folder) for given in data["inputs"]),  # type: ignore[arg-type]
            options=Options(**_tuples(data["options"])),
            motion=Motion(**_tuples(data["motion"])),
            unit=str(data["unit"]),
            project=str(data["project"]),
            regions=tuple(Region(**_tuples(region)) for region in data["regions"]),
        )
        hashes = tuple("" if given is None else given["sha256"] for given in data["inputs"])
        state = _state(data["view"])
        one, two = hashes
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"{name}: not a session of this program ({error})") from error
    return document, state, (one, two)


def regions_from(text: str, name: str) -> tuple[Region, ...]:
    """Return the regions of a file.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    try:
        return tuple(Region(**_tuples(region)) for region in json.loads(text))
    except (ValueError, TypeError) as error:
        raise InputError(f"{name}: no regions ({error})") from error


def write(path: Path, text: str) -> None:
    """Write a file completely or not at all."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        temporary.write_text(text, encoding="utf-8")
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def _state(data: dict[str, Any]) -> ViewState:
    fields = _tuples(data)
    places = [Place(**place) for place in fields["probes"]]
    picked = fields["picked"]
    return replace(
        ViewState(**fields),
        heatmap=Heatmap(fields["heatmap"]),
        scale=Scale(**fields["scale"]),
        picked=None if picked is None else Place(**picked),
        probes=tuple(places),
    )


def _path(given: dict[str, str] | None, folder: Path) -> Path | None:
    """Return where an input lies: where it was, else beside the session."""
    if given is None:
        return None
    path, beside = Path(given["file"]), (folder / given["beside"]).resolve()
    return beside if beside.is_file() and not path.is_file() else path


def _tuples(value: Any) -> Any:
    """Return JSON's lists as tuples, all the way down."""
    if isinstance(value, list):
        return tuple(_tuples(inner) for inner in value)
    if isinstance(value, dict):
        return {key: _tuples(inner) for key, inner in value.items()}
    return value
