#!/bin/sh
# Prints the extensions that pra-tactile.cabal gives to every component, as options for what runs without cabal.
set -eu
cd "$(dirname "$0")/.."
sed -n 's/^  default-extensions://p' pra-tactile.cabal | tr -s ' ,' '\n\n' | sed -n 's/^[A-Z]/-X&/p' | tr '\n' ' '
