"""The package as a whole: stubs, documentation, examples, viewer."""
import ast
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cairn

PYTHON = pathlib.Path(os.environ["CAIRN_TEST_PYTHON"])  # the folder `python` of the source


class Stubs(unittest.TestCase):
    def test_they_have_what_the_module_has_with_documentation(self):
        tree = ast.parse((PYTHON / "cairn" / "_cairn.pyi").read_text(encoding="utf-8"))
        for stub in (node for node in tree.body if isinstance(node, ast.ClassDef)):
            if stub.name.startswith("_"):
                continue
            real = getattr(cairn._cairn, stub.name)
            there = {name for name in dir(real) if not name.startswith("_")}
            here = {node.name for node in stub.body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")}
            here |= {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
            if any(getattr(base, "id", "") == "_Handle" for base in stub.bases):
                here |= {"bits", "index", "generation", "world"}
            self.assertEqual(here, there, stub.name)
            if stub.name in ("World", "Body"):
                undocumented = [node.name for node in stub.body if isinstance(node, ast.FunctionDef)
                                and not node.name.startswith("_") and not ast.get_docstring(node)
                                and not any(getattr(d, "attr", "") == "setter" for d in node.decorator_list)]
                self.assertEqual(undocumented, [n for n in ("id", "world", "closed") if n in undocumented])

    def test_help_has_documentation(self):
        for owner in (cairn.World, cairn.Body, cairn.Hull, cairn.BodyId, cairn.Snapshot, cairn.rollout, cairn.load, cairn.save):
            self.assertTrue(owner.__doc__, owner)
        for name in dir(cairn.World):
            if not name.startswith("_") and name not in ("closed", "time_step", "title", "hint", "warnings"):
                self.assertTrue(getattr(cairn.World, name).__doc__, name)
        for name in dir(cairn.Body):
            if not name.startswith("_") and name not in ("id", "world"):
                self.assertTrue(getattr(cairn.Body, name).__doc__, name)

    def test_all_names_are_there(self):
        for name in cairn.__all__:
            self.assertTrue(hasattr(cairn, name), name)
        self.assertTrue((pathlib.Path(cairn.__file__).parent / "py.typed").exists())


class Examples(unittest.TestCase):
    def test_all_run(self):
        files = sorted((PYTHON / "examples").glob("*.py"))
        self.assertEqual(len(files), 11)
        for file in files:
            with self.subTest(file.name):
                done = subprocess.run([sys.executable, file], capture_output=True, text=True, timeout=300, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertTrue(done.stdout)

    def test_the_plot_of_the_pendulums(self):
        try:
            import matplotlib  # noqa: F401 # only tests whether it is installed
        except ImportError:
            self.skipTest("no matplotlib (Debian: python3-matplotlib)")
        with tempfile.TemporaryDirectory() as folder:
            plot = pathlib.Path(folder) / "plot.png"
            subprocess.run([sys.executable, PYTHON / "examples" / "04_pendulum_batch.py", plot], check=True, capture_output=True)
            self.assertGreater(plot.stat().st_size, 5000)


class Viewer(unittest.TestCase):
    def test_without_the_program_it_says_so(self):
        path, program = os.environ.pop("PATH"), os.environ.pop("CAIRN_PROGRAM", None)
        try:
            with self.assertRaises(cairn.UnsupportedError) as caught:
                cairn.view(cairn.World())
        finally:
            os.environ["PATH"] = path
            if program:
                os.environ["CAIRN_PROGRAM"] = program
        self.assertIn("CAIRN_PROGRAM", str(caught.exception))

    def test_a_picture_is_rendered_by_the_program(self):
        if not os.environ.get("CAIRN_PROGRAM"):
            self.skipTest("this build has no program")
        world = cairn.World()
        body = world.create_body()
        world.add_shape(body, cairn.Box((1, 1, 1)))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.png"
            cairn.picture(world, file, 320, 200)
            data = file.read_bytes()
        self.assertEqual(data[1:4], b"PNG")
        self.assertEqual((int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")), (320, 200))

    def test_a_viewer_without_a_display_says_so(self):
        if not os.environ.get("CAIRN_PROGRAM"):
            self.skipTest("this build has no program")
        saved = {name: os.environ.pop(name) for name in ("DISPLAY", "WAYLAND_DISPLAY") if name in os.environ}
        try:
            with self.assertRaises(cairn.UnsupportedError):
                cairn.view(cairn.World())
        finally:
            os.environ.update(saved)


if __name__ == "__main__":
    unittest.main()
