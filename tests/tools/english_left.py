#!/usr/bin/env python3
"""English words that are left in reports of other languages.

  english_left.py LUXGATE WORK PROJECT.xml ...

Makes HTML, Markdown and text of each project in every language but English and looks for English words in
what is not marked as English (lang="en", code) and is not the project's own: whatever stands in an attribute
or a text of the project file, and strings of its photometry files. Exit code 1: a word is left.
"""

import html.parser
import os
import re
import subprocess
import sys
import xml.etree.ElementTree

# Words that English sentences can hardly do without, and those of lighting that are spelled otherwise in
# German and French. A word that a language has, too, is in its row of SHARED.
ENGLISH = set("""
the of and is are with that which without not nor from for by at each every this these its their were been have
has does it they only than then there where when who what how as to or other same two more most less least between
above below under over up down all no one because must should may cannot into through until after before against
about any some such another also seen drawn made named found given known unknown beyond within stated whole part
half low high left right lower upper larger smaller longer shorter next nearest largest smallest
plane planes room rooms value values light lights average averages required requirement requirements measured margin
grid spacing floor wall walls ceiling surround background task height width length depth luminaire luminaires limit
limits rule rules row rows standard calculated computed judged passes pass fails fail undecided waived waiver
deviation reason edge edges corner cell cells outside inside times day days year years hour hours month every scene
group number numbers list picture line lines colour error warning warnings note notes paths path looks seed
replicates rays points point sampling settings program files file made glare illuminance luminance reflectance
reflectances maintenance installed power emergency exit escape observer observers cylinder lamp road lane
""".split())
SHARED = {
    "de": set("in am an also was so des den man mit per text name wall art half rede seed".split()) & ENGLISH
          | set("also was half".split()),
    "fr": set("on or a par plus point points note notes lines luminance luminaire luminaires maintenance lane "
              "installed part".split()) & ENGLISH,
}
VOID = {"meta", "br", "img", "input", "link", "hr", "col", "wbr"}
SPOKEN = ("aria-label", "title", "alt", "placeholder")


class Page(html.parser.HTMLParser):
    """What of a page a reader sees or hears in the page's language."""

    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open = []
        self.texts = []

    def is_other(self):
        return any(other for _, other in self.open)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        other = values.get("lang") == "en" or tag in ("script", "style", "code", "pre")
        if not other and not self.is_other():
            self.texts += [values[key] for key in SPOKEN if values.get(key)]
        if tag not in VOID:
            self.open.append((tag, other))

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        while self.open:
            if self.open.pop()[0] == tag:
                return

    def handle_data(self, data):
        if data.strip() and not self.is_other():
            self.texts.append(data.strip())


def texts_of(path):
    with open(path, encoding="utf-8") as file:
        content = file.read()
    if not path.endswith(".html"):
        # A line of a command is none of ours; Markdown has it between backquotes.
        return [re.sub(r"`[^`]*`", " ", line) for line in content.split("\n")]
    page = Page()
    page.feed(content)
    return page.texts


def own_words(project):
    """Everything the project says itself, longest first."""
    own = {os.path.basename(project), project, os.path.basename(os.path.dirname(project))}
    for node in xml.etree.ElementTree.parse(project).iter():
        for text in [*node.attrib.values(), node.text or ""]:
            text = " ".join(text.split())
            if re.search(r"[A-Za-z]{2}", text):
                own.add(text)
        for name in node.attrib.values():
            photometry = os.path.join(os.path.dirname(project), name)
            if name.lower().endswith((".ies", ".ldt")) and os.path.isfile(photometry):
                with open(photometry, encoding="latin-1") as file:
                    own |= {re.sub(r"^\[\w+\]\s*", "", line.strip()) for line in file if re.search("[A-Za-z]{2}", line)}
    return sorted(own, key=len, reverse=True)


# Names for files, commands and rule packs, which are the same in every language: options, ids with dots, what
# stands in quotes, roles of packs that are no part of a row's usual ones.
NAMES = re.compile(r"""--[\w-]+|\b\w[\w\[\],-]*\.[\w.-]*[A-Za-z][\w.-]*|„[^“]*“|«[^»]*»|[Aa]ttribut\ scene""", re.VERBOSE)


def words_left(text, own, language):
    text = NAMES.sub(" ", text)
    for words in own:
        text = text.replace(words, " ")
    found = re.findall(r"[^\W\d_]+", text)
    return sorted({word for word in found if word.lower() in ENGLISH - SHARED.get(language, set())})


def main():
    luxgate, work, projects = sys.argv[1], sys.argv[2], sys.argv[3:]
    os.makedirs(work, exist_ok=True)
    left = {}
    for project in projects:
        own = own_words(project)
        name = os.path.basename(os.path.dirname(project))
        for language in ("de", "fr"):
            files = {kind: os.path.join(work, f"{name}-{language}.{end}")
                     for kind, end in (("html", "html"), ("markdown", "md"), ("text", "txt"))}
            command = [luxgate, "check", project, "--language", language, "--max-paths", "64", "--quiet", "--redact",
                       "--advice"]
            for kind, path in files.items():
                command += ["--format", f"{kind}={path}"]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode not in (0, 1, 3):  # undecided, too: few paths
                sys.exit(f"{project}: exit code {done.returncode}: {done.stderr}")
            for path in files.values():
                for text in texts_of(path):
                    for word in words_left(text, own, language):
                        left.setdefault((language, word), (os.path.basename(path), text))
    for (language, word), (path, text) in sorted(left.items()):
        print(f"{language}: '{word}' in {path}: {text[:400]}")
    print(f"{len(projects)} projects: {len(left)} English words left")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
