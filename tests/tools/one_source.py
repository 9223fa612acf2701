"""Numbers of one public source: a note once per report, and exit code 2 for whoever names them (--strict=one-source, a policy).

    one_source.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import pathlib
import shutil
import subprocess
import sys

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
PACK = """<rule-pack id="own" edition="1" title="Own" version="1" kind="contract" status="published" licence="internal" role="task">
<plane role="task" orientation="horizontal-up" heights="0 2"/>
<row ref="office" name="office" trust="confirmed"/>
<check id="Em" role="task" quantity="planar" statistic="average" at-least="100 lx" trust="{trust}"/>
</rule-pack>"""
POLICY = '<luxgate-policy version="1" name="House" every-space="nothing"><fatal-warnings ids="{ids}"/></luxgate-policy>'
NOTE = "Numbers of one row rest on one public source: Own:1 office."
WARNING = "warning[one-source]: the numbers of 1 row rest on one public source: Own:1 office; compare them with your copy of the standard"
TEXTS = ["text", "csv", "html", "junit", "sarif", "sarif-all", "github", "gitlab", "markdown"]
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code):
    done = subprocess.run([PROGRAM, *words], cwd=WORK, capture_output=True, text=True, check=False)
    expect(done.returncode == code, f"{words}: exit code {done.returncode}, expected {code}\n{done.stdout[-400:]}{done.stderr}")
    return done


def check(*words, code=0, pack="one.xml"):
    return run("check", "a.xml", "--rules", pack, "--pictures", "off", "--max-paths", "256", *words, code=code)


shutil.rmtree(WORK, ignore_errors=True)
small_designs.write(WORK / "a.xml", far=False)
design = (WORK / "a.xml").read_text()
own_limit = '<require id="mean" quantity="average" at-least="100"/>'
expect(own_limit in design, "the small design has another requirement")
(WORK / "a.xml").write_text(design.replace(own_limit, '<require pack="own" row="office"/>'))
# Without another warning, so that --strict alone finds nothing.
photometry = WORK / "spot.ies"
photometry.write_text(photometry.read_text().replace("[MANUFAC]", "[TESTLAB] none\n[ISSUEDATE] 2026-01-01\n[MANUFAC]"))
for name, trust in (("one", "single-source"), ("none", "unverified"), ("two", "confirmed")):
    (WORK / f"{name}.xml").write_text(PACK.format(trust=trust))

# A note in every report; no warning, and the exit code of the verdicts.
for kind in TEXTS:
    done = check("--format", kind)
    expect(done.stdout.count(NOTE) == 1, f"{kind} has the note {done.stdout.count(NOTE)} times")
    expect(done.stdout.count("one public source") == 1, f"{kind} says it beside requirements, too")
    expect("one-source]" not in done.stderr, f"{kind}: a warning that nobody has asked for\n{done.stderr}")
client = check("--format", "html", "--detail", "client").stdout
expect(client.count(NOTE) == 1, "the client's document has no note, or several")
result = json.loads(check("--format", "json").stdout)
expect(result["one_source"] == ["Own:1 office"], f"JSON: {result.get('one_source')}")
finding = result["projects"][0]["spaces"][0]["planes"][0]["findings"][0]
expect(finding["clause"] == "Own:1 office [one public source]", f"JSON: {finding['clause']}")

# It counts for whoever names it, and for nobody else.
for words in (["--strict=one-source"], ["--strict", "--strict=one-source"]):
    done = check(*words, code=2)
    expect(done.stderr.count(WARNING) == 1, f"{words}: the warning is not there once\n{done.stderr}")
check("--strict", code=0)
check("--strict=one-source", code=0, pack="two.xml")
for ids, code in (("one-source", 2), ("values-set one-source", 2), ("all one-source", 2), ("all", 0), ("values-set", 0)):
    (WORK / "policy.xml").write_text(POLICY.format(ids=ids))
    check("--policy", "policy.xml", code=code)
for command in ("validate", "plan"):
    for option, code in (([], 0), (["--strict"], 0), (["--strict=one-source"], 2)):
        run(command, "a.xml", "--rules", "one.xml", *option, code=code)
for kind in TEXTS:
    done = check("--strict=one-source", "--format", kind, code=2)
    expect("the numbers of 1 row rest on one public source" in done.stdout + done.stderr, f"{kind} does not say what counts")
    expect(kind != "text" or "1 warning (that count: 1)" in done.stdout, f"the table does not say that a warning counts\n{done.stdout}")

# What nobody has verified stays beside the requirement, and is no number of one source.
check("--strict=one-source", code=0, pack="none.xml")
for kind in ("text", "csv", "html", "junit", "sarif-all", "markdown"):
    text = check("--format", kind, pack="none.xml").stdout
    expect("nverified requirement" in text, f"{kind} does not say that a number is not verified")
    expect("public source:" not in text, f"{kind} has a note of one source")

print("\n".join(problems))
sys.exit(1 if problems else 0)
