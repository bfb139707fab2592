#!/usr/bin/env bash
# Usage: dev_arguments_test.sh DEV. ./dev must print the help of its commands, and reject unknown commands and arguments,
# before it installs or builds anything. It runs in a folder without sources, in which a build is impossible.
set -u
dev=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$dev" "$folder/dev"
failed=0

# expect CODE WORDS ARGUMENT...: ./dev with these arguments must exit with CODE, print WORDS, and create no build folder.
expect() {
    local code=$1 words=$2 said rc
    shift 2
    said=$(PATH=/usr/bin:/bin timeout 20 "$folder/dev" "$@" 2>&1)
    rc=$?
    if [ "$rc" -ne "$code" ] || [[ $said != *"$words"* ]] || [ -e "$folder/build" ]; then
        echo "dev $*: exited with $rc and printed: $said"
        failed=1
    fi
}

for command in run build test faults web docs soak fuzz nightly bench lint format; do
    expect 0 "$command" "$command" --help
    expect 0 "$command" "$command" -h
done
for command in build faults docs soak fuzz mutate nightly lint format web; do
    expect 2 "--nonsense" "$command" --nonsense
done
expect 2 "unknown argument 'many'" fuzz many
expect 2 "unknown argument '7'" fuzz 60 7
expect 2 "unknown argument '-x'" run -x
expect 2 "unknown command 'nonsense'" nonsense
exit $failed
