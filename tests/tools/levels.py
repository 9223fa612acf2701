"""Levels of light that a reader moves on the page: in a real browser, against what `check` judges in the same light scene.

    levels.py LUXGATE FOLDER [EXAMPLES]    FOLDER is made anew
"""
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MOST_S = 120
CHROMIUM = next((path for path in map(shutil.which, ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]) if path), None)
QUANTITIES = ["average", "minimum", "maximum", "Uo", "Ud"]
GROUP = 'a"b &amp; <c>'
LEVELS = {"window": 0.35, GROUP: 0.6}
problems = []

shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
(WORK / "list.csv").write_text("x,y,z,nx,ny,nz\n1,1,0.8,0,0,1\n2,2,0.8,0,0,1\n4,3,1.1,1,0,0\n")
(WORK / "spot.ies").write_text(small_designs.PHOTOMETRY.format(candela=small_designs.CANDELA))


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def requirements(scene):
    return "".join(f'<require quantity="{name}" {"at-least" if name != "maximum" else "at-most"}="{0.01 if name != "maximum" else 5000}"{scene}/>' for name in QUANTITIES)


def plane(name, scene, grid):
    return f'<plane id="{name}" origin="0.5 0.5 0.8" u="3 0 0" v="0 2 0" {grid}><require quantity="minimum" at-least="200"/>{requirements(scene)}</plane>'


def room(name, x, scene, inside):
    return f'''<room id="{name}" origin="{x} 0 0" size="5 4 2.8" ceiling="light" walls="light" floor="dark">
<luminaire id="{name}-1" type="spot" position="1 1 2.7" group="window"/><luminaire id="{name}-2" type="spot" position="4 1 2.7" group="{html.escape(GROUP)}"/>
<luminaire id="{name}-3" type="spot" position="2.5 3 2.7"/>{inside}</room>'''


def project(mf, scene):
    points = f'<plane id="list" file="list.csv">{requirements(scene)}</plane>'
    cylinder = f'<plane id="cylinder" quantity="cylindrical" origin="0.5 0.5 1.2" u="3 0 0" v="0 2 0" count="3 2">{requirements(scene)}</plane>'
    modelling = '<plane id="modelling" quantity="modelling" origin="0.5 0.5 1.2" u="3 0 0" v="0 2 0" count="3 2"><require quantity="minimum" at-least="0.01"/></plane>'
    dims = "".join(f'<dim group="{html.escape(name)}" level="{level}"/>' for name, level in LEVELS.items())
    return f'''<luxgate version="1" name="Levels" maintenance-factor="{mf}">
<material id="light" reflectance="0.7"/><material id="dark" reflectance="0.3"/>
<luminaire-type id="spot" photometry="spot.ies"/>
{room("one", 0, scene, plane("grid", scene, 'count="6 4"') + points + cylinder + modelling)}
{room("two", 10, scene, plane("other", scene, 'count="4 4"'))}
<scene id="evening">{dims}</scene>
</luxgate>'''


def check(mf, scene, *words):
    (WORK / "p.xml").write_text(project(mf, scene))
    done = subprocess.run([PROGRAM, "check", "p.xml", "-q", "--pictures", "off", *words], cwd=WORK, capture_output=True, timeout=MOST_S, check=False)
    expect(done.returncode in (0, 1), f"check: {done.returncode}, {done.stderr}")


