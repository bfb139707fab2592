# For ./dev, without Debian's tools: looks for what the named Debian packages have, and tells how to install what is missing.
# shellcheck shell=bash

# Whether something is there: cmd:COMMAND, h:HEADER or pc:MODULE (of pkg-config).
is_there() {
    case $1 in
    cmd:*) command -v "${1#cmd:}" >/dev/null ;;
    h:*) printf '#include <%s>\n' "${1#h:}" | c++ -std=c++20 -E -x c++ - >/dev/null 2>&1 ;;
    pc:*) pkg-config --exists "${1#pc:}" 2>/dev/null ;;
    esac
}

# need_elsewhere PACKAGE...: ends with an error if anything is missing.
# Packages without a line in tools/packages.txt are drivers, or of one command that will say itself what it misses.
need_elsewhere() {
    local manager='' column install package check dnf pacman brew names=() unnamed=()
    for manager in dnf pacman brew ''; do
        [ -z "$manager" ] || command -v "$manager" >/dev/null || continue
        break
    done
    case $manager in
    dnf) column=3 install="sudo dnf install" ;;
    pacman) column=4 install="sudo pacman -S --needed" ;;
    brew) column=5 install="brew install" ;;
    *) column=1 install= ;;
    esac
    local row fields
    while read -r row; do
        read -ra fields <<<"$row"
        case " $* " in *" ${fields[0]} "*) ;; *) continue ;; esac
        is_there "${fields[1]}" && continue
        if [ "${fields[column - 1]}" = - ]; then unnamed+=("${fields[1]#*:}"); else names+=("${fields[column - 1]}"); fi
    done < <(grep -v '^#' tools/packages.txt)
    [ $((${#names[@]} + ${#unnamed[@]})) -eq 0 ] && return
    if [ -z "$install" ]; then
        say "missing (as Debian calls them): ${names[*]}"
    elif [ ${#names[@]} -gt 0 ]; then
        say "missing; install with:"
        printf '%s\n' "${names[@]}" | awk '!seen[$0]++' | tr '\n' ' ' | sed "s/^/    $install /; s/ \$/\n/" >&2
    fi
    [ ${#unnamed[@]} -eq 0 ] || say "missing, and not known to be in a package of $manager: ${unnamed[*]}"
    exit 1
}
