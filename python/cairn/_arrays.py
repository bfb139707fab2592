"""Arrays of all bodies of a world: views without copies, which say so when they no longer hold."""
from __future__ import annotations

import numpy as np


class Liveness:
    """Whether the arrays of a world still follow it; shared by all of them."""

    __slots__ = ("reason",)

    def __init__(self) -> None:
        self.reason: str | None = None  # why they do not


def _checked(value):
    """The plain array of one that still holds."""
    if isinstance(value, BodyArray):
        value.check()
        return value.view(np.ndarray)
    if isinstance(value, (tuple, list)):
        return type(value)(_checked(v) for v in value)
    return value


class BodyArray(np.ndarray):
    """A row for each body, in order of slot index (`World.bodies`). Read-only. It follows the world: after a step it has
    the new values. Once bodies come or go it is of no use, and raises `WrongStateError`; `copy()` makes one that stays.
    `numpy.asarray` makes a plain array of the same memory, which is quicker to index, and neither follows nor complains
    after that."""

    _liveness: Liveness | None = None

    def __array_finalize__(self, obj):
        self._liveness = getattr(obj, "_liveness", None)

    def check(self) -> None:
        """Raises `WrongStateError` if this array no longer follows its world."""
        if self._liveness is not None and self._liveness.reason is not None:
            from ._errors import WrongStateError

            raise WrongStateError(f"array of bodies: {self._liveness.reason}; ask the world for it again",
                                  "array of bodies", "")

    def __getitem__(self, key):
        self.check()
        part = super().__getitem__(key)
        if isinstance(part, BodyArray) and not np.may_share_memory(part.view(np.ndarray), self.view(np.ndarray)):
            return part.view(np.ndarray)  # rows that were picked are a copy, which stays
        return part

    def __iter__(self):
        self.check()
        return super().__iter__()

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        return getattr(ufunc, method)(*(_checked(i) for i in inputs), **{k: _checked(v) for k, v in options.items()})

    def __array_function__(self, function, types, args, options):
        return function(*(_checked(a) for a in args), **{k: _checked(v) for k, v in options.items()})

    # NumPy makes False of an error in a comparison: the check comes first.
    def __eq__(self, other):
        return _checked(self) == _checked(other)

    def __ne__(self, other):
        return _checked(self) != _checked(other)

    __hash__ = None

    def __repr__(self):
        return repr(_checked(self))

    def __str__(self):
        return str(_checked(self))

    def copy(self, order="C"):
        """A plain array with the values of now."""
        return _checked(self).copy(order)

    def __reduce__(self):
        return _checked(self).copy().__reduce__()

    def tolist(self):
        return _checked(self).tolist()

    def astype(self, *args, **options):
        return _checked(self).astype(*args, **options)

    def item(self, *args):
        return _checked(self).item(*args)

    def tobytes(self, order="C"):
        return _checked(self).tobytes(order)


def view_of(owner: np.ndarray, liveness: Liveness) -> BodyArray:
    owner.flags.writeable = False  # and with it no view can be made writable
    view = owner.view(BodyArray)
    view._liveness = liveness
    return view
