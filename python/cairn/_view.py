"""Opens the viewer, and renders pictures and videos, by the program `cairn` where it is installed."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import tempfile

from ._cairn import World, save
from ._errors import UnsupportedError


def program() -> str:
    """The program `cairn`: the environment variable CAIRN_PROGRAM, or the one on the path. Raises UnsupportedError."""
    found = os.environ.get("CAIRN_PROGRAM") or shutil.which("cairn")
    if not found:
        raise UnsupportedError("cairn: the program is not installed here, which has the viewer (or set CAIRN_PROGRAM to it)",
                               "cairn", "")
    return found


def _run(world: World, command: list[str], arguments: list[str]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "world.glb"
        save(world, scene)
        done = subprocess.run([program(), *command, str(scene), *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise UnsupportedError(f"cairn {' '.join(command)}: {done.stderr.strip() or done.returncode}", "cairn", "")


def view(world: World) -> None:
    """Opens a window with a copy of the world as it stands now, and returns when it is closed. Raises UnsupportedError where
    there is no viewer or no display."""
    _run(world, ["view"], [])


def picture(world: World, path, width: int = 960, height: int = 540) -> None:
    """Renders the world as it stands now, or rather 0.1 ms later: the program takes a step. A .png or .jpg file."""
    _run(world, ["run"], ["--frames", "1", "--dt", "0.0001", "--width", str(width), "--height", str(height), "--png", os.fsdecode(path)])


def video(world: World, path, seconds: float, width: int = 960, height: int = 540) -> None:
    """Renders what a copy of the world does for so many seconds to a video file (.mp4, .webm, .gif). Needs ffmpeg."""
    _run(world, ["run"], ["--seconds", str(seconds), "--width", str(width), "--height", str(height),
                          "--video", os.fsdecode(path)])
