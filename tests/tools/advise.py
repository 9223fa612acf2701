#!/usr/bin/env python3
"""Whether what `luxgate advise` says holds.

  advise.py LUXGATE EXAMPLES WORK [PROJECTS]

Cases whose answer is known, then PROJECTS (default 6) random rooms that are known to pass at some levels: advice
must be found for each, must not cost more than these levels, and the project that it writes must pass a check with
random numbers that neither search nor advice have seen. Exit code 1: something does not hold.
"""

import json
import os
import random
import shutil
import subprocess
import sys
import xml.etree.ElementTree

try:
    import jsonschema
except ImportError:
    jsonschema = None

failures = []
schema = None


def expect(condition, words):
    if not condition:
        failures.append(words)
        print("FAILED: " + words)


def is_by_schema(advice):
    return not list(jsonschema.Draft7Validator(schema).iter_errors(advice))


def schema_finds(advice):
    """The schema is not one that everything fulfils."""
    for change in (lambda scene: scene.update(outcome="good"), lambda scene: scene.pop("groups"),
                   lambda scene: scene["requirements"][0]["before"].update(value="x"),
                   lambda scene: scene["limits"][0].update(requirement=-1),
                   lambda scene: scene["limits"][0].update(place_m=[1, 2]), lambda scene: scene.update(unit="kW")):
        changed = json.loads(json.dumps(advice))
        change(changed["scenes"][0])
        expect(not is_by_schema(changed), "the schema finds what is changed")


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def advise(luxgate, project, *options):
    done = run(luxgate, "advise", project, "--quiet", "--json", *options)
    advice = json.loads(done.stdout) if done.stdout.startswith("{") else None
    if advice and schema:
        expect(is_by_schema(advice), f"{project}: the advice is not what its schema says")
    return done.returncode, advice, done.stderr


