"""Contents on which a careless loop or pattern takes minutes."""

from collections.abc import Iterator

import numpy as np

from tests.core import surface_files as files
from tests.program.sound_files import FACES, POINTS, Made


def long_files() -> Iterator[tuple[str, str, Made]]:
    """Contents on which a careless loop or pattern takes minutes."""
    many = 100_000
    for ending in ("xyz", "csv", "txt", "obj", "off", "ply", "stl", "vtk"):
        yield f"{ending}, a million blank lines", ending, lambda: b"\n" * 1_000_000
        yield f"{ending}, a line of a million numbers", ending, lambda: b"1 " * 1_000_000
        yield f"{ending}, a number of a million digits", ending, lambda: b"1" * 1_000_000
        yield f"{ending}, a million commas", ending, lambda: b"," * 1_000_000
        yield f"{ending}, a million quotes", ending, lambda: b'"' * 999_999 + b",1,2\n1,2,3\n"
        yield f"{ending}, a million semicolons", ending, lambda: b"1;2;3\n" + b";" * 1_000_000
    comments = {
        "blanks": "unit" + " " * many,
        "units": "unit " * many,
        "is in": "unit is in " * many,
        "mm": "unit mm? " * many,
        "dashes": "units" + "-" * many + "x",
        "1 unit =": "1 unit = " * many,
        "space": "SPACE=" * many,
    }
    ply, obj, off = (write(POINTS, FACES) for write in (files.ply_text, files.obj, files.off))
    for what, comment in comments.items():
        line = comment.encode()
        yield (
            f"ply, comment of {what}",
            "ply",
            lambda line=line: ply.replace(
                b"element vertex", b"comment " + line + b"\nelement vertex"
            ),
        )
        for ending, rest in (("obj", obj), ("off", off), ("xyz", files.xyz(POINTS))):
            yield (
                f"{ending}, comment of {what}",
                ending,
                lambda line=line, rest=rest: b"# " + line + b"\n" + rest,
            )
        yield (
            f"stl, name of {what}",
            "stl",
            lambda line=line: files.stl_text(POINTS, FACES).replace(b"test", line, 1),
        )
        yield (
            f"vtk, title of {what}",
            "vtk",
            lambda comment=comment: files.vtk_text(POINTS, FACES, comment),
        )
        yield (
            f"npz, unit of {what}",
            "npz",
            lambda comment=comment: files.npz(POINTS, FACES, unit=np.array(comment)),
        )
    yield (
        "npz, deep JSON",
        "npz",
        lambda: files.npz(POINTS, FACES, meta=np.array("[" * many + "]" * many)),
    )
    yield "many comments", "obj", lambda: b"# unit of nothing\n" * many + obj
    header = "ply\nformat {} 1.0\nelement vertex {}\n{}end_header\n"
    props = "".join(f"property float p{k}\n" for k in range(20_000))
    yield "ply, many properties", "ply", lambda: header.format("ascii", 3, props).encode()
    yield (
        "ply binary, many properties",
        "ply",
        lambda: header.format("binary_little_endian", 3, props).encode() + bytes(240_000),
    )
    elements = "".join(f"element e{k} 0\nproperty float p\n" for k in range(20_000))
    yield "ply, many elements", "ply", lambda: header.format("ascii", 0, elements).encode()
    yield "ply, lists of nothing", "ply", lambda: _ply_lists(500_000)
    yield "ply, no end of the header", "ply", lambda: b"ply\n" + (b" " * 99 + b"\n") * 20_000
    one = b"FIELD f 20000\n" + b"a 1 1 int\n1\n" * 20_000
    vtk = files.vtk_text(POINTS, FACES)
    yield "vtk, many fields", "vtk", lambda: vtk.replace(b"POINTS", one + b"POINTS")
    yield (
        "vtk, many declared fields",
        "vtk",
        lambda: vtk.replace(b"POINTS", b"FIELD f 999999999999\na 0 0 int\nPOINTS"),
    )
    yield (
        "vtk, strings without end",
        "vtk",
        lambda: vtk.replace(
            b"POINTS", b"FIELD f 1\na 1 1000000 string\n" + b"\n" * 500_000 + b"POINTS"
        ),
    )
    yield (
        "obj, polygons of all sizes",
        "obj",
        lambda: obj + b"".join(b"f " + b"1 " * k + b"\n" for k in range(1, 1500)),
    )
    yield "obj, lines continued", "obj", lambda: obj + b"f 1 2 \\\n" * many + b" 3\n"
    tangle = " ".join(map(str, np.random.default_rng(1).integers(1, 145, 9000).tolist()))
    for count in (1, 50):
        yield (
            f"obj, {count} tangled polygons",
            "obj",
            lambda count=count: obj + f"f {tangle}\n".encode() * count,
        )
    strip = b"f " + b" ".join(b"%d" % (1 + k % 144) for k in range(300_000)) + b"\n"
    yield "obj, a polygon of 300 000 corners", "obj", lambda: obj + strip


def _ply_lists(count: int) -> bytes:
    head = files.ply_header("binary_little_endian", 3, count).replace(
        b"end_header", b"property list uchar uchar more\nend_header"
    )
    return head + np.eye(3).tobytes() + b"\1" + bytes(5) + bytes(2 * count - 2)
