#!/usr/bin/env bash
# Usage: precompiled_macros_test.sh DEV. What ./dev builds with a compiler cache has the macros of its headers as they are
# now. A header that was precompiled came back from the cache with the macros that it had had before: the library of C said
# that its interface was of version 3, when that was 4.
set -euo pipefail
command -v ccache >/dev/null || { echo "no ccache"; exit 77; }
dev=$(readlink -f "$1")
# Its functions, without what it does when it is run.
source <(sed -e '/^cd "\$(dirname/d' -e '/^case/,$d' "$dev")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export CCACHE_DIR=$folder/cache
unset CCACHE_SLOPPINESS CCACHE_DEPEND CCACHE_BASEDIR
mkdir build
printf 'int main() { return VERSION; }\n' >main.cpp
# In place of a build.
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
    [ $status -eq $version ] || { echo "a program of version $version says that it is of $status"; exit 1; }
done
misses=$(ccache --print-stats | awk '$1 == "cache_miss" { print $2 }')
[ "$misses" -ge 4 ] || { echo "the cache was not asked: $misses misses"; exit 1; }
