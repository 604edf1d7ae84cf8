"""Files made to break readers: cut off, lying, damaged, packed to fill the memory, or armed."""

from collections.abc import Iterator
from pathlib import Path

from surfcmp_core.io.read import READERS
from tests.program.hostile_bombs import bombs
from tests.program.hostile_code import armed_files
from tests.program.hostile_damage import cut, damaged, lying, odd_corners, odd_values, respelt
from tests.program.hostile_lengths import long_files
from tests.program.sound_files import FACES, POINTS, TEXTS, WRITERS, Made

ENDINGS = [ending for ending in READERS if ending != ".txt"]


def hostile(marker: Path) -> Iterator[tuple[str, str, Made]]:
    """Name, ending and content of each file.

    Parameters
    ----------
    marker : Path
        A file that appears where code in a file is run.
    """
    sound = {name: (ending, write(POINTS, FACES)) for name, (ending, write) in WRITERS.items()}
    for name, (ending, content) in sound.items():
        for what, made in (*cut(content), *damaged(content)):
            yield f"{name}, {what}", ending, made
        if name in TEXTS:
            for what, made in respelt(content):
                yield f"{name}, {what}", ending, made
        for what, made in lying(content):
            yield f"{name}, {what}", ending, made
        for other in ENDINGS:
            if other != f".{ending}":
                yield f"{name} as {other}", other[1:], lambda content=content: content
    yield from odd_values()
    yield from odd_corners()
    yield from bombs()
    yield from armed_files(marker)
    yield from long_files()
