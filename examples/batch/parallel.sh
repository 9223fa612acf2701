#!/bin/bash
# bash parallel.sh designs/*.xml: shards by GNU parallel, then the report. Run again it does the
# shards again that failed. PARALLEL='--sshlogin a,b' takes other machines, too.
# After a change of a design: delete the joblog first.
set -u
shards=${SHARDS:-4}
store=${STORE:-looks}
options=(--seed 1)  # the same for all: they change results
reports=(--format html=batch.html --format csv=batch.csv --format json=batch.json)

luxgate plan --units --format json "$@" >"$store-units.json" || exit 2
seq "$shards" | parallel --quote --joblog "$store.joblog" --resume-failed \
  luxgate check "${options[@]}" --jobs 1 --store "$store" --units "$store-units.json" --shard "{}/$shards" -- "$@"
luxgate check "${options[@]}" "${reports[@]}" --store "$store" --stored-only -- "$@"
