"""Files packed to fill the memory."""

import io
import struct
import zipfile
import zlib
from collections.abc import Iterator

import numpy as np

from tests.core import surface_files as files
from tests.program.sound_files import FACES, POINTS, Made

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


def bombs() -> Iterator[tuple[str, str, Made]]:
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
    yield "npz in an npz", "npz", lambda: packed(files.npz(POINTS, FACES))
    for method in (zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        yield (
            f"npz packed by method {method}",
            "npz",
            lambda method=method: packed(files.npy(np.zeros((1 << 20, 3))), method),
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


def packed(content: bytes, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        archive.writestr("points.npy", content)
    return stream.getvalue()
