#!/bin/sh
# Makes types from the schemas by generators of other people, in Python, TypeScript and Go, and has them compiled: so that who
# reads or writes these forms need not write them down again. It takes datamodel-codegen (Python), quicktype and tsc (npm), and go.
# usage: tools/types.sh [FOLDER]; without one nothing is kept
set -eu
cd "$(dirname "$0")/.."
schemas=$PWD/data/schemas
for program in datamodel-codegen quicktype tsc go; do
  command -v "$program" > /dev/null || { echo "pra-tactile: there is no $program here, by which types are made" >&2; exit 1; }
done
folder=${1:-$(mktemp -d)}
[ $# -gt 0 ] || trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/go"

datamodel-codegen --input "$schemas" --input-file-type jsonschema --output-model-type dataclasses.dataclass \
  --formatters builtin --output "$folder/python"
for file in "$folder"/python/*.py; do
  (cd "$folder" && python3 -c "import python.$(basename "$file" .py)")
done
for schema in request reply profile conform vectors suite; do
  quicktype --quiet --src-lang schema -S "$schemas/common.json" --lang typescript --just-types --top-level "$schema" \
    -o "$folder/$schema.ts" "$schemas/$schema.json"
  mkdir -p "$folder/go/$schema"
  quicktype --quiet --src-lang schema -S "$schemas/common.json" --lang go --package "$schema" --top-level "$schema" \
    -o "$folder/go/$schema/$schema.go" "$schemas/$schema.json"
done
tsc --strict --noEmit --target es2020 "$folder"/*.ts
(cd "$folder/go" && { [ -e go.mod ] || go mod init types 2> /dev/null; } && go vet ./...)
echo "types of all schemas in Python, and of the protocol's in TypeScript and Go: they compile"
