"""Git repositories for tests: nobody's settings, and the same ids of commits each time."""
import os
import subprocess


def environment(home):
    """Of the machine only what programs need to run: no GIT_*, no store, no settings of its user."""
    kept = {name: os.environ[name] for name in ("PATH", "LD_LIBRARY_PATH", "TMPDIR") if name in os.environ}
    home.mkdir(parents=True, exist_ok=True)
    moment = "2024-05-01T12:00:00Z"
    return {**kept, "HOME": str(home), "LC_ALL": "C", "GIT_CONFIG_NOSYSTEM": "1", "GIT_AUTHOR_DATE": moment, "GIT_COMMITTER_DATE": moment}


class Repository:
    def __init__(self, folder, variables):
        self.folder = folder
        self.variables = variables
        folder.mkdir(parents=True)
        self.git("init", "-q", "-b", "main")
        self.git("config", "user.name", "A")
        self.git("config", "user.email", "a@example.invalid")

    def git(self, *arguments):
        done = subprocess.run(["git", *map(str, arguments)], cwd=self.folder, env=self.variables, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(f"git {' '.join(map(str, arguments))}: {done.stderr}")
        return done.stdout.strip()

    def commit(self, message="change"):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", message)
        return self.git("rev-parse", "HEAD")
