"""The results made for programs: .json, .npz, .csv."""

import json
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from surfcmp_core.comparing.comparison import Comparison
from surfcmp_core.report.meanings import REASONS
from surfcmp_core.report.record import Record
from surfcmp_core.report.rows import rows_of


def json_bytes(document: Record) -> bytes:
    """Write a document as strict JSON, UTF-8, ending in a line feed."""
    return json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False).encode() + b"\n"


def write_json(_comparison: Comparison, document: Record, stream: BinaryIO) -> None:
    """Write the .json result."""
    stream.write(json_bytes(document))


def write_npz(comparison: Comparison, _document: Record, stream: BinaryIO) -> None:
    """Write the .npz result: every array of the comparison, unrounded."""
    united = comparison.united
    np.savez(
        stream,
        nodes=united.nodes.astype(np.float64, copy=False),
        label=united.label.astype(np.uint8, copy=False),
        z1=comparison.z1.astype(np.float64, copy=False),
        z2=comparison.z2.astype(np.float64, copy=False),
        triangles=united.triangles.astype(np.int32, copy=False),
        origin=united.origin.astype(np.uint8, copy=False),
        chain=united.chain.astype(np.int32, copy=False),
        chain_closed=united.chain_closed.astype(np.bool_, copy=False),
        compared=comparison.compared,
        area=comparison.area.astype(np.float64, copy=False),
        mean_abs=comparison.mean_abs.astype(np.float64, copy=False),
        mean_signed=comparison.mean_signed.astype(np.float64, copy=False),
        tree1=united.tree1.astype(np.int32, copy=False),
        tree2=united.tree2.astype(np.int32, copy=False),
        **exact_columns(comparison),
    )


def exact_columns(comparison: Comparison) -> dict[str, Any]:
    """Give the values of each triangle by the exact reading, where that was asked for."""
    if comparison.mean_abs_exact is None or comparison.mean_signed_exact is None:
        return {}
    return {
        "mean_abs_exact": comparison.mean_abs_exact,
        "mean_signed_exact": comparison.mean_signed_exact,
    }


def write_csv(comparison: Comparison, _document: Record, stream: BinaryIO) -> None:
    """Write the .csv result: a row for each triangle, empty where there is no value.

    x, y is the centroid; `compared` is 1 or 0 and `reason` says why it is 0.
    """
    united = comparison.united
    centroid = united.nodes[united.triangles].mean(axis=1)
    reals: dict[str, NDArray[np.float64]] = {
        "x": centroid[:, 0],
        "y": centroid[:, 1],
        "area": comparison.area,
        "mean_abs": comparison.mean_abs,
        "mean_signed": comparison.mean_signed,
        **exact_columns(comparison),
    }
    integers: dict[str, NDArray[Any]] = {
        "origin": united.origin,
        "chain": united.chain,
        "compared": comparison.compared,
    }
    stream.write(",".join([*reals, *integers, "reason"]).encode() + b"\n")
    for rows in rows_of([*reals.values()], [*integers.values()], comparison.reason, REASONS):
        stream.write(rows)
