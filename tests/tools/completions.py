"""Completions in real shells, and manual pages in man. Usage: completions.py LUXGATE WORK EXAMPLES"""

import os
import shutil
import subprocess
import sys

luxgate, work = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
os.makedirs(os.path.join(work, "here", "folder"))
here = os.path.join(work, "here")
open(os.path.join(here, "office.xml"), "w").close()
failures = []


def run(words, **more):
    return subprocess.run(words, capture_output=True, text=True, cwd=here, **more)


def expect(name, found, wanted, unwanted=()):
    for word in wanted:
        if word not in found:
            failures.append(f"{name}: '{word}' is missing in {sorted(found)[:20]}")
    for word in unwanted:
        if word in found:
            failures.append(f"{name}: '{word}' is there")


def script(shell):
    path = os.path.join(work, "luxgate." + shell)
    with open(path, "w") as file:
        result = subprocess.run([luxgate, "completions", shell], stdout=file)
    assert result.returncode == 0, shell
    return path


# What is typed, as bash splits it ('=' is a word), and what is offered or not.
LINES = [
    (["ch"], {"check"}, {"rules"}),
    (["rules", ""], {"list", "import", "diff"}, {"check"}),
    (["check", "--ba"], {"--backend", "--baseline"}, {"--goal"}),
    (["check", "--goal", ""], {"verdict", "accuracy"}, {"office.xml"}),
    (["check", "--goal", "=", "v"], {"verdict"}, {"accuracy"}),
    (["check", "--goal", "="], {"verdict", "accuracy"}, set()),
    (["check", "--format", "js"], {"json"}, {"csv"}),
    (["check", "--format", "json", "=", "off"], {"office.xml"}, {"json"}),
    (["check", "--format", "json", "="], {"office.xml"}, {"json"}),
    (["check", "--rules", ""], {"office.xml", "folder"}, {"check"}),
    (["check", "--store", ""], {"folder"}, {"office.xml"}),
    (["check", "-o", ""], {"folder"}, {"office.xml"}),
    (["check", "--seed", ""], set(), {"office.xml", "--goal"}),
    (["check", "--strict", "=", "light-l"], {"light-leaves-room"}, {"office.xml"}),
    (["check", "of"], {"office.xml"}, {"check"}),
    (["export", ""], {"radiance", "gltf"}, {"office.xml"}),
    (["export", "gltf", "o"], {"office.xml"}, {"radiance"}),
    (["policy", "check", "o"], {"office.xml"}, {"explain"}),
    (["help", "val"], {"validate"}, {"check"}),
    (["completions", ""], {"bash", "zsh", "fish"}, set()),
    (["check", "--language", ""], {"en", "de", "fr"}, set()),
]

bash = script("bash")
expect("bash -n", run(["bash", "-n", bash]).stderr.split(), [])
assert run(["bash", "-n", bash]).returncode == 0
for typed, wanted, unwanted in LINES:
    words = " ".join("'" + word + "'" for word in ["luxgate"] + typed)
    result = run(["bash", "-c", f"source {bash}; COMP_WORDS=({words}); COMP_CWORD={len(typed)}; "
                  "_luxgate; printf '%s\\n' \"${COMPREPLY[@]}\""])
    if result.stderr:
        failures.append(f"bash: {typed}: {result.stderr}")
    expect(f"bash: {typed}", set(result.stdout.split("\n")), wanted, unwanted)

skipped = []
zsh = script("zsh")
if shutil.which("zsh"):
    result = run(["zsh", "-n", zsh])
    if result.returncode != 0 or result.stderr:
        failures.append("zsh -n: " + result.stderr)
else:
    skipped.append("zsh is not installed")

fish = script("fish")
if shutil.which("fish"):
    result = run(["fish", "-n", fish])
    if result.returncode != 0 or result.stderr:
        failures.append("fish -n: " + result.stderr)
    for typed, wanted, unwanted in LINES:
        if "=" in typed:
            continue
        result = run(["fish", "--no-config", "-c",
                      f"source {fish}; complete -C \"luxgate {' '.join(typed)}\""],
                     env={**os.environ, "HOME": work})
        found = {line.split("\t")[0].rstrip("/") for line in result.stdout.split("\n")}
        expect(f"fish: {typed}", found, wanted, unwanted)
else:
    skipped.append("fish is not installed")

pages = os.path.join(work, "man1")
assert subprocess.run([luxgate, "man", "-o", pages]).returncode == 0
names = os.listdir(pages)
expect("man pages", set(names), {"luxgate.1", "luxgate-check.1", "luxgate-rules.1"})
if shutil.which("man") and shutil.which("groff"):
    for name in names:
        result = run(["man", "--warnings", "-l", os.path.join(pages, name)],
                     env={**os.environ, "MANROFFSEQ": "", "MANWIDTH": "80", "LC_ALL": "C.UTF-8"})
        if result.returncode != 0 or result.stderr or "SYNOPSIS" not in result.stdout:
            failures.append(f"man: {name}: {result.stderr[:300]}")
else:
    skipped.append("man or groff is not installed")

for failure in failures:
    print(failure)
if failures:
    sys.exit(1)
if skipped:
    print("skipped: " + "; ".join(skipped) + " (the rest is good)")
else:
    print("good")