# What the reader does, one after the other, and what the page then says.
PROBE = """
function say(name) {
  var out = { changed: name !== '' };
  document.querySelectorAll('article.plane').forEach(function (article) {
    var one = {}, id = article.querySelector('h4 .id') || article.querySelector('h4');
    article.querySelectorAll('tr[data-statistic]').forEach(function (row) { one[row.dataset.statistic] = [row.cells[1].textContent, row.cells[2].textContent]; });
    one.cells = Array.from(article.querySelectorAll('.cells path title')).map(function (title) { return title.textContent; });
    one.numbers = Array.from(article.querySelectorAll('.numbers text')).map(function (text) { return text.textContent; });
    one.matrix = Array.from(article.querySelectorAll('table.matrix td')).map(function (cell) { return cell.textContent; });
    one.list = Array.from(article.querySelectorAll('table.points td.strong')).map(function (cell) { return cell.textContent; });
    one.fills = Array.from(article.querySelectorAll('.cells path')).map(function (path) { return path.getAttribute('fill') || path.parentNode.getAttribute('fill'); });
    one.missed = article.querySelectorAll('.missed').length > 0 ? article.querySelector('.missed').getAttribute('d').split('M').length - 1 : 0;
    one.seen = Array.from(article.querySelectorAll('svg.plan, tr[data-statistic]')).every(function (n) { return n.getClientRects().length > 0; });
    one.verdicts = Array.from(article.querySelectorAll('.badge, .gauge, .share-bar, .isolux')).filter(function (n) { return n.getClientRects().length > 0; }).length;
    one.brief = Array.from(article.querySelectorAll('.brief-preview')).map(function (n) { return n.textContent; });
    one.key = Array.from(article.querySelectorAll('.key li')).filter(function (n) { return n.getClientRects().length > 0; }).map(function (n) { return n.textContent; });
    var cells = Array.from(article.querySelectorAll('.cells path')), mark = article.querySelector('.min-mark');
    one.frame = mark === null ? -1 : cells.findIndex(function (cell) { return cell.getAttribute('d') === mark.getAttribute('d'); });
    one.preview = article.classList.contains('preview');
    one.note = Array.from(article.querySelectorAll('details.card > div > p.message')).map(function (p) { return p.textContent; });
    out[article.querySelector('h4').textContent.trim()] = one;
  });
  out.status = Array.from(document.querySelectorAll('.levels [role=status]')).map(function (p) { return p.hidden ? '' : p.textContent; });
  out.nameless = Array.from(document.querySelectorAll('.levels .nameless')).map(function (p) { return !p.hidden; });
  out.outputs = Array.from(document.querySelectorAll('.levels output')).map(function (o) { return o.textContent; });
  return out;
}
function move(slider, value) { slider.value = value; slider.dispatchEvent(new Event('input', { bubbles: true })); }
var main = document.querySelector('main'), panels = document.querySelectorAll('details.levels'), told = {};
function sliders(panel) { return Array.from(panel.querySelectorAll('input')); }
document.querySelectorAll('details.card').forEach(function (card) { card.open = true; });
told.before = say('');
var page = main.innerHTML;
panels[0].querySelector('button[data-levels]').click();
told.scene = say('scene');
panels[0].querySelector('button[type=reset]').click();
told.same = main.innerHTML.replaceAll('hidden=""', 'hidden="hidden"') === page;
panels[0].querySelectorAll('.sliders label').forEach(function (label) {
  var name = label.querySelector('span').textContent;
  if (name === 'window') move(label.querySelector('input'), 35);
  if (name.indexOf('a"b') === 0) move(label.querySelector('input'), 60);
});
told.moved = say('moved');
told.saved = '<!DOCTYPE html>' + document.documentElement.outerHTML;
move(sliders(panels[0]).pop(), 0.6);
told.maintained = say('maintained');
panels[1].querySelector('button[data-levels]').click();
told.other = say('other');
move(sliders(panels[0])[0], 0);
told.uneven = say('uneven');
panels[1].querySelector('button[data-levels]').click();
dispatchEvent(new Event('beforeprint'));
told.printed = say('printed');
panels[0].querySelector('button[data-levels]').click();
sliders(panels[0]).forEach(function (slider) { if (slider.hasAttribute('data-group')) move(slider, 0); });
told.dark = say('dark');
panels[0].querySelector('button[type=reset]').click();
var pre = document.createElement('pre');
pre.id = 'told';
pre.textContent = JSON.stringify(told);
document.body.appendChild(pre);
"""


def look(page):
    """What the probe has seen. The page's policy allows its own scripts only: the probe's copy has none."""
    text = (WORK / page).read_text()
    expect(text.count("Content-Security-Policy") == 1, "the page has no policy")
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*/>', "", text)
    (WORK / "probe.html").write_text(text.replace("</body>", "<script>" + PROBE + "</script></body>"))
    found = re.search(r'<pre id="told">(.*?)</pre>', browse("probe.html"), re.S)
    expect(found is not None, "the page told nothing")
    return json.loads(html.unescape(found.group(1))) if found else None


def browse(page):
    done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                           "--disable-component-update", "--disable-sync", "--virtual-time-budget=20000", f"--user-data-dir={WORK}/profile", "--dump-dom", f"file://{WORK}/{page}"],
                          capture_output=True, timeout=MOST_S, check=False)
    expect(b"Uncaught" not in done.stderr, f"{page}: {done.stderr[-600:]}")
    return done.stdout.decode()


def of(told, name):
    return next(value for key, value in told.items() if key.split()[0] == name)


