"""Frozen data out of JSON's plain values, by the types of its fields."""

from dataclasses import is_dataclass
from enum import Enum
from itertools import repeat
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints


def read(kind: Any, value: Any) -> Any:
    """Return a plain value, as `dataclasses.asdict` and JSON leave it, as one of `kind`.

    `kind` may be a dataclass, an enumeration, a simple type, or tuples, choices and unions of
    such. Fields that are missing are as at first.

    Raises
    ------
    TypeError, ValueError
        It is none of that kind.
    """
    family, parts = get_origin(kind), get_args(kind)
    if is_dataclass(kind):
        if not isinstance(value, dict):
            raise TypeError(f"{value!r} has no fields")
        hints = get_type_hints(kind)
        given = {name: read(hints.get(name, Any), part) for name, part in value.items()}
        return kind(**given)  # type: ignore[operator]
    if family in {Union, UnionType}:
        (inner,) = (part for part in parts if part is not NoneType)
        return None if value is None else read(inner, value)
    if family is tuple:
        if not isinstance(value, list | tuple):
            raise TypeError(f"{value!r} is no list")
        kinds = (repeat(parts[0], len(value))) if parts[-1] is ... else parts
        return tuple(read(part, inner) for part, inner in zip(kinds, value, strict=True))
    if family is dict:
        return {str(key): read(parts[1], inner) for key, inner in value.items()}
    if kind is Any:
        return _frozen(value)
    if family is Literal:
        if value not in parts:
            raise ValueError(f"{value!r} is none of {parts}")
        return value
    if issubclass(kind, Enum):
        return kind(value)
    if kind is float and type(value) is int:
        return float(value)
    if type(value) is not kind:
        raise TypeError(f"{value!r} is not {kind.__name__}")
    return value


def _frozen(value: Any) -> Any:
    """Return lists as tuples, all the way down."""
    if isinstance(value, list):
        return tuple(_frozen(inner) for inner in value)
    if isinstance(value, dict):
        return {key: _frozen(inner) for key, inner in value.items()}
    return value
