#!/bin/bash
# bash slurm.sh designs/*.xml: an array of shards, then a closing job, however the shards ended.
# SBATCH_PARTITION, SBATCH_ACCOUNT and SBATCH_TIMELIMIT say the rest. On GPUs: add --gres=gpu:1 to
# both calls of sbatch, and --backend gpu to `options`.
set -eu
shards=${SHARDS:-4}
store=${STORE:-looks}
options=(--seed 1)  # the same for all: they change results
reports=(--format html=batch.html --format csv=batch.csv --format json=batch.json)

units=$(realpath -m -- "$store-units.json")
luxgate plan --units --format json "$@" >"$units"

# What sbatch reads on its standard input is the job; its words are "$@" there.
array=$(sbatch --parsable --array="1-$shards" --output="$store-%a.log" /dev/stdin \
  "${options[@]}" --store "$store" --units "$units" -- "$@" <<'JOB'
#!/bin/bash
exec luxgate check --jobs 1 --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_MAX" "$@"
JOB
)

# The verdict is what the closing job writes itself: Slurm's code is 0 or 1 where it was cancelled, too.
rm -f -- "$store-close.code"
closing=$(sbatch --parsable --dependency="afterany:${array%%;*}" --output="$store-close.log" /dev/stdin \
  "$store-close.code" "${options[@]}" "${reports[@]}" --store "$store" --stored-only -- "$@" <<'JOB'
#!/bin/bash
luxgate check "${@:2}"
code=$?
echo "$code" >"$1"
exit "$code"
JOB
)
echo "shards: job $array; closing job: job $closing"

# WAIT=1 waits for it, and ends with its exit code.
if [ -n "${WAIT:-}" ]; then
  while [ -n "$(squeue --noheader --jobs="${closing%%;*}" 2>/dev/null)" ]; do sleep 2; done
  exit "$(cat -- "$store-close.code" || echo 2)"
fi
