#!/usr/bin/env python3
"""Whether `check --advice` says what makes a project pass, in every format, and only where something is not met.

  check_advice.py LUXGATE EXAMPLES WORK

Exit code 1: something does not hold.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

failures = []


def expect(condition, words):
    if not condition:
        failures.append(words)
        print("FAILED: " + words)


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def project(requirements, scenes="", groups=("a", "b")):
    lights = "".join(f'<luminaire id="L{number}" type="t" position="{1.5 + 3 * number} 2 2.79"'
                     + (f' group="{name}"' if name else "") + "/>" for number, name in enumerate(groups))
    return f"""<luxgate version="1" maintenance-factor="0.8">
<material id="m" reflectance="0.5"/><luminaire-type id="t" photometry="batwing_1200.ies" power-w="36"/>{scenes}
<room id="r" name="Office" size="6 4 2.8" floor="m" ceiling="m" walls="m">{lights}
<plane id="p" name="Desk" height="0.75" margin="0.5">{requirements}</plane></room></luxgate>
"""


def check(luxgate, path, *options, advice=True):
    """Exit code, the project in the result, and the reports by format."""
    stem = path[:-4]
    files = {kind: f"{stem}.{kind}" for kind in ("json", "html", "markdown", "text")}
    done = run(luxgate, "check", path, "--quiet", "--pictures", "off", *(["--advice"] if advice else []), *options,
               *(word for kind, file in files.items() for word in ("--format", f"{kind}={file}")))
    if done.returncode == 2:
        return 2, None, done.stderr
    told = {kind: read(file) for kind, file in files.items()}
    return done.returncode, json.loads(told["json"])["projects"][0], told


def says_in_all(told, words, title="Suggested dimming levels"):
    expect(re.search(r'<h3 id="advice1"[^>]*>' + title, told["html"]) and title in told["text"]
           and f"**{title}**" in told["markdown"], f"every format has the title: {told['text']}")
    for one in words:
        for kind in ("html", "text", "markdown"):
            plain = told[kind].replace("&lt;", "<").replace("&gt;", ">").replace("\\", "")
            expect(one in plain, f"{kind} says '{one}': {told['text']}")


def main():
    luxgate, examples, work = sys.argv[1:4]
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    shutil.copy(os.path.join(examples, "04-office", "photometry", "batwing_1200.ies"), work)

    def case(name, *parts, **more):
        return write(os.path.join(work, name + ".xml"), project(*parts, **more))

    # A scene that is too dark: the levels are those of advise, and pass when they are taken.
    scene = '<scene id="eve"><dim group="a" level="0.1"/><dim group="b" level="0.2"/></scene>'
    asked = '<require id="mean" quantity="average" at-least="100" scene="eve"/>' \
            '<require id="full" quantity="average" at-least="50"/>'
    path = case("dark", asked, scenes=scene)
    code, found, told = check(luxgate, path)
    one = found["advice"][0]
    expect(code == 1 and len(found["advice"]) == 1 and one["scene"] == "eve" and one["outcome"] == "levels",
           f"only the scene that fails: {code} {found['advice']}")
    expect(one["passing"] == one["asked"] == 1 and not one["not_met"] and not one["excluding"], f"it passes: {one}")
    levels = {group["group"]: group["level"] for group in one["groups"]}
    by_advise = json.loads(run(luxgate, "advise", path, "--scene", "eve", "--quiet", "--json").stdout)["scenes"][0]
    expect(levels == {group["group"]: group["level"] for group in by_advise["groups"]} and one["now"] == by_advise["now"]
           and one["advised"] == by_advise["advised"], f"the levels are those of advise: {one} {by_advise['groups']}")
    text = read(path)
    for group, level in (("a", "0.1"), ("b", "0.2")):
        text = text.replace(f'group="{group}" level="{level}"', f'group="{group}" level="{levels[group]!r}"')
    done = run(luxgate, "check", write(os.path.join(work, "lit.xml"), text), "--seed", "88", "--quiet")
    expect(done.returncode == 0, f"with these levels the project passes: {done.returncode} {levels}")
    says_in_all(told, ["Light scene eve", "With these levels, 1 of 1 requirements pass", f"{one['advised']:.1f} W",
                       "10 %", f"{100 * levels['a']:g} %"])
    tree = xml.etree.ElementTree.fromstring(told["html"].replace("<!DOCTYPE html>", ""))
    table = [one for one in tree.iter("table") if one.get("class") == "advice"]
    expect(len(table) == 1 and len(list(table[0].iter("tr"))) == 3, "a row for each group")
    for kind in ("html", "markdown", "text"):
        again = run(luxgate, "report", path[:-4] + ".json", "--quiet", "--format", kind)
        expect(again.stdout == told[kind], f"{kind} of the result is the same: {again.stderr}")
    same = check(luxgate, path, "--jobs", "1")
    expect(same[1] == found and same[2] == told, "the same with one thread")
    expect("--advice" in json.loads(told["json"])["provenance"]["command_line"], "the command line has it")

    # Nobody has asked; nothing to be said.
    code, found, told = check(luxgate, path, advice=False)
    expect(code == 1 and "advice" not in found and "Suggested dimming levels" not in told["html"] + told["text"], "not asked")
    code, found, told = check(luxgate, case("met", '<require quantity="average" at-least="50"/>'))
    expect(code == 0 and found["advice"] == [] and "Suggested dimming levels" not in told["html"] + told["text"]
           + told["markdown"], f"all is met: {code} {found.get('advice')}")
    code, found, told = check(luxgate, case("besides", '<require quantity="average" at-least="50"/>'
                                                       '<require quantity="power-density" at-most="0.5"/>'))
    expect(code == 1 and found["advice"] == [], f"what is not met hangs on no levels: {code} {found.get('advice')}")
    says_in_all(told, ["do not depend on dimming levels"])

    # More light, and what excludes each other.
    both = '<require id="mean" quantity="average" at-least="180"/><require id="top" quantity="maximum" at-most="60"/>'
    code, found, told = check(luxgate, case("both", both))
    one = found["advice"][0]
    expect(one["outcome"] == "contradiction" and {name["requirement"] for name in one["excluding"]} == {"mean", "top"}
           and one["groups"] == [] and one["asked"] == 0, f"contradiction: {one}")
    says_in_all(told, ["No levels meet everything", "Office, Desk: average ≥ 180 lx", "Office, Desk: maximum ≤ 60 lx"])
    code, found, told = check(luxgate, case("weak", '<require id="mean" quantity="average" at-least="900"/>'))
    one = found["advice"][0]
    expect(one["outcome"] == "more-light" and max(group["level"] for group in one["groups"]) > 1, f"more light: {one}")
    says_in_all(told, ["With this much more light, 1 of 1 requirements would pass", "this is not checked",
                       "Office, Desk: average ≥ 900 lx"])
    code, found, told = check(luxgate, case("other", '<require id="g" quantity="uniformity-gradient" at-most="1"/>'
                                            .replace("uniformity-", "")))
    one = found["advice"][0]
    expect(one["outcome"] == "none-found" and "no requirement is a condition" in one["reason"], f"why none: {one}")
    says_in_all(told, ["No levels were found: no levels were searched, because no requirement"])
    # What hangs on levels, and not on points: nothing is said of it that is not so.
    shutil.copy(os.path.join(examples, "05-failing-corridor", "photometry", "lambert_panel_600.ies"), work)
    road = """<luxgate version="1" maintenance-factor="0.8"><material id="g" reflectance="0.5"/>
