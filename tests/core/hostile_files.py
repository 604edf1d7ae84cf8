"""Files made to break readers: cut off, lying, damaged, packed to fill the memory, or armed."""

import io
import pickle
import re
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from surfcmp_core.io.read import READERS
from tests.core import surface_files as files

Made = Callable[[], bytes]
"""Content of a file, made when it is asked for: some take a while."""

ENDINGS = [ending for ending in READERS if ending != ".txt"]

_N = 12
_X, _Y = np.meshgrid(np.arange(_N, dtype=float), np.arange(_N, dtype=float))
POINTS = np.column_stack((_X.ravel(), _Y.ravel(), (_X * _Y).ravel() / 64))
_A = (np.arange(_N - 1)[:, None] * _N + np.arange(_N - 1)).ravel()
FACES = np.concatenate(
    (np.column_stack((_A, _A + 1, _A + _N + 1)), np.column_stack((_A, _A + _N + 1, _A + _N)))
).astype(np.int32)

WRITERS: dict[str, tuple[str, Callable[..., bytes]]] = {
    "ply text": ("ply", files.ply_text),
    "ply binary": ("ply", files.ply_binary),
    "ply big-endian": ("ply", lambda p, f: files.ply_binary(p, f, order=">")),
    "obj": ("obj", files.obj),
    "off": ("off", files.off),
    "stl text": ("stl", files.stl_text),
    "stl binary": ("stl", files.stl_binary),
    "vtk text": ("vtk", files.vtk_text),
    "vtk binary": ("vtk", files.vtk_binary),
    "vtp text": ("vtp", files.vtp_text),
    "vtp base64": ("vtp", files.vtp_base64),
    "vtp compressed": ("vtp", files.vtp_compressed),
    "vtp appended": ("vtp", files.vtp_appended),
    "xyz": ("xyz", files.xyz),
    "csv": ("csv", files.csv),
    "npy": ("npy", files.npy),
    "npz": ("npz", files.npz),
    "las": ("las", files.las),
    "laz": ("laz", lambda p, f: files.las(p, f, compressed=True)),
}
TEXTS = ("ply text", "obj", "off", "stl text", "vtk text", "vtp text", "xyz", "csv")


def hostile(marker: Path) -> Iterator[tuple[str, str, Made]]:
    """Name, ending and content of each file.

    Parameters
    ----------
    marker : Path
        A file that appears where code in a file is run.
    """
    sound = {name: (ending, write(POINTS, FACES)) for name, (ending, write) in WRITERS.items()}
    for name, (ending, content) in sound.items():
        for what, made in (*_cut(content), *_damaged(content)):
            yield f"{name}, {what}", ending, made
        if name in TEXTS:
            for what, made in _respelt(content):
                yield f"{name}, {what}", ending, made
        for what, made in _lying(content):
            yield f"{name}, {what}", ending, made
        for other in ENDINGS:
            if other != f".{ending}":
                yield f"{name} as {other}", other[1:], lambda content=content: content
    yield from _values()
    yield from _indices()
    yield from _bombs()
    yield from _armed(marker)
    yield from _long()


