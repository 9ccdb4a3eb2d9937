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
        /^[0-9]+: Totals: / {
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

# run_entries PRESET LOG JOBS [CTEST_ARG...]: in large pages, where the kernel gives them to who asks: entries start hundreds of
# programs, and a fifth of what these cost is pages.
run_entries() {
    local preset=$1 log=$2 jobs=$3
    shift 3
    GLIBC_TUNABLES=glibc.malloc.hugetlb=1 ctest --test-dir "build/$preset" -V -j "$jobs" --output-log "$PWD/$log" "$@" 2>&1 |
        sed -u -n 's|^ *\([0-9]*/[0-9]*\) Test .*|\1|p' | show_progress "testing $preset"
}

# run_suite PRESET [CTEST_ARG...]: runs the entries of a build, those that fail once more and alone.
run_suite() {
    local preset=$1 log=build/$1/tests.log name good bad before=$passed
    shift
    run_entries "$preset" "$log" 3 --output-junit "$PWD/build/$preset/tests.xml" "$@" # Windows wait for their timers.
    while read -r name good bad; do
        if [ "$bad" -ne 0 ]; then
            say "   $name failed; once more, alone"
            show_failure "$log" "$name"
            run_entries "$preset" "build/$preset/again.log" 1 -R "^${name//./\\.}\$"
            read -r name good bad < <(entry_counts "build/$preset/again.log")
            if [ "$bad" -eq 0 ]; then
                flaky=$((flaky + 1))
                say "   FLAKY $name"
            else
                show_failure "build/$preset/again.log" "$name"
            fi
        fi
        passed=$((passed + good))
        failed=$((failed + bad))
    done < <(entry_counts "$log")
    [ "$passed" -gt "$before" ] || failed=$((failed + 1)) # Nothing was run.
    say "   the slowest of $preset:"
    sed -n 's|.*<testcase name="\([^"]*\)".* time="\([0-9.]*\)".*|\2 s  \1|p' "build/$preset/tests.xml" | sort -rn | head -n 10 |
        sed 's/^/     /' >&2
    say "   so far $passed passed, $failed failed; the whole log is $log"
}

# suite PRESET
suite() {
    say "== $1"
    build "$1" || { failed=$((failed + 1)); return; }
    run_suite "$1"
}

# sanitized PRESET
sanitized() {
    install_packages "${HAIRPAINT_CLANG_PACKAGES[@]}" || exit 1
    suite "$1"
}

# crowded TIMES: the ordinary suite so often, beside two processes that use both cores.
crowded() {
    local turn burners=()
    say "== crowded"
    build release || { failed=$((failed + 1)); return; }
    for turn in 1 2; do
        while :; do :; done &
        burners+=($!)
    done
    # shellcheck disable=SC2064
    trap "kill ${burners[*]}" EXIT
    for ((turn = 1; turn <= $1; ++turn)); do
        say "   turn $turn of $1"
        run_suite release
    done
}

# named NAME...: builds and runs the entries whose names hold one of them.
named() {
    local pattern entries programs
    pattern=$(IFS='|' && echo "$*")
    configure release || { failed=$((failed + 1)); return; }
    # Lines add_test([=[sim.lay]=] ".../tests/sim/test_sim" "lay").
    entries=$(cat build/release/tests/*/CTestTestfile.cmake | sed -n 's|^add_test(\[=\[\([^]]*\)\]=\] .*/tests/[a-z]*/\([a-z_]*\)".*|\1 \2|p')
    mapfile -t programs < <(awk -v pattern="$pattern" '$1 ~ pattern { print $2 }' <<<"$entries" | sort -u)
    if [ "${#programs[@]}" -eq 0 ]; then
        say "No test has a name that holds $*. The names:"
        cut -d ' ' -f 1 <<<"$entries" | tr '\n' ' ' >&2
        exit 2
    fi
    build release "${programs[@]}" || { failed=$((failed + 1)); return; }
    run_suite release -R "$pattern"
}

# show_failure LOG NAME: what that entry said of it.
show_failure() {
    awk -v name="$2" '
        $1 == "Start" && $3 == name { number = $2 + 0 }
        number && index($0, " Test ") && index($0, name " ") { print }
        number && $1 == number ":" { last[++lines % 12] = $0 }
        number && $1 == number ":" && /FAIL!|XPASS|SKIP|QFATAL|Loc:|ERROR: |runtime error|AddressSanitizer|ThreadSanitizer|LeakSanitizer|Actual|Expected/ {
            print
            told = 1
        }
        # It crashed or ran out of time: what it said last.
        END { for (i = lines - 11; !told && i <= lines; ++i) if (i > 0) print last[i % 12] }' "$1" |
        head -n 30 >&2
}

# fuzz SECONDS: every fuzz target for so long, two at a time, from the inputs of tests/data/fuzz on; each is one test.
fuzz() {
    install_packages "${HAIRPAINT_CLANG_PACKAGES[@]}" || exit 1
    say "== fuzz"
    build asan fuzz_targets || { failed=$((failed + 1)); return; }
    rm -f build/fuzz/*.result
    find build/asan/tests/fuzz -maxdepth 1 -name 'fuzz_*' -type f -executable | sort | xargs -P 2 -I TARGET bash -c '
        name=${1##*/fuzz_} log=build/fuzz/${1##*/fuzz_}.log
        mkdir -p "build/fuzz/found/$name" "build/fuzz/inputs/$name"
        leaks=1
        [ "$name" = settings ] && leaks=0 # What Qt keeps of a thread that is just ending looks like one.
        if ASAN_OPTIONS=quarantine_size_mb=16 QT_QPA_PLATFORM=offscreen "$1" -max_total_time="$2" -timeout=60 \
            -rss_limit_mb=2500 -max_len=16384 -detect_leaks=$leaks -artifact_prefix="build/fuzz/found/$name/" \
            "build/fuzz/inputs/$name" "tests/data/fuzz/$name" >"$log" 2>&1; then
            echo "   fuzz_$name found nothing" | tee "build/fuzz/$name.result" >&2
        else
            grep -E "ERROR|SUMMARY|Test unit written" "$log" | head -n 5 >&2
            echo "   fuzz_$name: the whole log is $log" >&2
            echo failed >"build/fuzz/$name.result"
        fi' _ TARGET "$1"
    count_results build/fuzz/*.result
}

# count_results FILE...: each is one test, which failed or was late where it says so.
count_results() {
    local bad late
    bad=$(cat "$@" | grep -c '^failed')
    late=$(cat "$@" | grep -c '^late')
    failed=$((failed + bad))
    passed=$((passed + $# - bad - late))
}

# tidy SECONDS FILE...: clang-format and clang-tidy; each file is one test. Those that are not begun by then are told of.
tidy() {
    local end=$((SECONDS + $1)) file late
    shift
    [ "$#" -eq 0 ] && return
    mkdir -p build/tidy/clean build/tidy/results
    rm -f build/tidy/results/*
    # Precompiled headers of GCC mean nothing to clang; generated files must be there.
    cmake -S . -B build/tidy -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
        -DHAIRPAINT_BENCHMARKS=ON -DHAIRPAINT_GENERATORS=ON >build/tidy/configure.log 2>&1 || { tail -n 5 build/tidy/configure.log; failed=$((failed + 1)); return; }
    # Only what moc writes is read; the targets themselves would compile every library first.
    find build/tidy -name AutogenInfo.json -print0 | xargs -0 -P 2 -I INFO cmake -E cmake_autogen INFO Debug >/dev/null 2>&1
    printf '%s\n' "$@" | END=$(($(date +%s) + end - SECONDS)) xargs -P 2 -I FILE bash -c '
        name=$(printf %s "$1" | tr / _) log=build/tidy/$(printf %s "$1" | tr / _).log
        finish() { echo "$1 $2" >"build/tidy/results/$name"; echo; exit; }
        clang-format --dry-run --Werror "$1" >"$log" 2>&1 || finish failed "$1"
        case "$1" in *_wgl.cpp | *_windows.cpp | *.h) finish good "$1" ;; esac
        [ "$(date +%s)" -lt "$END" ] || finish late "$1"
        # A file that was clean is not read again until its text, headers included, or the checks differ.
        command=$(grep -F -B 1 "\"file\": \"$PWD/$1\"" build/tidy/compile_commands.json | sed -n "s/^ *\"command\": \"\(.*\)\",\$/\1/p" | head -n 1 | sed "s/\\\\\(.\)/\1/g")
        key=$({ cat .clang-tidy; cd build/tidy && eval "${command/ -o * -c / -E }" 2>/dev/null; } | sha256sum | cut -c 1-32)
        [ -e "build/tidy/clean/$key" ] && finish good "$1"
        clang-tidy -quiet -p build/tidy "$1" >"$log" 2>/dev/null || finish failed "$1"
        touch "build/tidy/clean/$key"
        finish good "$1"' _ FILE | count_lines "$#" | show_progress "reading"
    while read -r _ file; do
        grep -E '(error|warning):' "build/tidy/$(printf %s "$file" | tr / _).log" | head -n 20 >&2
    done < <(grep -h '^failed' build/tidy/results/*)
    late=$(cat build/tidy/results/* | grep -c '^late')
    [ "$late" -eq 0 ] || say "   $late of $# files were not read for want of time; tests/run --tidy reads all"
    count_results build/tidy/results/*
}

# count_lines ALL: lines "DONE/ALL".
count_lines() {
    local line done=0
    while IFS= read -r line; do echo "$((++done))/$1"; done
}

# Our own sources; the sanitizers' and Windows' guarded files included.
is_source='\.(cpp|h)$'

tidy_all() {
    install_packages "${HAIRPAINT_TIDY_PACKAGES[@]}" || exit 1
    say "== tidy"
    mapfile -t files < <(git ls-files | grep -E "$is_source")
    tidy 36000 "${files[@]}"
}

# What differs from where this work began: where it left origin's main, or else, as in a clone of its result, the last commit
# of four hours before it. All files are formatted; as many as can be in four minutes are read, the newest first.
tidy_changed() {
    local base
    install_packages "${HAIRPAINT_TIDY_PACKAGES[@]}" || exit 1
    say "== tidy"
    base=$(git merge-base HEAD origin/main 2>/dev/null)
    if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
        base=$(git rev-list -1 --before="$(($(git log -1 --format=%ct) - 4 * 3600))" HEAD)
    fi
    say "   what changed since $(git log -1 --format='%h %s' "${base:-HEAD}")"
    mapfile -t files < <(git log --no-renames --diff-filter=d --name-only --pretty=format: "${base:-HEAD}..HEAD" | grep -E "$is_source" |
        awk '!seen[$0]++' | while read -r file; do [ -f "$file" ] && printf '%s\n' "$file"; done)
    tidy 240 "${files[@]}"
    git ls-files | grep -E "$is_source" | xargs clang-format --dry-run --Werror || failed=$((failed + 1))
}

# counted COMMAND...: its last line tells "N passed, M failed".
counted() {
    local log=build/counted.log good bad
    "$@" 2>&1 | tee "$log" >&2
    read -r good bad < <(tail -n 1 "$log" | sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p')
    passed=$((passed + ${good:-0}))
    failed=$((failed + ${bad:-1}))
}

exchange() {
    say "== exchange"
    install_packages "${HAIRPAINT_EXCHANGE_PACKAGES[@]}" || exit 1
    command -v npm >/dev/null || install_packages npm || exit 1 # A newer one than Debian's may be there.
    build release hairpaint || exit 1
    mkdir -p build/exchange
    cp tests/exchange/package.json build/exchange/
    npm install --prefix build/exchange --no-fund --no-audit --silent || exit 1
    NODE_PATH=$PWD/build/exchange/node_modules counted /usr/bin/python3 tests/exchange/check.py build/release/app/hairpaint build/exchange
}

# packages [SUITE...]: makes both and uses them on bare systems: what was made for this one on it, the portable one on others.
packages() {
    say "== packages"
    install_packages "${HAIRPAINT_PACKAGE_PACKAGES[@]}" || exit 1
    build release || { failed=$((failed + 1)); return; }
    local made=$PWD/build/packages version
    version=$(sed -n 's/^project(HairPaint VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
    rm -f "$made"/*.deb "$made"/*.tar.xz # Those for Windows stay.
    cpack -G DEB --config build/release/CPackConfig.cmake -B "$made" >/dev/null || { failed=$((failed + 1)); return; }
    resources/packaging/portable build/release "$made/hairpaint-$version-linux-x86_64.tar.xz" || { failed=$((failed + 1)); return; }
    rm -rf "$made/_CPack_Packages"
    ls -l "$made" >&2
    if lintian --fail-on error --allow-root "$made"/*.deb >&2; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    counted tests/packaging/bare_system "$made"/*.deb bookworm build/bare
    for suite in trixie jammy; do
        counted tests/packaging/bare_system "$made"/*.tar.xz "$suite" build/bare
    done
}

# windows: the suite's build for Windows under wine, then what both programs write.
windows() {
    local work=$PWD/build/windows
    say "== windows"
    install_packages wine64 xvfb xdotool imagemagick unzip || exit 1
    [ -n "${DISPLAY:-}" ] || exec xvfb-run -a -s "-screen 0 1440x900x24" tests/run --windows
    build release || { failed=$((failed + 1)); return; }
    resources/packaging/windows/build >&2 && resources/packaging/windows/build tests >&2 || { failed=$((failed + 1)); return; }
    export HAIRPAINT_WINDOWS_ROOT=$work/root HAIRPAINT_WINE=$work/wine
    resources/packaging/windows/under_wine wineboot --init >/dev/null 2>&1
    run_suite windows/program
    left_out build/release/tests.log build/windows/program/tests.log
    counted tests/packaging/windows_bytes "$work/package/hairpaint"
    counted tests/packaging/windows_installed build/packages/*-windows-x86_64-setup.exe build/packages/*-windows-x86_64.zip
    counted tests/packaging/windows_window "$work/package/hairpaint"
}

# left_out LOG OTHER: entries of which the other run has fewer functions, or none.
left_out() {
    local name good bad number all=0
    [ -f "$1" ] || { say "   run tests/run first to be told what Windows' build leaves out"; return; }
    declare -A there
    while read -r name good bad; do there[$name]=$((good + bad)); done < <(entry_counts "$2")
    while read -r name good bad; do
        number=$((good + bad - ${there[$name]:-0}))
        [ "$number" -gt 0 ] || continue
        all=$((all + number))
        say "   not on Windows: $number of $((good + bad)) functions of $name"
    done < <(entry_counts "$1" | sort)
    say "   $all functions are Linux' alone"
}

models() {
    say "== models"
    install_packages "${HAIRPAINT_MODELS_PACKAGES[@]}" || exit 1
    build release hairpaint hairpaint-import || exit 1
    counted /usr/bin/python3 tests/importer/foreign_models.py build/release/app/hairpaint /usr/share/assimp/models
}

bench() {
    say "== bench"
    install_packages "${HAIRPAINT_BENCH_PACKAGES[@]}" || exit 1
    build bench hairpaint_bench || exit 1
    ctest --test-dir build/bench -R '^bench\.' --output-on-failure >/dev/null || exit 1
    build/bench/tests/bench/hairpaint_bench --benchmark_out=build/bench.json --benchmark_out_format=json
    exit
}
