#!/usr/bin/env python3
"""Breaks the program in the places of mutations.txt, one after the other, and tells who notices.

usage: tests/mutation/run.py BUILD_FOLDER [--only NAME ...] [--table FILE] [--jobs N]

Run it in a clone of its own: it writes into the sources, and puts them back. BUILD_FOLDER is a
configured build of that clone, best with -DLUXGATE_UNITY=OFF. Of each change it builds `luxgate`
and the test programs named with it, runs `luxgate selftest` and these programs, and lists the
selftest cases that are wrong and the tests that fail. Exit code 1 if nobody notices a change.
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_NAMED = 3


def mutations():
    for line in (ROOT / "tests/mutation/mutations.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, file, before, after, programs = line.split(" | ")
            yield name, ROOT / file, before, after, programs.split()


def find(build, name):
    found = [p for p in build.rglob(name) if p.is_file() and p.stat().st_mode & 0o100]
    if not found:
        sys.exit(f"there is no '{name}' in {build}: build it first")
    return found[0]


def few(names):
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def selftest(build):
    done = subprocess.run([find(build, "luxgate"), "selftest", "--json"], capture_output=True, text=True, timeout=900)
    try:
        cases = json.loads(done.stdout)["cases"]
    except (json.JSONDecodeError, KeyError):
        return [f"exit code {done.returncode}"]
    return [c["name"] for c in cases if c["verdict"] not in ("in", "refused as documented")]


def failing_tests(build, programs):
    failing = []
    for program in programs:
        try:
            done = subprocess.run([find(build, program), "--gtest_brief=1"], capture_output=True, text=True,
                                  timeout=900)
        except subprocess.TimeoutExpired:
            failing.append(f"{program} hangs")
            continue
        names = [line.split("]")[1].split(",")[0].split(" (")[0].strip() for line in done.stdout.splitlines()
                 if line.startswith("[  FAILED  ]") and "." in line and "(" in line]
        failing += names or ([f"{program}: exit code {done.returncode}"] if done.returncode else [])
    return failing


def run_one(build, jobs, mutation):
    name, file, before, after, programs = mutation
    text = file.read_text()
    if text.count(before) != 1:
        sys.exit(f"{name}: the text stands {text.count(before)} times in {file}")
    try:
        file.write_text(text.replace(before, after))
        made = subprocess.run(["ninja", "-C", build, "-j", str(jobs), "luxgate", *programs], capture_output=True,
                              text=True)
        if made.returncode != 0:
            return ["does not compile"], []
        return selftest(build), failing_tests(build, programs)
    finally:
        file.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    rows, survivors = ["| change | in | selftest | tests |", "|---|---|---|---|"], []
    for mutation in mutations():
        name = mutation[0]
        if options.only and name not in options.only:
            continue
        cases, tests = run_one(options.build, options.jobs, mutation)
        if not cases and not tests:
            survivors.append(name)
        rows.append(f"| {name} | `{mutation[1].relative_to(ROOT)}` | {few(cases) or '-'} | {few(tests) or '-'} |")
        print(rows[-1], flush=True)
    if options.table:
        options.table.write_text("\n".join(rows) + "\n")
    if survivors:
        print("nobody noticed: " + ", ".join(survivors))
        sys.exit(1)


main()