def _cut(content: bytes) -> Iterator[tuple[str, Made]]:
    yield "empty", lambda: b""
    yield "one byte", lambda: content[:1]
    for tenth in range(1, 10):
        yield f"cut at {tenth}0 %", lambda tenth=tenth: content[: len(content) * tenth // 10]
    yield "but its end", lambda: content[:-1]


def _damaged(content: bytes) -> Iterator[tuple[str, Made]]:
    noise = np.random.default_rng(1).bytes(len(content))
    yield "twice", lambda: content * 2
    yield "zeros behind", lambda: content + bytes(1000)
    yield "noise behind", lambda: content + noise[:1000]
    yield "noise in the middle", lambda: content[: len(content) // 3] + noise[len(content) // 3 :]
    yield "all noise", lambda: noise
    yield "all zeros", lambda: bytes(len(content))
    yield "all ones", lambda: b"\xff" * len(content)
    yield "back to front", lambda: content[::-1]
    yield "shifted", lambda: b"\0" + content
    for at in range(5):
        flipped = bytearray(content)
        for k in np.random.default_rng(at).integers(0, len(content), 9).tolist():
            flipped[k] ^= 1 << (k & 7)
        yield f"bits flipped {at}", lambda flipped=flipped: bytes(flipped)


def _respelt(content: bytes) -> Iterator[tuple[str, Made]]:
    text = content.decode()
    yield "CRLF", lambda: content.replace(b"\n", b"\r\n")
    yield "CR", lambda: content.replace(b"\n", b"\r")
    yield "UTF-8 with a mark", lambda: b"\xef\xbb\xbf" + content
    for code in ("utf-16", "utf-16-le", "utf-16-be", "utf-32", "cp037"):
        yield code, lambda code=code: text.encode(code)
    yield "one line", lambda: content.replace(b"\n", b" ")
    yield "no blanks", lambda: content.replace(b" ", b"")
    yield "odd digits", lambda: text.translate({0x31: "\uff11", 0x32: "\u0662"}).encode()
    yield "commas for points", lambda: content.replace(b".", b",")
    yield "escapes", lambda: content.replace(b"0.0", b"\x1b[2J\x07\x00", 3)
    for value in (
        b"nan",
        b"inf",
        b"-inf",
        b"1e999",
        b"0x10",
        b"1_0",
        b"--1",
        b"9" * 5000,
        b"1e",
        b"\0",
    ):
        yield f"a {value[:9]!r}", lambda value=value: content.replace(b"0.0", value, 2)


_COUNT = re.compile(rb"(?<=[ \"(])(144|242|968|726)(?=[ \",])")


def _lying(content: bytes) -> Iterator[tuple[str, Made]]:
    """Each count in turn is another."""
    for k, found in enumerate(list(_COUNT.finditer(content))[:4]):
        start, end = found.span()
        for count in (b"0", b"1", b"143", b"100000", b"1000000000000", b"-144", b"9" * 30, b"1e12"):
            yield (
                f"count {k} as {count[:15].decode()}",
                lambda start=start, end=end, count=count: content[:start] + count + content[end:],
            )
    for number in (144, 242):
        for width in ("<I", "<Q", ">I"):
            packed = struct.pack(width, number)
            if (at := content.find(packed)) >= 0:
                for lie in (0, 1, 2**31, 2 ** (8 * len(packed)) - 1):
                    told = struct.pack(width, lie)
                    yield (
                        f"{width} {number} as {lie}",
                        lambda at=at, told=told: content[:at] + told + content[at + len(told) :],
                    )


_ODD = (np.nan, np.inf, -np.inf, 1.7e308, 1e300, 1e-300, 5e-324, -0.0, 2.0**53)


def _values() -> Iterator[tuple[str, str, Made]]:
    """Coordinates of any float, at one node and at all."""
    for name, (ending, write) in WRITERS.items():
        if ending in ("las", "laz"):
            continue
        for value in _ODD:
            one, every = POINTS.copy(), POINTS.copy()
            one[7, 1] = value
            every[:, 2] = value
            for where, points in (("one", one), ("every", every)):
                yield (
                    f"{name}, {where} node {value}",
                    ending,
                    lambda points=points, write=write: _quietly(write, points, FACES),
                )


def _quietly(write: Callable[..., bytes], *arrays: object) -> bytes:
    with np.errstate(all="ignore"):
        return write(*arrays)


def _indices() -> Iterator[tuple[str, str, Made]]:
    for name, (ending, write) in WRITERS.items():
        if ending in ("las", "laz", "xyz", "csv", "npy", "stl"):
            continue
        for odd in (-1, -144, 144, 2**31 - 1, -(2**31)):
            faces = FACES.copy()
            faces[100, 1] = odd
            yield (
                f"{name}, corner {odd}",
                ending,
                lambda faces=faces, write=write: write(POINTS, faces),
            )
    ply, obj, off = (write(POINTS, FACES) for write in (files.ply_text, files.obj, files.off))
    for corners in (
        "0",
        "1 0",
        "2 0 1",
        "4 0 1 13 12",
        "3 0 1 1099511627776",
        "-3 0 1 2",
        "9 0 1 2",
    ):
        row = corners.encode()
        yield f"ply, {corners}", "ply", lambda row=row: ply.replace(b"3 0 1 13", row, 1)
        yield f"off, {corners}", "off", lambda row=row: off.replace(b"3 0 1 13", row, 1)
    for corners in ("f", "f 1", "f 1 2", "f 0 1 2", "f -999 1 2", "f 1 2 1099511627776", "f a b c"):
        yield (
            f"obj, {corners}",
            "obj",
            lambda row=corners: obj.replace(b"f 1 2 14", row.encode(), 1),
        )
    big = files.npz(POINTS, FACES.astype(np.int64) + (1 << 40))
    yield "npz, corners at 2**40", "npz", lambda: big


GIGABYTE = 1 << 30
_CHUNK = 1 << 20


def _zeros(count: int, wbits: int) -> bytes:
    """So many zeros, packed by a thousand, without packing them all."""
    packer = zlib.compressobj(9, wbits=wbits)
    first = packer.compress(bytes(_CHUNK)) + packer.flush(zlib.Z_FULL_FLUSH)
    again = packer.compress(bytes(_CHUNK)) + packer.flush(zlib.Z_FULL_FLUSH)
    return first + again * (count // _CHUNK - 1) + packer.flush()


def _npz_bomb(count: int) -> bytes:
    """Zeros packed as `points`; the checksum, which comes last, is wrong."""
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        head, {"descr": "<f8", "fortran_order": False, "shape": (count // 24, 3)}
    )
    body = zlib.compressobj(0, wbits=-15)
    start = body.compress(head.getvalue()) + body.flush(zlib.Z_FULL_FLUSH)
    packed = start + _zeros(count, -15)
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("points.npy", packed)
    content = bytearray(stream.getvalue())
    size = len(head.getvalue()) + count
    for signature, method, sizes in ((b"PK\3\4", 8, 18), (b"PK\1\2", 10, 20)):
        at = content.rindex(signature)
        struct.pack_into("<H", content, at + method, zipfile.ZIP_DEFLATED)
        struct.pack_into("<II", content, at + sizes, len(packed), size)
    return bytes(content)


def _vtp_bomb(count: int, whole: int) -> bytes:
    """Zeros in one packed block, or the same block in many arrays."""
    packed = _zeros(count, 15)
    blob = struct.pack("<IIII", 1, whole, 0, len(packed)) + packed
    array = '<DataArray type="Float64" Name="Points" format="appended" offset="0"/>'
    piece = f'<Piece NumberOfPoints="{whole // 24}"><Points>{array}</Points></Piece>'
    return (
        '<VTKFile type="PolyData" byte_order="LittleEndian" compressor="vtkZLibDataCompressor">'
        f"<PolyData>{piece * (1 if count == whole else 500)}</PolyData>"
        '<AppendedData encoding="raw">_'
    ).encode() + blob  # fmt: skip


def _laz_of_one_place() -> bytes:
    return files.las(np.ones((2_000_000, 3)), compressed=True)


def _overlapping_vtp() -> bytes:
    array = '<DataArray type="Float64" Name="Points" format="appended" offset="0"/>'
    piece = f'<Piece NumberOfPoints="40000"><Points>{array}</Points></Piece>'
    blob = struct.pack("<I", 960_000) + np.random.default_rng(1).random(120_000).tobytes()
    return (
        '<VTKFile type="PolyData" byte_order="LittleEndian">'
        f'<PolyData>{piece * 1000}</PolyData><AppendedData encoding="raw">_'
    ).encode() + blob


_LAUGHS = (
    '<?xml version="1.0"{code}?><!DOCTYPE a [<!ENTITY a0 "ha">'
    + "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 12))
    + '<!ENTITY x SYSTEM "file:///etc/passwd">]>'
    + '<VTKFile type="PolyData">&a11;&x;</VTKFile>'
)


_PIECE = (
    b'<Piece NumberOfPoints="1"><Points><DataArray type="Int8">1 2 3</DataArray></Points></Piece>'
)


def _bombs() -> Iterator[tuple[str, str, Made]]:
    yield "npz, a gigabyte of zeros", "npz", lambda: _npz_bomb(GIGABYTE)
    yield "npz, 40 MB of zeros", "npz", lambda: _npz_bomb(40 << 20)
    yield "npz, 30 MB of zeros", "npz", lambda: _npz_bomb(30 << 20)
    yield (
        "npz that says less than it holds",
        "npz",
        lambda: _npz_bomb(GIGABYTE).replace(
            struct.pack("<I", GIGABYTE + 128), struct.pack("<I", 4096)
        ),
    )
    yield "npz in an npz", "npz", lambda: _packed(files.npz(POINTS, FACES))
    for method in (zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        yield (
            f"npz packed by method {method}",
            "npz",
            lambda method=method: _packed(files.npy(np.zeros((1 << 20, 3))), method),
        )
    yield "vtp, a gigabyte of zeros", "vtp", lambda: _vtp_bomb(GIGABYTE, GIGABYTE)
    yield "vtp, four gigabytes declared", "vtp", lambda: _vtp_bomb(1 << 24, 2**32 - 8)
    yield "vtp, 24 MB of zeros 500 times", "vtp", lambda: _vtp_bomb(24 << 20, 24_000_000)
    yield "vtp, one array in 1000 pieces", "vtp", _overlapping_vtp
    yield "laz, two million times one place", "laz", _laz_of_one_place
    yield "vtp, entities", "vtp", lambda: _LAUGHS.replace("{code}", "").encode()
    yield (
        "vtp, entities in UTF-16",
        "vtp",
        lambda: _LAUGHS.replace("{code}", ' encoding="UTF-16"').encode("utf-16"),
    )
    yield "vtp, deep", "vtp", lambda: b"<VTKFile>" + b"<a>" * 90_000 + b"</a>" * 90_000
    yield (
        "vtp, deep and closed",
        "vtp",
        lambda: b'<VTKFile type="PolyData">' + b"<a>" * 90_000 + b"</a>" * 90_000 + b"</VTKFile>",
    )
    yield (
        "vtp, a million elements",
        "vtp",
        lambda: b'<VTKFile type="PolyData">' + b"<a/>" * 1_000_000 + b"</VTKFile>",
    )
    for what, piece, count in (
        ("pieces of nothing", b"<Piece/>", 90_000),
        ("pieces", _PIECE, 20_000),
    ):
        yield (
            f"vtp, many {what}",
            "vtp",
            lambda piece=piece, count=count: (
                b'<VTKFile type="PolyData">' + piece * count + b"</VTKFile>"
            ),
        )
    yield "vtp, begun again and again", "vtp", lambda: b"<AppendedData " * 200_000
    yield (
        "vtp, a word of ten megabytes",
        "vtp",
        lambda: (
            b'<VTKFile type="PolyData"><Piece><Points><DataArray type="Float64">'
            + b"1" * 10_000_000
            + b"</DataArray></Points></Piece></VTKFile>"
        ),
    )


def _packed(content: bytes, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        archive.writestr("points.npy", content)
    return stream.getvalue()


class _Armed:
    """Once unpickled, it makes a file."""

    def __init__(self, marker: Path) -> None:
        self.marker = marker

    def __reduce__(self) -> tuple[object, tuple[object, ...]]:
        return Path.touch, (self.marker,)


def _armed(marker: Path) -> Iterator[tuple[str, str, Made]]:
    armed = np.array([_Armed(marker)] * 9, object).reshape(3, 3)
    stream = io.BytesIO()
    np.save(stream, armed, allow_pickle=True)
    raw = pickle.dumps(_Armed(marker))
    fields = np.zeros((3, 3), [("x", "f8"), ("y", object)])
    with_fields = io.BytesIO()
    np.save(with_fields, fields, allow_pickle=True)
    yield "npy, pickled objects", "npy", stream.getvalue
    yield "npy, objects in fields", "npy", with_fields.getvalue
    yield "npy, a pickle", "npy", lambda: raw
    yield "npz, pickled objects", "npz", lambda: _packed(stream.getvalue())
    yield "npz, a pickle", "npz", lambda: _packed(raw)
    yield (
        "npz, a pickle as its unit",
        "npz",
        lambda: files.npz(POINTS, FACES, unit=np.array(_Armed(marker), object)),
    )
    code = f"__import__('pathlib').Path({str(marker)!r}).touch()"
    shapes = ("(3, 3)", f"({code}, 3)", "(10**12, 3)", "(-3, 3)", "(3,) * 3", "(" * 5000)
    for shape in shapes:
        head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".encode()
        yield (
            f"npy, shape {shape[:20]}",
            "npy",
            lambda head=head: (
                b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head) + 1) + head + b"\n" + bytes(72)
            ),
        )
    old = b"{'descr': '<f8', 'fortran_order': False, 'shape': (3L, 3L), }\n"
    yield (
        "npy of Python 2",
        "npy",
        lambda: b"\x93NUMPY\x01\x00" + struct.pack("<H", len(old)) + old + np.eye(3).tobytes(),
    )
    for version in (b"\x02\x00", b"\x03\x00", b"\x09\x00"):
        yield (
            f"npy, header of four gigabytes {version!r}",
            "npy",
            lambda version=version: b"\x93NUMPY" + version + b"\xff" * 4 + b"{" * 1000,
        )
    for ending in ("txt", "csv", "xyz", "obj", "ply", "off"):
        yield f"Python in a .{ending}", ending, lambda: f"{code}\n{code} 1 2\n".encode()


def _long() -> Iterator[tuple[str, str, Made]]:
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
