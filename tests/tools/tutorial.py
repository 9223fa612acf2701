"""Runs the commands of pages for readers, as the pages show them.

    tutorial.py LUXGATE FOLDER EXAMPLES          runs EXAMPLES/TUTORIAL.md in FOLDER, which is made anew
    tutorial.py LUXGATE FOLDER EXAMPLES MANUAL   runs every page of the folder MANUAL, each in a folder of its own with a copy of EXAMPLES

Each line of a block ```sh is a command; its exit code is 0 unless "    # exit code N" says otherwise. Each line of a block without a
kind must be printed by a command of the page; "..." there means omitted lines. A block "```KIND FILE" is written to FILE. Blocks of
other kinds are not run. Links must lead to files and headings that exist. Pages of a manual must keep to short sentences and paragraphs.
"""
import pathlib
import re
import shutil
import subprocess
import sys

import git_repository

MOST_WORDS_OF_A_SENTENCE, MOST_WORDS_OF_A_PARAGRAPH = 30, 80
BLOCK = re.compile(r"^```(\w*) ?([\w./-]*)\n(.*?)^```$", re.M | re.S)


def paragraphs(text):
    """Returns paragraphs and items of lists as they are read: without blocks, tables, headings and remarks, each piece of code as a word."""
    text = re.sub(r"<!--.*?-->", "", BLOCK.sub("\n", text), flags=re.S)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"`[^`]*`", "code", text))
    text = re.sub(r"^(\||#).*$", "", text, flags=re.M)
    text = re.sub(r"^\s*([-*]|\d+\.) ", "\n", text, flags=re.M)
    return [" ".join(paragraph.split()) for paragraph in re.split(r"\n\s*\n", text) if paragraph.strip()]


def sentences(paragraph):
    return [sentence for sentence in re.split(r"(?<=[.!?])[*_)\"”]*\s+", paragraph) if sentence]


def words(text):
    return sum(any(letter.isalnum() for letter in word) for word in text.split())


def too_long(text):
    for paragraph in paragraphs(text):
        if words(paragraph) > MOST_WORDS_OF_A_PARAGRAPH:
            yield f"a paragraph has {words(paragraph)} words, at most {MOST_WORDS_OF_A_PARAGRAPH} are allowed: {paragraph[:60]}..."
        for sentence in sentences(paragraph):
            if words(sentence) > MOST_WORDS_OF_A_SENTENCE:
                yield f"a sentence has {words(sentence)} words, at most {MOST_WORDS_OF_A_SENTENCE} are allowed: {sentence[:60]}..."


def anchors(text):
    headings = re.findall(r"^#+ (.*)$", BLOCK.sub("", text), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(page, text):
    for link in re.findall(r"\]\(([^)]+)\)", BLOCK.sub("", text)):
        file, _, anchor = link.partition("#")
        target = page.parent / file if file else page
        if "://" not in link and not (target.exists() and (not anchor or anchor in anchors(target.read_text()))):
            yield f"a link leads nowhere: {link}"


def run_page(page, folder, variables):
    """Returns the number of commands, the number of lines of output shown, and what is wrong."""
    text, output, problems, count, shown = page.read_text(), "", [], 0, []
    for kind, file, block in BLOCK.findall(text):
        if file:
            (folder / file).write_text(block)
        elif kind == "":
            shown += [line for line in block.splitlines() if line.strip() != "..."]
        for line in block.splitlines() if kind == "sh" else []:
            command, _, remark = line.partition("    # exit code ")
            command = command.partition("    # ")[0]
            if command.startswith("cd "):
                folder = folder / command[3:]
                continue
            done = subprocess.run(["bash", "-c", command], cwd=folder, env=variables, capture_output=True, text=True, check=False)
            output += done.stdout + done.stderr
            count += 1
            if done.returncode != int(remark or 0):
                problems.append(f"{command}: exit code {done.returncode}, expected {remark or 0}\n{done.stderr}")
    printed = set(output.splitlines())
    problems += [f"not printed: {line}" for line in shown if line not in printed]
    return count, len(shown), problems + list(dead_links(page, text))


def main():
    program, work, examples = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    variables = git_repository.environment(work / "home")
    variables.update(PATH=f"{program.parent}:{variables['PATH']}", GIT_AUTHOR_NAME="A", GIT_AUTHOR_EMAIL="a@example.invalid", GIT_COMMITTER_NAME="A",
                     GIT_COMMITTER_EMAIL="a@example.invalid")
    if len(sys.argv) == 4:
        count, shown, problems = run_page(examples / "TUTORIAL.md", work, variables)
        least_commands, least_shown = 9, 3
    else:
        count, shown, problems, least_commands, least_shown = 0, 0, [], 40, 60
        for page in sorted(pathlib.Path(sys.argv[4]).resolve().glob("*.md")):
            shutil.copytree(examples, work / page.stem / "examples")
            commands, lines, wrong = run_page(page, work / page.stem, variables)
            count, shown = count + commands, shown + lines
            problems += [f"{page.name}: {problem}" for problem in [*wrong, *too_long(page.read_text())]]
    if count < least_commands or shown < least_shown:
        problems.append(f"only {count} commands and {shown} lines of output found")
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
