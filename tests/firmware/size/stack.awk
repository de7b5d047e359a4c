# awk -v name=NAME -v max=BYTES -v buffers=BYTES -v entries=FUNCTION,... -f stack.awk UNIT.ci
#
# The stack that the deepest chain of calls below the entries takes: the sum of what g++ -fcallgraph-info=su says of
# each function, without the buffers of the entry. The unit holds all of the library that it calls; what it calls
# outside is the application's, and named.
BEGIN { FS = "\"" }

/^node:/ && match($4, /[0-9]+ bytes \([a-z,]+\)/) {
    used[$2] = substr($4, RSTART) + 0
    if ($4 ~ /bytes \(dynamic\)/) fail("a stack that is not bounded: " $2)
    next
}
/^node:/ { outside[$2] = 1 }
/^edge:/ { calls[$2] = calls[$2] $4 "\"" }

function fail(why) {
    print name ": " why
    failed = 1
    exit 1
}

function deepest(caller,    callees, count, i, most, depth) {
    if (caller in known) return known[caller]
    if (caller in entered) fail("recursion: " caller)
    entered[caller] = 1
    count = split(calls[caller], callees, "\"")
    for (i = 1; i < count; ++i) {
        depth = deepest(callees[i])
        if (depth > most) most = depth
    }
    return known[caller] = used[caller] + most
}

END {
    if (failed) exit 1
    count = split(entries, entry, ",")
    for (i = 1; i <= count; ++i) {
        found = 0
        for (title in used) {
            if (title != entry[i] && index(title, "_Z" length(entry[i]) entry[i]) != 1) continue
            found = 1
            depth = deepest(title) - buffers
            if (depth > most) most = depth
        }
        if (!found) fail("no function " entry[i])
    }
    for (title in outside) printf "not counted: %s\n", title
    verdict = most <= max ? "ok" : "MISSED"
    printf "figure|%s: stack|%d B|at most %d B|%s\n", name, most, max, verdict
    exit verdict != "ok"
}
