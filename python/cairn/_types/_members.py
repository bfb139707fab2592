"""What is said of a keyword that no struct has."""
from __future__ import annotations

import functools
from typing import TypeVar

Struct = TypeVar("Struct")


def lists_members(struct: type[Struct]) -> type[Struct]:
    """The dataclass, whose construction names its members where it is given a keyword that is none of them."""
    construct, members = struct.__init__, struct.__dataclass_fields__

    @functools.wraps(construct)
    def __init__(self, *values, **named):
        try:
            construct(self, *values, **named)
        except TypeError:
            unknown = [name for name in named if name not in members]
            if not unknown:
                raise
            raise TypeError(f"{struct.__name__}: has no member {unknown[0]!r}; it has {', '.join(members)}") from None

    struct.__init__ = __init__
    return struct
