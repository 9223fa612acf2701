"""The Python module: the same results as the program, and every doubt with them.

    python_module.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew; the module is in PYTHONPATH

LUXGATE "" leaves out what compares with the program.
"""
import copy
import gc
import inspect
import json
import math
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy

import small_designs

import luxgate

PROGRAM = pathlib.Path(sys.argv[1]).resolve() if sys.argv[1] else None
WORK, EXAMPLES = pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
FAST = {"max_paths": 1024}
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def raises(kind, call, *parts):
    """The exception, whose text holds these parts."""
    try:
        got = call()
    except kind as error:
        for part in parts:
            expect(part in str(error), f"'{part}' is not in: {error}")
        return error
    except Exception as error:  # pylint: disable=broad-except
        problems.append(f"{kind.__name__} is expected, not {type(error).__name__}: {error}")
        return None
    problems.append(f"{kind.__name__} with {parts} is expected, not {got!r}")
    return None


def differences(file, part, place=""):
    """Where a part is not what the result file has."""
    if isinstance(part, luxgate.Part):
        fields = part.__dict__
        file = {{"pass": "pass_", "from": "from_", "in": "in_"}.get(key, key): value for key, value in file.items()}
        for key, value in file.items():
            if key not in fields:
                yield f"{place}/{key} is missing"
            else:
                yield from differences(value, fields[key], f"{place}/{key}")
        for key in set(fields) - set(file):
            is_absent = fields[key] is None or fields[key] is False or not isinstance(fields[key], (str, float, int, luxgate.Part)) and len(fields[key]) == 0
            if not is_absent and key not in ("space", "plane", "project", "words", "outcome", "unit", "formatted"):
                yield f"{place}/{key} is not in the file"
    elif isinstance(part, list):  # what a text is made of
        if part != file:
            yield f"{place}: {file!r} is {part!r}"
    elif isinstance(part, (tuple, numpy.ndarray)) and isinstance(file, list):
        if len(part) != len(file):
            yield f"{place}: {len(file)} are {len(part)}"
        for index, (one, own) in enumerate(zip(file, part)):
            yield from differences(one, own, f"{place}/{index}")
    elif file is None:
        if part is not None and math.isfinite(part):
            yield f"{place}: null is {part}"
    elif isinstance(file, bool) or isinstance(file, str):
        if isinstance(part, str) and str(part) == file or part is file:
            return
        yield f"{place}: {file!r} is {part!r}"
    elif float(file) != float(part):  # to the bit
        yield f"{place}: {file!r} is {part!r}"


def same_as_the_program():
    for name, settings in (("04-office", {}), ("05-failing-corridor", {"goal": "accuracy", "tolerance": 0.05, "seed": 7}), ("10-open-office", {}),
                           ("16-road", {}), ("09-office-by-row", {"by_luminaire": True}), ("14-car-park", {"confidence": "90%"})):
        project = f"{name}/project.xml"
        os.chdir(EXAMPLES)
        result = luxgate.check(project, backend="cpu", **FAST, **settings)
        text = result.to_json()
        found = list(differences(json.loads(text), result._all))
        expect(not found, f"{name}: {found[:5]}")
        for plane in result.planes:
            count = len(plane.__dict__["points"].rows)
            expect(plane.points.shape == (count, 3) and plane.normals.shape == (count, 3), f"{plane}: points {plane.points.shape}")
            expect(plane.values.shape == plane.low.shape == plane.high.shape == (count,), f"{plane}: values")
            expect(bool((plane.low <= plane.values).all() and (plane.values <= plane.high).all()), f"{plane}: intervals")
            expect(plane.values.dtype == numpy.float64, f"{plane}: {plane.values.dtype}")
        if PROGRAM is None:
            continue
        options = [word for key, value in {"backend": "cpu", **FAST, **settings}.items()
                   for word in (["--" + key.replace("_", "-")] + ([] if value is True else [str(value)]))]
        done = subprocess.run([PROGRAM, "check", project, *options, "--quiet", "--pictures", "off", "--format", "json"], capture_output=True, check=False)
        expect(done.stdout.decode() == text, f"{name}: the program writes another result")
        expect(done.returncode == result.exit_code, f"{name}: exit code {done.returncode}, not {result.exit_code}")
    os.chdir(WORK)


