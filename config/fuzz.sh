#!/usr/bin/env bash
# fuzz.sh [--runs N] [--duration D] [TEST…]: runs fuzz tests (docs/fuzzing.md) one after the other, all or those named by their
# methods, N executions (10 million) of each but at most for the time D, such as 40m; prints for each what it did. One in fifty
# executions also traces comparisons, which finds more and takes several times as long. Exits with 1 if an input was found that
# a reader does not stand.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

runs=10000000
duration=24h
while [[ "${1:-}" == --* ]]; do
    case $1 in
        --runs) runs=$2 ;;
        --duration) duration=$2 ;;
        *) echo "fuzz.sh: no option $1" >&2 && exit 2 ;;
    esac
    shift 2
done

# Prints "module class method" of every fuzz test.
tests() {
    local file
    for file in */src/test/java/org/daybreak/*/{,*/}*FuzzTest.java; do
        [ -f "$file" ] || continue
        sed -n '/@FuzzTest/{n;s/^ *void \([A-Za-z0-9]*\)(.*/\1/p;}' "$file" | while read -r method; do
            echo "${file%%/*} $(basename "$file" .java) $method"
        done
    done
}

# Runs test $3 of class $2 in module $1 for $4 executions with traces $5; adds the output to the log $6.
fuzz() {
    mvn -B -ntp -Pfuzz,quick -Dmaven.test.skip=false -pl "$1" -am test -Dtest="$2#$3" -Dsurefire.failIfNoSpecifiedTests=false \
        -Dfuzz.runs="$4" -Dfuzz.trace="$5" -Dfuzz.duration="$duration" < /dev/null >> "$6" 2>&1
}

logs=$(mktemp -d) || exit
trap 'rm -rf "$logs"' EXIT
status=0
echo "| test | executions | per second | edges | features | found |"
echo "|---|---|---|---|---|---|"
while read -r module class method; do
    if [ $# -gt 0 ] && ! printf '%s\n' "$@" | grep -qx "$method"; then
        continue
    fi
    log="$logs/$method"
    found=nothing
    if ! { fuzz "$module" "$class" "$method" $((runs / 50 + 1)) cov:cmp:div:indir "$log" &&
        fuzz "$module" "$class" "$method" "$runs" cov "$log"; }; then
        found="see below"
        status=1
    fi
    awk -v test="$class#$method" -v found="$found" '
        /^#[0-9]+.* cov: / { for (i = 1; i < NF; i++) v[$i] = $(i + 1) }
        /^#[0-9]+[ \t]+DONE/ { n += substr($1, 2) }
        /average_exec_per_sec:/ { s = $NF }
        END { print "| `" test "` | " n + 0 " | " s " | " v["cov:"] " | " v["ft:"] " | " found " |" }' "$log"
    if [ "$found" != nothing ]; then
        grep -A 20 -E '== Java Exception|ERROR: libFuzzer|Test unit written|^\[ERROR\]' "$log" | head -80
    fi
done < <(tests)
exit "$status"
