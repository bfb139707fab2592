"""What goes wrong: one class for each code of the C++ errors."""
from __future__ import annotations


class Error(Exception):
    """What went wrong at a call; the world is as it was. `field` names the argument (for example "BodyDef.mass"), `value`
    is what it was, as text, and `str(error)` says both together with what was expected."""

    def __init__(self, message: str, field: str = "", value: str = "") -> None:
        super().__init__(message, field, value)
        self.field = field
        self.value = value

    def __str__(self) -> str:
        return self.args[0]


class InvalidValueError(Error, ValueError):
    """An argument is NaN, infinite, or out of its range."""


class InvalidHandleError(Error, LookupError):
    """A handle is null, stale, or of another world."""


class WrongStateError(Error, RuntimeError):
    """The call is not allowed now: the world is closed, or in a step on another thread, or an array no longer holds."""


class InvalidFileError(Error, ValueError):
    """A file or a buffer is malformed."""


class UnsupportedError(Error, NotImplementedError):
    """A well-formed request for something that this build does not do."""


class FileError(Error, OSError):
    """A file could not be read or written."""


# In the order of the codes of C++.
BY_CODE = (InvalidValueError, InvalidHandleError, WrongStateError, InvalidFileError, UnsupportedError, FileError)