def what_a_result_says():
    project = small_designs.write(WORK / "d/a.xml")
    result = luxgate.check(project, **FAST)
    expect(result.verdict == luxgate.Outcome.FAIL and result.verdict == "fail" and result.exit_code == 1, f"{result}")
    expect([(f.space, f.plane, f.requirement, str(f.verdict), f.words) for f in result.findings]
           == [("room", "desk", "mean", "pass", "average"), ("room", "far", "least", "fail", "minimum")], f"{result.findings}")
    desk = result.findings[0]
    expect(desk.unit == "lx" and desk.limit == 100 and desk.measured.low <= desk.measured.value <= desk.measured.high, f"{desk}")
    expect(desk.waiver is None and desk.rule is None and desk.deviations == () and desk.doubtful is False, f"{desk}")
    expect(desk.project == project and result.project.path == project and len(result.luminaires) == 1, f"{result.project}")
    plane = result.planes[0]
    image = plane.image()
    expect(image.shape == (4, 6) and plane.unit == "lx" and not numpy.isnan(image).any(), f"{image}")
    expect(all(image[row, column] == value for (column, row), value in zip(plane.cells, plane.values)), "cells")
    expect(math.isclose(float(plane.values.mean()), plane.statistics.average_lx.value, rel_tol=1e-12), "average")
    raises(ValueError, lambda: plane.image([1.0, 2.0]), "24 points")
    table = json.loads(result.to_json())["projects"][0]["spaces"][0]["planes"][0]["points"]
    rows, column = numpy.array(table["rows"]), table["columns"].index
    for own, name in ((plane.values, "illuminance_lx"), (plane.low, "low_lx"), (plane.high, "high_lx"), (plane.direct_lx, "direct_lx"),
                      (plane.indirect_lx, "indirect_lx"), (plane.points[:, 2], "z_m"), (plane.points[:, 0], "x_m"), (plane.normals[:, 2], "nz")):
        expect(bool((own == rows[:, column(name)]).all()), f"{name}: {own}")
    expect(result.counts.pass_ == result.counts.to_dict()["pass"] == 1, f"{result.counts}")
    expect("pass" in repr(result) and "room" in repr(desk), repr(result) + repr(desk))
    waived = luxgate.check(small_designs.write(WORK / "d/w.xml", far_waiver=small_designs.WAIVER), **FAST)
    expect(waived.findings[1].outcome == "waived" and waived.findings[1].verdict == "fail" and waived.verdict == "pass", f"{waived.findings}")
    expect(waived.findings[1].waiver.owner == "A. Meier" and waived.findings[1].waiver.applies, "waiver")


def doubts_stay():
    result = luxgate.check("d/a.xml", **FAST)
    for thing in (result, result.findings[0], result.verdict, result.findings[0].verdict, result.project):
        raises(TypeError, lambda thing=thing: bool(thing), "true or false")
    raises(ValueError, lambda: result.verdict != "failed", "failed", "not-judged")
    raises(ValueError, lambda: result.findings[0].verdict == "waived", "waived")
    expect(luxgate.Outcome.FAIL in {luxgate.Outcome.FAIL: 1} and luxgate.Verdict("pass") is luxgate.Verdict.PASS, "names")
    raises(AttributeError, lambda: setattr(result.findings[0], "verdict", "pass"), "cannot be changed")
    raises(AttributeError, lambda: result.findings[0].verdikt, "verdikt", "verdict")
    nothing = (WORK / "d/nothing.xml")
    nothing.write_text(small_designs.project(far=False).replace('<require id="mean" quantity="average" at-least="100"/>', ""))
    asked = luxgate.check("d/nothing.xml", **FAST)
    expect(asked.verdict == "nothing-asked" and asked.verdict != luxgate.Outcome.PASS and asked.exit_code == 0, f"{asked}")
    # A plane without points, beside one that is met.
    empty = small_designs.project(far=False).replace("</room>", '<plane id="none" origin="1 1 0.8" u="1 0 0" v="0 1 0" margin="0.6" count="2 2"/></room>')
    (WORK / "d/empty.xml").write_text(empty)
    try:
        judged = luxgate.check("d/empty.xml", **FAST)
        lost = [plane for plane in judged.planes if not plane.is_computed]
        expect(judged.verdict == "not-judged" and judged.exit_code == 2 and len(lost) == 1, f"{judged}")
        raises(luxgate.Error, lambda: lost[0].values, "none", lost[0].reason)
        expect(any(message.severity == "error" for message in judged.messages), f"{judged.messages}")
    except luxgate.CheckError as error:  # all of the project is refused: no doubt either
        expect(error.result.verdict == "not-judged", f"{error}")
    # A part.
    part = luxgate.check("d/a.xml", plane="desk", **FAST)
    expect([finding.requirement for finding in part.findings] == ["mean"] and part.provenance.selection == "--plane desk", f"{part.findings}")
    expect(any(message.id == "part-selected" for message in part.messages), f"{part.messages}")
    raises(luxgate.Error, lambda: luxgate.check("d/a.xml", tag="north", **FAST), "--tag north", "chooses nothing")
    strict = luxgate.check("d/a.xml", set={"spot.flux-lm": 3000}, strict=["values-set"], **FAST)
    expect(strict.verdict == "warned" and strict.exit_code == 2, f"{strict}: {strict.messages}")
    expect(luxgate.check("d/a.xml", strict=True, set={"spot.flux-lm": 3000}, **FAST).verdict == "warned", "strict")


