"""luxgate.toml: where it is found, what it may say, what beats it, and that every result can be made again without it.

    config.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

import git_repository
import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PACK = """<rule-pack id="own" edition="1" title="Own" version="1" kind="contract" status="published" licence="internal" role="task">
<plane role="task" orientation="horizontal-up" heights="0 2"/>
<row ref="office" name="office" trust="confirmed"/>
<check id="Em" role="task" quantity="planar" statistic="average" at-least="100 lx" trust="confirmed"/>
</rule-pack>"""
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code, says="", at="repository/designs"):
    done = subprocess.run([PROGRAM, *words], cwd=WORK / at, capture_output=True, text=True, check=False)
    expect(done.returncode == code, f"{words}: exit code {done.returncode}, expected {code}\n{done.stdout[-400:]}{done.stderr}")
    expect(says in done.stderr, f"{words}: '{says}' is not said:\n{done.stderr}")
    return done


def check(*words, code=1, **others):
    return run("check", *words, "--pictures", "off", code=code, **others)


def provenance(*words, **others):
    return json.loads(check(*words, "--format", "json", **others).stdout)["provenance"]


def config(text, at="repository"):
    (WORK / at / "luxgate.toml").write_text(text)


shutil.rmtree(WORK, ignore_errors=True)
top = WORK / "repository"
small_designs.write(top / "designs" / "a.xml")
small_designs.write(top / "designs" / "deep" / "b.xml")
small_designs.write(WORK / "elsewhere" / "c.xml")
(top / ".git").mkdir()
(top / "own.xml").write_text(PACK)

# Above the top of the repository nothing is looked for.
config("tolerance = 0.3\n", at=".")
expect(provenance("a.xml")["tolerance"] == 0.02, "a file above the repository was taken")
expect(provenance("c.xml", at="elsewhere")["tolerance"] == 0.3, "a file two folders up was not taken")
(WORK / "luxgate.toml").unlink()

# Found upwards from the project, wherever the program runs.
config('tolerance = 0.05\nconfidence = "99%"\nlanguage = "de"\nby-luminaire = true\nmax-paths = 256\n')
before = provenance("a.xml")
expect((before["tolerance"], before["confidence"], before["max_paths"]) == (0.05, 0.99, 256), f"not taken: {before}")
expect(provenance("repository/designs/a.xml", at=".")["tolerance"] == 0.05, "it is looked for where the program runs")
expect("Anforderung" in check("a.xml", "--format", "markdown").stdout, "language = \"de\" is not German")

# The command line beats it, and the command in the result makes it again.
expect(provenance("a.xml", "--tolerance", "0.02")["tolerance"] == 0.02, "the command line does not beat the file")
expect("--no-config" in before["command_line"] and "--tolerance 0.05" in before["command_line"], f"command: {before['command_line']}")
again = provenance("a.xml", "--tolerance", "0.02")["command_line"]
config("tolerance = 0.4\nconfidence = 0.6\n")
repeated = provenance(*shlex.split(again)[2:])
expect((repeated["tolerance"], repeated["confidence"]) == (0.02, 0.99), f"'{again}' gave {repeated}")
expect(provenance("a.xml", "--no-config")["tolerance"] == 0.02, "--no-config")
(WORK / "other.toml").write_text("seed = 7\n")
expect(provenance("a.xml", "--config", "../../other.toml")["seed"] == 7, "--config")

# The closest one alone.
config("seed = 5\n", at="repository/designs/deep")
expect(provenance("deep/b.xml")["tolerance"] == 0.02 and provenance("deep/b.xml")["seed"] == 5, "two files are mixed")
check("a.xml", "deep/b.xml", code=2, says="these projects have different settings ('deep/luxgate.toml', '../luxgate.toml')")
check("a.xml", "../../elsewhere/c.xml", code=2, says="(none, '../luxgate.toml')")
check("a.xml", "deep/b.xml", "--no-config")
check(".", code=2, says="these projects have different settings")
expect(provenance("deep")["seed"] == 5, "a folder of projects has not their settings")
(WORK / "list.txt").write_text("deep/b.xml\n")
expect(provenance("--files-from", "../../list.txt")["seed"] == 5, "listed projects have not their settings")
expect("5  (deep/luxgate.toml:1)" in run("config", "show", "deep", code=0).stdout, "config show FOLDER")

# Rule packs and warnings; lists.
config('rules = ["own.xml"]\nstrict = ["values-set", "maintenance-not-stated"]\n')
check("a.xml", "--set", "mean.at-least=1", code=2)
check("a.xml", "--set", "mean.at-least=1", "--no-config", code=1)
asks = (top / "designs" / "a.xml").read_text().replace("</plane>", '<require pack="own" row="office"/></plane>', 1)
(top / "designs" / "asks.xml").write_text(asks)
expect("Own:1 office" in check("asks.xml", "--format", "csv").stdout, "rules are not loaded")
run("validate", "asks.xml", code=0)
run("plan", "asks.xml", code=0)
check("asks.xml", "--no-config", code=2)

# What shows them.
shown = run("config", "show", "a.xml", code=0).stdout
expect("rules         [../own.xml]  (../luxgate.toml:1)" in shown and "seed          1  (by default)" in shown, shown)
shown = json.loads(run("config", "show", "a.xml", "--json", code=0).stdout)
for setting, words in (("goal", "verdict"), ("tolerance", "0.02"), ("confidence", "0.95"), ("seed", "1"), ("replicates", "16"), ("max-paths", "65536"),
                       ("by-luminaire", "off"), ("decimal", "that of the language"), ("paper", "a4"), ("scale", "room"), ("palette", "cividis"), ("passes", "fold"), ("notes", "off")):
    expect(shown["settings"][setting] == {"from": "default", "words": words}, f"default of {setting}: {shown['settings'][setting]}")
expect(shown["settings"]["strict"] == {"value": ["values-set", "maintenance-not-stated"], "from": "../luxgate.toml", "line": 2}, str(shown))
expect("No luxgate.toml here" in run("config", "show", code=0, at="elsewhere").stdout, "config show without a file")

# A batch has them as options, the same in all of its parts.
config("tolerance = 0.05\nlanguage = \"de\"\n")
for more, options, others in (([], ["--no-config", "--tolerance 0.05", "--language de"], []), (["--no-config"], ["--no-config"], ["--tolerance"])):
    script = run("submit", "a.xml", "--engine", "local", "--store", "looks", "--format", "text=out/x.txt", *more, code=0).stdout
    # Every part and the merge take the one list of options.
    checks = [line for line in script.splitlines() if '"$luxgate" check ' in line]
    expect(len(checks) == 2 and all('check "${options[@]}" ' in line for line in checks), f"submit {more}: {checks}")
    expect(all(word in script for word in options) and not any(word in script for word in others), f"submit {more}: {script}")
run("submit", "a.xml", "--engine", "local", "--store", "looks", "--plane", "desk", code=2, says="unknown option '--plane'")

# An owner's policy stands above what lies in the projects' repository.
(WORK / "policy.xml").write_text('<luxgate-policy version="1" name="Owner" every-space="nothing"/>')
config("tolerance = 0.4\n")
expect(provenance("a.xml", "--policy", "../../policy.xml")["tolerance"] == 0.02, "a project's settings hold beside a policy")

# Nor does a request change what it is judged by: beside --against the file is that of the revision.
variables = git_repository.environment(WORK / "home")
team = git_repository.Repository(WORK / "team", variables)
small_designs.write(team.folder / "designs" / "a.xml")
(team.folder / "luxgate.toml").write_text("tolerance = 0.05\n")
team.commit("first")
against = dict(at="team/designs", code=1)
for text, expected in (("tolerance = 0.05\n", 0.05), ("tolerance = 0.4\n", 0.05), ("not toml", 0.05), (None, 0.05)):
    (team.folder / "luxgate.toml").unlink(missing_ok=True)
    if text:
        (team.folder / "luxgate.toml").write_text(text)
    got = provenance("a.xml", "--against", "HEAD", **against)["tolerance"]
    expect(got == expected, f"--against, {text!r}: {got}")
# What a request changes of how it will be judged is a question of its own, and stops the gate.
(team.folder / "luxgate.toml").write_text("tolerance = 0.05\nconfidence = 0.6\nlanguage = \"de\"\n")
gate = check("a.xml", "--against", "HEAD", "--gate", "regression", "--format", "json", "-q", at="team/designs", code=1)
questions = json.loads(gate.stdout)["revision"]["questions"]
expect([(one["change"], one["part"], one["after"]) for one in questions] == [("exchanged", "confidence", "confidence 0.6")], str(questions))
(team.folder / "luxgate.toml").write_text("tolerance = 0.09\n")
gate = check("a.xml", "--against", "HEAD", "--gate", "regression", at="team/designs", code=1, says="config-of-revision")
expect("tolerance 0.09" in gate.stdout and "requires less" in gate.stdout, gate.stdout)
(team.folder / "luxgate.toml").unlink()
# Not by a link, either, in place of the folder that has settings of its own.
(team.folder / "designs" / "luxgate.toml").write_text("tolerance = 0.07\n")
team.commit("nearer")
(team.folder / "designs").rename(team.folder / "real")
(team.folder / "designs").symlink_to("real")
for folder in ("designs/a.xml", "designs"):
    got = provenance(folder, "--against", "HEAD", at="team", code=1)["tolerance"]
    expect(got == 0.07, f"--against, a link in place of {folder}: {got}")
(team.folder / "designs").unlink()
(team.folder / "real").rename(team.folder / "designs")
(team.folder / "designs" / "luxgate.toml").unlink()
team.git("rm", "-q", "--cached", "designs/luxgate.toml")
team.git("commit", "-q", "-m", "no settings")
(team.folder / "designs" / "luxgate.toml").write_text("tolerance = 0.4\n")
expect(provenance("a.xml", "--against", "HEAD", **against)["tolerance"] == 0.02, "--against: settings that are not merged hold")
expect(provenance("a.xml", **against)["tolerance"] == 0.4, "without --against the file on the disk does not hold")
check("a.xml", "--against", "nowhere", at="team/designs", code=2, says="--against nowhere")

# Errors: what, where, what is allowed.
for text, says in (
        ("tolerance = 0.05\ntolerance = 0.06\n", "../luxgate.toml:2:13: error[config-syntax]: not TOML: "),
        ("tolerance == 1\n", "luxgate.toml:1:"),
        ("tolerence = 0.05\n", "../luxgate.toml:1:1: error[config-unknown]: unknown setting 'tolerence'; allowed: rules, goal, tolerance"),
        ("[check]\ntolerance = 0.05\n", "unknown setting 'check'"),
        ("output = \"x\"\n", "unknown setting 'output'"),
        ("\n tolerance = 3\n", "../luxgate.toml:2:2: error[config-value]: setting 'tolerance': '3': "),
        ("tolerance = true\n", "setting 'tolerance': a value is needed (SHARE)"),
        ("tolerance = [0.1, 0.2]\n", "setting 'tolerance': it has one value, no list"),
        ("goal = 2020-01-01\n", "setting 'goal': a text, a number"),
        ("goal = \"speed\"\n", "setting 'goal': 'speed': "),
        ("by-luminaire = 1\n", "setting 'by-luminaire': true or false is needed"),
        ("seed = -1\n", "setting 'seed': '-1': "),
        ("seed = nan\n", "setting 'seed': 'nan': "),
        ("strict = [\"no-such-id\"]\n", "setting 'strict': "),
        ("rules = [\"/etc/hostname\"]\n", "only files of the folder of luxgate.toml, and below it, are allowed"),
        ("rules = [\"../elsewhere/spot.ies\"]\n", "only files of the folder"),
        ("rules = [\"link.xml\"]\n", "only files of the folder"),
        ("rules = \"designs\"\n", "files are allowed, folders are not"),
        ("seed = 1 # " + "x" * (1 << 16), "larger than 64 KiB"),
        ("a." * 32000 + "a = 1\n", "unknown setting 'a'"),
        ("seed = \"\xff", "luxgate.toml:1:")):
    (top / "link.xml").unlink(missing_ok=True)
    (top / "link.xml").symlink_to("/etc/hostname")
    config(text)
    check("a.xml", code=2, says=says)
    if "link" not in text:
        run("config", "show", "a.xml", code=2, says=says)
(top / "luxgate.toml").unlink()
(top / "luxgate.toml").symlink_to("/etc/hostname")
check("a.xml", code=2, says="../luxgate.toml: error[file-not-readable]: cannot read '../luxgate.toml'")
(top / "luxgate.toml").unlink()
# Of somebody else, in a folder where everybody may have put it: nobody has asked for that.
if os.geteuid() == 0:
    config("seed = 7\n")
    os.chown(top / "luxgate.toml", 12345, -1)
    check("a.xml", code=1)
    top.chmod(0o1777)
    for words in (["a.xml"], ["a.xml", "--strict"]):
        check(*words, code=2, says="belongs to another user")
    check("a.xml", "--no-config", code=1)
    check("a.xml", "--config", "../luxgate.toml", code=1)
    top.chmod(0o755)
    (top / "luxgate.toml").unlink()
check("a.xml", "--config", "none.toml", code=2, says="--config: 'none.toml' is no file")
check("a.xml", "--config", "a.xml", "--no-config", code=2, says="--no-config")

print("\n".join(problems))
sys.exit(1 if problems else 0)
