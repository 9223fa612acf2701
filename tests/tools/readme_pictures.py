"""Compares the terminal in README with what the program prints; makes the pictures of README.

    readme_pictures.py LUXGATE FOLDER EXAMPLES          fails if terminal.svg is not what the program prints today
    readme_pictures.py LUXGATE FOLDER EXAMPLES --make   writes terminal.svg and report-*.png anew; needs Chromium and pdftoppm

Pages of the report differ between releases of Chromium, so that only people can check them. FOLDER is not used.
"""
import fcntl
import html
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import termios

COLUMNS, LETTER_PX, LINE_PX, MARGIN_PX = 120, 7.2, 17, 14
TERMINAL, REPORT = "19-school-tender", "17-storey"
PAGES = {"rooms": 2, "plan": 3, "room": 6}
COLOURS = {"31": "#cf222e", "32": "#1a7f37", "33": "#9a6700", "2": "#6e7781"}
STYLE = re.compile(r"\x1b\[([0-9;]*)m")


def printed(luxgate, examples):
    """Returns what the program prints about a tender, with colours: the rooms, what is not met and the last lines."""
    ours, its = os.openpty()
    fcntl.ioctl(its, termios.TIOCSWINSZ, struct.pack("HHHH", 60, COLUMNS, 0, 0))
    run = subprocess.Popen([luxgate, "check", "project.xml", "--color", "always"], cwd=examples / TERMINAL, stdin=subprocess.DEVNULL,
                           stdout=its, stderr=subprocess.DEVNULL)
    os.close(its)
    text = b""
    try:
        while piece := os.read(ours, 65536):
            text += piece
    except OSError:  # the end, on Linux
        pass
    run.wait()
    blocks = text.decode().replace("\r", "").strip("\n").split("\n\n")
    last = blocks[-1].splitlines()[-2:]
    return ["$ luxgate check project.xml"] + "\n\n".join(blocks[:2]).splitlines() + ["", "…", ""] + last


def svg(lines):
    """Returns lines with colours of a terminal as a picture."""
    width, height = COLUMNS * LETTER_PX + 2 * MARGIN_PX, len(lines) * LINE_PX + 2 * MARGIN_PX
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height}" font-family="monospace" font-size="12">',
           '<rect width="100%" height="100%" rx="6" fill="#f6f8fa"/>']
    for number, line in enumerate(lines):
        style, column, spans = "", 0, []
        for k, piece in enumerate(STYLE.split(line)):
            if k % 2 == 1:
                style = piece
                continue
            for match in re.finditer(r"\S+(?: \S+)*", piece):
                colour = next((COLOURS[part] for part in style.split(";") if part in COLOURS), "#24292f")
                weight = ' font-weight="bold"' if "1" in style.split(";") else ""
                at, length = MARGIN_PX + (column + match.start()) * LETTER_PX, len(match[0]) * LETTER_PX
                spans.append(f'<text x="{at:.1f}" y="{MARGIN_PX + (number + 0.8) * LINE_PX:.1f}" textLength="{length:.1f}" '
                             f'fill="{colour}"{weight}>{html.escape(match[0])}</text>')
            column += len(piece)
        out += spans
    return "\n".join(out + ["</svg>"]) + "\n"


def make_pages(luxgate, examples, folder):
    with tempfile.TemporaryDirectory() as work:
        pdf = pathlib.Path(work) / "report.pdf"
        subprocess.run([luxgate, "check", "project.xml", "-q", "--format", f"pdf={pdf}"], cwd=examples / REPORT, check=True)
        for name, page in PAGES.items():
            subprocess.run(["pdftoppm", "-png", "-r", "60", "-f", str(page), "-l", str(page), "-singlefile", pdf,
                            folder / f"report-{name}"], check=True)


def main():
    luxgate, examples = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    folder = examples.parent / "report/cli/manual/pictures"
    terminal = folder / "terminal.svg"
    made = svg(printed(luxgate, examples))
    if "--make" in sys.argv:
        terminal.write_text(made)
        make_pages(luxgate, examples, folder)
    elif terminal.read_text() != made:
        sys.exit(f"{terminal.name} is not what the program prints; make it anew with {pathlib.Path(__file__).name} --make")


main()