def errors_are_exceptions():
    (WORK / "d/bad.xml").write_text(small_designs.project().replace('quantity="average"', 'quantitty="average"'))
    error = raises(luxgate.CheckError, lambda: luxgate.check("d/bad.xml"), "d/bad.xml:", "unknown-attribute", "quantitty")
    message = next(message for message in error.messages if message.severity == "error")
    expect((message.file, message.id, message.severity) == ("d/bad.xml", "unknown-attribute", "error") and message.line > 0 and message.column > 0, f"{message!r}")
    expect(message.text in str(message) and "quantitty" in message.text, f"{message}")
    expect(error.result.verdict == "not-judged" and error.result.exit_code == 2, f"{error.result}")
    expect("quantitty" in error.result.render("junit"), "the report of an error")
    expect(str(pickle.loads(pickle.dumps(error))) == str(error), "a pickled error")
    raises(luxgate.CheckError, lambda: luxgate.check("d/nowhere.xml"), "d/nowhere.xml")
    raises(luxgate.CheckError, lambda: luxgate.check("d/a.xml", rules="d/nowhere"), "nowhere")
    raises(luxgate.CheckError, lambda: luxgate.check("d/a.xml", set={"spot.flux": 1}), "spot")
    raises(luxgate.SettingError, lambda: luxgate.check("d/a.xml", tolerance=3), "--tolerance", "'3'")
    raises(ValueError, lambda: luxgate.check("d/a.xml", goal="speed"), "--goal", "verdict")
    raises(ValueError, lambda: luxgate.check("d/a.xml", strict=["no-such-id"]), "--strict", "no-such-id")
    raises(ValueError, lambda: luxgate.check("d/a.xml", gl_device=0, backend="cpu"), "--gl-device")
    raises(TypeError, lambda: luxgate.check("d/a.xml", tolerence=0.1), "tolerence", "did you mean 'tolerance'")
    raises(TypeError, lambda: luxgate.check("d/a.xml", images=True), "images", "command line only")
    raises(TypeError, lambda: luxgate.check("d/a.xml", by_luminaire="yes"), "True or False")
    raises(TypeError, lambda: luxgate.check("d/a.xml", seed=[1, 2]), "one value")
    raises(TypeError, lambda: luxgate.check("d/a.xml", seed=True), "bool")
    raises(TypeError, lambda: luxgate.check("d/a.xml", tolerance=numpy.array([0.1])), "ndarray")
    raises(TypeError, lambda: luxgate.check(None))
    expect("unknown-attribute" in [m.id for m in luxgate.validate("d/bad.xml") if m.severity == "error"], "validate finds no error")
    expect(all(m.severity == "warning" for m in luxgate.validate("d/a.xml")), "validate finds errors")
    expect(luxgate.validate(EXAMPLES / "05-failing-corridor/project.xml") == (), "validate")
    raises(TypeError, lambda: luxgate.validate("d/a.xml", seed=1), "seed")
    same = luxgate.check(pathlib.Path("d/a.xml"), seed=numpy.int64(3), tolerance=numpy.float64(0.02), jobs=None, **FAST)
    expect(same.provenance.seed == 3, "numbers of numpy")


