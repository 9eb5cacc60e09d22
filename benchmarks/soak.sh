#!/bin/sh
# Takes very many samples in one process; checks that none was infinite or no number, and that the heap does not grow: what is
# in use after a full collection, which this script asks for every few seconds. Ends with an error if either fails.
#
#   benchmarks/soak.sh [SAMPLES [RENDER OPTIONS...]]      default: 1000000000, of SCENE at 160x120 on 2 threads
#
#   SCENE          scene file; default: scenes/cornell_spheres/scene.xml
#   INTERVAL       seconds between two collections; default: 10
#   DAYBREAK_JAR   the program; default: cli/target/daybreak.jar
#   DAYBREAK_OPTS  options for the virtual machine, such as --add-modules jdk.incubator.vector
#
# Build first: mvn -q -pl cli -am package -DskipTests. Needs a JDK in JAVA_HOME or on the path (java, jcmd, jstat).
set -eu
cd "$(dirname "$0")/.."
bin=${JAVA_HOME:+$JAVA_HOME/bin/}
jar=${DAYBREAK_JAR:-cli/target/daybreak.jar}
[ -f "$jar" ] || { echo "$0: $jar is missing; build it first (see the head of this script)" >&2; exit 1; }
scene=${SCENE:-scenes/cornell_spheres/scene.xml}
width=160
height=120
samples=${1:-1000000000}
[ $# -gt 0 ] && shift
spp=$(((samples + width * height - 1) / (width * height)))
folder=$(mktemp -d)
process=
trap '[ -z "$process" ] || kill "$process" 2>/dev/null || true; rm -rf "$folder"' EXIT
# shellcheck disable=SC2086
"${bin}java" -Xmx512m ${DAYBREAK_OPTS:-} -jar "$jar" render "$scene" --size "${width}x$height" --spp "$spp" --threads 2 \
    --progress none --stats "$folder/stats.json" -o "$folder/out.pfm" "$@" &
process=$!
echo "seconds  heap used after a full collection / KiB  metaspace / KiB  resident / KiB"
seconds=0
while sleep "${INTERVAL:-10}" && kill -0 "$process" 2>/dev/null; do
    seconds=$((seconds + ${INTERVAL:-10}))
    # The process may end between these calls.
    "${bin}jcmd" "$process" GC.run >/dev/null 2>&1 || break
    "${bin}jstat" -gc "$process" >"$folder/jstat" 2>/dev/null || break
    resident=$(awk '/^VmRSS/ { print $2 }' "/proc/$process/status" 2>/dev/null) || resident=
    # By the names of the columns: they differ from release to release.
    awk -v s="$seconds" -v r="${resident:--}" 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR == 2 { print s, $column["S0U"] + $column["S1U"] + $column["EU"] + $column["OU"], $column["MU"], r }' \
        "$folder/jstat" | tee -a "$folder/heap"
done
code=0
wait "$process" || code=$?
process=
taken=$(sed -n 's/^ *"samples" *: *\([0-9]*\).*/\1/p' "$folder/stats.json")
bad=$(sed -n '/"nonFinite"/,/}/s/.*"count" *: *\([0-9]*\).*/\1/p' "$folder/stats.json")
echo "exit code $code, $taken samples, $bad of them not finite"
[ "$code" = 0 ] && [ "$bad" = 0 ] && [ "$taken" -ge "$samples" ] || { echo "FAILED: samples" >&2; exit 1; }
# Medians of the first and the last third; the first is without the first measurement, when classes are still being loaded.
awk 'function median(from, to,   i, j, t, v, n) {
        for (i = from; i <= to; i++) v[++n] = used[i]
        for (i = 2; i <= n; i++) for (j = i; j > 1 && v[j - 1] > v[j]; j--) { t = v[j]; v[j] = v[j - 1]; v[j - 1] = t }
        return v[int((n + 1) / 2)]
    }
    NR > 1 { used[NR - 1] = $2 }
    END {
        n = NR - 1
        if (n < 6) { print "FAILED: only " n " measurements of the heap" > "/dev/stderr"; exit 1 }
        first = median(1, int(n / 3)); last = median(n - int(n / 3) + 1, n)
        printf "heap in use: first third %d KiB, middle %d KiB, last third %d KiB (medians)\n", \
            first, median(int(n / 3) + 1, n - int(n / 3)), last
        if (last > 1.02 * first) { print "FAILED: the heap grows" > "/dev/stderr"; exit 1 }
        print "passed: every sample is finite, and the heap does not grow"
    }' "$folder/heap"
