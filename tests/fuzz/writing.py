"""The files of a trial, in as many manners as programs have."""

from pathlib import Path

import numpy as np

from tests.core import surface_files
from tests.fuzz.trials import Model

ENDINGS = {"ply binary": "ply", "vtk binary": "vtk", "vtp base64": "vtp"}


def write(model: Model, folder: Path, name: str) -> Path:
    """Write a model's file; its coordinates are there to the last bit."""
    path = folder / f"{name}.{ENDINGS.get(model.form, model.form)}"
    path.write_bytes(_bytes(model))
    return path


def _bytes(model: Model) -> bytes:
    points = np.array(model.points, np.float64)
    if model.form in ("xyz", "txt", "csv"):
        return _text(model)
    if model.form == "npy":
        return surface_files.npy(points)
    if model.form in ("ply", "obj", "off"):
        return _polygon_text(model)
    faces = np.array(model.polygons or np.empty((0, 3)), np.int32)
    writers = {
        "ply binary": surface_files.ply_binary,
        "vtk": surface_files.vtk_text,
        "vtk binary": surface_files.vtk_binary,
        "vtp": surface_files.vtp_text,
        "vtp base64": surface_files.vtp_base64,
        "npz": surface_files.npz,
    }
    return writers[model.form](points, faces)


def _text(model: Model) -> bytes:
    style = model.style
    separator = "," if model.form == "csv" else style["separator"]
    words = style["heading"].replace("# ", "#").split()
    if "[mm]" in words:
        words = ["x [mm]", "y [mm]", "z [mm]"]
        separator = "," if separator in (" ", "\t") else separator
    lines = [separator.join(words)] if words else []
    lines += [separator.join(map(_number(model), row)) for row in model.points]
    return "".join(line + style["end"] for line in lines).encode()


def _polygon_text(model: Model) -> bytes:
    number, end = _number(model), model.style["end"]
    polygons = model.polygons or []
    comment = model.style["comment"]
    rows = [" ".join(map(number, row)) for row in model.points]
    faces = [[len(one), *one] for one in polygons]
    if model.form == "obj":
        lines = [f"# {comment}", *(f"v {row}" for row in rows)]
        lines += ["f " + " ".join(str(v + 1) for v in one) for one in polygons]
    elif model.form == "off":
        lines = ["OFF", f"# {comment}", f"{len(rows)} {len(polygons)} 0", *rows]
        lines += [" ".join(map(str, one)) for one in faces]
    else:
        lines = ["ply", "format ascii 1.0", f"comment {comment}", f"element vertex {len(rows)}"]
        lines += [f"property double {axis}" for axis in "xyz"]
        lines += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
        lines += ["end_header", *rows, *(" ".join(map(str, one)) for one in faces)]
    return "".join(line + end for line in lines).encode()


def _number(model: Model):  # type: ignore[no-untyped-def]
    """Shortest decimals, or seventeen digits: the same number."""
    return (lambda x: f"{x:.17e}") if model.style["long"] else repr
