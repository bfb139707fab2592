"""`pip install ./python` without network access, in a new virtual environment; and the source archive. Takes minutes without
a compiler cache. The environment variable CAIRN_TEST_FOLDER contains the working folder."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

FOLDER = pathlib.Path(os.environ["CAIRN_TEST_FOLDER"])
PYTHON = pathlib.Path(os.environ["CAIRN_TEST_PYTHON"])
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "PIP_"))}
sys.path.insert(0, str(PYTHON))
import cairn_build  # noqa: E402 # it is in the folder that was just added to the path


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=ENVIRONMENT, **options)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def compiled(folder):
    """The files that CMake would compile, as paths relative to the engine."""
    run("cmake", "-S", folder, "-B", folder / "configured", "-DCAIRN_PYTHON=ON", "-DCAIRN_APP=OFF", "-DCAIRN_TESTS=OFF",
        "-DCAIRN_C_API=OFF", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", f"-DPython_EXECUTABLE={sys.executable}", "-DCAIRN_UNITY=OFF")
    commands = json.loads((folder / "configured" / "compile_commands.json").read_text(encoding="utf-8"))
    return {pathlib.Path(entry["file"]).relative_to(folder).as_posix() for entry in commands}


class Pip(unittest.TestCase):
    def test_a_wheel_is_installed_without_network_and_works_elsewhere(self):
        place = FOLDER / "environment"
        shutil.rmtree(place, ignore_errors=True)
        run(sys.executable, "-m", "venv", "--system-site-packages", place)
        run(place / "bin" / "pip", "install", "--no-index", "--disable-pip-version-check", "--force-reinstall", "--no-deps",
            "--config-settings", f"build-folder={FOLDER}", PYTHON, cwd=FOLDER)
        program = "import cairn, sys; w = cairn.World(); w.step(); print(cairn.__file__, cairn.__version__)"
        file, version = run(place / "bin" / "python", "-c", program, cwd=FOLDER).split()
        self.assertTrue(file.startswith(str(place)), file)
        self.assertEqual(version, cairn_build.version())
        self.assertIn("3.0000", run(place / "bin" / "python", PYTHON / "examples" / "01_falling_ball.py", cwd=FOLDER))
        listed = run(place / "bin" / "pip", "show", "--files", "--disable-pip-version-check", "cairn-physics")
        for name in ("cairn/_cairn.pyi", "cairn/py.typed", "cairn/_types/joint.py"):
            self.assertIn(name, listed)


class SourceArchive(unittest.TestCase):
    def test_it_has_all_that_is_compiled(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            name = cairn_build.build_sdist(temporary)
            with tarfile.open(folder / name) as archive:
                archive.extractall(folder)
                names = archive.getnames()
            inside = folder / name.removesuffix(".tar.gz")
            self.assertIn(f"{inside.name}/PKG-INFO", names)
            self.assertFalse([n for n in names if n.endswith((".so", ".o")) or "__pycache__" in n])
            from_archive = compiled(inside / "engine")
            root = folder / "repository"  # a copy of the files, because the build writes into their folder
            root.mkdir()
            for entry in PYTHON.parent.iterdir():
                if entry.name in ("CMakeLists.txt", "cmake", "include", "src", "scenes", "python", "LICENSE"):
                    shutil.copytree(entry, root / entry.name) if entry.is_dir() else shutil.copy(entry, root)
            self.assertEqual(from_archive, compiled(root))
            self.assertGreater(len(from_archive), 150)


if __name__ == "__main__":
    unittest.main()
