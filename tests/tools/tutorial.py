"""The commands of examples/TUTORIAL.md, one after the other as a reader types them, with the exit codes that stand beside them.

    tutorial.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import pathlib
import re
import shutil
import subprocess
import sys

import git_repository

PROGRAM, WORK, EXAMPLES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
variables = git_repository.environment(WORK / "home")
variables.update(PATH=f"{PROGRAM.parent}:{variables['PATH']}", GIT_AUTHOR_NAME="A", GIT_AUTHOR_EMAIL="a@example.invalid", GIT_COMMITTER_NAME="A",
                 GIT_COMMITTER_EMAIL="a@example.invalid")
text = (EXAMPLES / "TUTORIAL.md").read_text()
folder, output, problems, count = WORK, "", [], 0
blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
for block in [block for kind, block in blocks if kind == "sh"]:
    for line in block.splitlines():
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
# What the page shows is what is printed.
shown = [line for kind, block in blocks if kind == "" for line in block.splitlines()]
problems += [f"not printed: {line}" for line in shown if line not in output.splitlines()]
problems += [f"a link leads nowhere: {link}" for link in re.findall(r"\]\(([^)#]+)\)", text) if not (EXAMPLES / link).exists()]
if count < 9 or len(shown) < 3:
    problems.append(f"only {count} commands and {len(shown)} lines of output found")
print("\n".join(problems))
sys.exit(1 if problems else 0)
