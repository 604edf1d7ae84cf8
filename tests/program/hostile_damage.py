"""Files cut off, damaged, spelt otherwise, lying about their sizes, with odd numbers."""

import re
import struct
from collections.abc import Callable, Iterator

import numpy as np

from tests.core import surface_files as files
from tests.program.sound_files import FACES, POINTS, WRITERS, Made


def cut(content: bytes) -> Iterator[tuple[str, Made]]:
    yield "empty", lambda: b""
    yield "one byte", lambda: content[:1]
    for tenth in range(1, 10):
        yield f"cut at {tenth}0 %", lambda tenth=tenth: content[: len(content) * tenth // 10]
    yield "but its end", lambda: content[:-1]


def damaged(content: bytes) -> Iterator[tuple[str, Made]]:
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


def respelt(content: bytes) -> Iterator[tuple[str, Made]]:
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


def lying(content: bytes) -> Iterator[tuple[str, Made]]:
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


def odd_values() -> Iterator[tuple[str, str, Made]]:
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


def odd_corners() -> Iterator[tuple[str, str, Made]]:
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
