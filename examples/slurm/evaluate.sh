#!/bin/sh
# An evaluation in 8 shards: sbatch evaluate.sh --presses 1000000 --seed 1
# When all are done: pra-tactile merge part-*.json --output evaluation.json
# A task that is requeued goes on where its file ends.
#SBATCH --job-name=evaluate
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=evaluate-%a.log
shard=$SLURM_ARRAY_TASK_ID
pra-tactile evaluate "$@" --shard "$shard/8" --output "part-$shard.json"
