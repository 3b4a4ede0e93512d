#!/bin/sh
# Makes the manual pages from the program's own --help, so that the two cannot differ: pra-tactile.1, and one page a command.
# usage: tools/manual.sh PROGRAM FOLDER
set -eu
program=$1 folder=$2
mkdir -p "$folder"

# A help text to a page. Headings and entries are told by their indentation: entries start in column 2, what is said of
# one is parted from it by two spaces or stands far to the right on the next lines.
page() { # NAME-OF-PAGE  ONE-LINE-DESCRIPTION-OR-NOTHING
  awk -v page="$1" -v title="$2" -v version="$version" -v date="$date" -v status="$exit_status" -v commands="$commands" '
    function escaped(text) {
      gsub(/\\/, "\\e", text); gsub(/\^/, "\\(ha", text); gsub(/~/, "\\(ti", text); gsub(/`/, "\\(ga", text)
      gsub(/\047/, "\\(aq", text)
      return text
    }
    # Typed text: what looks like a hyphen is one.
    function typed(text) { text = escaped(text); gsub(/-/, "\\-", text); return text }
    # Prose: options in it are typed text.
    function prose(text,   words, i, n) {
      n = split(text, words, " ")
      text = ""
      for (i = 1; i <= n; i++)
        text = text (i > 1 ? " " : "") (words[i] ~ /--/ || words[i] ~ /^[(\047]?-/ || words[i] ~ /pra-tactile/ ? typed(words[i]) : escaped(words[i]))
      return text
    }
    # In lines of less than 80 columns, none of which looks like a macro.
    function put(text,   words, i, n, line) {
      n = split(text, words, " ")
      line = words[1]
      for (i = 2; i <= n; i++)
        if (length(line) + length(words[i]) < 78) line = line " " words[i]
        else { put_line(line); line = words[i] }
      put_line(line)
    }
    function put_line(line) { print (line ~ /^\./ ? "\\&" : "") line }
    function flush() {
      if (paragraph != "") { if (!entry && !fresh) print ".PP"; put(prose(paragraph)); fresh = 0 }
      paragraph = ""; entry = 0
    }
    function add(text) { sub(/^ +/, "", text); paragraph = paragraph (paragraph == "" ? "" : " ") text }
    function section(name) { flush(); print ".SH " toupper(name); fresh = 1 }
    function end_of_usage() { if (part == "usage") { put(typed(usage)); section("Description"); if (about != "") put(prose(about)); part = "text" } }
    BEGIN {
      print ".TH " toupper(typed(page)) " 1 \"" date "\" \"pra\\-tactile " typed(version) "\" \"pra\\-tactile\""
      print ".nh\n.ad l"
    }
    /^Usage: / {
      # Before the usage, the program says in a sentence what it is for.
      if (title == "") { title = paragraph; sub(/^[^ ]+ - /, "", title); about = toupper(substr(title, 1, 1)) substr(title, 2) "." }
      paragraph = ""
      section("Name"); put(typed(page) " \\- " prose(tolower(substr(title, 1, 1)) substr(title, 2)))
      section("Synopsis"); part = "usage"; usage = substr($0, 8); next
    }
    part == "usage" && /^   / { line = $0; sub(/^ +/, "", line); sub(/ +$/, "", usage); usage = usage " " line; next }
    { end_of_usage() }
    /^Examples?:$/ { section("Examples"); part = "examples"; print ".nf"; next }
    part == "examples" && /^  / { sub(/^  /, ""); sub(/ +$/, ""); print typed($0); next }
    part == "examples" { print ".fi"; part = "text" }
    /^Exit status: / { flush(); part = "status"; next }
    part == "status" { next }
    /^$/ { if (part != "") flush(); next }
    /^[A-Z][^.]*:$/ { sub(/:$/, ""); section($0 == "Available options" ? "Options" : ($0 == "Available commands" ? "Commands" : $0)); part = "entries"; next }
    part == "entries" && /^  [^ ]/ {
      flush()
      sub(/^  /, ""); cut = match($0, /   */)
      tag = cut ? substr($0, 1, cut - 1) : $0
      print ".TP\n.B " typed(tag)
      entry = 1
      if (cut) add(substr($0, cut))
      next
    }
    { add($0) }
    END {
      end_of_usage(); flush()
      if (part == "examples") print ".fi"
      if (status != "") { section("Exit status"); put(prose(status)) }
      section("See also")
      n = split(page == "pra-tactile" ? commands : "pra-tactile", others, " ")
      for (i = 1; i <= n; i++) print ".BR " typed(page == "pra-tactile" ? "pra-tactile-" others[i] : others[i]) " (1)" (i < n ? " ," : "")
    }'
}

date=$(date -r "$program" +%Y-%m-%d)
version=$("$program" --version | sed 's/^pra-tactile \([^,]*\).*/\1/')
help=$("$program" --help)
exit_status=$(printf '%s\n' "$help" | sed -n '/^Exit status: /,/^$/p' | tr '\n' ' ' | sed -e 's/^Exit status: //' -e 's/ *$//')
# The entries of every list but the options, by name.
commands=$(printf '%s\n' "$help" | awk '/^[A-Z].*:$/ { listed = !/options/ } listed && /^  [a-z]/ { print $1 }')
printf '%s\n' "$help" | page pra-tactile "" > "$folder/pra-tactile.1"

for command in $commands; do
  text=$("$program" "$command" --help)
  # What it does, as the program's help has it on one line.
  title=$(printf '%s\n' "$help" | awk -v name="$command" '/^  [a-z]/ && $1 == name { sub(/^  [a-z]+ +/, ""); print; exit }')
  printf '%s\n' "$text" | page "pra-tactile-$command" "$title" > "$folder/pra-tactile-$command.1"
done
