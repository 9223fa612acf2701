"""Which tests a change can break, from what the build knows: python3 changed_tests.py ROOT BUILD REVISION FILE

Changed is what differs from REVISION in the work tree, and what git does not know. A test is chosen if a program that its command names is
made of a changed file, by the build's own list of dependencies, or if its command names a changed file or a folder that holds one. A change
of the build itself can break all. Of tests that run the whole program only those are chosen that took less than MOST_S in the last run: the
others are counted. FILE is for `ctest --tests-information`. Ends with 3 if no test is chosen.
"""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys

MOST_S = 5.0


def lines_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def changed_files(root, revision):
    git = ["git", "-C", root]
    named = lines_of(*git, "diff", "--name-only", "--no-renames", revision) + lines_of(*git, "ls-files", "--others", "--exclude-standard")
    return {os.path.join(root, name) for name in named}


def files_of_objects(build):
    """Object to the files that it is compiled from."""
    files, target = collections.defaultdict(set), None
    for line in lines_of("ninja", "-C", build, "-t", "deps"):
        if line.startswith("    "):
            files[target].add(os.path.normpath(os.path.join(build, line.strip())))
        elif line.endswith("(VALID)"):
            target = line.split(": #deps")[0]
    return files


def changed_programs(build, programs, changed):
    objects = files_of_objects(build)
    touched = {name for name, files in objects.items() if files & changed}
    found = set()
    for program in programs:
        inputs = set(lines_of("ninja", "-C", build, "-t", "inputs", os.path.relpath(program, build)))
        if inputs & touched or {os.path.normpath(os.path.join(build, name)) for name in inputs} & changed:
            found.add(program)
    return found


def seconds_of_tests(build):
    """Name to the mean time of a run, as ctest keeps it."""
    seconds = {}
    file = pathlib.Path(build, "Testing/Temporary/CTestCostData.txt")
    for line in file.read_text().splitlines() if file.exists() else []:
        if match := re.fullmatch(r"(.+) (\d+) ([-+.e\d]+)", line):
            seconds[match[1]] = float(match[3])
    return seconds


def main():
    root, build, revision, out = sys.argv[1:]
    root, build = os.path.realpath(root), os.path.realpath(build)
    changed = changed_files(root, revision)
    tests = json.loads("\n".join(lines_of("ctest", "--test-dir", build, "--show-only=json-v1")))["tests"]
    # Words and the values of -DNAME=value.
    paths = [{word.split("=", 1)[-1] for word in test.get("command", []) if "/" in word} for test in tests]
    programs = {path for named in paths for path in named if path.startswith(build + "/") and os.path.isfile(path) and os.access(path, os.X_OK)}
    new_programs = changed_programs(build, sorted(programs), changed)
    holders = changed | {str(folder) for file in changed for folder in pathlib.Path(file).parents if root in map(str, folder.parents)}
    # A folder that holds the tree's sources says nothing of a test that is given it.
    holders -= {os.path.join(root, name) for name in ("calc", "rules", "report", "gpu", "tests", "examples")}
    seconds = seconds_of_tests(build)
    chosen, left_out = [], []
    scripts = os.path.join(root, "tests/tools/")
    if any(file.endswith(("/CMakeLists.txt", ".cmake", ".cmake.in")) and not file.startswith(scripts) for file in changed):
        new_programs |= programs
    for number, (test, named) in enumerate(zip(tests, paths), 1):
        if named & holders or test.get("command", [""])[0] in new_programs:
            chosen.append(number)
        elif named & new_programs:
            (chosen if seconds.get(test["name"], 0.0) < MOST_S else left_out).append(number)
    print(f"{len(changed)} files changed since {revision}: {len(chosen)} of {len(tests)} tests are run"
          + (f"; {len(left_out)} that run the program for longer than {MOST_S:g} s are left to a whole run" if left_out else ""), flush=True)
    pathlib.Path(out).write_text("0,0,0," + ",".join(map(str, chosen)) + "\n")
    return 0 if chosen else 3


sys.exit(main())
