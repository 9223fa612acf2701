"""`check --against REV` from outside: the same as a checkout of REV, and every reason why there is none.

    revision_against.py LUXGATE FOLDER    FOLDER is made anew
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import git_repository
import small_designs

PROGRAM = sys.argv[1]
WORK = pathlib.Path(sys.argv[2]).resolve()
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
VARIABLES = git_repository.environment(WORK / "home")
problems = []


def luxgate(folder, *arguments, **variables):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, env={**VARIABLES, **variables}, capture_output=True, text=True)


def check(folder, *arguments, **variables):
    return luxgate(folder, "check", *arguments, "--pictures", "off", **variables)


def expect(name, done, code, *words, without=()):
    text = done.stdout + done.stderr
    found = [] if done.returncode == code else [f"exit code {done.returncode}, expected {code}"]
    found += [f"'{word}' is missing" for word in words if word not in text]
    found += [f"'{word}' is there" for word in without if word in text]
    problems.extend(f"{name}: {problem}" for problem in found)
    if found:
        print(f"--- {name}\n{text}")


def state(repository):
    """Every byte of the work tree and of .git."""
    return {str(file): (file.stat().st_mtime_ns, file.read_bytes()) for file in sorted(repository.folder.rglob("*")) if file.is_file()}


def revision(folder, *arguments):
    """What `check` says of the revision, without what must differ: names and ids of what it is compared with, and notes on that."""
    done = check(folder, *arguments, "-q", "--format", "json")
    if done.returncode not in (0, 1):
        problems.append(f"no result: {done.stderr}")
        return None
    said = json.loads(done.stdout)["revision"]
    for key in ("baseline", "commits", "baseline_version", "notes", "notes_message"):
        said.pop(key, None)
    return json.dumps(said, indent=1)


# Designs of main, and what a branch makes of them: changed, weaker, renamed, moved, new, gone.
team = git_repository.Repository(WORK / "team", VARIABLES)
DESIGNS = [team.folder / f"designs/d{k}/project.xml" for k in range(5)]
for k, design in enumerate(DESIGNS):
    small_designs.write(design, name=f"Design {k}", columns=3 + k % 2)
(team.folder / ".gitattributes").write_text("*.ies eol=crlf\n")
first = team.commit()
team.git("tag", "-a", "-m", "text", "v1")
team.git("checkout", "-q", "-b", "topic")
small_designs.write(DESIGNS[1], name="Design 1", columns=2)
small_designs.write(DESIGNS[2], name="Design 2", limit="80")
small_designs.write(DESIGNS[3], name="Design 3", columns=4, plane="table", was_plane=' was="desk"')
small_designs.write(team.folder / "designs/new/project.xml", name="New", room_id="other", columns=5)
team.git("mv", "designs/d4", "designs/moved")
DESIGNS[4] = team.folder / "designs/moved/project.xml"
NAMES = [str(file.relative_to(team.folder)) for file in [*DESIGNS, team.folder / "designs/new/project.xml"]]

# The same bytes as with a result of a checkout, with and without a store; nothing is touched.
checkout = WORK / "checkout"
team.git("worktree", "add", "-q", checkout, "main")
THEN = ["designs/d0/project.xml", "designs/d1/project.xml", "designs/d2/project.xml", "designs/d3/project.xml", "designs/d4/project.xml"]
baseline = WORK / "main.json"
done = check(checkout, *THEN, "-q", "--format", f"json={baseline}")
assert done.returncode == 1, done.stderr
text = baseline.read_text()
baseline.write_text(text.replace("designs/d4/project.xml", "designs/moved/project.xml"))  # a result does not know of git
team.git("worktree", "remove", "--force", checkout)
before = state(team)
wanted = revision(team.folder, *NAMES, "--baseline", baseline)
for name, arguments in {"--against": [], "cold store": ["--store", WORK / "store"], "warm store": ["--store", WORK / "store"]}.items():
    got = revision(team.folder, *NAMES, "--against", "main", *arguments)
    if wanted is None or got is None or got != wanted:
        problems.append(f"{name}: another revision than with a result of a checkout")
        (WORK / "wanted.json").write_text(wanted or "")
        (WORK / f"{name.strip('-')}.json").write_text(got or "")
if state(team) != before:
    problems.append("the repository was touched")

GATE = ("--gate", "regression")
expect("topic", check(team.folder, *NAMES, "--against", "main", *GATE), 1, f"main ({first[:10]})", "designs/d1/project.xml",
       "≥ 80 lx", "is compared with main:designs/d4/project.xml", "designs/new/project.xml did not exist at main; it is new")
for name in ("v1", first, first[:9], "HEAD", "main...", "topic~0"):
    expect(name, check(team.folder, NAMES[0], "--against", name, *GATE), 0, f"Compared with {name}" if first.startswith(name) else f"{name} ({first[:10]})")
expect("from elsewhere", check(WORK, "team/designs/d2/project.xml", "--against", "main", *GATE), 1, "≥ 80 lx")
expect("absolute", check(WORK, DESIGNS[4], "--against", "main", *GATE), 0, "is compared with main:designs/d4/project.xml")
done = check(team.folder, *NAMES, "--against", "main", "-q", "--explain-cost")
read, computed = map(int, re.search(r"--against: (\d+) sampling rounds of planes read from it, (\d+) computed", done.stderr).groups())
if read < computed:
    problems.append(f"what did not change is calculated twice: {read} looks taken, {computed} computed")
result = json.loads(check(team.folder, NAMES[0], "--against", "main", "--format", "json", "-q").stdout)
if result["revision"]["commits"] != [first] or result["revision"]["baseline"] != "main":
    problems.append(f"JSON: {result['revision']['commits']}")
expect("a result is shown again", check(team.folder, *NAMES, "--against", "main", "-q", "--format", f"json={WORK / 'r.json'}"), 1)
if luxgate(WORK, "report", "r.json", "--format", "json").stdout != (WORK / "r.json").read_text():
    problems.append("report: another result")
expect("redacted", check(WORK, DESIGNS[4], "--against", "main", "--redact", "-q", "--format", "json"), 1, first, '"baseline": "main"',
       without=[str(WORK)])

# Rules in the repository are those of then, as a file and as a folder; others are those of now.
ruled = git_repository.Repository(WORK / "ruled", VARIABLES)
OWN = pathlib.Path(__file__).resolve().parent.parent / "own_table"
TABLE = (OWN / "table.csv").read_text()
shutil.copy(OWN / "lamp.ies", ruled.folder)
(ruled.folder / "project.xml").write_text("""<luxgate version="1" maintenance-factor="0.8">
<material id="grey" reflectance="0.3"/><luminaire-type id="lamp" photometry="lamp.ies"/>
<room id="hall" size="10 2 3" ceiling="grey" walls="grey" floor="grey">
<luminaire-grid id="l" type="lamp" origin="0 0 2.9" size="10 2" rows="1" columns="5"/>
<plane id="bench" height="0.75" margin="0.3"><require pack="own" row="A.2"/></plane></room></luxgate>
""")


def import_rules(table, place):
    (WORK / "table.csv").write_text(table)
    place.parent.mkdir(exist_ok=True)
    place.unlink(missing_ok=True)
    done = luxgate(ruled.folder, "rules", "import", WORK / "table.csv", "--id", "own", "-o", place)
    assert done.returncode == 0, done.stderr


PACK = ruled.folder / "packs/own.xml"
import_rules(TABLE, PACK)
ruled.commit()
import_rules(TABLE.replace("desk,300,500", "desk,200,500"), PACK)
for rules in ("packs", "packs/own.xml"):
    expect(f"rules {rules}", check(ruled.folder, "project.xml", "--rules", rules, "--against", "HEAD", *GATE), 1, "▼ requires less", "≥ 300 lx", "≥ 200 lx")
shutil.copy(PACK, WORK / "own.xml")
expect("rules outside", check(ruled.folder, "project.xml", "--rules", WORK / "own.xml", "--against", "HEAD"), 0, without=["requires less"])
shutil.move(PACK.parent, ruled.folder / "later")
expect("rules that are new", check(ruled.folder, "project.xml", "--rules", "later", "--against", "HEAD"), 0, "later did not exist at HEAD")

# One that could not be read then is new to the last failure, and its errors say when.
broken = git_repository.Repository(WORK / "broken", VARIABLES)
design = broken.folder / "project.xml"
small_designs.write(design, limit="none")
broken.commit()
small_designs.write(design, far=False)
expect("unreadable then", check(broken.folder, "project.xml", "--against", "HEAD", *GATE), 0, "HEAD:project.xml:", "could not be judged before")
small_designs.write(design)
expect("failing, unreadable then", check(broken.folder, "project.xml", "--against", "HEAD", *GATE), 1, "HEAD:project.xml:")
design.unlink()
expect("gone now", check(broken.folder, "project.xml", "--against", "HEAD", *GATE), 2, "project.xml")

# Two repositories in one run.
other = git_repository.Repository(WORK / "other", VARIABLES)
small_designs.write(other.folder / "project.xml", name="Other")
second = other.commit()
small_designs.write(other.folder / "project.xml", name="Other", limit="70")
expect("two repositories", check(WORK, DESIGNS[0], other.folder / "project.xml", "--against", "main", *GATE), 1, "≥ 70 lx", first[:10], second[:10])
expect("one lacks it", check(WORK, DESIGNS[0], other.folder / "project.xml", "--against", "topic"), 2, f"{other.folder} has no commit 'topic'")

# Reasons why there is nothing to compare with: what, where, what is allowed.
ONE = NAMES[0]
for name, words in {
    "nothing": ["--against nothing", str(team.folder), "a branch, a tag, the id of a commit"],
    "HEAD~99": ["has no commit 'HEAD~99'"],
    "HEAD:designs": ["is a tree, not a commit"],
    "main..topic": ["main..topic"],
    "nothing...": ["has no commit 'nothing'"],
}.items():
    expect(name, check(team.folder, ONE, "--against", name), 2, "error[revision-not-available]", *words)
for name in ("", "-q"):
    expect(f"'{name}'", check(team.folder, ONE, f"--against={name}"), 2, "--against", "a branch, a tag")
expect("both", check(team.folder, ONE, "--against", "main", "--baseline", baseline), 2, "--against", "--baseline")
with tempfile.TemporaryDirectory() as elsewhere:  # WORK may lie in a repository
    alone = small_designs.write(pathlib.Path(elsewhere) / "project.xml")
    expect("no repository", check(WORK, alone, "--against", "main"), 2, "is not in a git repository", elsewhere)
outside = small_designs.write(WORK / "outside/project.xml")
team.git("clone", "-q", "--bare", ".", WORK / "bare.git")
expect("bare", check(WORK, outside, "--against", "main", GIT_DIR=str(WORK / "bare.git"), GIT_WORK_TREE=str(team.folder)), 2, "outside the work tree")
expect("bare, named", check(team.folder, ONE, "--against", "main", GIT_DIR=str(WORK / "bare.git"), GIT_WORK_TREE=str(team.folder)), 1, first[:10])
expect("no GIT_DIR", check(team.folder, ONE, "--against", "main", GIT_DIR=str(WORK / "none.git")), 2, "none.git", "GIT_DIR")
team.commit()
team.git("clone", "-q", "--depth", "1", f"file://{team.folder}", WORK / "shallow")
expect("shallow", check(WORK / "shallow", ONE, "--against", "HEAD~1"), 2, "shallow clone", "fetch-depth: 0", "GIT_DEPTH")
expect("shallow, branch", check(WORK / "shallow", ONE, "--against", "origin/main..."), 2, "shallow clone")
expect("shallow, there", check(WORK / "shallow", ONE, "--against", "HEAD"), 1, "HEAD")
subprocess.run(["git", "init", "-q", "--object-format=sha256", WORK / "sha256"], check=True, env=VARIABLES)
expect("SHA-256", check(WORK, small_designs.write(WORK / "sha256/project.xml"), "--against", "HEAD"), 2, "SHA-256")

# Files that the revision has and that cannot be had: an error, no guess.
odd = git_repository.Repository(WORK / "odd", VARIABLES)
design = small_designs.write(odd.folder / "project.xml", far=False)
light = (odd.folder / "spot.ies").read_bytes()
digest = hashlib.sha256(light).hexdigest()
(odd.folder / "spot.ies").write_text(f"version https://git-lfs.github.com/spec/v1\noid sha256:{digest}\nsize {len(light)}\n")
pointer = odd.commit()
(odd.folder / "spot.ies").write_bytes(light)
expect("LFS pointer", check(odd.folder, design, "--against", "HEAD"), 2, "HEAD:project.xml:3", "spot.ies", "Git LFS", f"git lfs fetch origin {pointer}")
contents = odd.folder / f".git/lfs/objects/{digest[:2]}/{digest[2:4]}/{digest}"
contents.parent.mkdir(parents=True)
contents.write_bytes(light)
expect("LFS contents", check(odd.folder, design, "--against", "HEAD"), 0, "1 unchanged")
contents.write_bytes(light[:-1] + b" ")
expect("other LFS contents", check(odd.folder, design, "--against", "HEAD"), 2, "hash of its contents differs")
(odd.folder / "spot.ies").unlink()
(odd.folder / "spot.ies").symlink_to("../team/designs/d0/spot.ies")
odd.commit()
expect("link out", check(odd.folder, design, "--against", "HEAD"), 2, "HEAD:project.xml:3", "'spot.ies' leads out of the repository")
(odd.folder / "spot.ies").unlink()
(odd.folder / "light").mkdir()
(odd.folder / "light/real.ies").write_bytes(light)
(odd.folder / "spot.ies").symlink_to("light/real.ies")
odd.commit()
expect("link inside", check(odd.folder, design, "--against", "HEAD"), 0, "1 unchanged")
blob = odd.git("rev-parse", "HEAD:light/real.ies")
damaged = odd.folder / f".git/objects/{blob[:2]}/{blob[2:]}"
damaged.chmod(0o644)
damaged.write_bytes(b"nothing")
expect("damaged object", check(odd.folder, design, "--against", "HEAD"), 2, blob, "is damaged", "git fsck")
odd.git("-c", "protocol.file.allow=always", "submodule", "add", "-q", WORK / "bare.git", "lib")
(odd.folder / "spot.ies").unlink()
(odd.folder / "spot.ies").symlink_to("lib/designs/d0/spot.ies")
odd.commit()
expect("submodule", check(odd.folder, design, "--against", "HEAD"), 2, "HEAD:project.xml:3", "the submodule 'lib'")
expect("project in a submodule", check(odd.folder, "lib/designs/d0/project.xml", "--against", "HEAD"), 1, first[:10])
if os.geteuid() == 0:
    for file in [other.folder, *other.folder.rglob("*")]:
        os.chown(file, 12345, -1)
    expect("another user's", check(other.folder, "project.xml", "--against", "main"), 2, "another user", f"git config --global --add safe.directory {other.folder}")
    subprocess.run(["git", "config", "--global", "--add", "safe.directory", other.folder], check=True, env=VARIABLES)
    expect("trusted", check(other.folder, "project.xml", "--against", "main", *GATE), 1, "≥ 70 lx")

# A folder asks for all that was in it: a design that was deleted is one that asks for nothing any more.
fewer = git_repository.Repository(WORK / "fewer", VARIABLES)
for name in ("a", "b", "c"):
    small_designs.write(fewer.folder / f"designs/{name}.xml", name=name, far=False)
(fewer.folder / "designs/pack.xml").write_text("<rule-pack/>")
fewer.commit()
fewer.git("rm", "-q", "designs/b.xml", "designs/pack.xml")
fewer.git("mv", "designs/c.xml", "designs/moved.xml")
for folder in ("designs", "designs/", ".", fewer.folder):
    expect(f"deleted, {folder}", check(fewer.folder, folder, "--against", "HEAD", *GATE), 1, "designs/b.xml", "was a project at HEAD, but is not one now",
           without=("pack.xml is", "designs/c.xml was a project"))
fewer.git("checkout", "-q", "HEAD", "--", "designs/b.xml")
text = (fewer.folder / "designs/b.xml").read_text()
for name, change in (("another root", lambda file: file.write_text(text.replace("luxgate", "luxgatex"))),
                     ("hidden", lambda file: file.rename(file.with_name(".b.xml"))),
                     ("elsewhere", lambda file: file.rename(fewer.folder / "b.xml"))):
    (fewer.folder / "designs/b.xml").write_text(text)
    change(fewer.folder / "designs/b.xml")
    expect(f"no project any more: {name}", check(fewer.folder, "designs", "--against", "HEAD", *GATE), 1, "designs/b.xml", "was a project at HEAD, but is not one now")
(fewer.folder / "designs/b.XML").write_text(text)
expect("large letters", check(fewer.folder, "designs", "--against", "HEAD", *GATE), 0, "b.XML is compared with HEAD:designs/b.xml")
(fewer.folder / "designs/b.XML").unlink()
(fewer.folder / "designs/b.xml").write_text("")
expect("no project any more: empty", check(fewer.folder, "designs", "--against", "HEAD", *GATE), 2, "designs/b.xml")
(fewer.folder / "designs/b.xml").unlink()
# Another project in its place does not stand for it.
for others in (["x.xml"], ["u/b.xml", "v/y.xml"], ["x.xml", "y.xml"]):
    for other in others:
        small_designs.write(fewer.folder / "designs" / other, name="Other", far=False, plane="other", room_id="other", limit="1")
    expect(f"replaced by {others}", check(fewer.folder, "designs", "--against", "HEAD", *GATE), 1, "designs/b.xml")
    for other in others:
        (fewer.folder / "designs" / other).unlink()
    shutil.rmtree(fewer.folder / "designs/u", ignore_errors=True)
    shutil.rmtree(fewer.folder / "designs/v", ignore_errors=True)
expect("deleted, accepted", check(fewer.folder, "designs", "--against", "HEAD", *GATE, "--accept-weaker", "b is not built"), 0, "b is not built")
(fewer.folder / "designs").rename(fewer.folder / "before")
small_designs.write(fewer.folder / "other.xml", name="Other", far=False, plane="other", room_id="other", limit="1")
(fewer.folder / "other.xml").rename(fewer.folder / "designs")
expect("a file in place of the folder", check(fewer.folder, "designs", "--against", "HEAD", *GATE), 1, "designs/a.xml", "designs/b.xml")
(fewer.folder / "designs").unlink()
(fewer.folder / "before").rename(fewer.folder / "designs")
expect("others are named", check(fewer.folder, "designs/a.xml", "--against", "HEAD", *GATE), 0, without=("b.xml",))

# A few bytes of a commit say that there are 10^10 files: those beside the designs are not listed, and those in place of them are an error.
bomb = git_repository.Repository(WORK / "bomb", VARIABLES)
small_designs.write(bomb.folder / "designs/a.xml", far=False)
bomb.commit()
blob = bomb.git("hash-object", "-w", "designs/a.xml")
tree = subprocess.run(["git", "mktree"], cwd=bomb.folder, env=VARIABLES, check=True, capture_output=True, text=True,
                      input="".join(f"100644 blob {blob}\tf{k:02}.xml\n" for k in range(50))).stdout.strip()
for _ in range(5):
    tree = subprocess.run(["git", "mktree"], cwd=bomb.folder, env=VARIABLES, check=True, capture_output=True, text=True,
                          input="".join(f"040000 tree {tree}\tt{k:02}\n" for k in range(50))).stdout.strip()
for where, code, words in (("beside", 1, ["≥ 90 lx"]), ("designs", 2, ["it has more than 1000000 files"])):
    top = subprocess.run(["git", "mktree"], cwd=bomb.folder, env=VARIABLES, check=True, capture_output=True, text=True,
                         input="".join(f"{line}\n" for line in bomb.git("ls-tree", "HEAD").splitlines() if where != "designs")
                         + f"040000 tree {tree}\t{where}\n").stdout.strip()
    commit = bomb.git("commit-tree", top, "-m", where)
    small_designs.write(bomb.folder / "designs/a.xml", far=False, limit="90")
    begin = time.monotonic()
    expect(f"many files {where}", check(bomb.folder, "designs", "--against", commit, *GATE), code, *words)
    if time.monotonic() - begin > 20:
        problems.append(f"many files {where}: {time.monotonic() - begin:.0f} s")

# A folder of then whose object is lacking may have had designs.
lacking = git_repository.Repository(WORK / "lacking", VARIABLES)
small_designs.write(lacking.folder / "designs/a.xml", far=False)
small_designs.write(lacking.folder / "designs/old/b.xml", name="B", far=False)
lacking.commit()
tree = lacking.git("rev-parse", "HEAD:designs/old")
lacking.git("rm", "-q", "-r", "designs/old")
lacking.commit()
(lacking.folder / f".git/objects/{tree[:2]}/{tree[2:]}").unlink()
expect("a folder that is not at hand", check(lacking.folder, "designs", "--against", "HEAD~1", *GATE), 2, "not among the repository's objects")

# Who can push tags must not choose what a design is compared with.
named = git_repository.Repository(WORK / "named", VARIABLES)
design = small_designs.write(named.folder / "a.xml", far=False)
old = named.commit()
named.git("update-ref", "refs/remotes/origin/main", old)
small_designs.write(named.folder / "a.xml", far=False, limit="5")
new = named.commit()
for tag in ("origin/main", "refs/remotes/origin/main", "refs/remotes/origin/none", old[:8], "9" * 40):
    named.git("update-ref", f"refs/tags/{tag}", new)
FULL = "refs/remotes/origin/main"
for name, code, words in ((FULL, 1, "≥ 5 lx"), (f"{FULL}...", 1, "≥ 5 lx"), (old, 1, "≥ 5 lx"), ("origin/main", 2, "several commits"),
                          ("origin/main...", 2, "several commits"), ("origin/main~0", 2, "several commits"), (old[:8], 2, "several commits"),
                          ("refs/remotes/origin/none", 2, "has no 'refs/remotes/origin/none'"), ("9" * 40, 2, "has no commit 9999")):
    expect(f"tagged, {name}", check(named.folder, "a.xml", "--against", name, *GATE), code, words)
named.git("update-ref", "refs/tags/same", new)
named.git("branch", "same")
small_designs.write(named.folder / "a.xml", far=False, limit="4")
expect("two names of one commit", check(named.folder, "a.xml", "--against", "same", *GATE), 1, "≥ 4 lx")

# HEAD beside itself: nothing can be worse, and the gate says so instead of "nothing became worse". What is staged is compared.
named.git("checkout", "-q", "--", ".")
for name in ("HEAD", "main", "main...", new):
    expect(f"itself, {name}", check(named.folder, "a.xml", "--against", name, *GATE), 2, "error[revision-is-head]", "this is HEAD, and no file differs from it")
    expect(f"itself, {name}, no gate", check(named.folder, "a.xml", "--against", name), 0, "is HEAD itself and no file differs from it")
for form in ("json", "csv", "markdown", "junit", "sarif", "github", "gitlab", "html", "text"):
    done = check(named.folder, "a.xml", "--against", "HEAD", *GATE, "-q", "--format", form)
    expect(f"itself, {form}", done, 2)
    if "no file differs from it" not in done.stdout:
        problems.append(f"itself, {form}: it is not said")
(named.folder / "notes.txt").write_text("text")
named.git("add", "notes.txt")
expect("something is staged", check(named.folder, "a.xml", "--against", "HEAD", *GATE), 0, "nothing became worse")

# Designs in a submodule are compared with the commit that the revision of the repository around it names, not with their own branches.
annex = git_repository.Repository(WORK / "annex", VARIABLES)
small_designs.write(annex.folder / "x.xml", far=False)
annex_first = annex.commit()
small_designs.write(annex.folder / "x.xml", far=False, limit="10")
annex_second = annex.commit()
site = git_repository.Repository(WORK / "site", VARIABLES)
small_designs.write(site.folder / "designs/hall.xml", far=False)
site.commit()
ALLOW = ("-c", "protocol.file.allow=always")
site.git(*ALLOW, "submodule", "add", "-q", annex.folder, "designs/annex")
site.git("-C", "designs/annex", "checkout", "-q", annex_first)
site.commit("with the annex")
site.git("-C", "designs/annex", "checkout", "-q", annex_second)
site.commit("a weaker annex")
expect("a weaker submodule", check(site.folder, "designs", "--against", "HEAD~1", *GATE), 1, "≥ 10 lx")
expect("a weaker submodule, no sandbox", check(site.folder, "designs", "--against", "HEAD~1", *GATE, "--sandbox", "off"), 1, "≥ 10 lx")
expect("a submodule that is new", check(site.folder, "designs", "--against", "HEAD~2", *GATE), 0, "annex/x.xml did not exist at HEAD~2")
site.git("-C", "designs/annex", "rm", "-q", "x.xml")
site.git("-C", "designs/annex", "-c", "user.name=A", "-c", "user.email=a@example.invalid", "commit", "-q", "-m", "empty")
site.commit("an empty annex")
expect("a submodule without its design", check(site.folder, "designs", "--against", "HEAD~1", *GATE), 1, "annex/x.xml")
site.git("-C", "designs/annex", "checkout", "-q", annex_first)
site.commit("the first annex")
site.git("mv", "designs/annex", "designs/annex2")
site.git("-C", "designs/annex2", "checkout", "-q", annex_second)
site.commit("a weaker annex by another name")
expect("a weaker submodule by another name", check(site.folder, "designs/annex2", "--against", "HEAD~1", *GATE), 1, "≥ 10 lx")
(site.folder / "luxgate.toml").write_text("confidence = 0.99\n")
site.git("rm", "-q", "-f", "designs/annex2")
site.commit("settings, no annex")
site.git(*ALLOW, "submodule", "add", "-q", annex.folder, "designs/a")
site.commit("an annex with settings of none")
expect("settings of the repository around", check(site.folder, "designs/hall.xml", "designs/a/x.xml", "--against", "HEAD~1", *GATE), 2, "different settings")
site.git("-C", "designs/a", "checkout", "-q", annex_first)
site.git("mv", "designs/a", "designs/annex")
site.commit("back")
site.git("rm", "-q", "-f", "designs/annex")
site.git("rm", "-q", "luxgate.toml")
site.commit("no annex")
expect("a submodule that is gone", check(site.folder, "designs", "--against", "HEAD~1", *GATE), 2, "the submodule 'designs/annex' of this revision cannot be read")

# A design that was a link, settings that a move leaves behind, a folder that is a link.
odds = git_repository.Repository(WORK / "odds", VARIABLES)
small_designs.write(odds.folder / "v7/parts/b.design", far=False)
small_designs.write(odds.folder / "v7/a.xml", far=False)
shutil.copy(odds.folder / "v7/spot.ies", odds.folder / "v7/parts/spot.ies")
(odds.folder / "v7/b.xml").symlink_to("parts/b.design")
(odds.folder / "v7/east").mkdir()
small_designs.write(odds.folder / "v7/east/x.xml", name="East", far=False)
(odds.folder / "v7/east/luxgate.toml").write_text("confidence = 0.99\n")
(odds.folder / "designs").symlink_to("v7")
odds.commit()
(odds.folder / "notes.txt").write_text("x")
odds.git("add", "notes.txt")
expect("a folder that is a link", check(odds.folder, "designs/", "--no-config", "--against", "HEAD", *GATE), 0, "nothing became worse")
odds.git("rm", "-q", "v7/b.xml")
expect("a link to a design is deleted", check(odds.folder, "v7", "--no-config", "--against", "HEAD", *GATE), 1, "v7/b.xml")
odds.git("checkout", "-q", "HEAD", "--", "v7/b.xml")
(odds.folder / "v7/west").mkdir()
odds.git("mv", "v7/east/x.xml", "v7/east/spot.ies", "v7/west/")
expect("moved out of its settings", check(odds.folder, "v7/west/x.xml", "--against", "HEAD", *GATE), 2, "settings of 'v7/east/x.xml' have changed", "luxgate.toml")
text = (odds.folder / "v7/west/x.xml").read_text()
(odds.folder / "v7/west/x.xml").write_text(text.replace(">\n", ">\n<!-- " + "other " * 4000 + " -->\n", 1))
expect("moved out of its settings, and not known", check(odds.folder, "v7/west", "v7/east", "--against", "HEAD", *GATE), 2)
expect("moved out of its settings, by the folder", check(odds.folder, "v7", "--against", "HEAD", *GATE), 2, "settings of")
(odds.folder / "v7/west/x.xml").write_text(text)
expect("moved, no settings", check(odds.folder, "v7/west/x.xml", "--against", "HEAD", *GATE, "--no-config"), 0, "is compared with")

# Somebody let a failure go up to a day that is over: it is broken now, as beside a baseline, and not one that was there before.
ended = git_repository.Repository(WORK / "ended", VARIABLES)
OVER = small_designs.WAIVER.replace("2099-12-31", "2026-01-31")
small_designs.write(ended.folder / "a.xml", far_waiver=OVER)
ended.commit()
small_designs.write(ended.folder / "a.xml", far_waiver=OVER, name="Design again")
for day, code, words in ((1767225600, 0, "nothing became worse"), (1775000000, 1, "broken")):
    expect(f"a waiver, {day}", check(ended.folder, "a.xml", "--against", "HEAD", *GATE, "--timestamp", day), code, words)

# Interrupted: nothing is written.
process = subprocess.Popen([PROGRAM, "check", *NAMES, "--against", "main", "--goal", "accuracy", "--tolerance", "0.00001", "--max-paths", "1073741824",
                            "--format", f"json={WORK / 'interrupted.json'}"], cwd=team.folder, env=VARIABLES, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
time.sleep(1.0)
process.send_signal(signal.SIGTERM)
_, told = process.communicate(timeout=60)
if process.returncode != 130 or "interrupted" not in told or (WORK / "interrupted.json").exists():
    problems.append(f"interrupted: exit code {process.returncode}: {told}")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
