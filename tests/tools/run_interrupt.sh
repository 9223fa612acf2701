#!/usr/bin/env bash
# SIGINT during a calculation: exit code 130 and no file. Arguments: luxgate, project, scratch folder.
set -u
luxgate=$1 project=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"

# An accuracy that cannot be reached in time keeps it busy. Background jobs of scripts ignore SIGINT, so SIGTERM it is.
"$luxgate" check "$project" --goal accuracy --tolerance 0.00001 --max-paths 1073741824 --output "$scratch/out" \
  >"$scratch/stdout" 2>"$scratch/stderr" &
pid=$!
sleep 1.5
kill -TERM "$pid" || { echo "ended before the signal"; cat "$scratch/stderr"; exit 1; }
wait "$pid"
status=$?
cat "$scratch/stderr"
[[ $status -eq 130 ]] || { echo "exit code $status, expected 130"; exit 1; }
[[ ! -e "$scratch/out" ]] || { echo "something was written"; exit 1; }
[[ ! -s "$scratch/stdout" ]] || { echo "standard output is not empty"; exit 1; }
