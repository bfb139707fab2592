#!/usr/bin/env python3
"""Finds differences between the API table and the public headers: each test puts one into a copy of the headers."""
import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import api_table  # noqa: E402 # needs the path above


class Table(unittest.TestCase):
    def setUp(self):
        self.table = api_table.Table()
        self.folder = pathlib.Path(tempfile.mkdtemp()) / "cairn"
        shutil.copytree(ROOT / "include" / "cairn", self.folder)
        self.addCleanup(shutil.rmtree, self.folder.parent)

    def findings(self, file, before, after):
        path = self.folder / file
        text = path.read_text(encoding="utf-8")
        self.assertIn(before, text)
        path.write_text(text.replace(before, after, 1), encoding="utf-8")
        return "\n".join(api_table.disagreements(self.table, self.folder))

    def test_agrees_with_the_headers_as_they_are(self):
        self.assertEqual(list(api_table.disagreements(self.table, self.folder)), [])

    def test_a_new_call_of_world_is_missed(self):
        for before in ("    void step(float dt);", "    double kinetic_energy() const;", "    ~World();"):
            with self.subTest(before):
                found = self.findings("world.h", before, before + "\n    int explode(BodyId body, float force) const;")
                self.assertIn("World::explode(BodyId, float) const is in the headers, but not in the table", found)

    def test_a_new_overload_is_missed(self):
        found = self.findings("world.h", "    void step(float dt);", "    void step(float dt);\n    void step(double dt);")
        self.assertIn("World::step(double) is in the headers", found)

    def test_a_call_that_is_gone_is_noticed(self):
        found = self.findings("body.h", "    void wake();", "")
        self.assertIn("Body::wake() is in the table (api/), but not in the headers", found)

    def test_another_type_name_or_order_of_arguments_is_noticed(self):
        self.assertIn("set_damping", self.findings("body.h", "set_damping(float linear, float angular)",
                                                   "set_damping(float angular, float linear)"))
        self.assertIn("World::step(double)", self.findings("world.h", "void step(float dt)", "void step(double dt)"))

    def test_a_member_of_a_struct_that_is_new_or_renamed_is_noticed(self):
        self.assertIn("bounciness", self.findings("shape.h", "float restitution = 0.0f;", "float bounciness = 0.0f;"))
        self.assertIn("age", self.findings("body.h", "    bool allow_sleep = true;", "    bool allow_sleep = true;\n    int age = 0;"))

    def test_a_value_of_an_enum_that_is_new_is_noticed(self):
        self.assertIn("implicit_euler", self.findings("world.h", "    rk4, ", "    implicit_euler, ///< new\n    rk4, "))

    def test_an_alternative_of_a_variant_that_is_new_is_noticed(self):
        self.assertIn("Torus", self.findings("shape.h", "std::variant<Sphere,", "std::variant<Torus, Sphere,"))

    def test_every_call_that_is_written_by_hand_is_fuzzed(self):
        text = (ROOT / "tests" / "fuzz" / "c_api_by_hand.cpp").read_text(encoding="utf-8")
        for function in self.table.functions:
            if function.custom:
                with self.subTest(function.name):
                    self.assertRegex(text, rf"\bcairn_{function.name}\b")


if __name__ == "__main__":
    unittest.main()
