#!/usr/bin/env bash
# Usage: precompiled_macros_test.sh DEV. Programs that ./dev builds with a compiler cache must have the present values of
# the macros in their headers. Without CCACHE_DEPEND, the cache confuses precompiled headers that differ only in their
# macros, so that for example the C library reports a previous version of its interface.
set -euo pipefail
command -v ccache >/dev/null || { echo "no ccache"; exit 77; }
dev=$(readlink -f "$1")
# Defines the functions of ./dev, without the commands that it executes.
source <(sed -e '/^cd "\$(dirname/d' -e '/^case/,$d' "$dev")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export CCACHE_DIR=$folder/cache
unset CCACHE_SLOPPINESS CCACHE_DEPEND CCACHE_BASEDIR
mkdir build
printf 'int main() { return VERSION; }\n' >main.cpp
# Stands in for the build.
cmake() {
    rm -f all.h.gch main
    ccache c++ -x c++-header -MD -MF header.d -o all.h.gch -c all.h &&
        ccache c++ -include all.h -Winvalid-pch -MD -MF main.d -c -o main.o main.cpp && c++ -o main main.o
}
for version in 1 2; do
    printf '#define VERSION %s\n' $version >all.h
    make build
    status=0
    ./main || status=$?
    [ $status -eq $version ] || { echo "the program of version $version reports version $status"; exit 1; }
done
misses=$(ccache --print-stats | awk '$1 == "cache_miss" { print $2 }')
[ "$misses" -ge 4 ] || { echo "the cache was not used: $misses misses"; exit 1; }
