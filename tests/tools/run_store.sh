#!/usr/bin/env bash
# `check --store` from outside: the same bytes and exit code as without, cold, warm, pruned, damaged, shared by running
# processes, and after writers were killed. Arguments: luxgate, example folder, scratch folder, how often one is killed.
set -u
luxgate=$1 example=$2 scratch=$3 kills=$4
rm -rf "$scratch"
mkdir -p "$scratch"
store=$scratch/store
unset LUXGATE_STORE

fail() { echo "$*"; exit 1; }
# check NAME OPTION...: every format into $scratch/NAME; gives the exit code.
check() {
  local name=$1
  shift
  "$luxgate" check "$example/project.xml" --pictures off --jobs 1 --output "$scratch/$name" \
    --format text="$scratch/$name.txt" --format sarif="$scratch/$name.sarif" --format junit="$scratch/$name.xml" \
    "$@" >"$scratch/$name.out" 2>"$scratch/$name.err"
}
same() {
  diff -r "$scratch/plain" "$scratch/$1" >/dev/null || fail "$1: files differ"
  for kind in out txt sarif xml; do cmp "$scratch/plain.$kind" "$scratch/$1.$kind" || fail "$1: $kind differs"; done
}
# with NAME OPTION...: as check, and the same as without a store.
with() {
  check "$@" --store "$store"
  [[ $? -eq $code ]] || fail "$1: another exit code than $code: $(cat "$scratch/$1.err")"
  same "$1"
}
taken() { grep -o 'store: .*' "$scratch/$1.err"; }

check plain
code=$?
with cold --explain-cost
[[ $(taken cold) == "store: 0 sampling rounds"* ]] || fail "cold: $(taken cold)"
with warm --explain-cost
[[ $(taken warm) == *" 0 computed" ]] || fail "warm: $(taken warm)"
LUXGATE_STORE=$store check variable --explain-cost
same variable
[[ $(taken variable) == *" 0 computed" ]] || fail "variable: $(taken variable)"
LUXGATE_STORE=$store check off --explain-cost --store off
same off
[[ -z $(taken off) ]] || fail "off: $(taken off)"

# A damaged entry: one warning, which --strict does not count; then it is whole again.
"$luxgate" store verify "$store" >/dev/null || fail "a whole store is said to be damaged"
entry=$(find "$store" -mindepth 2 -type f | sort | head -n 1)
printf X | dd of="$entry" bs=1 seek=100 conv=notrunc status=none
"$luxgate" store verify "$store" >"$scratch/verify.txt" && fail "a damaged entry was not found"
grep -q 'its checksum is wrong' "$scratch/verify.txt" || fail "$(cat "$scratch/verify.txt")"
with damaged --strict
[[ $(grep -c 'warning\[store-entry-unusable\]' "$scratch/damaged.err") -eq 1 ]] || fail "$(cat "$scratch/damaged.err")"
"$luxgate" store verify "$store" >/dev/null || fail "the damaged entry was not replaced"

# Half of it is pruned.
bytes=$(find "$store" -mindepth 2 -type f -printf '%s\n' | awk '{s += $1} END {print s}')
"$luxgate" store prune "$store" --max-size $((bytes / 2)) >"$scratch/prune.txt" || fail "prune: $(cat "$scratch/prune.txt")"
with pruned
"$luxgate" store info "$store" | grep -q entries || fail "info says nothing"

# Two at once, from nothing.
rm -rf "$store"
(with first) & one=$!
(with second) & two=$!
wait $one || exit 1
wait $two || exit 1

# Killed at any moment: what is left is used or not, and nothing but temporary files is odd.
for ((k = 0; k < kills; ++k)); do
  [[ $((k % 3)) -eq 0 ]] && rm -rf "$store"
  check killed --store "$store" --seed $((1 + k % 2)) & pid=$!
  sleep "0.$(printf %03d $((RANDOM % 150)))"
  kill -KILL $pid $(ps -o pid= --ppid $pid) 2>/dev/null
  wait $pid 2>/dev/null
  rm -rf "$scratch/killed"*
  if [[ -e $store/CACHEDIR.TAG ]]; then
    "$luxgate" store verify "$store" >/dev/null || fail "killed: damaged entries"
  fi
  with after
  ! grep -q 'warning\[store' "$scratch/after.err" || fail "killed: $(cat "$scratch/after.err")"
done

# Stores that cannot be.
: >"$scratch/file"
check file --store "$scratch/file"
[[ $? -eq 2 ]] || fail "a file was taken for a store"
grep -q 'is not a folder' "$scratch/file.err" || fail "$(cat "$scratch/file.err")"
store=/dev/null/store
with unwritable
[[ $(grep -c 'warning\[store-not-written\]' "$scratch/unwritable.err") -eq 1 ]] || fail "$(cat "$scratch/unwritable.err")"
echo "the same in all cases"
