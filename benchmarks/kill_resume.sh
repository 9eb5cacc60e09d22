#!/bin/sh
# Kills a checkpointed render with SIGKILL at random moments, resumes it each time, and compares the bits of all sums with those
# of the uninterrupted render. Ends with an error at the first difference.
#
#   benchmarks/kill_resume.sh [KILLS [SEED [RENDER OPTIONS...]]]      default: 50 1 and a render of a few seconds
#
# Build first: mvn -q -pl cli -am package -DskipTests. Needs java on the path (or JAVA_HOME).
set -eu
cd "$(dirname "$0")/.."
java=${JAVA_HOME:+$JAVA_HOME/bin/}java
jar=${DAYBREAK_JAR:-cli/target/daybreak.jar}
[ -f "$jar" ] || { echo "$0: $jar is missing; build it first (see the head of this script)" >&2; exit 1; }
kills=${1:-50}
seed=${2:-1}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- --size 160x120 --spp 192 --threads 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
daybreak() { "$java" -cp "$jar" org.daybreak.cli.Main "$@"; }
render() {
    daybreak render scenes/cornell_spheres/scene.xml --progress none --layers variance,depth "$@"
}
sums() { daybreak info "$1" | grep -E '^(complete|samples|sums|splats)'; }
now() { date +%s%N; }
started=$(now)
render "$@" -o "$folder/whole.daybreak"
nanoseconds=$(($(now) - started))
sums "$folder/whole.daybreak" > "$folder/expected"
cat "$folder/expected"
done=0
attempt=0
without=0
while [ $done -lt "$kills" ]; do
    attempt=$((attempt + 1))
    rm -f "$folder"/c.daybreak "$folder"/.c.daybreak.tmp
    # exec, so that the process that is killed is the virtual machine.
    sh -c 'exec "$@"' sh "$java" -cp "$jar" org.daybreak.cli.Main render scenes/cornell_spheres/scene.xml --progress none \
        --layers variance,depth "$@" --checkpoint "$folder/c.daybreak" --checkpoint-interval 0.05 \
        -o "$folder/killed.daybreak" &
    process=$!
    sleep "$(awk -v seed="$seed" -v i="$attempt" -v n="$nanoseconds" \
        'BEGIN { srand(seed * 1000 + i); print rand() * n * 1e-9 }')"
    # A render that has ended is no case for this test.
    if ! kill -KILL "$process" 2>/dev/null; then
        wait "$process"
        continue
    fi
    wait "$process" 2>/dev/null && continue
    done=$((done + 1))
    if [ -f "$folder/c.daybreak" ]; then
        render "$@" --resume "$folder/c.daybreak" -o "$folder/resumed.daybreak"
    else
        without=$((without + 1))
        render "$@" -o "$folder/resumed.daybreak"
    fi
    sums "$folder/resumed.daybreak" > "$folder/actual"
    if ! cmp -s "$folder/expected" "$folder/actual"; then
        echo "attempt $attempt of seed $seed: the resumed render differs" >&2
        cat "$folder/actual" >&2
        exit 1
    fi
done
echo "$kills kills: all resumed to the same bits ($without before the first checkpoint)"
