# Sourced by tests/run: each job adds what passed, what failed and what was FLAKY (failed, then passed alone) to the sums.
# shellcheck shell=bash

passed=0
failed=0
flaky=0

# entry_counts LOG...: a line "NAME GOOD BAD" for each entry of ctest's logs, in functions. A skipped function has failed,
# and so has a program that ends without its totals.
entry_counts() {
    awk '
        $1 == "Start" { name[$2 + 0] = $3 }
        match($0, /^[0-9]+: Totals: /) {
            number = $1 + 0
            for (i = 2; i < NF; ++i) {
                if ($(i + 1) ~ /^passed/) good[number] += $i
                if ($(i + 1) ~ /^(failed|skipped|blacklisted)/) bad[number] += $i
            }
        }
        /^The following tests FAILED:/ { listing = 1; next }
        listing && $2 == "-" && !bad[$1 + 0] { bad[$1 + 0] = 1 }
        END { for (number in name) print name[number], good[number] + 0, bad[number] + 0 }' "$@"
}

# run_entries PRESET LOG JOBS [CTEST_ARG...]
run_entries() {
    local preset=$1 log=$2 jobs=$3
    shift 3
    LSAN_OPTIONS="suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0" UBSAN_OPTIONS=print_stacktrace=1 \
        ctest --test-dir "build/$preset" -V -j "$jobs" --output-log "$PWD/$log" "$@" 2>/dev/null |
        sed -u -n 's|^ *\([0-9]*/[0-9]*\) Test .*|\1|p' | show_progress "testing"
}

# suite PRESET [CTEST_ARG...]: builds it and runs its entries, those that fail once more and alone.
suite() {
    local preset=$1 log name good bad counts
    shift
    say "== $preset"
    if ! build "$preset" "${targets[@]}"; then
        failed=$((failed + 1))
        return
    fi
    log=build/$preset/tests.log
    run_entries "$preset" "$log" "$jobs" --output-junit "$PWD/build/$preset/tests.xml" "$@"
    # Read once: a name that is FLAKY is counted as it was when it passed.
    counts=$(entry_counts "$log")
    while read -r name good bad; do
        [ -n "$name" ] || continue
        if [ "$bad" -ne 0 ]; then
            say "   $name failed; once more, alone"
            show_failure "$log" "$name"
            run_entries "$preset" "build/$preset/again-$name.log" 1 -R "^${name//./\\.}\$"
            read -r name good bad <<<"$(entry_counts "build/$preset/again-$name.log")"
            if [ "$bad" -eq 0 ]; then
                flaky=$((flaky + 1))
                say "   FLAKY $name"
            fi
        fi
        passed=$((passed + good))
        failed=$((failed + bad))
    done <<<"$counts"
    show_slowest "$log"
    say "   $passed passed, $failed failed so far; the whole log is $log"
}

# show_failure LOG NAME: what that entry said of it.
show_failure() {
    awk -v name="$2" '
        $1 == "Start" && $3 == name { number = $2 + 0 }
        number && $1 == number ":" && /FAIL!|XPASS|SKIP|QFATAL|Loc:|ERROR: |runtime error|AddressSanitizer|ThreadSanitizer|LeakSanitizer|Actual|Expected/' "$1" |
        head -n 30 >&2
    grep -E "Test +#[0-9]+: $2 .*\*\*\*" "$1" >&2
}

show_slowest() {
    say "   the slowest:"
    sed -n 's|^ *[0-9]*/[0-9]* Test  *#[0-9]*: \([^ ]*\) .* \([0-9.]*\) sec.*|\2 s  \1|p' "$1" | sort -rn | head -n 10 |
        sed 's/^/     /' >&2
}

# fuzz SECONDS: every fuzz target for so long, from the inputs of tests/data/fuzz on; each is one test.
fuzz() {
    local target name log begin
    say "== fuzz"
    configure asan && build asan fuzz_targets || { failed=$((failed + 1)); return; }
    for target in build/asan/tests/fuzz/fuzz_*; do
        [ -f "$target" ] && [ -x "$target" ] || continue
        name=${target##*/fuzz_}
        log=build/asan/fuzz-$name.log
        mkdir -p "build/fuzz/found/$name" "build/fuzz/inputs/$name"
        say "   fuzzing $name"
        if ASAN_OPTIONS=quarantine_size_mb=16 QT_QPA_PLATFORM=offscreen "$target" -max_total_time="$1" -timeout=60 \
            -rss_limit_mb=2500 -max_len=16384 -artifact_prefix="build/fuzz/found/$name/" \
            "build/fuzz/inputs/$name" "tests/data/fuzz/$name" >"$log" 2>&1; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            grep -E 'ERROR|SUMMARY|Test unit written' "$log" | head -n 5
            say "   fuzz_$name: the whole log is $log"
        fi
    done
}
