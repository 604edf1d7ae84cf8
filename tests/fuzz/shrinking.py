"""Fewer items, as long as what they show stays."""

from collections.abc import Callable, Sequence


def fewer[T](items: Sequence[T], shows: Callable[[list[T]], bool]) -> list[T]:
    """Leave out items, many at a time and then one by one (Zeller and Hildebrandt 2002)."""
    kept = list(items)
    size = max(1, len(kept) // 2)
    while True:
        changed, begin = False, 0
        while begin < len(kept):
            trial = kept[:begin] + kept[begin + size :]
            if shows(trial):
                kept, changed = trial, True
            else:
                begin += size
        if size == 1 and not changed:
            return kept
        size = size if changed and size == 1 else max(1, size // 2)
