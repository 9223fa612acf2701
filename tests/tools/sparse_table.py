"""The table of tests/validation/sparse.md, by `bench_core sparse`: kept as it is, or written anew.

    sparse_table.py BENCH_CORE SPARSE.md            its quickest row is what the program prints; seconds
    sparse_table.py BENCH_CORE SPARSE.md --write    the whole table; half an hour
"""
import pathlib
import re
import subprocess
import sys

PROGRAM, FILE = sys.argv[1], pathlib.Path(sys.argv[2])
QUICKEST = "dark hall"


def printed(*arguments):
    done = subprocess.run([PROGRAM, "sparse", "400", *arguments], capture_output=True, text=True, check=True)
    lines = [re.split(r"\s{2,}", line.strip()) for line in done.stdout.splitlines() if line.startswith("  ")]
    return ["| " + " | ".join(line) + " |" for line in lines[1:]]


text = FILE.read_text()
if "--write" in sys.argv:
    kept = text[:text.rindex("|---|\n") + len("|---|\n")]
    FILE.write_text(kept + "\n".join(printed("--min-paths", "64", "--max-paths", "1024")) + "\n")
    sys.exit(0)
missing = [row for row in printed(QUICKEST, "--min-paths", "64", "--max-paths", "64") if row not in text.splitlines()]
print("\n".join(f"not in {FILE.name}: {row}" for row in missing) or "as it is kept")
sys.exit(1 if missing else 0)