def room(requirements, groups=(("a", "1.5 2 2.79"), ("b", "4.5 2 2.79")), scenes=""):
    lights = ""
    for number, (name, place) in enumerate(groups):
        group = f' group="{name}"' if name else ""
        lights += f'<luminaire id="L{number}" type="t" position="{place}"{group}/>'
    return f"""<luxgate version="1" maintenance-factor="0.8">
<material id="m" reflectance="0.5"/><luminaire-type id="t" photometry="batwing_1200.ies" power-w="36"/>{scenes}
<room id="r" size="6 4 2.8" floor="m" ceiling="m" walls="m">{lights}
<plane id="p" height="0.75" margin="0.5">{requirements}</plane></room></luxgate>
"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def known_cases(luxgate, examples, work):
    office = os.path.join(examples, "04-office")
    copied = os.path.join(work, "office")
    shutil.copytree(office, copied, dirs_exist_ok=True)
    dimmed = os.path.join(copied, "dimmed.xml")
    code, advice, _ = advise(luxgate, os.path.join(copied, "project.xml"), "--write", dimmed)
    full = advice["scenes"][0]
    expect(code == 0 and full["outcome"] == "levels" and full["is_all_met"], "the office has levels")
    expect(full["least"] <= full["advised"] < full["now"] == 540, "the office saves power")
    if schema:
        schema_finds(advice)
    expect(full["limits"] and all(one["saved_per_percent"] > 0 for one in full["limits"]), "it is said what limits")
    expect(all(one["after"]["verdict"] == "pass" for one in full["requirements"]), "every requirement is said to pass")
    done = run(luxgate, "check", dimmed, "--seed", "77", "--quiet")
    expect(done.returncode == 0, f"the office with these levels passes: {done.returncode} {done.stderr}")
    scene = xml.etree.ElementTree.parse(dimmed).find("scene[@id='advised']")
    levels = {dim.get("group"): float(dim.get("level")) for dim in scene}
    expect(levels == {row["group"]: row["level"] for row in full["groups"]}, "the levels are those that were said")
    written = advice.pop("written")
    expect(written["what"] == "levels" and written["passing"] == written["asked"] and written["not_met"] == [],
           f"it is said what was written: {written}")
    again, same, _ = advise(luxgate, os.path.join(copied, "project.xml"), "--jobs", "1")
    expect(again == code and same == advice, "the same advice with one thread")

    done = run(luxgate, "advise", os.path.join(copied, "project.xml"), "--quiet", "--format", "markdown")
    rows = [line for line in done.stdout.splitlines() if line.startswith("| ")]
    expected = sum(2 + len(one["groups"]) + len(one["requirements"]) for one in advice["scenes"])
    expect(done.returncode == 0 and len(rows) == expected,
           f"Markdown has a row for each group and requirement: {done.stdout}")
    expect("1 % looser" in done.stdout and "345.6 W" in done.stdout, f"Markdown says what limits: {done.stdout}")

    corridor = os.path.join(examples, "05-failing-corridor", "project.xml")
    code, advice, _ = advise(luxgate, corridor)
    expect(code == 1 and advice["scenes"][0]["outcome"] == "more-light", "the corridor needs more light")
    expect(advice["scenes"][0]["unit"] == "lm", "nobody says the power of its luminaires: lumens are counted")
    measured = advice["scenes"][0]["requirements"]
    average = next(one for one in measured if one["quantity"] == "average")
    factor = advice["scenes"][0]["groups"][0]["level"]
    expect(abs(factor * average["before"]["low"] / average["limit"] - 1) < 0.02,
           "the corridor needs as much as its average lacks")
    expect(advice["scenes"][0]["contradicting"] == [measured.index(average)], "its average alone is the reason")

    # The road's luminance takes no part in the search, and passes now.
    code, advice, _ = advise(luxgate, os.path.join(examples, "16-road", "project.xml"))
    scene = advice["scenes"][0]
    expect(code == 0 and scene["is_all_met"] and scene["least"] < scene["advised"] < scene["now"],
           f"what the search does not know is kept: {code} {scene['advised']}")
    expect(any(scene["requirements"][i]["quantity"] == "road-luminance" for i in scene["raised_for"]),
           "it is said what levels were raised for")

    def case(name, *parts, **more):
        return write(os.path.join(work, name + ".xml"), room(*parts, **more))

    both = ('<require id="mean" quantity="average" at-least="180"/><require id="top" quantity="maximum" '
            'at-most="60"/><require id="low" quantity="minimum" at-least="5"/>')
    code, advice, _ = advise(luxgate, case("both", both))
    scene = advice["scenes"][0]
    expect(code == 1 and scene["outcome"] == "contradiction", "what excludes each other has no levels")
    expect({scene["requirements"][i]["id"] for i in scene["contradicting"]} == {"mean", "top"},
           "it is said what excludes each other")

    expect(all("after" not in one for one in scene["requirements"]), "without levels nothing is said of after")
    done = run(luxgate, "advise", os.path.join(work, "both.xml"))
    expect("even with up to 20 times the light" in done.stdout, f"how far it was looked: {done.stdout}")
    written = os.path.join(work, "both-dimmed.xml")
    done = run(luxgate, "advise", os.path.join(work, "both.xml"), "--write", written)
    expect(done.returncode == 2 and "no scene has levels" in done.stderr and "No dimming levels meet all of these" in done.stdout
           and not os.path.exists(written), f"nothing to write: {done.returncode} {done.stderr}")

    # More light, and what nobody has calculated for it.
    dark = '<require id="mean" quantity="average" at-least="900"/><require id="g" quantity="gradient" at-most="9"/>'
    code, advice, _ = advise(luxgate, case("dark", dark))
    scene = advice["scenes"][0]
    by_id = {one["id"]: one for one in scene["requirements"]}
    expect(code == 1 and scene["outcome"] == "more-light", f"more light: {scene['outcome']}")
    expect(by_id["mean"]["after"]["verdict"] == "pass", "with more light the average is met")
    expect(all(abs(row["level"] * 100 - round(row["level"] * 100)) < 1e-9 for row in scene["groups"]),
           "more light in whole steps")

    # Between the value and the end of its interval: not met, and not surely too little.
    one_group = dict(groups=(("", "3 2 2.79"),))
    path = case("measure", '<require quantity="average" at-least="1"/>', **one_group)
    run(luxgate, "check", path, "--goal", "accuracy", "--tolerance", "0.005", "--quiet", "--format",
        "json=" + path[:-4] + ".json")
    with open(path[:-4] + ".json", encoding="utf-8") as file:
        value = json.load(file)["projects"][0]["spaces"][0]["planes"][0]["findings"][0]["measured"]["value"]
    for name, limit, outcome in (("unsure", 1.002 * value, "too-uncertain"), ("sure", 1.03 * value, "more-light")):
        path = case(name, f'<require quantity="average" at-least="{limit:.7g}"/>', **one_group)
        code, advice, _ = advise(luxgate, path)
        scene = advice["scenes"][0]
        before = scene["requirements"][0]["before"]
        expect((before["high"] > limit) == (name == "unsure") and before["value"] < limit, f"{name}: {before} {limit}")
        expect(code == 1 and scene["outcome"] == outcome, f"{name}: {scene['outcome']} {before} {limit}")

    # The energy of a year: of two groups that are alike that which daylight replaces costs less.
    energy = '<energy day-hours="2000" night-hours="500" parasitic-kwh-m2="0"><part group="b" daylight="0.25"/></energy>'
    text = room('<require quantity="average" at-least="100"/>').replace("<room", energy + "<room", 1)
    path = write(os.path.join(work, "energy.xml"), text)
    code, advice, told = advise(luxgate, path, "--least", "energy")
    scene = advice["scenes"][0]
    level = {row["group"]: row["level"] for row in scene["groups"]}
    kwh = {"a": 36 * 2500 / 1000, "b": 36 * (2000 * 0.25 + 500) / 1000}
    expect(code == 0 and scene["unit"] == "kWh" and level["b"] > level["a"], f"daylight costs less: {code} {level} {told}")
    expect(level["b"] == 1 or level["a"] == 0, f"first all of what costs less: {level}")
    expect({row["group"]: row["energy_kwh"] for row in scene["groups"]} == kwh
           and abs(scene["advised"] - sum(level[name] * kwh[name] for name in kwh)) < 1e-9
           and abs(scene["now"] - sum(kwh.values())) < 1e-9, f"energy by hand: {scene['advised']} {kwh}")
    by_power = advise(luxgate, path)[1]["scenes"][0]
    power = sum(36 * row["level"] for row in by_power["groups"])
    expect(by_power["unit"] == "W" and power <= sum(36 * value for value in level.values()) + 1e-9,
           f"power is another thing: {power} {level}")
    done = run(luxgate, "advise", path, "--least", "energy", "--quiet")
    expect("kWh a year" in done.stdout and "hours of use" in done.stdout, f"the text says so: {done.stdout}")
    done = run(luxgate, "advise", case("no-energy", '<require quantity="average" at-least="100"/>'), "--least", "energy")
    expect(done.returncode == 2 and "its use is not stated" in done.stderr, f"a room without its use: {done.stderr}")

    # No requirement that can be searched.
    code, advice, _ = advise(luxgate, case("none", '<require id="g" quantity="gradient" at-most="9"/>'))
    reason = advice["scenes"][0].get("reason", "")
    expect(code == 1 and "p, g:" in reason, f"it is said why: {reason}")

    # The levels of all scenes are checked together before they are written.
    scenes = '<scene id="s"><dim group="a" level="0.9"/></scene>'
    two = ('<require id="mean" quantity="average" at-least="100"/>'
           '<require id="dim" quantity="average" at-least="50" scene="s"/>')
    path = case("two", two, scenes=scenes)
    written = os.path.join(work, "two-dimmed.xml")
    code, advice, told = advise(luxgate, path, "--write", written)
    expect(code == 0 and len(advice["scenes"]) == 2, f"two scenes: {code} {told}")
    done = run(luxgate, "check", written, "--seed", "99", "--quiet")
    expect(done.returncode == 0, f"both scenes pass in one project: {done.returncode} {done.stderr}")
    light = os.path.join(work, "batwing_1200.ies")
    with open(light, "rb") as file:
        bytes_before = file.read()
    code, _, told = advise(luxgate, path, "--write", light)
    with open(light, "rb") as file:
        expect(code == 2 and "it is an input" in told and file.read() == bytes_before, f"no input is written over: {told}")

    # Levels that the text of the project cannot give are no advice.
    write(os.path.join(work, "list.csv"), "name,type,x_m,y_m,z_m\na,t,1.5,2,2.79\nb,t,4.5,2,2.79\n")
    listed = room('<require quantity="average" at-least="50"/>', groups=(("", "3 2 2.79"),))
    path = write(os.path.join(work, "listed.xml"), listed.replace("<plane", '<luminaires id="c" file="list.csv"/><plane'))
    code, advice, _ = advise(luxgate, path)
    scene = advice["scenes"][0]
    expect(code == 1 and scene["outcome"] == "none-found" and "2 of 3" in scene["reason"],
           f"luminaires of lists cannot be dimmed: {scene['outcome']} {scene.get('reason')}")

    # A room of which nothing is asked stays as it is.
    second = '<room id="s" origin="20 0 0" size="6 4 2.8" floor="m" ceiling="m" walls="m">' \
             '<luminaire id="K" type="t" position="3 2 2.79" group="k"/></room></luxgate>'
    path = write(os.path.join(work, "second.xml"), room('<require quantity="average" at-least="50"/>')
                 .replace("</luxgate>", second))
    code, advice, _ = advise(luxgate, path)
    scene = advice["scenes"][0]
    expect(code == 0 and scene["left_alone"] == ["k"] and scene["now"] == 72
           and "k" not in [row["group"] for row in scene["groups"]], f"what is not asked for is left alone: {scene}")

    # What no level mends is said, and keeps the exit code from 0.
    code, advice, _ = advise(luxgate, case("dense", '<require quantity="average" at-least="20"/>'
                                                    '<require quantity="power-density" at-most="0.5"/>'))
    expect(code == 1 and advice["scenes"][0]["is_all_met"] and len(advice["not_met_besides"]) == 1,
           f"the power by area is not met: {code} {advice['not_met_besides']}")

    # From the folder of the project, as the manual has it; and outputs over inputs.
    case("here", '<require quantity="average" at-least="100"/>')
    done = subprocess.run([luxgate, "advise", "here.xml", "--quiet", "--write", "new.xml"], capture_output=True,
                          text=True, check=False, cwd=work)
    expect(done.returncode == 0 and os.path.exists(os.path.join(work, "new.xml")), f"a name alone: {done.stderr}")
    for output, words in (("batwing_1200.ies", "it is an input"), ("new.xml", "new.xml"), ("here.xml", "here.xml")):
        done = subprocess.run([luxgate, "advise", "here.xml", "--quiet", "--write", "new.xml", "--format",
                               "json=" + output], capture_output=True, text=True, check=False, cwd=work)
        expect(done.returncode == 2 and words in done.stderr, f"{output} is not written over: {done.stderr}")
    with open(light, "rb") as file:
        expect(file.read() == bytes_before, "photometry is as it was")

    # One group, exact but for the average's noise: the level is limit / value, a step up.
    single = '<require quantity="average" at-least="100"/>'
    code, advice, _ = advise(luxgate, case("single", single, groups=(("", "3 2 2.79"),)))
    scene = advice["scenes"][0]
    value = scene["requirements"][0]["before"]
    level = scene["groups"][0]["level"]
    limit = scene["limits"][0]
    expect(len(scene["limits"]) == 1 and abs(limit["saved_per_percent"] / (0.01 * scene["least"]) - 1) < 0.02,
           f"one group: all power hangs on the limit: {limit}")
    expect(abs(limit["lx_of_group"][0] / 100 - 1) < 0.03 and limit["lx_of_others"] == 0 and "place_m" not in limit,
           f"one group gives all light: {limit}")
    expect(code == 0 and level >= 100 / value["high"] and level <= 100 / value["low"] + 0.02, "one group: limit / value")
    code, advice, _ = advise(luxgate, case("tenths", single, groups=(("", "3 2 2.79"),)), "--steps", "10")
    level = advice["scenes"][0]["groups"][0]["level"]
    expect(code == 0 and abs(level * 10 - round(level * 10)) < 1e-12, "levels keep to their steps")

    for name, command, words in (
            ("scene", [case("x", single), "--scene", "nowhere"], "nowhere"),
            ("nothing", [case("nothing", "")], "no requirement"),
            ("folder", [case("x", single), "--write", os.path.join(os.path.dirname(work), "elsewhere.xml")], "folder"),
            ("itself", [case("x", single), "--write", os.path.join(work, "x.xml")], "project itself"),
            ("steps", [case("x", single), "--steps", "0"], "--steps"),
            ("csv", [case("x", single), "--format", "csv"], "text, json, html or markdown"),
            ("broken", [write(os.path.join(work, "broken.xml"), "<luxgate")], "broken.xml")):
        done = run(luxgate, "advise", *command)
        expect(done.returncode == 2 and words in done.stderr, f"{name}: {done.returncode} {done.stderr}")
    expect(not os.path.exists(os.path.join(os.path.dirname(work), "elsewhere.xml")), "nothing is written elsewhere")


def packages(luxgate, work):
    """Which lamp packages are enough: cases whose answer is known, and one against all combinations."""
    listed = ('<package article="S-800" flux-lm="800" power-w="7"/><package article="M-1600" flux-lm="1600" power-w="13"/>'
              '<package article="L-3200" flux-lm="3200" power-w="25"/><package article="XL &amp; more" flux-lm="6400" '
              'power-w="60"/>')
    typed = 'photometry="batwing_1200.ies" power-w="36"/>'

    def case(name, requirements, types=typed.replace("/>", f">{listed}</luminaire-type>"), **more):
        return write(os.path.join(work, name + ".xml"), room(requirements, **more).replace(typed, types))

    def average(path):
        result = path[:-4] + ".json"
        run(luxgate, "check", path, "--goal", "accuracy", "--tolerance", "0.005", "--quiet", "--format", "json=" + result)
        with open(result, encoding="utf-8") as file:
            return json.load(file)["projects"][0]["spaces"][0]["planes"][0]["findings"][0]["measured"]["value"]

    # The light goes with the flux, so that the least package follows from one average.
    value = average(case("packages-now", '<require id="mean" quantity="average" at-least="1"/>'))
    flux = {"S-800": 800, "M-1600": 1600, "L-3200": 3200, "XL & more": 6400}
    path = os.path.join(work, "packages-now.xml")
    _, advice, _ = advise(luxgate, path, "--packages")
    expect(advice["packages"]["types"][0]["now"]["article"] == "" and advice["packages"]["combinations"] == 5,
           "now there is none of them, and that is one choice")
    own = advice["packages"]["types"][0]["now"]["flux_lm"]
    for wanted in flux:
        limit = 0.93 * value * flux[wanted] / own
        path = case("packages-" + wanted[0], f'<require id="mean" quantity="average" at-least="{limit:.5g}"/>')
        written = path[:-4] + "-written.xml"
        code, advice, told = advise(luxgate, path, "--packages", "--write", written)
        found = advice["packages"]
        as_now = own <= flux[wanted] and own >= flux[wanted] * 0.95
        expect(code == 0 and found["is_all_met"] and not found["scenes"], f"{wanted}: {code} {told} {found}")
        if not as_now:
            one = found["types"][0]["advised"]
            expect(one["article"] == wanted and found["advised"] == 2 * one["power_w"], f"{wanted} is the least: {found}")
            expect(run(luxgate, "check", written, "--seed", "55", "--quiet").returncode == 0, f"{wanted}: it passes")
            tree = xml.etree.ElementTree.parse(written).find("luminaire-type")
            expect(tree.get("package") == wanted and tree.get("power-w") is None, f"{wanted} is written: {tree.attrib}")
            again = written[:-4] + "-again.xml"
            _, same, told = advise(luxgate, written, "--packages", "--write", again)
            expect(same["packages"]["is_as_now"] and "already need the least" in told and not os.path.exists(again),
                   f"{wanted}: nothing more to be had: {told}")
            if wanted != "S-800":
                expect("average" in found["next_below"], f"{wanted}: it is said what less would lack: {found}")
    # More than any has.
    limit = 2 * value * 6400 / own
    code, advice, told = advise(luxgate, case("packages-none", f'<require quantity="average" at-least="{limit:.5g}"/>'),
                                "--packages", "--write", os.path.join(work, "never.xml"))
    expect(code == 2 and "no combination" in advice["packages"]["problem"] and "no combination" in told
           and not os.path.exists(os.path.join(work, "never.xml")), f"none is enough: {code} {told}")

    # Two types that share a group and a limit from above that only less light or other levels meet.
    two = ('<package article="lo" flux-lm="{}" power-w="{}"/><package article="mid" flux-lm="{}" power-w="{}"/>'
           '<package article="hi" flux-lm="{}" power-w="{}"/>')
    types = typed.replace("/>", ">" + two.format(900, 9, 2000, 18, 4100, 40) + "</luminaire-type>") + \
        '<luminaire-type id="t2" photometry="batwing_1200.ies" power-w="30">' + \
        two.format(700, 8, 1900, 14, 3900, 41) + "</luminaire-type>"

    def text(requirements, chosen=("", ""), name="packages-two"):
        done = room(requirements, groups=(("g", "1.5 2 2.79"), ("g", "4.5 2 2.79"), ("h", "3 1 2.79")))
        done = done.replace('id="L1" type="t"', 'id="L1" type="t2"').replace(typed, types)
        for number, article in zip(("t", "t2"), chosen):
            if article:
                done = done.replace(f'id="{number}" photometry', f'id="{number}" package="{article}" photometry')
                power = ' power-w="36"' if number == "t" else ' power-w="30"'
                done = done.replace(f'package="{article}" photometry="batwing_1200.ies"{power}',
                                    f'package="{article}" photometry="batwing_1200.ies"')
        return write(os.path.join(work, name + ".xml"), done)

    asked = ('<require id="mean" quantity="average" at-least="{:.5g}"/><require id="low" quantity="minimum" '
             'at-least="{:.5g}"/>')
    result = os.path.join(work, "packages-two.json")
    run(luxgate, "check", text(asked.format(1, 1)), "--goal", "accuracy", "--tolerance", "0.005", "--quiet", "--format",
        "json=" + result)
    with open(result, encoding="utf-8") as file:
        mean, low = (one["measured"]["value"]
                     for one in json.load(file)["projects"][0]["spaces"][0]["planes"][0]["findings"])
    power = {("t", "lo"): 9, ("t", "mid"): 18, ("t", "hi"): 40, ("t2", "lo"): 8, ("t2", "mid"): 14, ("t2", "hi"): 41,
             ("t", ""): 36, ("t2", ""): 30}
    for share in (0.2, 0.8):
        limits = asked.format(share * mean, share * low)
        enough = {}
        for one in ("", "lo", "mid", "hi"):
            for other in ("", "lo", "mid", "hi"):
                done = run(luxgate, "check", text(limits, (one, other), "packages-try"), "--seed", "4", "--quiet")
                enough[(one, other)] = (done.returncode == 0, 2 * power["t", one] + power["t2", other])
        least = min(watts for passes, watts in enough.values() if passes)
        code, advice, told = advise(luxgate, text(limits), "--packages")
        found = advice["packages"]
        expect(code == 0 and abs(found["advised"] - least) < 1e-9 and found["combinations"] == 16,
               f"two types, {share}: {found['advised'] if 'advised' in found else found} W, by all runs {least} W {told}")

    # What passes only with other levels too, of a scene that is dimmed now.
    scene = '<scene id="s"><dim group="a" level="0.5"/><dim group="b" level="0.5"/></scene>'
    limit = 0.9 * value * 3200 / own
    path = case("packages-dimmed", f'<require id="mean" quantity="average" at-least="{limit:.5g}" scene="s"/>', scenes=scene)
    code, advice, told = advise(luxgate, path, "--packages", "--write", path[:-4] + "-written.xml")
    found = advice["packages"]
    expect(code == 0 and found["types"][0]["advised"]["article"] == "L-3200" and len(found["scenes"]) == 1,
           f"the least package with other levels: {found} {told}")
    expect(run(luxgate, "check", path[:-4] + "-written.xml", "--seed", "66", "--quiet").returncode == 0,
           "it passes with these levels")

    # Near a limit: what is not told apart is checked, or it is said that it is not excluded.
    chosen = 0
    path = case("packages-near", f'<require quantity="average" at-least="{value * 1600 / own / 1.006:.6g}"/>')
    for seed in ("1", "2", "3", "4"):
        code, advice, told = advise(luxgate, path, "--packages", "--seed", seed)
        found = advice["packages"]
        is_chosen = found["types"][0]["advised"]["article"] == "M-1600"
        chosen += is_chosen
        expect(is_chosen or found["not_excluded"] > 0, f"near the limit, seed {seed}: {code} {found} {told}")
    expect(chosen == 4, f"what the light leaves open a check decides: {chosen} of 4")

    # Where nothing is asked nothing gets darker for it, unless the type is one.
    def with_dark(kind):
        return (f'<room id="s" origin="20 0 0" size="6 4 2.8" floor="m" ceiling="m" walls="m">'
                f'<luminaire id="K" type="{kind}" position="3 2 2.79"/></room></luxgate>')
    dark = f'<luminaire-type id="k" photometry="batwing_1200.ies" power-w="30">{listed}</luminaire-type>'
    asked = f'<require quantity="average" at-least="{0.9 * value * 1600 / own:.5g}"/>'
    for kind, elsewhere in (("k", 0), ("t", 1)):
        path = case("packages-dark", asked)
        with open(path, encoding="utf-8") as file:
            changed = file.read().replace("</luxgate>", with_dark(kind)).replace("<room id=\"r\"", dark + "<room id=\"r\"")
        found = advise(luxgate, write(path, changed), "--packages")[1]["packages"]
        expect([(one["type"], one["where_nothing_is_asked"]) for one in found["types"]] == [("t", elsewhere)],
               f"a room in which nothing is asked, type {kind}: {found['types']}")

    # What no package mends is named.
    path = case("packages-dense", asked + '<require quantity="power-density" at-most="0.1"/>')
    code, advice, _ = advise(luxgate, path, "--packages")
    found = advice["packages"]
    expect(code == 1 and not found["is_all_met"] and len(found["not_met"]) == 1 and found["passing"] == 1,
           f"what is not met with the packages is named: {found}")

    # Names are no markup, wherever the block stands.
    hostile = "a ``` b **d** [x](http://e) &lt;img src=x&gt;"
    path = case("packages-hostile", asked, types=typed.replace(
        "/>", f'><package article="{hostile}" flux-lm="1600" power-w="13"/></luminaire-type>'))
    done = run(luxgate, "advise", path, "--packages", "--quiet", "--format", "markdown")
    blocks = done.stdout.split("````text\n")
    expect(len(blocks) == 2 and "**d** [x](http://e) <img src=x>" in blocks[1].split("\n````\n")[0], done.stdout)
    # --set takes one in place of flux and power.
    done = run(luxgate, "check", case("packages-set", asked), "--set", "t.package=M-1600", "--quiet")
    expect(done.returncode == 0, f"--set of a package: {done.stderr}")

    path = case("packages-without", '<require quantity="average" at-least="1"/>', types=typed)
    code, advice, told = advise(luxgate, path, "--packages")
    expect(code == 0 and "<package>" in advice["packages"]["problem"], f"no type has packages: {told}")
    done = run(luxgate, "advise", path, "--packages", "--scene", "full-output")
    expect(done.returncode == 2 and "--scene" in done.stderr, f"packages are of all scenes: {done.stderr}")


def random_case(luxgate, work, number):
    """A room that passes at levels drawn before; then the advice for it."""
    draw = random.Random(number)
    names = ["a", "b", "c", "d"][:draw.randint(2, 4)]
    groups = [(name, f"{draw.uniform(0.6, 5.4):.2f} {draw.uniform(0.6, 3.4):.2f} 2.79") for name in names]
    levels = {name: draw.randint(10, 100) / 100 for name in names}
    scene = '<scene id="s">' + "".join(f'<dim group="{name}" level="{level}"/>' for name, level in levels.items()) \
        + "</scene>"
    path = os.path.join(work, f"random-{number}.xml")
    kinds = ["average", "minimum", "maximum", "Uo", "Ud"]
    asked = "".join(f'<require id="{kind}" quantity="{kind}" {"at-most" if kind == "maximum" else "at-least"}="'
                    f'{"0.5" if kind in ("Uo", "Ud") else "100"}" scene="s"/>' for kind in kinds)
    write(path, room(asked, groups, scene))
    result = path[:-4] + ".json"
    run(luxgate, "check", path, "--goal", "accuracy", "--tolerance", "0.01", "--quiet", "--format", "json=" + result)
    with open(result, encoding="utf-8") as file:
        findings = json.load(file)["projects"][0]["spaces"][0]["planes"][0]["findings"]
    chosen = draw.sample(kinds, draw.randint(1, 4))
    if not {"average", "minimum"} & set(chosen):
        chosen.append("average")
    asked = ""
    for finding in findings:
        kind, value = finding["requirement"], finding["measured"]
        if kind not in chosen:
            continue
        room_left = draw.uniform(0.02, 0.1)
        limit = value["high"] * (1 + room_left) if kind == "maximum" else value["low"] * (1 - room_left)
        asked += f'<require id="{kind}" quantity="{kind}" {"at-most" if kind == "maximum" else "at-least"}="' \
                 f'{limit:.4g}" scene="s"/>'
    write(path, room(asked, groups, scene))
    dimmed = path[:-4] + "-dimmed.xml"
    code, advice, told = advise(luxgate, path, "--tolerance", "0.01", "--write", dimmed)
    name = f"random room {number}"
    if advice is None or code != 0:
        expect(False, f"{name}: {code} {told} {advice and advice['scenes'][0]['outcome']}")
        return 0.0
    found = advice["scenes"][0]
    expect(found["advised"] <= found["now"] + 1e-9, f"{name}: {found['advised']} W are more than {found['now']} W")
    expect(found["least"] <= found["advised"], f"{name}: less than the least")
    done = run(luxgate, "check", dimmed, "--seed", str(1000 + number), "--quiet")
    expect(done.returncode == 0, f"{name}: the written project ends with {done.returncode}: {done.stderr}")
    return found["advised"] / found["now"]


def main():
    luxgate, examples, work = sys.argv[1:4]
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 6
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    shutil.copy(os.path.join(examples, "04-office", "photometry", "batwing_1200.ies"), work)
    if jsonschema:
        global schema
        schema = json.loads(run(luxgate, "schema", "--advice").stdout)
    else:
        print("python3-jsonschema is not installed: the schema is not looked at")
    known_cases(luxgate, examples, work)
    packages(luxgate, work)
    shares = [random_case(luxgate, work, number) for number in range(1, count + 1)]
    print(f"{count} random rooms: on average {100 * sum(shares) / max(1, count):.1f} % of the power of the levels drawn")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
