#!/bin/sh
# lay.sh BUILD - lays out the manual for MkDocs: its pages under BUILD/manual, at
# the places that they have here, and BUILD/mkdocs.yml.
#
# Pages are README.md and what lies under docs/; in which order those of docs/
# stand is docs/site/order.txt; the families of instructions and the lessons come
# from their files.  What pages link to is a page, too.
set -eu
BUILD=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
manual=$BUILD/manual config=$BUILD/mkdocs.yml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
rm -rf "$manual"
mkdir -p "$manual/docs/isa"
touch "$work/families" "$work/linked"

# lay PAGE [FILE]: the text of the page is that of the file.
lay() {
    mkdir -p "$manual/$(dirname "$1")"
    awk -v page="$1" -v families="$work/families" -v linked="$work/linked.one" \
        -f docs/site/page.awk "${2:-$1}" >"$work/page"
    cp "$work/page" "$manual/$1"
    [ ! -f "$work/linked.one" ] || cat "$work/linked.one" >>"$work/linked"
    rm -f "$work/linked.one"
}

is_picture() { # FILE
    case $1 in
    *.png | *.svg | *.jpg) ;;
    *) false ;;
    esac
}

# A file that is no page, as a page that shows it.
show() { # FILE
    mkdir -p "$manual/$(dirname "$1")"
    case $1 in
    *.s) language=nasm ;;
    *.pov | *.inc) language=pov ;;
    *.c | *.h | *.def) language=c ;;
    *.sh | *.sbatch) language="bash" ;;
    *.json) language=json ;;
    *) language=text ;;
    esac
    {
        printf '# %s\n\n~~~~ %s\n' "$1" "$language"
        cat "$1"
        echo '~~~~'
    } >"$manual/$1.md"
}

# What a folder holds, as a page.
show_folder() { # FOLDER
    mkdir -p "$manual/$1"
    printf "# %s/\n\n" "$1" >"$manual/$1/index.md"
    find "$1" -type f | sort | while read -r file; do
        name=${file#"$1"/}
        if is_picture "$file"; then
            mkdir -p "$manual/$(dirname "$file")"
            cp "$file" "$manual/$file"
            echo "- [$name]($name)"
        else
            echo "- [$name]($name.md)"
            echo "$file" >>"$work/files"
        fi
    done >>"$manual/$1/index.md"
}

mkdir -p "$work/docs/isa"
awk -v folder="$work" -v families="$work/families" -f docs/site/isa.awk \
    docs/isa.md >"$work/isa.md"
lay docs/isa.md "$work/isa.md"
cut -d ' ' -f 2 "$work/families" | uniq >"$work/family_pages"
while read -r page; do
    lay "$page" "$work/$page"
done <"$work/family_pages"
for page in README.md docs/*.md docs/course/index.md; do
    [ "$page" = docs/isa.md ] || [ ! -f "$page" ] || lay "$page"
done
for lesson in docs/course/[0-9]*/; do
    [ -d "$lesson" ] || continue
    {
        cat "$lesson/lesson.md"
        printf '\n## Files\n\n'
        for file in "$lesson"*.s; do
            echo "- [$(basename "$file")]($(basename "$file"))"
        done
    } >"$work/lesson"
    lay "${lesson}lesson.md" "$work/lesson"
done
find docs -name '*.png' -o -name '*.svg' | while read -r picture; do
    mkdir -p "$manual/$(dirname "$picture")"
    cp "$picture" "$manual/$picture"
done
cp docs/site/site.css "$manual/site.css"

sort -u "$work/linked" | while read -r path; do
    if [ -d "$path" ]; then
        show_folder "${path%/}"
    else
        echo "$path" >>"$work/files"
    fi
done
sort -u "$work/files" | while read -r file; do
    show "$file"
done

# --- the navigation -----------------------------------------------------------

title_of() { # PAGE
    sed -n '/^# /{s/^# //;s/:.*//;p;q;}' "$manual/$1"
}

entry() { # PAGE
    printf '      - "%s": %s\n' "$(title_of "$1")" "$1"
}

section() { # PAGE: those that belong under it
    case $1 in
    docs/isa.md)
        while read -r family; do
            entry "$family"
        done <"$work/family_pages"
        ;;
    docs/course/index.md)
        for lesson in docs/course/[0-9]*/; do
            number=${lesson#docs/course/}
            printf '      - "%s. %s": %slesson.md\n' "${number%%-*}" \
                "$(title_of "${lesson}lesson.md")" "$lesson"
        done
        ;;
    esac
}

{
    sed "s|@MANUAL@|$manual|; s|@SITE@|$BUILD/site|" docs/site/mkdocs.yml
    echo 'nav:'
    while read -r line; do
        page=docs/$line
        [ "$line" != README.md ] || page=$line
        case $line in
        '' | '#'*) ;;
        *.md)
            [ -f "$page" ] || continue
            [ -z "$heading" ] || printf '  - "%s":\n' "$heading"
            heading=
            entry "$page"
            section "$page"
            ;;
        *) heading=$line ;;
        esac
    done <docs/site/order.txt
} >"$config"