<luminaire-type id="panel" photometry="lambert_panel_600.ies" flux-lm="4000" power-w="30"/>
<scene id="s"><dim group="a" level="0.2"/></scene>
<road id="rd" width="7" lanes="2" spacing="30" surface="R3">
<luminaire-row id="row" type="panel" side="right" height="8" group="a"/>
<luminaire-row id="other" type="panel" side="left" height="8" group="b"/>REQUIRE</road></luxgate>
"""
    path = write(os.path.join(work, "road.xml"), road.replace(
        "REQUIRE", '<require quantity="road-luminance" at-least="0.9" scene="s"/>'))
    code, found, told = check(luxgate, path)
    one = found["advice"][0] if found and found["advice"] else {}
    expect(code == 1 and one.get("outcome") == "none-found" and "no levels were searched" in one["reason"], f"a road: {one}")
    expect("do not depend on dimming levels" not in told["html"] + told["text"], "road luminance hangs on levels")
    # Levels that save power of what passes mend nothing.
    path = write(os.path.join(work, "road-2.xml"), road.replace(
        "REQUIRE", '<require quantity="road-luminance" at-least="0.9" scene="s"/><strip id="way" side="right" gap="0.5" '
        'width="2"><require quantity="average" at-least="0.01" scene="s"/></strip>'))
    code, found, told = check(luxgate, path)
    one = found["advice"][0] if found and found["advice"] else {}
    expect(one.get("outcome") == "none-found" and "unmet requirements were not searched" in one["reason"], f"a road: {one} {told}")
    # Of a road one luminaire of each row counts.
    path = write(os.path.join(work, "road-3.xml"), road.replace(
        "REQUIRE", '<strip id="way" side="right" gap="0.5" width="2"><require quantity="average" at-least="0.01"/></strip>'))
    done = json.loads(run(luxgate, "advise", path, "--quiet", "--json").stdout)["scenes"][0]
    expect(done["now"] == 60 and [row["luminaires"] for row in done["groups"]] == [1, 1], f"a road's power: {done['now']}")
    # Only darkness meets a limit of nothing.
    dark = '<require id="none" quantity="maximum" at-most="0" scene="eve"/>'
    code, found, told = check(luxgate, case("nothing", dark, scenes=scene))
    one = found["advice"][0]
    expect(one["outcome"] == "levels" and one["advised"] == 0 and one["passing"] == 1, f"darkness: {one}")
    # Luminaires of lists cannot be dimmed without a group.
    write(os.path.join(work, "list.csv"), "name,type,x_m,y_m,z_m\na,t,1.5,2,2.79\nb,t,4.5,2,2.79\n")
    text = project('<require quantity="maximum" at-most="150"/>', groups=()).replace(
        "<plane", '<luminaires id="c" file="list.csv"/><plane')
    for tag, words in (("en", "2 of 2 luminaires without a group"), ("de", "2 von 2 Leuchten ohne Gruppe")):
        code, found, told = check(luxgate, write(os.path.join(work, "listed.xml"), text), "--language", tag)
        expect(words in told["text"] and words in told["html"] and "others" not in told["text"], f"lists: {told['text']}")
    # What is not met although the levels are found.
    mixed = '<require id="mean" quantity="average" at-least="100" scene="eve"/>' \
            '<require id="g" quantity="gradient" at-most="1.01" scene="eve"/>'
    code, found, told = check(luxgate, case("mixed", mixed, scenes=scene))
    one = found["advice"][0]
    if one["outcome"] == "levels":
        expect([name["requirement"] for name in one["not_met"]] == ["g"] and one["passing"] == 1 and one["asked"] == 2,
               f"what stays unmet is said: {one}")
        says_in_all(told, ["Not met with these levels", "With these levels, 1 of 2"])
    else:
        expect(False, f"levels for the average: {one}")

    # Names are no markup.
    hostile = "a &lt;b&gt; [x](http://e)"
    text = read(case("hostile", asked, scenes=scene.replace('"a"', f'"{hostile}"'), groups=(hostile, "b")))
    text = text.replace('name="Desk"', f'name="{hostile}"').replace('at-least="100"', 'at-least="900"')
    code, found, told = check(luxgate, write(os.path.join(work, "hostile.xml"), text))
    expect(code == 1 and found["advice"][0]["outcome"] == "more-light", f"odd names: {found and found['advice']}")
    expect("a <b>" not in told["html"] and "[x](http" not in told["markdown"] and "<b> [x]" in told["text"], "no markup")

    # Other languages.
    for tag, title in (("de", "Vorgeschlagene Dimmstufen"), ("fr", "Niveaux de gradation proposés")):
        for name in ("dark", "both", "weak"):
            told = check(luxgate, os.path.join(work, name + ".xml"), "--language", tag)[2]
            says_in_all(told, [], title)
            expect("No levels" not in told["html"] and "With these" not in told["text"], f"{tag}: {told['text']}")

    # Of several projects that which fails has it.
    done = run(luxgate, "check", os.path.join(work, "met.xml"), os.path.join(work, "dark.xml"), "--advice", "--quiet",
               "--json")
    parts = json.loads(done.stdout)["projects"]
    expect(parts[0]["advice"] == [] and len(parts[1]["advice"]) == 1, "each project has its own")
    # Many at the same time, each as alone.
    many = []
    for number in range(12):
        name = f"many-{number}"
        many.append(case(name, asked.replace('at-least="100"', f'at-least="{60 + 10 * number}"'), scenes=scene))
    alone = [check(luxgate, one)[1]["advice"] for one in many]
    done = run(luxgate, "check", *many, "--advice", "--quiet", "--json", "--jobs", "4")
    together = [one["advice"] for one in json.loads(done.stdout)["projects"]]
    expect(together == alone and len({str(one) for one in alone}) > 6, "projects of a batch have the advice that they have alone")
    # --set is part of the project.
    path = os.path.join(work, "dark.xml")
    code, found, _ = check(luxgate, path, "--set", "t.power-w=18")
    expect(found["advice"][0]["now"] == by_advise["now"] / 2, f"what is set counts: {found['advice'][0]['now']}")

    # In another order of planes the same: levels, and of several sets that exclude each other the same one.
    shutil.copytree(os.path.join(examples, "04-office"), os.path.join(work, "office"), dirs_exist_ok=True)
    text = read(os.path.join(work, "office", "project.xml"))
    text = re.sub(r'<luminaire-line id="C".*/>', "", text)
    text = re.sub(r'<dim group="corridor".*/>', "", text)
    text = re.sub(r'(<luminaire-line .*)count="5"', r'\1count="3"', text)
    planes = re.findall(r"<plane .*?</plane>", text, re.S)
    turned = text
    for number, plane in enumerate(planes):
        turned = turned.replace(plane, f"@{number}@")
    for number, plane in enumerate(reversed(planes)):
        turned = turned.replace(f"@{number}@", plane)
    both = []
    for number, one in enumerate((text, turned)):
        advice = check(luxgate, write(os.path.join(work, "office", f"order-{number}.xml"), one))[1]["advice"]
        for scene_advice in advice:
            for key in ("excluding", "not_met"):
                scene_advice[key].sort(key=str)
        both.append(advice)
    expect(len(planes) > 2 and both[0] and both[0] == both[1], f"advice in another order of planes: {both}")

    # What cannot be.
    for words, options in (("--stored-only", ["--stored-only", "--store", os.path.join(work, "store")]),
                           ("--shard", ["--shard", "1/2", "--store", os.path.join(work, "store")]),
                           ("--vpl", ["--vpl", "x"])):
        done = run(luxgate, "check", path, "--advice", *options)
        expect(done.returncode == 2 and words in done.stderr and "--advice" in done.stderr, f"{words}: {done.stderr}")
    result = read(os.path.join(work, "dark.json"))
    for old, new in (('"passing": 1', '"passing": 7'), ('"outcome": "levels"', '"outcome": "good"'),
                     ('"level": 0.', '"level": 50.'), ('"now": 0.1', '"now": -0.1')):
        expect(old in result, f"the result has {old}")
        changed = write(os.path.join(work, "changed.json"), result.replace(old, new))
        done = run(luxgate, "report", changed)
        expect(done.returncode == 2 and "advice" in done.stderr, f"{new} is refused: {done.returncode} {done.stderr}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
