"""Opens the viewer, and renders pictures and videos, with the program `cairn`, if it is installed."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import tempfile

from ._cairn import World, save
from ._errors import UnsupportedError


def program() -> str:
    """The program `cairn`: the value of the environment variable CAIRN_PROGRAM, or the program found on the PATH. Raises
    UnsupportedError if there is none."""
    found = os.environ.get("CAIRN_PROGRAM") or shutil.which("cairn")
    if not found:
        raise UnsupportedError("cairn: the program with the viewer was not found; install it, or set CAIRN_PROGRAM to its "
                               "path", "cairn", "")
    return found


def _run(world: World, command: list[str], arguments: list[str]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "world.glb"
        save(world, scene)
        done = subprocess.run([program(), *command, str(scene), *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise UnsupportedError(f"cairn {' '.join(command)}: {done.stderr.strip() or done.returncode}", "cairn", "")


def view(world: World) -> None:
    """Opens a window with a copy of the world in its present state, and returns when the window is closed. Raises
    UnsupportedError if there is no viewer or no display."""
    _run(world, ["view"], [])


def picture(world: World, path, width: int = 960, height: int = 540) -> None:
    """Renders the world in its present state to a .png or .jpg file; more exactly 0.1 ms later, because the program performs
    one step."""
    _run(world, ["run"], ["--frames", "1", "--dt", "0.0001", "--width", str(width), "--height", str(height), "--png", os.fsdecode(path)])


def video(world: World, path, seconds: float, width: int = 960, height: int = 540) -> None:
    """Simulates a copy of the world for `seconds`, and renders it to a video file (.mp4, .webm, .gif). Requires ffmpeg."""
    _run(world, ["run"], ["--seconds", str(seconds), "--width", str(width), "--height", str(height),
                          "--video", os.fsdecode(path)])
