# For ./dev on systems without apt-get: checks whether the contents of the required Debian packages are installed, and
# prints how to install missing ones.
# shellcheck shell=bash

# is_there KIND:NAME: whether something is installed: cmd:COMMAND, h:HEADER or pc:MODULE (a module of pkg-config).
is_there() {
    case $1 in
    cmd:*) command -v "${1#cmd:}" >/dev/null ;;
    h:*) printf '#include <%s>\n' "${1#h:}" | c++ -std=c++20 -E -x c++ - >/dev/null 2>&1 ;;
    pc:*) pkg-config --exists "${1#pc:}" 2>/dev/null ;;
    esac
}

# need_elsewhere PACKAGE...: exits with an error if any of these Debian packages has no counterpart installed. Packages
# without a line in tools/packages.txt are not checked: they are drivers, or belong to a single command, which reports
# itself what is missing.
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
        say "missing packages (names of Debian): ${names[*]}"
    elif [ ${#names[@]} -gt 0 ]; then
        say "missing; install with:"
        printf '%s\n' "${names[@]}" | awk '!seen[$0]++' | tr '\n' ' ' | sed "s/^/    $install /; s/ \$/\n/" >&2
    fi
    [ ${#unnamed[@]} -eq 0 ] || say "missing, and in no known package of $manager: ${unnamed[*]}"
    exit 1
}
