#!/usr/bin/env python3
"""The table of docs/faults.md, held against the tests.

usage: tools/faults_table.py BUILD_DIR [--run]

Prints each row with the number of its tests; with --run, runs them and says whether they pass. Exit status 1 if a row
names a test that does not exist, if a row is missing, or if a test fails.
"""
import argparse
import fnmatch
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROWS = 60
FILTER = "--gtest_filter="
ROW = re.compile(r"^\| (\d+) \| ([^|]+) \| [^|]+ \| ([^|]+) \|$")


def read_rows(page):
    """(number, what, patterns) of each row, in the order of the page."""
    for line in page.read_text(encoding="utf-8").splitlines():
        if found := ROW.match(line):
            yield int(found.group(1)), found.group(2), re.findall(r"`([^`]+)`", found.group(3))


def test_programs(build):
    """The program of each GoogleTest of the build."""
    answer = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, check=True)
    programs = {}
    for test in json.loads(answer.stdout)["tests"]:
        for part in test.get("command", [])[1:]:
            if part.startswith(FILTER):
                programs[part[len(FILTER):]] = test["command"][0]
    return programs


def run_tests(programs, names):
    """The verdict of each test: "pass", "FAIL" or "skipped"."""
    verdicts = dict.fromkeys(names, "FAIL")  # the default for tests that a crash prevents from finishing
    with tempfile.TemporaryDirectory() as folder:
        for program in sorted({programs[name] for name in names}):
            report = pathlib.Path(folder, "report.json")
            report.unlink(missing_ok=True)
            chosen = ":".join(name for name in names if programs[name] == program)
            done = subprocess.run([program, FILTER + chosen, f"--gtest_output=json:{report}"], capture_output=True,
                                  text=True, check=False)
            if done.returncode != 0:
                print(done.stdout[-20000:], done.stderr, file=sys.stderr)
            if not report.exists():
                continue
            for suite in json.loads(report.read_text())["testsuites"]:
                for case in suite["testsuite"]:
                    verdict = "FAIL" if "failures" in case else "skipped" if case["result"] == "SKIPPED" else "pass"
                    verdicts[f"{suite['name']}.{case['name']}"] = verdict
    return verdicts


def main():
    arguments = argparse.ArgumentParser(description="The table of docs/faults.md, held against the tests.")
    arguments.add_argument("build")
    arguments.add_argument("--run", action="store_true", help="run the tests too")
    options = arguments.parse_args()
    rows = list(read_rows(pathlib.Path(__file__).resolve().parent.parent / "docs/faults.md"))
    programs = test_programs(options.build)
    mistakes = [f"row {i} is missing" for i in range(1, ROWS + 1) if i not in {number for number, _, _ in rows}]
    found = {}
    for number, _, patterns in rows:
        for pattern in patterns:
            matches = fnmatch.filter(programs, pattern)
            if not matches:
                mistakes.append(f"row {number}: no test is named {pattern}")
            found.setdefault(number, set()).update(matches)
    verdicts = run_tests(programs, sorted(set().union(*found.values()))) if options.run else {}
    for number, what, _ in rows:
        own = sorted(found[number])
        failed = [name for name in own if verdicts.get(name) == "FAIL"]
        skipped = sum(verdicts.get(name) == "skipped" for name in own)
        verdict = ("FAIL" if failed else "pass") if options.run else ""
        print(f"{number:>3}  {verdict:<4} {len(own):>3} tests  {what}" + (f" ({skipped} skipped)" if skipped else ""))
        mistakes += [f"row {number}: {name} fails" for name in failed]
    print("\n".join(mistakes) if mistakes else f"{len(rows)} rows, every one held by tests")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
