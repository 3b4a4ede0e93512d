#!/bin/sh
# Runs a command whose text nobody reads unless it fails: says what is being done, then how long it took. The text goes
# to a log; the compiler's warnings are shown, and after a failure the first error, or the end of the log.
# usage: tools/quietly.sh LOG WHAT COMMAND...     (the exit status is the command's)
set -u
log=$1 what=$2
shift 2
mkdir -p "$(dirname "$log")"

# What cabal says of public sublibraries at every step, and of having no repository, is true and of no use: two lines each.
without_chatter() { awk '/^Warning: .*(experimental feature|No remote package servers)/ { getline; next } { print }' "$log"; }

# Messages of the compiler of a kind: a line with a place, then indented lines and those with the source, as "75 | ...".
messages() {
  awk -v kind="$1" '
    inside && !/^( |[0-9]+ \|)/ { inside = 0; print "" }
    $0 ~ "^(<[a-z ]+>|[^ ]+:[0-9(][0-9:(),-]*): " kind { inside = 1 }
    inside { print }
    END { if (inside) print "" }' "$log"
}

duration() {
  if [ "$1" -ge 60 ]; then echo "$(($1 / 60)) min $(($1 % 60)) s"; else echo "$1 s"; fi
}

# On a terminal, what the log has come to.
show_progress() {
  while sleep 1; do
    printf '\r\033[K  %.76s' "$(tail -n 1 "$log" | sed 's/ ( .*//')"
  done
}

echo "$what (its text: $log)"
begin=$(date +%s)
: > "$log"
ticker=""
if [ -t 1 ]; then
  show_progress &
  ticker=$!
  # The ticker is this script's own child: without this it would outlive an interrupted build.
  trap 'kill "$ticker" 2>/dev/null; exit 130' INT TERM
fi
"$@" >> "$log" 2>&1
status=$?
if [ -n "$ticker" ]; then kill "$ticker" 2>/dev/null; wait "$ticker" 2>/dev/null; printf '\r\033[K'; fi
took=$(duration $(($(date +%s) - begin)))
without_chatter > "$log.clean" && mv -f "$log.clean" "$log"

if [ "$status" -eq 0 ]; then
  messages warning
  echo "  done in $took"
else
  first=$(messages error | awk '{ print } /^$/ { exit }' | head -n 40)
  printf '%s\n' "${first:-$(tail -n 20 "$log")}" >&2
  echo "pra-tactile: this failed after $took; all that was said is in $log" >&2
fi
exit "$status"
