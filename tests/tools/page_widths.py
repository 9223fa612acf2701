#!/usr/bin/env python3
"""Whether pages are wider than their windows, in a real browser.

  page_widths.py LUXGATE BROWSER EXAMPLES WORK

Makes pages of `check`, `compare` and `converge` in every language, opens each in frames as wide
as a desktop's window, a small one and a phone, and prints each. Exit code 1: a page is too wide, or not printed.
"""

import html
import os
import re
import subprocess
import sys

WIDTHS = (1400, 1100, 700, 390)
PROBE = """
addEventListener('load', function () {
  var told = [], seen = 0;
  document.querySelectorAll('iframe').forEach(function (frame) {
    var page = frame.contentDocument, root = page.documentElement;
    seen += 1;
    if (root.scrollWidth > frame.clientWidth)
      told.push(frame.title + ': ' + (root.scrollWidth - frame.clientWidth) + ' px too wide');
    if (frame.clientWidth < 1000) return;
    page.querySelectorAll('.scroll').forEach(function (box) {
      if (box.querySelector('.matrix, .positions') === null && box.scrollWidth > box.clientWidth + 1)
        told.push(frame.title + ': "' + box.getAttribute('aria-label') + '" is ' +
                  (box.scrollWidth - box.clientWidth) + ' px too wide for its place');
    });
  });
  document.getElementById('result').textContent =
      'WIDTHS ' + seen + ' frames, ' + told.length + ' too wide\\n' + told.join('\\n');
});
"""


def run(command, allowed=(0,)):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in allowed:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr}")
    return done


def pages(luxgate, examples, work):
    """Paths of all pages that are looked at."""
    made = []

    def at(name):
        made.append(os.path.join(work, name))
        return made[-1]

    few = ["--max-paths", "64", "--quiet"]
    projects = {name: os.path.join(examples, name, "project.xml")
                for name in ("04-office", "06-on-the-edge", "09-office-by-row", "12-warehouse-aisle")}
    office = projects["04-office"]
    result, other = os.path.join(work, "a.json"), os.path.join(work, "b.json")
    run([luxgate, "check", office, *few, "--format", "json=" + result], (0, 1, 3))
    run([luxgate, "check", office, *few, "--seed", "7", "--format", "json=" + other], (0, 1, 3))
    for language in ("en", "de", "fr"):
        words = ["--language", language]
        for name, project in projects.items():
            if language != "de" and name != "04-office":
                continue
            run([luxgate, "check", project, *few, *words, "--format", "html=" + at(f"{name}-{language}.html")],
                (0, 1, 3))
        run([luxgate, "compare", result, other, *words, "--paper", "letter", "--quiet",
             "--format", "html=" + at(f"compare-{language}.html")], (0, 1))
        run([luxgate, "converge", os.path.join(examples, "02-direct-and-indirect", "project.xml"), "--max-paths", "256",
             "--seeds", "2", *words, "--quiet", "--format", "html=" + at(f"converge-{language}.html")])
    return made


def main():
    luxgate, browser, examples, work = sys.argv[1:]
    os.makedirs(work, exist_ok=True)
    made = pages(luxgate, examples, work)
    flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", f"--user-data-dir={work}/profile"]
    failed = False
    for path in made:
        with open(path, encoding="utf-8") as file:
            page = html.escape(file.read())
        frames = "".join(f'<iframe title="{os.path.basename(path)} at {width} px" width="{width}" height="900" '
                         f'srcdoc="{page}"></iframe>\n' for width in WIDTHS)
        probe = os.path.join(work, "probe.html")
        with open(probe, "w", encoding="utf-8") as file:
            file.write(f"<!DOCTYPE html><meta charset=\"utf-8\"><pre id=\"result\"></pre>{frames}"
                       f"<script>{PROBE}</script>")
        dom = run([browser, *flags, "--window-size=1500,1000", "--dump-dom", "file://" + probe]).stdout
        told = re.search(r"WIDTHS[^<]*", dom)
        if not told or f"{len(WIDTHS)} frames, 0 too wide" not in told.group():
            print(os.path.basename(path) + ": " + (told.group() if told else "the browser told nothing"))
            failed = True
        if not re.search(r"(compare|converge)-(de|fr)", path):
            continue
        printed = path.removesuffix(".html") + ".pdf"
        run([browser, *flags, "--no-pdf-header-footer", "--print-to-pdf=" + printed, "file://" + path])
        with open(printed, "rb") as file:
            if file.read(4) != b"%PDF":
                print(f"{os.path.basename(path)}: not printed")
                failed = True
    print(f"{len(made)} pages at {len(WIDTHS)} widths")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
