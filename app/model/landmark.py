"""Landmarks: the same place on both surfaces."""

from dataclasses import dataclass

Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Landmark:
    """The same place on both surfaces, in the files' coordinates."""

    one: Point | None = None
    two: Point | None = None

    @property
    def complete(self) -> bool:
        """Whether both places are known."""
        return self.one is not None and self.two is not None