def reports():
    result = luxgate.check("d/a.xml", **FAST)
    for kind in luxgate.formats():
        result.write(kind, f"out/{kind}")
        written = (WORK / "out" / kind).read_bytes()
        if kind == "xlsx":
            raises(ValueError, lambda: result.render("xlsx"), "no text")
            expect(written.startswith(b"PK"), "xlsx: no ZIP file")
            continue
        expect(written.decode("cp1252" if kind == "dxf" else "utf-8") == result.render(kind) and len(written) > 50, f"{kind}: {len(written)} bytes")
    expect("pdf" not in luxgate.formats(), "pdf")
    expect('lang="de"' in result.render("html", language="de"), "language")
    raises(ValueError, lambda: result.write("pdf", "out/pdf"), "pdf", "luxgate report")
    raises(ValueError, lambda: result.write("exel", "out/exel"), "exel", "json")
    raises(ValueError, lambda: result.render("html", language="xx"), "--language")
    raises(TypeError, lambda: result.render("html", seed=1), "seed")
    (WORK / "out/folder").mkdir()
    raises(OSError, lambda: result.write("json", "out/folder"), "out/folder")
    for read in ("d/a.xml", "d/spot.ies", "d/../d/spot.ies"):
        kept = (WORK / read).read_bytes()
        raises(OSError, lambda: result.write("json", read), read, "was read as an input")
        expect((WORK / read).read_bytes() == kept, f"{read} was overwritten")
    again = luxgate.read("out/json")
    expect(again.to_json() == result.to_json() and again.verdict == result.verdict, "read")
    expect(pickle.loads(pickle.dumps(result)).to_json() == result.to_json(), "a pickled result")
    finding = copy.deepcopy(result.findings[0])
    expect(type(finding) is luxgate.Finding and finding.measured.value == result.findings[0].measured.value, f"{finding}")
    changed = json.loads(result.to_json())
    changed["projects"][0]["spaces"][0]["planes"][1]["findings"][0]["verdict"] = "pass"
    (WORK / "out/changed.json").write_text(json.dumps(changed))
    raises(luxgate.CheckError, lambda: luxgate.read("out/changed.json"), "out/changed.json")
    raises(luxgate.CheckError, lambda: luxgate.read("out/nowhere.json"), "nowhere")
    json.loads(luxgate.schema("result"))
    expect("<xs:schema" in luxgate.schema() and luxgate.version == luxgate.__version__, "schema")
    raises(ValueError, lambda: luxgate.schema("sweep"), "sweep")


def arrays_live_alone():
    result = luxgate.check("d/a.xml", **FAST)
    values, points, kept = result.planes[0].values, result.planes[0].points, result.planes[0].values.copy()
    raises(ValueError, lambda: values.__setitem__(0, 1.0))
    del result
    gc.collect()
    for _ in range(20):
        luxgate.check("d/a.xml", max_paths=64)
    expect(bool((values == kept).all()) and points.shape == (24, 3), "arrays whose result is gone")


def sweeps():
    averages = [luxgate.check("d/a.xml", set={"spot.flux-lm": flux}, **FAST).planes[0].statistics.average_lx.value for flux in (1000, 2000.0, "4000")]
    expect(numpy.allclose(numpy.array(averages) / averages[0], [1, 2, 4]), f"{averages}")
    told = luxgate.check("d/a.xml", set=["spot.flux-lm=1000", "desk.mean.at-least=50"], **FAST).messages
    expect(any(message.id == "values-set" and "spot.flux-lm=1000" in message.text for message in told), f"{told}")


SLOW = dict(goal="accuracy", tolerance=1e-6, max_paths=2**24, jobs=1)


