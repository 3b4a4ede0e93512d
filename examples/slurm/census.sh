#!/bin/sh
# A census in 8 shards: sbatch census.sh --q 4 --degree 6
# When all are done: pra-tactile merge part-*.csv --output census.csv
# A task that is requeued goes on where its file ends.
#SBATCH --job-name=census
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=census-%a.log
shard=$SLURM_ARRAY_TASK_ID
pra-tactile census "$@" --shard "$shard/8" --output "part-$shard.csv"