def number(text):
    return float(re.match(r"[\d.]+", text.replace(",", ".")).group())


def is_shown(text, value):
    """Within half of the last digit that is shown."""
    digits = re.match(r"[\d.]+", text.replace(",", ".")).group()
    last = 10.0 ** -len(digits.partition(".")[2])
    return abs(float(digits) - value) <= 0.5 * last + 2e-5 * abs(value)


def values_of(result):
    """Measured in the scene, by plane and quantity."""
    values = {}
    for space in json.loads((WORK / result).read_text())["projects"][0]["spaces"]:
        for each in space["planes"]:
            values[each["id"]] = {finding["quantity"]: finding["measured"]["value"] for finding in each["findings"] if finding["scene"]}
    return values


def against_check():
    check(0.8, ' scene="evening"', "--format", "json=a.json", "--format", "html=a.html")
    told = look("a.html")
    if told is None:
        return
    judged = values_of("a.json")
    for state in ["scene", "moved"]:
        for name in ["grid", "list", "cylinder"]:
            seen = of(told[state], name)
            expect(seen["preview"] and len(seen["note"]) == 1, f"{state}, {name}: it is not marked as a preview: {seen['note']}")
            expect(seen["seen"] and seen["verdicts"] == 0 and of(told["before"], name)["verdicts"] > 0, f"{state}, {name}: values are hidden, or verdicts are shown")
            for quantity in QUANTITIES:
                text, interval = seen[quantity]
                expect(is_shown(text, judged[name][quantity]), f"{state}, {name}, {quantity}: {text} on the page, {judged[name][quantity]} judged")
                expect(interval == "preview, no verdict", f"{state}, {name}: {interval} in place of an interval")
    expect({key: value for key, value in told["scene"].items() if key not in ("status", "outputs")} == {key: value for key, value in told["moved"].items() if key not in ("status", "outputs")},
           "the button of a scene and its levels are not the same")
    seen, before = of(told["moved"], "grid"), of(told["before"], "grid")
    expect(seen["numbers"] == [cell.split()[0] for cell in seen["cells"]] and sorted(map(number, filter(None, seen["matrix"]))) == sorted(map(number, seen["numbers"])), "drawing and table differ")
    expect(min(map(number, seen["numbers"])) < min(map(number, before["numbers"])), "dimming did not make it darker")
    # The limit of 200 lx: as many are hatched as miss it.
    below = sum(number(text) < 200 for text in seen["numbers"])
    expect(before["missed"] == 0 and 0 < seen["missed"] == below, f"{seen['missed']} cells are hatched, {below} are below")
    expect(len(set(seen["fills"])) > 1 and seen["fills"] != before["fills"], "the colours stay")
    expect(of(told["moved"], "modelling")["note"] and not of(told["moved"], "modelling")["preview"], "a ratio that does not follow does not say so")
    expect(of(told["moved"], "other") == of(told["before"], "other"), "another room follows")
    expect(told["same"], "taking it back leaves the page changed")
    status = told["moved"]["status"][0]
    expect('<scene id="preview"><dim group="window" level="0.35"/>' in status and 'level="0.6"/></scene>' in status, f"the line for the project: {status}")
    group = re.search(r'<dim group="(a[^"]*)"', status)
    expect(group is not None and html.unescape(group.group(1)) == GROUP, f"the group's name in the line: {status}")
    expect("30 %" not in told["moved"]["outputs"] and "35 %" in told["moved"]["outputs"], f"levels: {told['moved']['outputs']}")
    expect(told["dark"]["nameless"][0] and not told["moved"]["nameless"][0], "luminaires without a group are not named")
    expect(seen["brief"] == ["preview, no verdict: Ē " + seen["average"][0] + " · Uo " + seen["Uo"][0]], f"a folded card says {seen['brief']}")
    expect("≥ 200 lx" in seen["note"][0] and not any("200" in words for words in seen["key"]), f"what is hatched: {seen['note']}, {seen['key']}")
    # A copy that was saved then has no sliders and says what it is.
    saved = re.sub(r"<script>function say.*?</script>|<script>\s*function say.*?</script>", "", told["saved"], flags=re.S)
    (WORK / "saved.html").write_text(saved.replace("</body>", """<pre id="told2"></pre><script>
document.getElementById('told2').textContent = [document.querySelector('main').firstChild.textContent, document.querySelectorAll('.levels:not([hidden])').length].join('|');</script></body>"""))
    found = re.search(r'<pre id="told2">(.*?)</pre>', browse("saved.html"), re.S)
    expect(found is not None and found.group(1).startswith("This copy was saved during a preview") and found.group(1).endswith("|0"), f"a saved copy: {found and found.group(1)}")
    for state in ["moved", "uneven"]:  # the minimum of the second one is another cell
        drawn = of(told[state], "grid")
        least = min(map(number, drawn["numbers"]))
        expect(number(drawn["numbers"][drawn["frame"]]) == least, f"{state}: the frame is at {drawn['numbers'][drawn['frame']]} lx, the minimum is {least}")
    expect(told["other"]["outputs"][:4] == ["100 %", "100 %", "100 %", "0.8"], f"another room's sliders: {told['other']['outputs']}")
    # Only one preview at a time; paper has none.
    expect(of(told["other"], "grid") == {**before} and of(told["other"], "other")["preview"], "two previews at a time")
    for name in ["grid", "list", "other"]:
        expect(of(told["printed"], name) == of(told["before"], name), f"{name}: a preview is printed")
    dark = of(told["dark"], "grid")
    expect(set(dark["numbers"]) == {"0.0"} and dark["Uo"][0] == "–", f"no light: {set(dark['numbers'])}, {dark['Uo']}")
    # Another maintenance factor: judged by the program, too.
    check(0.6, ' scene="evening"', "--format", "json=b.json")
    judged = values_of("b.json")
    for name in ["grid", "list"]:
        for quantity in ["average", "minimum", "maximum", "Uo"]:
            text = of(told["maintained"], name)[quantity][0]
            expect(is_shown(text, judged[name][quantity]), f"maintenance factor 0.6, {name}, {quantity}: {text}, {judged[name][quantity]} judged")
    expect('maintenance-factor="0.6"' in told["maintained"]["status"][0], f"the line: {told['maintained']['status'][0]}")


