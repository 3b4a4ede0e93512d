#!/bin/sh
# Make the peers of the benchmarks in one folder, which should lie outside the repository: a Python
# environment with galois, and the C programs.
# usage: bench/peers/setup.sh FOLDER        then: ... bench/targets --peers FOLDER
set -eu
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
python3 -m venv "$1"
"$1/bin/pip" install --quiet --requirement "$here/requirements.txt"
for program in register enumerate; do
  ${CC:-cc} -O3 -march=native -std=gnu11 -Wall -Wextra -o "$1/bin/$program" "$here/$program.c"
done
echo "peers are in $1; the C compiler is $(${CC:-cc} --version | head -n 1)"
