#!/bin/sh
# check_instructions.sh PROGRAM [BASELINE [--update]]
#
# Counts the instructions of every function measured_* in PROGRAM with callgrind, and compares them with BASELINE, a
# file of lines "NAME COUNT": more than 3 % up or down fails, for a gain belongs into the baseline. The counts are those
# of one compiler on one processor, which the first line names; with another, or without BASELINE, they are only shown.
set -eu

program=$1
baseline=${2:-}
here="# $(g++ -dumpfullversion | cut -d. -f1) $(uname -m)"
counts=$(mktemp)
trap 'rm -f "$counts" "$counts.all"' EXIT

# Symbols are bound at once, so that nothing but the functions is counted.
LD_BIND_NOW=1 valgrind --tool=callgrind --toggle-collect='measured_*' --callgrind-out-file="$counts" \
    "$program" >/dev/null 2>&1
# The caller's line in the annotated list includes what the function calls.
callgrind_annotate --inclusive=yes --threshold=100 "$counts" |
    awk '/:measured_/ {
             count = $1; gsub(",", "", count)
             match($0, /measured_[a-z0-9_]+/); name = substr($0, RSTART, RLENGTH)
             if (count + 0 > most[name]) most[name] = count + 0
         }
         END { for (name in most) print name, most[name] }' | sort >"$counts.all"

if [ -z "$baseline" ]; then
    cat "$counts.all"
    exit 0
fi
if [ "${3:-}" = --update ]; then
    { echo "$here"; cat "$counts.all"; } >"$baseline"
    cat "$baseline"
    exit 0
fi
[ -f "$baseline" ] || { echo "no baseline: $0 $program $baseline --update" >&2; exit 1; }
if [ "$(head -n 1 "$baseline")" != "$here" ]; then
    echo "the baseline is of '$(head -n 1 "$baseline")', this is '$here': not compared"
    cat "$counts.all"
    exit 0
fi
awk '/^#/ { next }
     NR == FNR { old[$1] = $2; next }
     { seen[$1] = 1 }
     !($1 in old) { print "NEW  ", $0; bad = 1; next }
     {
         change = 100 * ($2 - old[$1]) / old[$1]
         verdict = change > 3 ? "WORSE" : change < -3 ? "BETTER" : "ok"
         if (verdict != "ok") bad = 1
         printf "%-6s %-48s %8d -> %8d %+6.1f %%\n", verdict, $1, old[$1], $2, change
     }
     END { for (name in old) if (!(name in seen)) { print "GONE ", name; bad = 1 } exit bad }' "$baseline" "$counts.all"
