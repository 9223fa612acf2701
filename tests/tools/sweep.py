"""Variants of a project: --set and sweep say what a project says that was written with these values.

    sweep.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import csv
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
FAST = ["--max-paths", "4096"]
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code=0):
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=WORK, check=False)
    expect(done.returncode == code, f"{words}: exit code {done.returncode}, expected {code}: {done.stderr}")
    return done


def result(project, *words, code=0):
    """A result as JSON, without what names the file and its bytes."""
    text = run("check", project, *FAST, "--quiet", "--pictures", "off", "--format", "json", *words, code=code).stdout
    data = json.loads(text)
    for part in data["projects"]:  # an edited file needs no warning
        kept = [told for told in part["diagnostics"] if told["id"] != "values-set"]
        for counts in (data["warnings"], part["warnings"]):
            counts["all"] -= len(part["diagnostics"]) - len(kept)
        part["diagnostics"] = kept
    return re.sub(r'"(sha256|command_line|path)": "[^"]*"', "", json.dumps(data, indent=1)), text


def told_everywhere():
    """Also with --quiet: who sees a verdict sees that the file says something else."""
    small_designs.write(WORK / "d/a.xml", far=False)
    kinds = ("text", "json", "html", "csv", "junit", "sarif", "github", "gitlab", "markdown")
    for kind in kinds:
        text = run("check", "d/a.xml", *FAST, "--quiet", "--pictures", "off", "--set", "desk.mean.at-least=1", "--format", kind).stdout
        expect("desk.mean.at-least=1" in text and "other values than the file has" in text or kind == "text" and "1 warning" in text,
               f"{kind} does not tell of --set: {text[:2000]}")
    run("check", "d/a.xml", *FAST, "--strict", "--set", "desk.mean.at-least=1", code=2)


def like_an_edited_file():
    small_designs.write(WORK / "d/a.xml", far=False)
    small_designs.write(WORK / "d/edited.xml", far=False, columns=4, limit=2000, flux=' flux-lm="1500"', mf="0.7")
    values = ["--set", "L.columns=4", "--set", "desk.mean.at-least=2000", "--set", "spot.flux-lm=1500", "--set",
              "luxgate.maintenance-factor=0.7"]
    set_here, whole = result("d/a.xml", *values, code=1)
    edited, _ = result("d/edited.xml", code=1)
    # 'where' in front of the attribute that was added stays, what stands behind on the line may not.
    without_columns = [re.sub(r'"column": \d+', "", text) for text in (set_here, edited)]
    expect(without_columns[0] == without_columns[1].replace("edited.xml", "a.xml"), "--set says something else than the edited file")
    command = json.loads(whole)["provenance"]["command_line"]
    expect(command == "luxgate check d/a.xml " + " ".join(values) + " --max-paths 4096", f"the command is: {command}")
    named = json.loads(result("d/a.xml", "--redact", "--set", "desk.mean.clause=brief 3/4, in /home/me/x.pdf")[1])["provenance"]
    expect(named["command_line"] == "luxgate check a.xml --set 'desk.mean.clause=brief 3/4, in x.pdf' --max-paths 4096",
           f"redacted the command is: {named['command_line']}")
    _, base = result("d/a.xml")
    digest = [json.loads(text)["projects"][0]["inputs"][0]["sha256"] for text in (whole, base)]
    expect(digest[0] != digest[1], "the digest of the project is the file's, though another one was judged")


def in_store_only(words, whole, is_whole):
    """Nothing is calculated; what is not in the store is named, and all else as it would be."""
    before = sorted((WORK / "store").rglob("*"))
    done = run(*words, "--store", "store", "--stored-only", "--format", "csv=only.csv", "--format", "json=only.json", code=0 if is_whole else 2)
    expect(" 0 sampling rounds of planes computed" in done.stderr, f"--stored-only has calculated: {done.stderr}")
    expect(sorted((WORK / "store").rglob("*")) == before, "--stored-only has changed the store")
    if is_whole:
        expect([(WORK / f"only.{kind}").read_bytes() for kind in ("csv", "json")] == whole[:2], "the bytes depend on --stored-only")
        expect("error" not in done.stderr, done.stderr)
        return
    rows, all_rows = (list(csv.DictReader(data.decode().splitlines())) for data in ((WORK / "only.csv").read_bytes(), whole[0]))
    missing = [row["variant"] for row in rows if row["verdict"] == "not-judged"]
    expect(0 < len(missing) < len(rows), f"{len(missing)} variants are missing")
    expect(f"store: error[store-lacks-variants]: {len(missing)} of the 8 variants have light that is not in the result cache: "
           f"{', '.join(missing)}; calculate it with 'luxgate sweep --shard'" in done.stderr, f"missing {missing}: {done.stderr}")
    for row, other in zip(rows, all_rows):
        expect({**row, "front": ""} == {**other, "front": ""} if row["variant"] not in missing
               else row["reason"] == "plane 'desk' cannot be judged: its light is not in the result cache" and row["margin"] == "", f"{row} beside {other}")


def swept():
    """Every variant as --set has it; the same bytes for any jobs and any store; shards fill the store."""
    small_designs.write(WORK / "d/a.xml", far=False)
    # Factors share looks: with four shards no shard has the looks of another.
    vary = ["--vary", "luxgate.maintenance-factor=0.6,0.8", "--vary", "spot.flux-lm=1000:1500:500", "--vary", "L.columns=2,4"]
    words = ["sweep", "d/a.xml", *vary, "--set", "desk.mean.at-least=190", "--set", "spot.power-w=20", *FAST]

    def files(name, *more):
        outputs = [word for kind in ("csv", "json", "html") for word in ("--format", f"{kind}={name}.{kind}")]
        done = run(*words, *outputs, *more)
        return [(WORK / f"{name}.{kind}").read_bytes() for kind in ("csv", "json", "html")] + [done.stdout], done.stderr

    first, told = files("one", "--jobs", "1")
    found = re.search(r"8 variants; (\d+) sampling rounds of planes computed, (\d+) read from memory", told)
    expect(found and 0 < int(found[1]) <= int(found[2]), f"maintenance factors share no looks: {told}")
    expect(files("two", "--jobs", "2")[0] == first, "the bytes depend on --jobs")
    for shard in ("1/4", "2/4", "3/4"):
        run(*words, "--store", "store", "--shard", shard)
    in_store_only(words, first, is_whole=False)
    run(*words, "--store", "store", "--shard", "4/4")
    in_store_only(words, first, is_whole=True)
    stored, told = files("stored", "--store", "store")
    expect(stored == first, "the bytes depend on the store")
    expect(" 0 sampling rounds of planes computed" in told, f"shards left something to compute: {told}")
    rows = list(csv.DictReader(first[0].decode().splitlines()))
    expect(len(rows) == 8 and {row["verdict"] for row in rows} == {"pass", "fail"}, f"{rows} are no sweep")
    expect(any(row["front"] == "on" for row in rows), "nothing is on the front")
    for row in rows:
        values = [word for path in ("spot.flux-lm", "L.columns", "luxgate.maintenance-factor")
                  for word in ("--set", f"{path}={row[path]}")]
        _, text = result("d/a.xml", "--set", "desk.mean.at-least=190", "--set", "spot.power-w=20", *values,
                         code=0 if row["verdict"] == "pass" else 1)
        space = json.loads(text)["projects"][0]["spaces"][0]
        finding = space["planes"][0]["findings"][0]
        expect(finding["verdict"] == row["verdict"], f"variant {row['variant']}: {finding['verdict']} alone")
        measured = finding["measured"]
        for key, column in (("value", "margin"), ("low", "margin_low"), ("high", "margin_high")):
            margin = (measured[key] - 190) / 190  # of which a sweep says twelve digits
            expect(abs(margin - float(row[column])) < 1e-11 * max(1, abs(margin)), f"variant {row['variant']}: {column} differs")
        expect(float(row["power_w"]) == 20 * 2 * int(row["L.columns"]), f"variant {row['variant']}: {row['power_w']} W")
    # The table names a command for one of them.
    alone = re.search(r"Variant \d+ alone: luxgate (.*)", first[3])
    expect(alone and run(*alone[1].split(), "--quiet").returncode == 0, "the command of a variant does not give its verdict")


def shards_share_no_light():
    """Each with a store of its own: together they compute what one run does, in any order of --vary, and none does nothing."""
    small_designs.write(WORK / "d/a.xml", far=False)
    vary = [["--vary", words] for words in ("spot.flux-lm=1000:1500:500", "luxgate.maintenance-factor=0.6,0.7,0.8", "L.columns=2,4")]

    def looks(*words):
        found = re.search(r"(\d+) variants; (\d+) sampling rounds of planes computed", run(*words, "--jobs", "1").stderr)
        return int(found[1]), int(found[2])

    for name, order in (("a", (0, 1, 2)), ("b", (1, 0, 2)), ("c", (2, 0, 1))):
        words = ["sweep", "d/a.xml", *(word for v in order for word in vary[v]), *FAST]
        whole = looks(*words)
        for count in (2, 4):
            shares = [looks(*words, "--store", f"apart-{name}{count}-{k}", "--shard", f"{k}/{count}") for k in range(1, count + 1)]
            expect([share[0] for share in shares] == [12 // count] * count, f"{name}: shards of {count} are not alike: {shares}")
            expect(sum(share[1] for share in shares) == whole[1], f"{name}: {count} shards compute {shares}, one run {whole}")


def prices():
    """A price changes no light; the front is of it where that is asked, and every format says so."""
    small_designs.write(WORK / "d/a.xml", far=False)
    words = ["sweep", "d/a.xml", "--vary", "spot.price=30,10.1,20", "--vary", "L.columns=2,4", *FAST, "--store", "prices"]
    done = run("sweep", "d/a.xml", "--vary", "L.columns=2,4", *FAST, "--store", "prices", "--format", "csv")
    expect(all(row["price"] == "" and int(row["luminaires_without_price"]) == 2 * int(row["L.columns"])
               for row in csv.DictReader(done.stdout.splitlines())), f"prices that nobody stated: {done.stdout}")
    done = run(*words, "--front", "price", *(word for kind in ("csv", "json", "html") for word in ("--format", f"{kind}=price.{kind}")))
    expect(" 0 sampling rounds of planes computed" in done.stderr, f"a price has changed light: {done.stderr}")
    rows = list(csv.DictReader((WORK / "price.csv").read_text().splitlines()))
    for row in rows:
        expect(float(row["price"]) == round(float(row["spot.price"]) * 2 * int(row["L.columns"]), 6) and row["luminaires_without_price"] == "0",
               f"{row} has another price")
    expect([row["front"] for row in rows] == ["off", "off", "on", "on", "off", "off"] and {row["front_of"] for row in rows} == {"price"},
           f"another front: {rows}")
    data = json.loads((WORK / "price.json").read_text())
    expect(data["front_of"] == "price" and "--front price" in data["provenance"]["command"]
           and [row["price"] for row in data["variants"]] == [float(row["price"]) for row in rows], f"{data}")
    expect("On the front of margin and price" in (WORK / "price.html").read_text(), "HTML does not say what the front is of")
    text = run(*words).stdout
    expect("front of power" in text and "40.4" in text and text.count("  on\n") == 6, f"the usual front is not of power: {text}")
    done = run("sweep", "d/a.xml", "--vary", "L.columns=2,4", *FAST, "--front", "price", "--store", "prices")
    expect("variants that pass and cannot be on the front, because the price of luminaires is not known: 2" in done.stdout, done.stdout)
    told = run(*words, "--front", "cost", code=2).stderr
    expect("--front: 'cost': power or price is needed" in told, f"--front cost: {told}")


def one_cannot_be():
    """A variant that is no project is told; the others are judged."""
    small_designs.write(WORK / "d/a.xml", far=False)
    done = run("sweep", "d/a.xml", "--vary", "L.columns=2,0,x,3", *FAST, "--format", "json", code=2)
    verdicts = [row["verdict"] for row in json.loads(done.stdout)["variants"]]
    expect(verdicts == ["pass", "not-judged", "not-judged", "pass"], f"{verdicts}")
    expect("attribute 'columns' of <luminaire-grid>: 0 is not allowed; expected a whole number from 1 (variant 2)" in done.stderr
           and "'x' is not a whole number; expected a whole number from 1 (variant 3)" in done.stderr, done.stderr)


def messages():
    small_designs.write(WORK / "d/a.xml")
    small_designs.write(WORK / "d/b.xml", far=False)
    for words, expected in (
            (["check", "d/a.xml", "--set", "spit.flux-lm=1"],
             "d/a.xml: error[value-not-set]: --set spit.flux-lm: the project has no element 'spit'; it has L, dark, desk, far, least, "
             "light, luxgate, mean, room, spot; did you mean 'spot'?\n"),
            (["check", "d/b.xml", "d/a.xml", "--set", "far.margin=1"],
             "d/b.xml: error[value-not-set]: --set far.margin: the project has no element 'far'; it has L, dark, desk, light, luxgate, "
             "mean, room, spot\n"),
            (["sweep", "d/a.xml", "--vary", "spot.photometry=a,b"],
             "d/a.xml:3:1: error[value-not-set]: --vary spot.photometry: 'photometry' of <luminaire-type> cannot be set: it names a file; "
             "vary the type instead; allowed: flux-lm, power-w, package, price, maintenance-factor, llmf, lsf, lmf, rsmf, opening, "
             "interpolation, lamp-set, variant or emitter\n"),
            (["sweep", "d/a.xml", "--vary", "L.columns=2,3", "--format", "csv=d/a.xml"],
             "error[output-not-possible]: 'd/a.xml' is an input or another output and is not overwritten\n")):
        done = run(*words, code=2)
        expect(done.stderr == expected and not done.stdout, f"{words}: {done.stderr}")
    for words, expected in (
            (["sweep", "d/a.xml"], "--vary is missing: name an attribute and its values"),
            (["sweep", "d/a.xml", "--vary", "a.b=1:1000:1", "--vary", "c.d=1:1000:1"], "--vary: more than 100000 variants"),
            (["sweep", "d/a.xml", "--vary", "a.b=1:2:0"], "in '1:2:0', which is from:to:step, the step is 0"),
            (["sweep", "d/a.xml", "--vary", "a.b=1", "--shard", "1/2"], "--shard needs --store"),
            (["sweep", "d/a.xml", "--vary", "a.b=1", "--stored-only"], "--stored-only needs --store"),
            (["sweep", "d/a.xml", "--vary", "a.b=1", "--stored-only", "--store", "s", "--shard", "1/2"],
             "--shard and --stored-only exclude each other"),
            (["sweep", "d/a.xml", "--vary", "a.b=1", "--stored-only", "--store", "s", "--time-limit", "9"],
             "--stored-only and --time-limit exclude each other"),
            (["sweep", "d/a.xml", "--vary", "a.b=1", "--format", "csv", "--store", "s", "--shard", "1/2"], "leave --format to the run with --stored-only"),
            (["check", "d/a.xml", "--set", "a.b"], "'a.b' is not PATH=VALUE, as linear.flux-lm=4000"),
            (["check", "d/a.xml", "--against", "HEAD", "--set", "a.b=1"], "--against")):
        done = run(*words, code=2)
        expect(expected in done.stderr and not done.stdout, f"{words}: {done.stderr}")


def interrupted():
    """Nothing is written, and the same command goes on from the store."""
    small_designs.write(WORK / "d/a.xml", far=False)
    words = ["sweep", "d/a.xml", "--vary", "spot.flux-lm=1000:3000:1", *FAST, "--store", "half"]
    process = subprocess.Popen([PROGRAM, *words, "--format", "csv=half.csv"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               cwd=WORK)
    end = time.monotonic() + 60
    while time.monotonic() < end and not any((WORK / "half").rglob("*.*")) and process.poll() is None:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    printed, told = process.communicate()
    expect(process.returncode == 130 and not printed and not (WORK / "half.csv").exists()
           and "interrupted; nothing was written, finished light is in the result cache" in told, f"{process.returncode}: {told}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
told_everywhere()
like_an_edited_file()
swept()
shards_share_no_light()
prices()
one_cannot_be()
messages()
interrupted()
print("\n".join(problems))
sys.exit(1 if problems else 0)
