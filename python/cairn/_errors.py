"""Exceptions: one class for each error code of the C++ API."""
from __future__ import annotations


class Error(Exception):
    """The error of a rejected call; the world is unchanged. `field` is the name of the argument (for example
    "BodyDef.mass"), `value` its value as text, and `str(error)` has both, and what was expected."""

    def __init__(self, message: str, field: str = "", value: str = "") -> None:
        super().__init__(message, field, value)
        self.field = field
        self.value = value

    def __str__(self) -> str:
        return self.args[0]


class InvalidValueError(Error, ValueError):
    """An argument is NaN, infinite, or out of its range."""


class InvalidHandleError(Error, LookupError):
    """A handle is null, stale, or belongs to another world."""


class WrongStateError(Error, RuntimeError):
    """The call is not allowed in the present state: the world is closed, a step runs on another thread, or an array of
    bodies is invalid."""


class InvalidFileError(Error, ValueError):
    """A file or a buffer is malformed."""


class UnsupportedError(Error, NotImplementedError):
    """The request is well formed, but this build does not support it."""


class FileError(Error, OSError):
    """A file could not be read or written."""


# In the order of the error codes of the C++ API.
BY_CODE = (InvalidValueError, InvalidHandleError, WrongStateError, InvalidFileError, UnsupportedError, FileError)
