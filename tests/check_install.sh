#!/bin/sh
# check_install.sh BUILD MAKE - checks that the installed files are sufficient. rt205
# must find its dynamic libraries. C programs with only the headers, the libraries and
# the files of pkg-config must run a program of the machine, assemble a program and
# trace a scene. The libraries must define only names that the headers declare, a
# program may use all other names, and each header must compile alone.
set -u
. "$(dirname "$0")/count.sh"
build=$1 make=$2
scene=$(pwd)/scenes/first.pov
clients=$(pwd)/tests/install
archives=$(cd "$build" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root/usr
said=$work/out

succeeds() { # COMMAND ..: the command must succeed
    "$@" >"$said" 2>&1
    verdict $? "$*"
}


succeeds "$make" --no-print-directory BUILD="$build" \
    DESTDIR="$work/root" PREFIX=/usr install
unset RT205_LIBDIR
cd "$work" || exit 1
succeeds "$root/bin/rt205" render "$scene" -o a.png -W 40 -H 30
succeeds test -s a.png
succeeds "$root/bin/c205" isa ADDNV
documents=$root/share/doc/c205
succeeds "$root/bin/c205" run --check "$documents"/asm/examples/*.s
succeeds "$root/bin/rt205" render "$documents/scenes/first.pov" -o b.png -W 20 -H 15
succeeds test -s "$documents/docs/machine.md"
lesson=$documents/docs/course/03-first-vector
succeeds "$root/bin/c205" check "$lesson" "$lesson/solution.s"
(cd "$documents" && find . -name '*.md' | while read -r page; do
    grep -o ']([^)#: ]*[)#]' "$page" | sed 's/^](//; s/.$//' |
        while read -r link; do
            [ -e "$(dirname "$page")/$link" ] || echo "$page: $link"
        done
done) >links.txt
succeeds diff /dev/null links.txt
export PKG_CONFIG_PATH="$root/lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$work/root"

client() { # NAME PACKAGE: compiles a client of a package
    # The compiler and its flags are words, so they are not quoted.
    # shellcheck disable=SC2046,SC2086
    succeeds ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror \
        $(pkg-config --cflags "$2") -o "$1" "$clients/$1.c" \
        $(pkg-config --static --libs "$2")
    succeeds sh -c "./$1 >$1.txt"
}

client machine c205
client program c205asm
client scene rt205
succeeds grep -q '^status 205 after [1-9][0-9]* clocks$' machine.txt
succeeds grep -q '^status 205 after [1-9][0-9]* clocks$' program.txt
# Both forms must see the sphere with equal results. $2 and $4 are fields of awk.
# shellcheck disable=SC2016
succeeds awk '{ hits += $2 > 100; last = sum; sum = $4 }
    END { exit !(NR == 2 && hits == 2 && last == sum) }' scene.txt

for program in c205 rt205; do
    for page in man/man1/$program.1 bash-completion/completions/$program \
        zsh/site-functions/_$program fish/vendor_completions.d/$program.fish
    do
        succeeds grep -q "$program" "$root/share/$page"
    done
done

include=$root/include/c205
(cd "$include" && find . -name '*.h') | while read -r header; do
    echo "#include <${header#./}>"
    echo "int main(void) { return 0; }"
    echo "// end"
done | awk '/^#/ { file = "header" ++n ".c" } !/^\/\/ end/ { print > file }'
succeeds test -s header1.c
for header in header*.c; do
    # The compiler may have options.
    # shellcheck disable=SC2086
    succeeds ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror \
        -I"$include" -I"$include/vm" -fsyntax-only "$header"
done

names() { # ARCHIVE ..: prints the global names that they define
    nm -g --defined-only "$@" | awk 'NF == 3 { print $3 }' | sort -u
}

# Every name of a library is declared in a header.
for library in libc205 libc205asm librt205; do
    names "$root/lib/$library.a" >names.txt
    succeeds test -s names.txt
    cat header*.c | grep '^#' >declared.c
    sed 's/.*/void use_&(void);\nvoid use_&(void) { (void)&; }/' names.txt \
        >>declared.c
    # The compiler may have options.
    # shellcheck disable=SC2086
    succeeds ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror \
        -I"$include" -I"$include/vm" -fsyntax-only declared.c
done
succeeds [ -z "$(names "$root/lib/libc205.a" | grep -v '^c205_')" ]

# A client's functions may have the names that the libraries use internally.
for library in libc205 libbase libc205asm librt205; do
    names "$archives/$library.a"
done | sort -u >inside.txt
own_names() { # CLIENT PACKAGE: a client may define the internal names of a package
    for library in $(pkg-config --libs-only-l "$2"); do
        names "$root/lib/lib${library#-l}.a"
    done | sort -u | comm -13 - inside.txt >own.txt
    succeeds grep -qx 'half_add_upper' own.txt
    succeeds grep -qx 'decode' own.txt
    sed 's/.*/int &(void);\nint &(void) { return 205; }/' own.txt >own.c
    # shellcheck disable=SC2046,SC2086
    succeeds ${CC:-cc} -std=c99 -fno-builtin $(pkg-config --cflags "$2") \
        -o "own_$1" "$clients/$1.c" own.c $(pkg-config --static --libs "$2")
    "./own_$1" >own.txt
    succeeds cmp own.txt "$1.txt"
}
own_names machine c205
own_names program c205asm
own_names scene rt205
counted
