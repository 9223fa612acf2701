"""`luxgate watch` as somebody uses it: saves files while it runs, and reads the terminal and the browser's page.

    watch.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
PATIENCE_S = 60
problems = []


class Terminal:
    """What a running program has printed so far."""

    def __init__(self, *arguments, folder):
        self.text = ""
        self.seen = 0
        self.process = subprocess.Popen([PROGRAM, "watch", *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=folder)
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        for line in iter(self.process.stdout.readline, b""):
            self.text += line.decode()

    def wait(self, name, *words, without=()):
        """Until it has printed the words and waits again: where two files are saved, it may have checked in between."""
        end = time.monotonic() + PATIENCE_S
        part = ""
        while not (part.rstrip().endswith("Ctrl-C ends") and all(word in part for word in words)):
            if time.monotonic() > end or self.process.poll() is not None:
                problems.append(f"{name}: one of {words} is missing, or it does not wait: {part}")
                break
            time.sleep(0.01)
            part = self.text[self.seen:]
        self.seen += len(part)
        problems.extend(f"{name}: '{word}' is there in {part}" for word in without if word in part)
        return part

    def end(self, name, code):
        self.process.send_signal(signal.SIGINT)
        try:
            if self.process.wait(PATIENCE_S) != code:
                problems.append(f"{name}: exit code {self.process.returncode}, expected {code}")
        except subprocess.TimeoutExpired:
            self.process.kill()
            problems.append(f"{name}: it does not end")


def get(address, host=None):
    """Status and text."""
    request = urllib.request.Request(address, headers={"Host": host} if host else {})
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
            return answer.status, answer.read().decode(), answer.headers
    except urllib.error.HTTPError as error:
        return error.code, "", error.headers


shutil.rmtree(WORK, ignore_errors=True)
project = WORK / "project.xml"
LIGHT = small_designs.CANDELA
DARK = "500 480 430 350 240 120 0"
MET = dict(far=False)
small_designs.write(project, **MET)
run = Terminal("project.xml", folder=WORK)
run.wait("first", "✓ pass", "1 requirement: 1 pass", without=["after the save"])
small_designs.write(project, **MET, limit="5000")
run.wait("a limit", "✗ broken", "≥ 5000 lx", "s after the save")
small_designs.write(project, **MET)
run.wait("back", "✓ fixed", "requires less")
(WORK / "spot.ies").write_text(small_designs.PHOTOMETRY.format(candela=DARK))
run.wait("photometry", "▼ worse", "photometry")
other = WORK / "other.tmp"
other.write_text(small_designs.PHOTOMETRY.format(candela=LIGHT))
os.replace(other, WORK / "spot.ies")  # as many editors save
run.wait("a file in its place", "▲ better")
project.write_text(small_designs.project(**MET).replace("</room>", ""))
run.wait("not well-formed", "error[xml-syntax]", "not judged", without=["✗ broken"])
project.unlink()
run.wait("gone", "not judged")
small_designs.write(project, **MET, columns=4)
run.wait("there again", "▲ better", without=["broken", "new"])
for limit in ("101", "102", "103", "104"):  # an editor that saves often: only the last one counts
    project.write_text(small_designs.project(**MET, columns=4, limit=limit))
run.wait("many saves", "≥ 104 lx")
project.touch()
run.wait("touched", "1 unchanged")
small_designs.write(project, limit="100", columns=4)
run.wait("failing", "new, fails")
run.end("failing", 1)

# In a browser.
small_designs.write(project, **MET)
run = Terminal("project.xml", "--serve", folder=WORK)
address = re.search(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/\n", run.wait("serve", "the report is at"))
url, port, token = address.group(0).strip(), address.group(1), address.group(2)
status, page, headers = get(url)
if status != 200 or "EventSource" not in page or "frame-ancestors 'none'" not in headers["Content-Security-Policy"]:
    problems.append(f"page: {status} {headers}")
nonce = re.search(r'<script nonce="(\w+)">', page).group(1)
if f"'nonce-{nonce}'" not in headers["Content-Security-Policy"] or nonce in get(url)[1]:
    problems.append("page: its script's nonce")
status, report, headers = get(url + "report")
done = subprocess.run([PROGRAM, "check", "project.xml", "--pictures", "off", "--format", "html"], capture_output=True, text=True, cwd=WORK)
same = [text.replace("<pre", "\n<pre") for text in (report, done.stdout)]
if status != 200 or same[0] != same[1]:
    problems.append("report: another page than `check` writes")
for wrong, code in ((f"http://127.0.0.1:{port}/", 404), (f"http://127.0.0.1:{port}/{'0' * 32}/report", 404), (url + "../etc/passwd", 404)):
    if get(wrong)[0] != code:
        problems.append(f"{wrong}: {get(wrong)[0]}")
if get(url + "report", host=f"attacker.example:{port}")[0] != 403:
    problems.append("another host's name is let in")
# Who sends a request byte by byte, or without an end, keeps nobody else from the page.
slow = [socket.create_connection(("127.0.0.1", int(port))) for _ in range(64)]
for one in slow:
    one.send(b"G")
begin = time.monotonic()
if get(url)[0] != 200 or time.monotonic() - begin > 6:
    problems.append(f"64 slow connections: {time.monotonic() - begin:.1f} s")
with socket.create_connection(("127.0.0.1", int(port))) as endless:
    begin = time.monotonic()
    try:
        endless.sendall(b"GET / HTTP/1.1\r\n")
        while time.monotonic() - begin < 10:
            endless.sendall(b"X: " + b"y" * 4000 + b"\r\n")
        problems.append("headers without an end are read for 10 s")
    except OSError:
        pass
for one in slow:
    one.close()
news = []


def listen():
    with urllib.request.urlopen(url + "news", timeout=PATIENCE_S) as answer:
        for line in answer:
            news.append(line)
            if line.startswith(b"data:"):
                return


listener = threading.Thread(target=listen, daemon=True)
listener.start()
time.sleep(0.3)
small_designs.write(project, **MET, limit="5000")
run.wait("served", "✗ broken")
listener.join(PATIENCE_S)
if listener.is_alive() or "requires more" not in get(url + "report")[1]:
    problems.append(f"news: {news}")
run.end("served", 1)

# What cannot be.
for arguments, word in ((("none.xml", "--baseline", "x.json"), "--baseline"), ((), "no project: PROJECT.xml or --files-from is needed")):
    done = subprocess.run([PROGRAM, "watch", *arguments], capture_output=True, text=True, cwd=WORK)
    if done.returncode != 2 or word not in done.stderr:
        problems.append(f"{arguments}: {done.returncode} {done.stderr}")
run = Terminal("none.xml", folder=WORK)  # it may come
run.wait("not there yet", "not judged", "none.xml")
shutil.copy(project, WORK / "none.xml")
run.wait("there now", "1 requirement: 1 fail")
run.end("there now", 1)

# Rule packs: a folder of them.
(WORK / "rules").mkdir()
shutil.copy(pathlib.Path(sys.argv[3]) / "11-classroom/rules/brief.xml", WORK / "rules/brief.xml")
run = Terminal("project.xml", "--rules", "rules", "--serve", folder=WORK)
url = re.search(r"http://\S+", run.wait("rules", "1 requirement: 1 fail")).group(0)
(WORK / "rules/new.xml").write_text("<wrong/>")
run.wait("a wrong pack", "error[wrong-root-element]", "1 project not judged")
if "could not be judged" not in get(url + "report")[1] and "not judged" not in get(url + "report")[1]:
    problems.append("a wrong pack: the page shows an older result")
(WORK / "rules/new.xml").unlink()
run.wait("without it", "1 requirement: 1 fail")
run.end("rules", 1)
early = subprocess.Popen([PROGRAM, "watch", "project.xml", "--goal", "accuracy", "--tolerance", "0.0001", "--max-paths", "1048576"], cwd=WORK,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE)
time.sleep(0.5)
early.send_signal(signal.SIGINT)
early.communicate(timeout=PATIENCE_S)
if early.returncode not in (1, 130):  # 1: it was done by then
    problems.append(f"before the first result: {early.returncode}")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
