"""The jobs in examples/ci, run as GitHub and GitLab would run them, for requests that do this and that to a team's designs.

    ci_jobs.py LUXGATE FOLDER            FOLDER is made anew
    ci_jobs.py LUXGATE FOLDER --table    and prints what a reviewer reads first of each request of a day
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import git_repository
import small_designs

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not installed")
    sys.exit(0)

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
WORK = pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = pathlib.Path(__file__).resolve().parent.parent.parent / "examples/ci"
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
VARIABLES = git_repository.environment(WORK / "home")
VARIABLES["PATH"] = f"{PROGRAM.parent}:{VARIABLES['PATH']}"
# As in the image of a job, which has no OpenGL: pictures of rooms would be four fifths of the time, and are cli.pictures.
VARIABLES["LUXGATE_GL_FAULT"] = "no-egl"
HOSTILE = "x$(touch${IFS}pwned)`touch${IFS}pwned`;touch${IFS}pwned;#'\""
problems = []

# The repository of the team.
team = git_repository.Repository(WORK / "team", VARIABLES)
DESIGNS = {f"designs/room-{k:02}.xml": dict(name=f"Room {k}", columns=3 + k % 3, points=4 + k, limit="500", far=False) for k in range(12)}


# Two rooms of one file, and furniture in one of them.
FLOOR = small_designs.project(name="Floor", limit="300", far=False)
PLAIN_ROOM = re.search("<room.*</room>", FLOOR, re.DOTALL)[0]
ROOM = PLAIN_ROOM.replace("<plane ", '<box id="cupboard" material="dark" size="0.5 0.8 1.2" position="0.5 0.5 0"/>\n<plane ', 1)
FLOOR = FLOOR.replace(PLAIN_ROOM, ROOM + ROOM.replace('"room"', '"second"').replace('"Office"', '"Second"').replace('"desk"', '"table"').replace('"cupboard"', '"board"').replace('"L"', '"M"'))
ATTIC = small_designs.project(name="Attic", room_id="attic", room="Attic", plane="bench", far=False).replace('"L"', '"A"')


def write(changes={}, designs=None):
    """All of them, or these, some of the twelve changed: {name: what is other}."""
    shutil.rmtree(team.folder / "designs", ignore_errors=True)
    (team.folder / "designs/floors").mkdir(parents=True)
    small_designs.write(team.folder / "designs/floors/floor.xml")  # its photometry
    (team.folder / "designs/floors/floor.xml").write_text(FLOOR)
    (team.folder / "designs/floors/attic.xml").write_text(ATTIC)
    for name, values in (designs or DESIGNS).items():
        values = {**values, **changes.get(name, {})}
        small_designs.write(team.folder / values.pop("file", name), **values)


def branch(name, changes):
    team.git("checkout", "-q", "-B", name, "start")
    write(changes)
    team.commit(name)


write()
(team.folder / ".gitattributes").write_text("*.xml text eol=crlf\n")
team.commit("designs")
team.git("tag", "start")
branch("darker", {"designs/room-07.xml": dict(columns=1)})
branch("weaker", {"designs/room-03.xml": dict(limit="400")})
branch("renamed", {name: dict(plane="table", was_plane=' was="desk"', name="Other", file=f"designs/hall-{k:02}.xml")
                   for k, name in enumerate(DESIGNS) if k % 3 == 0})
branch("better", {"designs/room-05.xml": dict(columns=7)})
branch("unreadable", {"designs/room-02.xml": dict(limit="none")})
branch("dimmer", {"designs/room-11.xml": dict(candela="500 480 430 350 240 120 0")})  # the photometry of all, which is written last
team.git("checkout", "-q", "-B", "deleted", "start")
write()
(team.folder / "designs/room-09.xml").unlink()
team.commit("deleted")
team.git("checkout", "-q", "-B", "forged", "start")
write({"designs/room-04.xml": dict(columns=1)})
(team.folder / "out").mkdir()
(team.folder / "out/summary.md").write_text("forged")
team.commit("forged")
shutil.rmtree(team.folder / "out")
team.git("checkout", "-q", "-B", HOSTILE, "start")
# What others merge meanwhile is no regression of those who have it not yet.
team.git("checkout", "-q", "main")
write({"designs/room-01.xml": dict(columns=9)})
team.commit("brighter")
# Whoever can push tags tries to be the commit that is compared with.
for name in ("origin/main", "refs/remotes/origin/main", "main"):
    team.git("update-ref", f"refs/tags/{name}", "weaker")

# Name of the request: target, exit code, what people read of it.
REQUESTS = {
    "darker": ("main", 1, ["room-07.xml", "✗ broken"]),
    "weaker": ("main", 1, ["room-03.xml", "requires less", "≥ 500 lx", "≥ 400 lx"]),
    "renamed": ("main", 0, ["nothing became worse"]),
    "better": (HOSTILE, 0, ["▲ better", "room-05.xml"]),
    "deleted": ("main", 1, ["room-09.xml"]),
    "unreadable": ("main", 2, ["room-02.xml"]),
    "forged": ("main", 2, ["out is in git"]),
    "dimmer": ("main", 1, ["room-11.xml", "✗ broken"]),
}


# A day's requests: what somebody does to the designs, exit code, what is read of it.
R0, SPOT, FLOORS = "designs/room-00.xml", "designs/spot.ies", "designs/floors"
DAY, MORNING = [], {R0: DESIGNS[R0]}


def request(title, code, *words, edit=None, **changes):
    """edit(folder of the team) does what `changes` of room 0 do not."""
    DAY.append((title, code, words, edit, changes))


def replaces(*pairs, file=R0):
    def edit(team_folder):
        text = (team_folder / file).read_text()
        for old, new in pairs:
            assert old in text, (old, text)
            text = text.replace(old, new)
        (team_folder / file).write_text(text)
    return edit


def puts(file, content):
    def edit(team_folder):
        (team_folder / file).parent.mkdir(parents=True, exist_ok=True)
        (team_folder / file).write_bytes(content if isinstance(content, bytes) else content.encode())
    return edit


def moves(old, new):
    def edit(team_folder):
        (team_folder / new).parent.mkdir(parents=True, exist_ok=True)
        shutil.move(team_folder / old, team_folder / new)
    return edit


def all_of(*edits):
    def edit(team_folder):
        for one in edits:
            one(team_folder)
    return edit


def splits(second=lambda text: text):
    """The second room gets a file of its own."""
    def edit(team_folder):
        rooms = re.findall("<room.*?</room>", FLOOR, re.DOTALL)
        puts(f"{FLOORS}/floor.xml", FLOOR.replace(rooms[1], ""))(team_folder)
        puts(f"{FLOORS}/second.xml", second(FLOOR.replace(rooms[0], "").replace('name="Floor"', 'name="Second floor"')))(team_folder)
    return edit


OPEN, STOPPED = "nothing became worse", "stopped"
USUAL = small_designs.project(**DESIGNS[R0])
CORNER = USUAL.replace('name="Room 0"', 'name="New"')
GRID = re.search("<luminaire-grid[^>]*>", USUAL)[0]
REQUIRE = re.search("<require[^>]*>", USUAL)[0]
request("nothing", 0, OPEN)
request("a read-me file", 0, OPEN, edit=puts("designs/README.md", "# Designs\n"))
request("comments and blanks", 0, OPEN, edit=replaces(("<room ", "<!-- the corner -->\n\n<room ")))
request("another name", 0, OPEN, name="Corner office")
request("another name of the room", 0, OPEN, room="Corner")
request("a file renamed", 0, OPEN, edit=moves(R0, "designs/corner.xml"))
request("a file in another folder", 0, OPEN, edit=all_of(moves(R0, "designs/east/room-00.xml"), puts("designs/east/spot.ies", small_designs.PHOTOMETRY.format(candela=small_designs.CANDELA))))
request("a plane renamed, which says so", 0, OPEN, plane="table", was_plane=' was="desk"')
request("a plane renamed", 1, "requires less", STOPPED, plane="table")
request("a room renamed, which says so", 0, OPEN, room_id="corner", was_room=' was="room"')
request("a room renamed", 1, "requires less", STOPPED, room_id="corner")
request("a file split", 0, OPEN, "rooms moved", edit=splits())
request("a file split, one half easier", 1, "requires less", "≥ 200 lx", edit=splits(lambda text: text.replace('at-least="300"', 'at-least="200"')))
request("a file split, one half forgotten", 1, "requires less", edit=all_of(splits(), lambda folder: (folder / FLOORS / "second.xml").unlink()))
request("a room taken out", 1, "requires less", edit=lambda folder: puts(f"{FLOORS}/floor.xml", FLOOR.replace(re.findall("<room.*?</room>", FLOOR, re.DOTALL)[1], ""))(folder))
request("two files merged", 0, OPEN, "rooms moved", edit=all_of(
    replaces(("</luxgate>", re.search("<room.*</room>", ATTIC, re.DOTALL)[0] + "</luxgate>"), file=f"{FLOORS}/floor.xml"),
    lambda folder: (folder / FLOORS / "attic.xml").unlink()))
request("a design deleted", 1, "requires less", "room-00.xml", edit=lambda folder: (folder / R0).unlink())
request("a design emptied", 1, "requires less", edit=puts(R0, '<luxgate version="1"/>\n'))
request("a design of no byte", 2, "room-00.xml", edit=puts(R0, ""))
request("another program's XML", 0, OPEN, edit=puts("designs/pom.xml", "<project/>\n"))
request("a design added", 0, OPEN, edit=puts("designs/new.xml", CORNER))
request("a design added that fails", 1, "new", edit=puts("designs/new.xml", CORNER.replace('at-least="500"', 'at-least="5000"')))
request("a design added as .XML that fails", 1, "NEW.XML", edit=puts("designs/NEW.XML", CORNER.replace('at-least="500"', 'at-least="5000"')))
request("a copy", 0, OPEN, edit=puts("designs/copy.xml", USUAL))
request("more luminaires", 0, "better", columns=5)
request("fewer luminaires", 1, columns=2)
request("luminaires in one another", 0, "luminaires-coincide", edit=replaces((GRID, GRID + GRID.replace('id="L"', 'id="L2"'))))
request("brighter photometry", 0, "better", candela="1100 1056 946 770 528 264 0")
request("darker photometry by a little", 0, "worse", OPEN, candela="998 958 858 699 479 239 0")
request("darker photometry", 1, "worse", candela="960 921 825 672 460 230 0")
request("photometry that is gone", 2, "spot.ies", edit=lambda folder: (folder / SPOT).unlink())
request("photometry that is cut", 2, "spot.ies", edit=puts(SPOT, "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 7"))
request("photometry left to Git LFS", 2, "spot.ies", edit=puts(SPOT, f"version https://git-lfs.github.com/spec/v1\noid sha256:{'0' * 64}\nsize 12345\n"))
request("a design left to Git LFS", 2, "room-00.xml", edit=puts(R0, f"version https://git-lfs.github.com/spec/v1\noid sha256:{'0' * 64}\nsize 12345\n"))
request("lumens by hand", 1, "luminous flux", flux=' flux-lm="3600"')
request("a maintenance factor raised", 1, "maintenance factor", mf="0.85")
request("a maintenance factor lowered, still met", 0, OPEN, "lower maintenance factor", mf="0.78")
request("a maintenance factor lowered, not met", 1, "broken", mf="0.4")
request("a maintenance factor lowered, and darker", 1, "worse", mf="0.78", candela="960 921 825 672 460 230 0")
request("brighter walls", 0, "reflectance", edit=replaces(('reflectance="0.7"', 'reflectance="0.75"')))
request("darker walls", 1, "reflectance", edit=replaces(('reflectance="0.7"', 'reflectance="0.3"')))
request("furniture added", 1, "cupboard", edit=replaces(("<plane ", '<box id="cupboard" material="dark" size="0.4 1 2" position="1.5 1.5 0"/>\n<plane ')))
request("furniture moved", 0, "moved", edit=replaces(('position="0.5 0.5 0"', 'position="0.5 0.6 0"'), file=f"{FLOORS}/floor.xml"))
request("a finer grid", 0, OPEN, "requires more", points=12)
request("a coarser grid", 1, "requires less", points=3)
request("a row of points", 1, "requires other things", edit=replaces((' count="4 4"', ' count="40 1"')))
request("a smaller area", 1, "requires less", width="2")
request("a larger area", 1, "requires other things", width="3.5")
request("a wider margin", 1, "margin", margin="0.3")
request("a limit lowered", 1, "requires less", limit="400")
request("a limit lowered by a hair", 1, "requires less", limit="499.9")
request("a limit raised", 0, "requires more", limit="510")
request("a limit raised too far", 1, "broken", limit="5000")
request("a requirement deleted", 1, "requires less", edit=replaces((REQUIRE, REQUIRE.replace('"mean"', '"least"').replace("average", "minimum").replace("500", "100"))))
request("another quantity", 1, "requires other things", edit=replaces((REQUIRE, REQUIRE.replace("average", "maximum"))))
request("a requirement added", 0, "requires more", edit=replaces((REQUIRE, REQUIRE + '<require id="least" quantity="minimum" at-least="50"/>')))
request("a requirement added that fails", 1, "requires more", edit=replaces((REQUIRE, REQUIRE + '<require id="least" quantity="minimum" at-least="5000"/>')))
request("a waiver", 1, "waiver", "A. Meier", edit=replaces((REQUIRE, REQUIRE.replace("/>", small_designs.WAIVER + "/>"))))
request("light of new luminaires", 1, "initial", edit=replaces((REQUIRE, REQUIRE.replace("/>", ' state="initial"/>'))))
request("a scene added", 0, OPEN, edit=replaces(("<room ", '<scene id="night"><dim group="g" level="0.1"/></scene>\n<room '), ('rows="2"', 'rows="2" group="g"')))
request("judged in another scene", 1, "requires other things", edit=replaces(("<room ", '<scene id="more"><dim group="g" level="1"/></scene>\n<room '), ('rows="2"', 'rows="2" group="g"'), (REQUIRE, REQUIRE.replace("/>", ' scene="more"/>'))))
request("other settings", 1, "requires other things", "confidence 0.8", edit=puts("luxgate.toml", "confidence = 0.8\n"))
request("conflict markers", 2, "room-00.xml", edit=replaces(("<room ", "<<<<<<< HEAD\n<room ")))
request("a limit that is none", 2, "room-00.xml", limit="many")
request("UTF-16 without a mark", 2, "room-00.xml", edit=lambda folder: (folder / R0).write_bytes(USUAL.encode("utf-16-le")))
request("a link to nothing", 2, "room-00.xml", edit=all_of(lambda folder: (folder / R0).unlink(), lambda folder: (folder / R0).symlink_to("nowhere.xml")))
request("another folder for all", 2, "designs", edit=moves("designs", "plans"))


def play_day(system):
    team.git("checkout", "-q", "-B", "morning", "start")
    write(designs=MORNING)
    team.commit("morning")
    for number, (name, _, _, edit, changes) in enumerate(DAY, 1):
        team.git("checkout", "-q", "-B", f"day-{number}", "morning")
        write({R0: changes}, MORNING)
        if edit:
            edit(team.folder)
        team.commit(name)
    machine, rows = Machine("day", 0), []
    for number, (name, code, words, _, _) in enumerate(DAY, 1):
        done = system.play(f"day-{number}", "morning", machine=machine)
        expect(f"request: {name}", done, code, words)
        lines = [line for line in done[2].splitlines() if line.startswith(("| ▼", "| ✗", "| ↔", "| ▲", "| ✓", "| –"))]
        lines += [line for line in done[2].splitlines() if line.startswith("- ")]
        rows.append((number, name, done[0], lines[0] if lines else done[1].splitlines()[0]))
    if "--table" in sys.argv:
        print("| | request | exit | read first |\n|---|---|---|---|")
        for row in rows:
            print("| {} | {} | {} | {} |".format(*row[:3], row[3].replace("|", "·")))


class Machine:
    """A clone as the system makes it, of another user's as in a container."""

    def __init__(self, name, depth):
        self.folder = WORK / name
        self.home = WORK / f"{name}-home"
        self.variables = {**VARIABLES, **git_repository.environment(self.home), "PATH": VARIABLES["PATH"]}
        limits = [] if depth == 0 else ["--depth", str(depth)]
        subprocess.run(["git", "clone", "-q", "--no-checkout", *limits, f"file://{team.folder}", self.folder], check=True, env=VARIABLES)

    def git(self, *arguments):
        done = subprocess.run(["git", "-c", "safe.directory=*", "-c", "user.name=A", "-c", "user.email=a@example.invalid", *arguments], cwd=self.folder, env=VARIABLES,
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{self.folder.name}: git {' '.join(arguments)}: {done.stderr}")

    def clean(self):
        self.git("reset", "-q", "--hard")
        self.git("clean", "-q", "-d", "-f")

    def hand_over(self):
        if os.geteuid() == 0:
            for file in [self.folder, self.folder / ".git", *self.folder.rglob("*")]:
                os.chown(file, 12345, -1, follow_symlinks=False)

    def run(self, shell, script, variables):
        (WORK / "step.sh").write_text(script)
        return subprocess.run([*shell, WORK / "step.sh"], cwd=self.folder, env={**self.variables, **variables}, capture_output=True, text=True)


def read_example(name):
    return yaml.safe_load((EXAMPLES / name).read_text())


class GitHub:
    def __init__(self):
        workflow = read_example("github.yml")
        self.job = workflow["jobs"]["designs"]
        text = (EXAMPLES / "github.yml").read_text()
        if workflow["permissions"] != {} or self.job["permissions"] != {"contents": "read", "security-events": "write"}:
            problems.append("GitHub: more rights than it needs")
        if "pull_request_target" in text or "secrets" in text:
            problems.append("GitHub: secrets for requests of anybody")
        for step in self.job["steps"]:
            if "uses" in step and not re.fullmatch(r"[\w./-]+@[0-9a-f]{40}", step["uses"]):
                problems.append(f"GitHub: {step['uses']} is not pinned")
            if "${{" in step.get("run", ""):
                problems.append(f"GitHub: a value is pasted into a script: {step['run']}")
        self.checkout = next(step for step in self.job["steps"] if step.get("uses", "").startswith("actions/checkout@"))

    # What GitHub puts in their place: for a request to `target` or a push, with or without the label.
    BASE = ("${{ github.event_name == 'merge_group' && github.event.merge_group.base_sha || github.base_ref "
            "&& format('refs/remotes/origin/{0}...', github.base_ref) || '' }}")
    ACCEPT = ("${{ contains(github.event.pull_request.labels.*.name, 'accept-weaker') && 'the label accept-weaker' "
              "|| github.event_name == 'merge_group' && 'looked at before the queue' || '' }}")

    def expressions(self, target, label):
        return {self.BASE: f"refs/remotes/origin/{target}..." if target else "", self.ACCEPT: "the label accept-weaker" if label else ""}

    def play(self, name, target, label=False, machine=None):
        """target: None for a push to `name`; machine: one that has served before. Exit code, log, summary, machine."""
        if machine:
            machine.clean()
        else:
            machine = Machine(f"github-{name}", self.checkout["with"].get("fetch-depth", 1))
        machine.git("checkout", "-q", "--detach", f"refs/remotes/origin/{target or name}")
        if target:
            machine.git("merge", "-q", "--no-ff", "-m", "merge", f"refs/remotes/origin/{name}")
        machine.hand_over()
        summary = WORK / f"github-{name}.md"
        variables = {"GITHUB_WORKSPACE": str(machine.folder), "GITHUB_STEP_SUMMARY": str(summary)}
        expressions = self.expressions(target, label)
        variables.update({key: expressions[value] for key, value in self.job["env"].items()})
        code, log = 0, ""
        for step in self.job["steps"]:
            if "run" not in step or (code != 0 and "!cancelled()" not in step.get("if", "")):
                continue
            done = machine.run(["sh", "-e"], step["run"], variables)
            log += done.stdout + done.stderr
            code = code or done.returncode
        return code, log, summary.read_text() if summary.exists() else "", machine


class GitHubAction(GitHub):
    """The composite action, in a job that has nothing else."""

    def __init__(self):
        super().__init__()
        self.action = read_example("action/action.yml")
        for step in self.action["runs"]["steps"]:
            if "uses" in step or "${{" in step["run"] or step["shell"] != "bash":
                problems.append(f"action: a step that is not pinned, not bash or pasted together: {step['name']}")

    def play(self, name, target, label=False):
        machine = Machine(f"action-{name}", 0)
        machine.git("checkout", "-q", "--detach", f"refs/remotes/origin/{target or name}")
        if target:
            machine.git("merge", "-q", "--no-ff", "-m", "merge", f"refs/remotes/origin/{name}")
        machine.hand_over()
        summary, output = WORK / f"action-{name}.md", WORK / f"action-{name}.out"
        inputs = {key: row["default"] for key, row in self.action["inputs"].items()}
        expressions = self.expressions(target, label)
        inputs = {key: expressions.get(value, value) for key, value in inputs.items()}
        if any("${{" in value for value in inputs.values()):
            problems.append("action: another default than this test knows")
        variables = {"GITHUB_WORKSPACE": str(machine.folder), "GITHUB_STEP_SUMMARY": str(summary), "GITHUB_OUTPUT": str(output)}
        code, log = 0, ""
        for step in self.action["runs"]["steps"]:
            if step.get("if") == "${{ inputs.package != '' }}" and inputs["package"] == "":
                continue
            values = {key: inputs[re.fullmatch(r"\$\{\{ inputs\.([\w-]+) \}\}", value)[1]] for key, value in step.get("env", {}).items()}
            done = machine.run(["bash", "--noprofile", "--norc", "-eo", "pipefail"], step["run"], {**machine.variables, **variables, **values})
            log += done.stdout + done.stderr
            code = code or done.returncode
        if f"exit-code={code}\n" != (output.read_text() if output.exists() else ""):
            problems.append(f"action: {name}: its output is not exit-code={code}")
        return code, log, summary.read_text() if summary.exists() else "", machine


    def install_archive(self):
        """With an archive that holds a program: the steps after it find this one; with another sum it is not unpacked."""
        folder = WORK / "archive"
        (folder / "luxgate-1-linux-x86_64/bin").mkdir(parents=True)
        program = folder / "luxgate-1-linux-x86_64/bin/luxgate"
        program.write_text("#!/bin/sh\necho of the archive\n")
        program.chmod(0o755)
        archive, paths = folder / "luxgate-1-linux-x86_64.tar.gz", folder / "path"
        subprocess.run(["tar", "-czf", archive, "-C", folder, "luxgate-1-linux-x86_64"], check=True)
        sha256 = hashlib.sha256(archive.read_bytes()).hexdigest()
        step = self.action["runs"]["steps"][0]
        for given, code in ((sha256, 0), (sha256[::-1], 1)):
            paths.write_text("")
            variables = {**os.environ, "PACKAGE": str(archive), "SHA256": given, "GITHUB_PATH": str(paths)}
            done = subprocess.run(["bash", "-eo", "pipefail", "-c", step["run"]], env=variables, capture_output=True, text=True)
            if done.returncode != code:
                problems.append(f"action: the archive: exit code {done.returncode}, expected {code}: {done.stderr}")
            found = paths.read_text().strip()
            if code == 0 and subprocess.run([f"{found}/luxgate"], capture_output=True, text=True).stdout != "of the archive\n":
                problems.append(f"action: the archive's program is not found in '{found}'")
            if code != 0 and found:
                problems.append("action: an archive of another sum was unpacked")


class GitLab:
    def __init__(self):
        self.job = read_example("gitlab.yml")["luxgate"]

    def play(self, name, target, label=False):
        """As GitHub.play; a request is its branch, not a merge."""
        machine = Machine(f"{type(self).__name__.lower()}-{name}", int(self.job["variables"].get("GIT_DEPTH", 20)))
        machine.git("checkout", "-q", "--detach", f"refs/remotes/origin/{name}")
        machine.hand_over()
        variables = {"CI_PROJECT_DIR": str(machine.folder), **self.job["variables"]}
        if target:
            variables["CI_MERGE_REQUEST_TARGET_BRANCH_NAME"] = target
        if label:
            variables["CI_MERGE_REQUEST_LABELS"] = "office,accept-weaker"
        done = machine.run(["sh", "-e"], "\n".join(self.job["script"]), variables)
        summary = machine.folder / "out/summary.md"
        return done.returncode, done.stdout + done.stderr, summary.read_text() if summary.exists() else "", machine


class GitLabComponent(GitLab):
    """The component, with its inputs as by default."""

    def __init__(self):
        spec, jobs = yaml.safe_load_all((EXAMPLES / "component/templates/luxgate.yml").read_text())
        inputs = {key: (row or {}).get("default", "given") for key, row in spec["spec"]["inputs"].items()}

        def filled(value):
            if isinstance(value, dict):
                return {key: filled(item) for key, item in value.items()}
            if isinstance(value, list):
                return [filled(item) for item in value]
            return re.sub(r"\$\[\[ inputs\.([\w-]+) \]\]", lambda found: inputs[found[1]], value) if isinstance(value, str) else value

        self.job = filled(jobs["luxgate"])
        if any("$[[" in line for line in jobs["luxgate"]["script"]):
            problems.append("component: a value is pasted into a script")


def expect(name, done, code, words):
    got, log, summary, machine = done
    found = [] if got == code else [f"exit code {got}, expected {code}"]
    found += [f"'{word}' is missing" for word in words if word not in (summary if code != 2 else log + summary)]
    found += [f"'{file}' was made" for file in machine.folder.rglob("pwned*")]
    problems.extend(f"{name}: {problem}" for problem in found)
    if found:
        print(f"--- {name}\n{log}\n{summary}")
    return machine


play_day(GitHub())
GitHubAction().install_archive()
for system in (GitHub(), GitHubAction(), GitLab(), GitLabComponent()):
    kind = type(system).__name__
    expect(f"{kind}: main", system.play("main", None), 0, ["pass"])
    for name, (target, code, words) in REQUESTS.items():
        machine = expect(f"{kind}: {name}", system.play(name, target), code, words)
        if name == "forged":
            continue
        if name == "weaker":
            for left in WORK.glob("*-weaker*"):
                shutil.rmtree(left) if left.is_dir() else left.unlink()
            machine = expect(f"{kind}: weaker, accepted", system.play(name, target, True), 0, ["room-03.xml", "the label accept-weaker"])
            code = 0
        out = machine.folder / "out"
        files = ("luxgate.sarif", "report.txt", "report.html") if kind.startswith("GitHub") else ("junit.xml", "quality.json", "report.html")
        missing = [file for file in files if not (out / file).exists()]
        problems.extend(f"{kind}: {name}: {file} is missing" for file in missing)
        if missing:
            continue
        if kind.startswith("GitHub"):
            sarif = json.loads((out / "luxgate.sarif").read_text())
            if code == 1 and not any(result.get("baselineState") in ("new", "updated") for run in sarif["runs"] for result in run["results"]):
                problems.append(f"{kind}: {name}: nothing in SARIF")
        elif code == 1 and ('failures="0"' in (out / "junit.xml").read_text().split("<testsuite ")[0] or not json.loads((out / "quality.json").read_text())):
            problems.append(f"{kind}: {name}: nothing in JUnit or code quality")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
