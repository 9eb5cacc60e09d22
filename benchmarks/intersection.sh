#!/bin/sh
# Compares the ray intersectors with Embree (single rays, through FFM) on the same meshes and rays, and prints the median
# over several JVM launches of the ratio of rays per CPU second; 1.00 is Embree. Then the build of a million triangles.
#
#   benchmarks/intersection.sh [LAUNCHES [INTERSECTOR...]]          default: 5 vector512 vector256 scalar
#   benchmarks/intersection.sh --scaling FILE.csv [INTERSECTOR]     time per ray from 10^3 to 10^7 triangles
#
# Needs a JDK 25 (JAVA_HOME_25 or JAVA_HOME, else java on the path) and libembree3.so.3. Build first, with that JDK:
#   mvn -q -pl benchmarks -am package -DskipTests
set -eu
cd "$(dirname "$0")/.."
home=${JAVA_HOME_25:-${JAVA_HOME:-}}
java=${home:+$home/bin/}java
jar=benchmarks/target/benchmarks.jar
[ -f "$jar" ] || { echo "$0: $jar is missing; build it first (see the head of this script)" >&2; exit 1; }
run() {
    class=$1
    shift
    # G1 puts large arrays at the start of a region, so that no vector straddles two cache lines.
    "$java" -Xmx6g -XX:+UseG1GC -XX:+UseTransparentHugePages --add-modules jdk.incubator.vector \
        --enable-native-access=ALL-UNNAMED -cp "$jar" "org.daybreak.benchmarks.intersection.$class" "$@" 2>/dev/null
}
if [ "${1:-}" = --scaling ]; then
    run ScalingBenchmark "${3:-vector512}" 7 > "$2.part"
    mv "$2.part" "$2"
    exit
fi
launches=${1:-5}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- vector512 vector256 scalar
results=$(mktemp)
trap 'rm -f "$results"' EXIT
for intersector in "$@"; do
    i=0
    while [ $i -lt "$launches" ]; do
        run IntersectionBenchmark "$intersector" >> "$results"
        i=$((i + 1))
    done
done
echo "intersector  scene      rays      Mrays/s  Embree   ratio (least - greatest)  differing rays"
# Sorted by ratio within each group, the middle line is the median.
sort -t, -k1,1r -k3,3n -k4,4 -k7,7n "$results" | awk -F, '
    function flush(   m) {
        if (n == 0) return
        m = int((n + 1) / 2)
        printf "%-12s %-10s %-8s %8.2f %7.2f    %.2f (%.2f - %.2f)  %17d\n",
            id, scene, kind, ours[m], theirs[m], ratio[m], ratio[1], ratio[n], worst
    }
    $1 "," $2 "," $4 != key { flush(); n = 0; worst = 0; key = $1 "," $2 "," $4; id = $1; scene = $2; kind = $4 }
    { n++; ours[n] = $5; theirs[n] = $6; ratio[n] = $7; if ($8 > worst) worst = $8 }
    END { flush() }'
echo
echo "build        triangles  threads   wall ms   Embree  ratio    CPU ms   Embree  ratio   first build, ms"
for intersector in "$@"; do
    for threads in 1 2; do
        run BuildBenchmark "$intersector" 1000000 "$threads" | awk -F, '
            { printf "%-12s %9d  %7d  %8d %8d  %5.2f  %8d %8d  %5.2f  %16d\n", $1, $2, $3, $4, $5, $6, $7, $8, $9, $10 }'
    done
done
