"""Sessions as files, written and opened beside the window.

A session is a text (`app.model.session_text`), or a ZIP archive of that text and of the scans.
"""

import hashlib
import shutil
import zipfile
import zlib
from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import mkdtemp
from typing import IO, BinaryIO, Literal

from PySide6.QtCore import QCoreApplication

from app.model.document import Document
from app.model.session_text import Eye, Saved, Scan, from_text, to_text
from app.model.view_state import ViewState
from surfcmp_core.errors import InputError
from surfcmp_core.system.progress import Progress
from surfcmp_core.system.whole_files import write_all

translate = QCoreApplication.translate

TEXT = "session.json"
PIECE = 1 << 22
MOST_TEXT = 1 << 28
"""No session's text is longer, in bytes."""
DAMAGES = (zipfile.BadZipFile, zlib.error, EOFError, KeyError, NotImplementedError, RuntimeError)

Located = Mapping[int, tuple[Path, bool]]
"""Number of a surface (1 or 2) to the file the user chose, and whether any content will do."""


@dataclass(frozen=True, slots=True)
class Fault:
    """Why a session cannot be opened as it was saved."""

    number: int
    name: str
    kind: Literal["missing", "changed", "another"]
    """Another: the file that the user chose is not the one the session was saved with."""
    path: Path | None = None


@dataclass(frozen=True, slots=True)
class Opened:
    """A session that was found whole (`fault` None), or what is amiss."""

    path: Path
    document: Document
    state: ViewState
    fault: Fault | None = None
    embedded: bool = False
    """Whether the session holds its scans."""
    camera: Eye | None = None


def save_session(
    path: Path,
    document: Document,
    state: ViewState,
    hashes: tuple[str, str],
    camera: Eye | None,
    embed: bool,
    progress: Progress,
) -> Path:
    """Write a session, completely or not at all.

    Parameters
    ----------
    hashes : (str, str)
        SHA-256 of the scans as they were compared; empty where they were not read yet.
    embed : bool
        Put the scans into the file.

    Raises
    ------
    InputError
        A scan cannot be read, or is no longer the one that was compared.
    OutputError
        The file cannot be written; it is untouched then.
    """
    found = [
        "" if scan is None else sha or _sha256(scan, progress)
        for scan, sha in zip(document.paths, hashes, strict=True)
    ]
    text = to_text(document, state, (found[0], found[1]), path.parent.absolute(), camera)

    def write(stream: BinaryIO) -> None:
        if embed:
            _write_archive(stream, text, document, found, progress)
        else:
            stream.write(text.encode())

    write_all({path: write})
    return path


def open_session(path: Path, scans: Path, located: Located, progress: Progress) -> Opened:
    """Read a session and find its scans, each with the content it was saved with.

    A scan is looked for where it was, beside the session, and in it; one that the session holds
    is unpacked into a new folder in `scans`.

    Raises
    ------
    InputError
        One line that names the file and the fault.
    """
    try:
        with path.open("rb") as stream:
            if zipfile.is_zipfile(stream):
                with closing(zipfile.ZipFile(stream)) as archive:
                    return _open(path, archive, scans, located, progress)
            return _open(path, None, scans, located, progress)
    except OSError as error:
        raise _unreadable(path, error) from error
    except DAMAGES as error:
        raise InputError(
            translate("Sessions", "the session is damaged"), where=(path.name,)
        ) from error


def _open(
    path: Path, archive: zipfile.ZipFile | None, scans: Path, located: Located, progress: Progress
) -> Opened:
    saved = _saved(path, archive)
    paths: list[Path | None] = list(saved.document.paths)
    for number, scan in enumerate(saved.scans, 1):
        if scan is None:
            continue
        if number in located:
            chosen, any_content = located[number]
            good = any_content or not scan.sha256 or _sha256(chosen, progress) == scan.sha256
            found: Path | Fault = chosen if good else Fault(number, scan.name, "another", chosen)
        else:
            found = _find(number, scan, archive, scans, progress)
        if isinstance(found, Fault):
            return Opened(path, saved.document, saved.state, found)
        paths[number - 1] = found
    document = replace(saved.document, paths=(paths[0], paths[1]))
    return Opened(path, document, saved.state, embedded=archive is not None, camera=saved.camera)


def _saved(path: Path, archive: zipfile.ZipFile | None) -> Saved:
    if archive is None:
        data = path.read_bytes()
    elif archive.getinfo(TEXT).file_size > MOST_TEXT:
        raise zipfile.BadZipFile
    else:
        data = archive.read(TEXT)
    try:
        text = data.decode()
    except UnicodeDecodeError as error:
        raise InputError(
            translate("Sessions", "not a session of this program"), where=(path.name,)
        ) from error
    return from_text(text, path.parent.absolute(), path.name)


def _find(
    number: int, scan: Scan, archive: zipfile.ZipFile | None, scans: Path, progress: Progress
) -> Path | Fault:
    """Return where a scan lies; what is there but has changed is not taken."""
    there = [place for place in scan.places if place.is_file()]
    for place in there:
        if not scan.sha256 or _sha256(place, progress) == scan.sha256:
            return place
    if archive is not None and _entry(number) in archive.namelist():
        return _unpack(number, scan, archive, scans, progress)
    return Fault(number, scan.name, "changed" if there else "missing", there[0] if there else None)


def _entry(number: int) -> str:
    return f"scans/{number}"


def _write_archive(
    stream: BinaryIO, text: str, document: Document, hashes: list[str], progress: Progress
) -> None:
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        archive.writestr(TEXT, text)
        for number, (scan, sha) in enumerate(zip(document.paths, hashes, strict=True), 1):
            if scan is None:
                continue
            try:
                source = scan.open("rb")
            except FileNotFoundError as error:
                raise InputError(
                    translate("Sessions", "is not there any longer"), where=(scan.name,)
                ) from error
            except OSError as error:
                raise _unreadable(scan, error) from error
            with source, archive.open(_entry(number), "w") as target:
                now = _copy(source, target, progress)
            if now != sha:
                raise InputError(
                    translate("Sessions", "has changed since it was read; open it again"),
                    where=(scan.name,),
                )


def _unpack(
    number: int, scan: Scan, archive: zipfile.ZipFile, scans: Path, progress: Progress
) -> Path:
    scans.mkdir(parents=True, exist_ok=True)
    folder = Path(mkdtemp(dir=scans))
    target = folder / (scan.name if Path(scan.name).name == scan.name else f"scan {number}")
    with archive.open(_entry(number)) as source, target.open("wb") as stream:
        found = _copy(source, stream, progress)
    if scan.sha256 and found != scan.sha256:
        shutil.rmtree(folder, ignore_errors=True)
        raise zipfile.BadZipFile
    return target


def _copy(source: IO[bytes], target: IO[bytes], progress: Progress) -> str:
    """Copy and return the SHA-256 of what was copied."""
    digest = hashlib.sha256()
    while piece := source.read(PIECE):
        progress("keep", 0.0)
        digest.update(piece)
        target.write(piece)
    return digest.hexdigest()


def _sha256(path: Path, progress: Progress) -> str:
    digest = hashlib.sha256()
    try:
        with path.open("rb") as stream:
            while piece := stream.read(PIECE):
                progress("keep", 0.0)
                digest.update(piece)
    except OSError as error:
        raise _unreadable(path, error) from error
    return digest.hexdigest()


def _unreadable(path: Path, error: OSError) -> InputError:
    text = translate("Sessions", "cannot be read ({})")
    return InputError(text.format(error.strerror or error), where=(path.name,))
