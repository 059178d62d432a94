#!/bin/sh
# check_install.sh BUILD MAKE - what make install puts into a folder is all
# that is needed: rt205 finds its adapter there, and C programs that have only
# the headers, the libraries and pkg-config's files run a program of the machine,
# assemble one and trace a scene.  The libraries have no names but those of the
# headers, and each header stands by itself.
set -u
. "$(dirname "$0")/count.sh"
build=$1 make=$2
scene=$(pwd)/scenes/first.pov
clients=$(pwd)/tests/install
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root/usr
said=$work/out

succeeds() { # COMMAND ..
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

client() { # NAME PACKAGE
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
# Both forms see the sphere, bit for bit alike.
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
    succeeds ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror \
        -I"$include" -I"$include/vm" -fsyntax-only "$header"
done

names() { # all words of the headers
    find "$include" -type f -exec cat {} + | grep -oE '[A-Za-z_][A-Za-z_0-9]*' |
        sort -u
}
for library in libc205 libc205asm librt205; do
    nm -g --defined-only "$root/lib/$library.a" | awk 'NF == 3 { print $3 }' |
        sort -u >names.txt
    succeeds test -s names.txt
    names | comm -13 - names.txt >extra.txt
    succeeds diff /dev/null extra.txt
done
counted