def threads_go_on():
    alone = luxgate.check("d/a.xml", **FAST).to_json()
    texts = []
    workers = [threading.Thread(target=lambda: texts.append(luxgate.check("d/a.xml", **FAST).to_json())) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    expect(texts == [alone] * 4, "checks of several threads differ")
    ticks, is_done = [], threading.Event()
    ticker = threading.Thread(target=lambda: [ticks.append(time.monotonic()) for _ in iter(lambda: is_done.wait(0.01), True)])
    ticker.start()
    cut = luxgate.check("d/a.xml", time_limit=1, **SLOW)
    is_done.set()
    ticker.join()
    expect(len(ticks) >= 5, f"another thread came to {len(ticks)} steps during a check of a second")
    expect(cut.provenance.same_bits_on == "nowhere", f"{cut.provenance}")


def alone(script, *, interrupt_after=None):
    """A Python of its own; what it printed."""
    process = subprocess.Popen([sys.executable, "-B", "-c", script], cwd=WORK, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if interrupt_after:
        expect(process.stdout.readline() == "ready\n", "the script has not begun")
        time.sleep(interrupt_after)
        process.send_signal(signal.SIGINT)
    try:
        printed, _ = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        printed, _ = process.communicate()
        problems.append("a script had to be killed")
    return printed


def can_be_interrupted():
    printed = alone("import luxgate, signal, time\n"
                    "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                    "print('ready', flush=True)\n"
                    "try:\n"
                    f"    luxgate.check('d/a.xml', **{SLOW})\n"
                    "except KeyboardInterrupt:\n"
                    "    print('stopped', luxgate.check('d/a.xml', max_paths=64).verdict)\n", interrupt_after=1.0)
    expect(printed == "stopped fail\n", f"an interrupted check: {printed}")


def nothing_is_printed():
    printed = alone("import luxgate\n"
                    "luxgate.check('d/a.xml', max_paths=64, set={'spot.flux-lm': 3000}, timing=True)\n"
                    "luxgate.validate('d/bad.xml')\n"
                    "for settings in ({}, {'rules': 'd/nowhere'}, {'set': 'x.y=1'}, {'seed': -1}):\n"
                    "    try:\n"
                    "        luxgate.check('d/bad.xml' if not settings else 'd/a.xml', **settings)\n"
                    "    except luxgate.Error:\n"
                    "        continue\n"
                    "    print('no error')\n")
    expect(printed == "", f"printed: {printed}")


def example():
    done = subprocess.run([sys.executable, "-B", EXAMPLES / "python/check.py", EXAMPLES / "05-failing-corridor/project.xml", "panel.flux-lm", "2000", "9000"],
                          capture_output=True, text=True, check=False)
    expect(done.returncode == 1 and done.stderr == "" and "project.xml: fail\n" in done.stdout, f"{done}")
    expect("panel.flux-lm=2000: fail" in done.stdout and "panel.flux-lm=9000: pass" in done.stdout and " lx at (" in done.stdout, done.stdout)


def explains_itself():
    signature = inspect.signature(luxgate.check)
    expect({"goal", "tolerance", "confidence", "seed", "jobs", "max_paths", "time_limit", "rules", "set", "strict"} <= set(signature.parameters), f"{signature}")
    expect("format" not in signature.parameters and "relative half-width" in luxgate.check.__doc__, luxgate.check.__doc__)
    stub = pathlib.Path(luxgate.__file__).with_name("__init__.pyi")
    text = stub.read_text()
    compile(text, str(stub), "exec")
    for word in ("class Finding(Part):", "def measured(self) -> Estimate | None", "max_paths: ", "def verdict(self) -> Verdict"):
        expect(word in text, f"'{word}' is not in the stub")
    for title in ("Result", "CheckError", *{type(part).__name__ for part in luxgate.check("d/a.xml", **FAST).findings}):
        expect(f"class {title}(" in text or f"class {title}:" in text, f"{title} is not in the stub")
    if shutil.which("mypy") is None:
        return
    (WORK / "typed.py").write_text(
        "import luxgate\nresult = luxgate.check('a.xml', seed=1, set={'a.b': 2.0}, strict=True)\n"
        "for finding in result.findings:\n    margin: float | None = finding.margin\n    place: str = finding.space + finding.plane\n"
        "    if finding.measured is not None:\n        low: float | None = finding.measured.low\n"
        "average: float = float(result.planes[0].values.mean())\nresult.write('html', 'a.html', language='de')\n")
    (WORK / "wrong.py").write_text("import luxgate\nluxgate.check('a.xml', sede=1)\nluxgate.read('a').findings[0].verdikt\nluxgate.read('a').write('exel', 'a')\n")
    environment = {**os.environ, "MYPYPATH": str(stub.parent.parent)}
    mypy = ["mypy", "--cache-dir", str(WORK / "mypy"), "--strict", "--follow-imports", "silent"]
    right = subprocess.run([*mypy, "typed.py"], cwd=WORK, env=environment, capture_output=True, text=True, check=False)
    expect(right.returncode == 0, f"mypy: {right.stdout}{right.stderr}")
    wrong = subprocess.run([*mypy, "wrong.py"], cwd=WORK, env=environment, capture_output=True, text=True, check=False).stdout
    expect("sede" in wrong and "verdikt" in wrong and "write" in wrong, f"mypy finds no mistakes: {wrong}")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    os.chdir(WORK)
    for test in (what_a_result_says, doubts_stay, errors_are_exceptions, reports, arrays_live_alone, sweeps, threads_go_on, can_be_interrupted,
                 nothing_is_printed, example, explains_itself, same_as_the_program):
        before, began = len(problems), time.monotonic()
        try:
            test()
        except Exception as error:  # pylint: disable=broad-except
            import traceback
            problems.append(f"{test.__name__}: {error!r}\n{traceback.format_exc()}")
        print(f"{test.__name__}: {'failed' if len(problems) > before else 'ok'}, {time.monotonic() - began:.1f} s", flush=True)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
