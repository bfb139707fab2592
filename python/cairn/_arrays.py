"""Arrays of all bodies of a world: views of its memory, which raise an error once they are invalid."""
from __future__ import annotations

import numpy as np


class Liveness:
    """Whether the arrays of a world are still valid; shared by all arrays of a world."""

    __slots__ = ("reason",)

    def __init__(self) -> None:
        self.reason: str | None = None  # why they are invalid; None: they are valid


def _checked(value):
    """Replaces each `BodyArray`, also in tuples and lists, by a plain array of the same memory; raises if it is invalid."""
    if isinstance(value, BodyArray):
        value.check()
        return value.view(np.ndarray)
    if isinstance(value, (tuple, list)):
        return type(value)(_checked(v) for v in value)
    return value


class BodyArray(np.ndarray):
    """One row for each body, in the order of `World.bodies` (by slot index). Read-only. The array is a view of the world's
    state: after a step it has the new values. Once bodies are created or destroyed it is invalid, and its use raises
    `WrongStateError`; `copy()` returns an independent array. `numpy.asarray` returns a plain array of the same memory,
    which is faster to index; once it is invalid, it keeps its last values and raises no error."""

    _liveness: Liveness | None = None

    def __array_finalize__(self, obj):
        self._liveness = getattr(obj, "_liveness", None)

    def check(self) -> None:
        """Raises `WrongStateError` if this array is invalid."""
        if self._liveness is not None and self._liveness.reason is not None:
            from ._errors import WrongStateError

            raise WrongStateError(f"array of bodies: {self._liveness.reason}; get a new one from the world",
                                  "array of bodies", "")

    def __getitem__(self, key):
        self.check()
        part = super().__getitem__(key)
        if isinstance(part, BodyArray) and not np.may_share_memory(part.view(np.ndarray), self.view(np.ndarray)):
            return part.view(np.ndarray)  # rows selected by a mask or by indices are an independent copy
        return part

    def __iter__(self):
        self.check()
        return super().__iter__()

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        return getattr(ufunc, method)(*(_checked(i) for i in inputs), **{k: _checked(v) for k, v in options.items()})

    def __array_function__(self, function, types, args, options):
        return function(*(_checked(a) for a in args), **{k: _checked(v) for k, v in options.items()})

    # NumPy turns an error in a comparison into False, so that the check must come first.
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
        """An independent plain array with the present values."""
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
    owner.flags.writeable = False  # then no view of it can be made writable either
    view = owner.view(BodyArray)
    view._liveness = liveness
    return view
