#!/bin/sh
# lay.sh BUILD - writes the manual for MkDocs: its pages to BUILD/manual, at the same
# paths as in the repository, and its settings to BUILD/mkdocs.yml.
#
# The pages are README.md, the files of docs/ in the order of docs/site/order.txt, the
# families of instructions, and the lessons. Each file that a page links to becomes a
# page, too. The manual includes the card of the build and, if it was built, the page that
# runs programs.
set -eu
BUILD=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
manual=$BUILD/manual config=$BUILD/mkdocs.yml
work=$(mktemp -d) heading=
trap 'rm -rf "$work"' EXIT
rm -rf "$manual"
mkdir -p "$manual/docs/slides" "$work/docs/isa"
touch "$work/linked" "$work/files"

# --- pages ------------------------------------------------------------------

# Writes a page of the manual with the text of a file.
lay() { # PAGE FILE
    mkdir -p "$(dirname "$manual/$1")"
    awk -v page="$1" -v families="$work/families" -v linked="$work/more" \
        -f docs/site/page.awk "$2" >"$manual/$1"
    [ ! -f "$work/more" ] || cat "$work/more" >>"$work/linked"
    rm -f "$work/more"
}

lay_instructions() {
    awk -v folder="$work" -v families="$work/families" -f docs/site/isa.awk \
        docs/isa.md >"$work/isa.md"
    cut -d ' ' -f 2 "$work/families" | uniq >"$work/family_pages"
    lay docs/isa.md "$work/isa.md"
    while read -r page; do
        lay "$page" "$work/$page"
    done <"$work/family_pages"
}

# Adds links to the page that runs programs, and to the programs of the lesson.
lay_lesson() { # FOLDER
    name=${1#docs/course/*-}
    {
        sed 1q "$1lesson.md"
        [ ! -f "$BUILD/web/c205.html" ] || printf '\n[%s](%s)\n' \
            'Work on it in the page' \
            "../../../page/index.html#lesson=${name%/}"
        sed 1d "$1lesson.md"
        printf '\n## Files\n\n'
        for file in "$1"*.s; do
            echo "- [$(basename "$file")]($(basename "$file"))"
        done
    } >"$work/lesson"
    lay "$1lesson.md" "$work/lesson"
}

lay_teaching() {
    {
        cat docs/teaching.md
        printf '\n## Here\n\n- [The slides](slides/vector.html)\n'
        printf -- '- The card on [A4](card/card.pdf) and on [Letter](%s)\n' \
            card/card-letter.pdf
    } >"$work/teaching"
    lay docs/teaching.md "$work/teaching"
    sh docs/slides/deck.sh docs/slides/vector.md >"$manual/docs/slides/vector.html"
    mkdir "$manual/docs/card"
    cp "$BUILD"/card/*.pdf "$manual/docs/card"
}

lay_page() {
    mkdir -p "$manual/page" "$manual/docs/course"
    cp "$BUILD/web/c205.html" "$manual/page/index.html"
    cat >"$manual/docs/course/page.md" <<END
---
hide:
  - toc
---
# The page

Text, editor and machine side by side; [by itself](../../page/index.html) it has all of
the window.

<iframe class="page" src="../../page/index.html" title="The page"></iframe>
END
}

# --- linked files -----------------------------------------------------

is_picture() { # FILE
    case $1 in
    *.png | *.svg | *.jpg) ;;
    *) false ;;
    esac
}

put_picture() { # FILE
    mkdir -p "$(dirname "$manual/$1")"
    cp "$1" "$manual/$1"
}

# Adds a file: a Markdown file as a page, any other file as a page that shows its text.
show_file() { # FILE
    case $1 in *.md)
        lay "$1" "$1"
        return
        ;;
    esac
    mkdir -p "$(dirname "$manual/$1")"
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

# Adds a page that lists the files of a folder.
show_folder() { # FOLDER
    mkdir -p "$manual/$1"
    printf '# %s/\n\n' "$1" >"$manual/$1/index.md"
    find "$1" -type f | sort | while read -r file; do
        name=${file#"$1"/}
        if is_picture "$file"; then
            put_picture "$file"
            echo "- [$name]($name)"
        else
            echo "- [$name]($name.md)"
            echo "$file" >>"$work/files"
        fi
    done >>"$manual/$1/index.md"
}

show_linked() {
    sort -u "$work/linked" | while read -r path; do
        if [ -d "$path" ]; then
            show_folder "${path%/}"
        else
            echo "$path" >>"$work/files"
        fi
    done
    sort -u "$work/files" | while read -r file; do
        show_file "$file"
    done
}

# --- the navigation -----------------------------------------------------------

entry() { # NUMBER PAGE
    title=$(sed -n '/^# /{s/^# //;s/:.*//;p;q;}' "$manual/$2")
    printf '      - "%s%s": %s\n' "$1" "$title" "$2"
}

# Prints the entries below a page that are not in order.txt.
entries_under() { # PAGE
    case $1 in
    docs/isa.md)
        while read -r page; do
            entry '' "$page"
        done <"$work/family_pages"
        ;;
    docs/course/index.md)
        [ ! -d "$manual/page" ] || entry '' docs/course/page.md
        for lesson in docs/course/[0-9]*/; do
            number=${lesson#docs/course/}
            entry "${number%%-*}. " "${lesson}lesson.md"
        done
        ;;
    esac
}

navigation() {
    echo 'nav:'
    while read -r line; do
        case $line in
        '' | '#'*) ;;
        *.md)
            page=docs/$line
            [ "$line" != README.md ] || page=$line
            [ -f "$page" ] || continue
            [ -z "$heading" ] || printf '  - "%s":\n' "$heading"
            heading=
            entry '' "$page"
            entries_under "$page"
            ;;
        *) heading=$line ;;
        esac
    done <docs/site/order.txt
}

# ----------------------------------------------------------------------------

lay_instructions
for page in README.md docs/*.md docs/course/index.md; do
    case $page in
    docs/isa.md | docs/teaching.md) ;;
    *) [ ! -f "$page" ] || lay "$page" "$page" ;;
    esac
done
for lesson in docs/course/[0-9]*/; do
    [ ! -d "$lesson" ] || lay_lesson "$lesson"
done
lay_teaching
[ ! -f "$BUILD/web/c205.html" ] || lay_page
find docs -type f | while read -r file; do
    ! is_picture "$file" || put_picture "$file"
done
cp docs/site/site.css "$manual"
show_linked
{
    sed "s|@MANUAL@|$manual|; s|@SITE@|$BUILD/site|" docs/site/mkdocs.yml
    navigation
} >"$config"
