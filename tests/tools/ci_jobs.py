"""The jobs in examples/ci, run as GitHub and GitLab would run them, for requests that do this and that to twelve designs.

    ci_jobs.py LUXGATE FOLDER    FOLDER is made anew
"""
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


def write(changes={}):
    """All twelve, some of them changed: {name: what is other}."""
    shutil.rmtree(team.folder / "designs", ignore_errors=True)
    for name, values in DESIGNS.items():
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
    "weaker": ("main", 1, ["room-03.xml", "asks less", "≥ 500 lx", "≥ 400 lx"]),
    "renamed": ("main", 0, ["nothing became worse"]),
    "better": (HOSTILE, 0, ["▲ better", "room-05.xml"]),
    "deleted": ("main", 1, ["room-09.xml"]),
    "unreadable": ("main", 2, ["room-02.xml"]),
    "forged": ("main", 2, ["out is in git"]),
    "dimmer": ("main", 1, ["room-11.xml", "✗ broken"]),
}


class Machine:
    """A clone as the system makes it, of another user's as in a container."""

    def __init__(self, name, depth):
        self.folder = WORK / name
        self.home = WORK / f"{name}-home"
        self.variables = {**VARIABLES, **git_repository.environment(self.home), "PATH": VARIABLES["PATH"]}
        limits = [] if depth == 0 else ["--depth", str(depth)]
        subprocess.run(["git", "clone", "-q", "--no-checkout", *limits, f"file://{team.folder}", self.folder], check=True, env=VARIABLES)

    def git(self, *arguments):
        done = subprocess.run(["git", "-c", "user.name=A", "-c", "user.email=a@example.invalid", *arguments], cwd=self.folder, env=VARIABLES,
                              capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{self.folder.name}: git {' '.join(arguments)}: {done.stderr}")

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

    def play(self, name, target, label=False):
        """target: None for a push to `name`. Exit code, log, summary, folder."""
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
