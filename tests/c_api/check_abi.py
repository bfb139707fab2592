#!/usr/bin/env python3
"""Compares the binary interface of libcairn_c with the recorded one (abi.txt): exported symbols with their versions, sizes of
structs and offsets of their members. Compiled programs depend on them: they must not change unless CAIRN_ABI_VERSION grows.

usage: check_abi.py LIBRARY LAYOUT_PROGRAM [--renew]
"""
import pathlib
import subprocess
import sys

RECORDED = pathlib.Path(__file__).with_name("abi.txt")


def interface(library, layout):
    listing = subprocess.run(["nm", "-D", "--defined-only", "--with-symbol-versions", library], capture_output=True, text=True,
                             check=True).stdout
    symbols = sorted(line.split()[-1].replace("@@", "@") for line in listing.splitlines() if line.split()[-2] != "A")
    sizes = subprocess.run([layout], capture_output=True, text=True, check=True).stdout.split("\n")
    return symbols + [line for line in sizes if line]


def main():
    arguments = [a for a in sys.argv[1:] if a != "--renew"]
    if len(arguments) != 2:
        sys.exit(__doc__)
    now = interface(*arguments)
    if "--renew" in sys.argv:
        RECORDED.write_text("\n".join(now) + "\n", encoding="ascii")
    recorded = RECORDED.read_text(encoding="ascii").split("\n")[:-1]
    for line in recorded:
        if line not in now:
            print(f"no longer: {line}")
    for line in now:
        if line not in recorded:
            print(f"new: {line}")
    if now == recorded:
        print(f"{len(now)} lines, all as recorded")
        return 0
    print("If this is meant (new functions, or a new CAIRN_ABI_VERSION in tools/api_c_header.py), record it: --renew")
    return 1


if __name__ == "__main__":
    sys.exit(main())
