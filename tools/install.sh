#!/bin/sh
# Installs the program with its manual pages and completions, or removes them again.
# usage: [PREFIX=/usr/local] [DESTDIR=] [PROGRAM=bin/pra-tactile] tools/install.sh install|uninstall
set -eu
cd "$(dirname "$0")/.."
program=${PROGRAM:-bin/pra-tactile}
top=${DESTDIR:-}${PREFIX:-/usr/local}
manual=$top/share/man/man1
bash=$top/share/bash-completion/completions
zsh=$top/share/zsh/site-functions
fish=$top/share/fish/vendor_completions.d

case ${1:-} in
install)
  made=$(mktemp -d)
  trap 'rm -rf "$made"' EXIT
  tools/manual.sh "$program" "$made"
  # Completions ask the program that stands on the PATH, so that they hold wherever it is moved to.
  for shell in bash zsh fish; do "$program" "--$shell-completion-script" pra-tactile > "$made/$shell"; done
  mkdir -p "$top/bin" "$manual" "$bash" "$zsh" "$fish"
  install -m 755 "$program" "$top/bin/pra-tactile"
  install -m 644 "$made"/*.1 "$manual"
  install -m 644 "$made/bash" "$bash/pra-tactile"
  install -m 644 "$made/zsh" "$zsh/_pra-tactile"
  install -m 644 "$made/fish" "$fish/pra-tactile.fish"
  echo "installed $top/bin/pra-tactile, its manual pages, and completions for bash, zsh and fish"
  ;;
uninstall)
  rm -f "$top/bin/pra-tactile" "$manual/pra-tactile.1" "$manual"/pra-tactile-*.1 \
    "$bash/pra-tactile" "$zsh/_pra-tactile" "$fish/pra-tactile.fish"
  echo "removed pra-tactile from $top"
  ;;
*)
  echo "usage: tools/install.sh install|uninstall" >&2
  exit 2
  ;;
esac