def german():
    check(0.8, ' scene="evening"', "--format", "html=g.html", "--language", "de")
    told = look("g.html")
    if told is not None:
        expect(of(told["moved"], "grid")["Uo"] == [of(told["moved"], "grid")["Uo"][0], "Vorschau, keine Bewertung"] and "," in of(told["moved"], "grid")["Uo"][0],
               f"German: {of(told['moved'], 'grid')['Uo']}")


def read_again():
    """The result file has what the page needs."""
    check(0.8, "", "--format", "json=r.json", "--format", "html=r.html")
    subprocess.run([PROGRAM, "report", "r.json", "--format", "html=s.html"], cwd=WORK, capture_output=True, timeout=MOST_S, check=True)
    expect((WORK / "s.html").read_bytes() == (WORK / "r.html").read_bytes(), "report makes another page")
    result = json.loads((WORK / "r.json").read_text())
    groups = result["projects"][0]["spaces"][0]["planes"][0]["groups"]
    points = result["projects"][0]["spaces"][0]["planes"][0]["points"]["rows"]
    for i, point in enumerate(points):
        total = sum(group["point_lx"][i] for group in groups)
        expect(abs(total - point[8]) <= 3e-6 * point[8], f"groups of point {i} give {total}, it has {point[8]}")
    for change, said in [(-1.0, b"below 0"), (10.0, b"add up")]:
        doctored = json.loads((WORK / "r.json").read_text())
        light = doctored["projects"][0]["spaces"][0]["planes"][0]["groups"][1]["point_lx"]
        light[3] *= change
        (WORK / "doctored.json").write_text(json.dumps(doctored))
        done = subprocess.run([PROGRAM, "report", "doctored.json"], cwd=WORK, capture_output=True, timeout=MOST_S, check=False)
        expect(done.returncode == 2 and said in done.stderr, f"light times {change} is read: {done.returncode}, {done.stderr}")
    groups[0]["point_lx"].pop()
    (WORK / "short.json").write_text(json.dumps(result))
    done = subprocess.run([PROGRAM, "report", "short.json"], cwd=WORK, capture_output=True, timeout=MOST_S, check=False)
    expect(done.returncode == 2 and b"as many values as the plane has points" in done.stderr, f"too few values are read: {done.returncode}, {done.stderr}")


read_again()
if CHROMIUM is None:
    print("\n".join(problems) if problems else "skipped: the page itself, since there is no Chromium")
else:
    against_check()
    german()
    print("\n".join(problems))
sys.exit(1 if problems else 0)
