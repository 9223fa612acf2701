"""Small projects whose verdicts were worked out by hand (expected.csv) against what the program says of them.

    run.py LUXGATE [NUMBER...]    with numbers: only these projects

Compared are the exit code and every verdict: one that the table lacks counts as a difference, too. The table's columns:

file         the project, in this folder
arguments    of `check` beside the project
exit         the exit code
place        id of the plane, or: (aggregate), (building) with its id, (message), or (project) for one that must be refused
requirement  id of the requirement, of the check of a rule pack, aggregate or message
verdict      pass, fail, undecided, not_judged, with (waived), (deviation), (advice) or (in aggregate) behind it; warning; refused
known_wrong  what the program says instead, where the hand is right and the program is not: reported, and a difference as soon as it is no longer so
by_hand      the calculation or the reason
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
MOST_S = 60


def in_words(finding):
    words = finding["verdict"].replace("-", "_")
    if finding.get("waiver", {}).get("applies"):
        words += " (waived)"
    if any(deviation["accepted"] for deviation in finding.get("deviations", [])):
        words += " (deviation)"
    if finding.get("severity", "shall") != "shall":
        words += {"advice": " (advice)", "in-aggregate": " (in aggregate)"}[finding["severity"]]
    return words


def verdicts(result):
    """(place, requirement) to the verdict in words, of a result file with one project; the ids of its messages."""
    project = result["projects"][0]
    said = {}
    if not project["is_judged"]:
        said["(project)", ""] = "refused"
    for space in project.get("spaces", []):
        for plane in space["planes"]:
            for finding in plane["findings"]:
                key = plane["id"], finding.get("rule", {}).get("check", finding["requirement"])
                said[key] = in_words(finding) if key not in said else "asked twice"
    for aggregate in project.get("aggregates", []):
        if aggregate["kind"] == "building":
            said[f"(building) {aggregate['building']}", aggregate["sum"]["requirement"]] = in_words(aggregate["sum"])
        if aggregate["kind"] == "aggregate":
            said["(aggregate)", aggregate["id"]] = aggregate["verdict"].replace("-", "_") + (" (waived)" if aggregate.get("is_waived") else "")
    return said, {diagnostic["id"]: diagnostic["severity"] for diagnostic in project["diagnostics"]}


def run(program, file, arguments, folder):
    json_file = folder / "result.json"
    json_file.unlink(missing_ok=True)
    done = subprocess.run([program, "check", file, *arguments.split(), "--quiet", "--jobs", "1", "--pictures", "off", "--format", f"json={json_file}"],
                          cwd=FOLDER, capture_output=True, text=True, timeout=MOST_S)
    if not json_file.exists():
        return done.returncode, {("(project)", ""): "refused"}, {}, done.stderr
    return done.returncode, *verdicts(json.loads(json_file.read_text())), done.stderr


def differences(rows, code, said, messages):
    """What differs from the table, and what is known to be wrong, in lines."""
    differ, known = [], []
    expected = {}
    for row in rows:
        place, requirement, verdict = row["place"], row["requirement"], row["verdict"]
        if place == "(message)":
            found = messages.get(requirement)
        else:
            expected[place, requirement] = verdict
            found = said.get((place, requirement))
        line = f'{place} {requirement}: {found or "nothing"} instead of {verdict}; by hand: {row["by_hand"]}'
        if row["known_wrong"]:
            if found == row["known_wrong"]:
                known.append(line)
            else:
                differ.append(line if found != verdict else f"{place} {requirement}: is right now, take known_wrong out of the table")
        elif found != verdict:
            differ.append(line)
    differ += [f"{place} {requirement}: {verdict}, which the table does not have" for (place, requirement), verdict in said.items() if (place, requirement) not in expected]
    if str(code) != rows[0]["exit"] and not known:
        differ.append(f'exit code {code} instead of {rows[0]["exit"]}')
    return differ, known


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    numbers = {int(number) for number in sys.argv[2:]}
    cases = {}
    with open(FOLDER / "expected.csv", newline="", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            cases.setdefault(row["file"], []).append(row)
    problems = [f"{path.name}: not in the table" for path in sorted(FOLDER.glob("[0-9]*.xml")) if path.name not in cases]
    counted = wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for file, rows in cases.items():
            if numbers and int(file.split("-")[0]) not in numbers:
                continue
            counted += 1
            if len({(row["exit"], row["arguments"]) for row in rows}) != 1:
                problems.append(f"{file}: its rows have several exit codes or arguments")
                continue
            code, said, messages, stderr = run(program, file, rows[0]["arguments"], pathlib.Path(folder))
            differ, known = differences(rows, code, said, messages)
            for line in known:
                print(f"known to be wrong: {file}: {line}")
            wrong += len(known)
            problems += [f"{file}: {line}" for line in differ]
            if differ:
                problems += [f"    {line}" for line in stderr.splitlines()]
    for line in problems:
        print(line)
    print(f"{counted} projects, {len(problems)} lines of differences, {wrong} known to be wrong")
    return 1 if problems or not counted else 0


if __name__ == "__main__":
    sys.exit(main())
