# forms.awk - makes a program that runs each operation of asm/lib/forms.s in both forms
# on random operands, and expects no difference. It reads the operations from the list at
# the top of forms.s:
#
#     awk -f tests/forms.awk asm/lib/forms.s >operations.s
#     c205 run --check operations.s
#
# The operands k to p of the list are numbers, the others are vectors. No operand of an
# operation is indefinite if its meaning begins with *. A definition that is not in the
# list is an error.

BEGIN {
    elements = 40
    rounds = 6
    vectors = split("a b c d e f g h i x y t", vector, " ")
    pool = split("0.0 1.0 -1.0 2.0 0.5 -0.5 3.0 1.0e8000 -1.0e8000 1.0e-8000", special, " ")
    srand(205)

    # The lines around @, for operations that have an effect only with others.
    then = "if_above_number y, p, end:@:end_if end"
    around["then"] = then
    around["if"] = "@:then_copy d, f:end_if label"
    around["unless"] = "@:otherwise_set k, f:end_if label"
    around["and_if"] = "if_not_nearer x, y, label:" around["if"]
    around["otherwise"] = "unless_above_number y, p, end:@:end_if end"
    around["otherwise_if"] = "if_less x, y, next:then_copy d, f:otherwise end, next:@:" \
                             "then_copy e, f:end_if label:end_if end"
    around["otherwise_if_not_nearer"] = \
        "if_less x, y, next:then_copy d, f:otherwise end, next:@:then_copy e, f:" \
        "otherwise end, label:then_sign h, k, l, f, t, rest:end_if end"
    around["then_set_or"] = "default l, c:" then
    around["then_set_or_copy"] = "default b, c:" then
    around["leave_if"] = "leaving m, l, c:@:staying l, c:end_if label"
    # These operations are only in the lines around others.
    covered = " otherwise end_if default leaving staying "
    begin_program()
}

function random_word(is_definite) {
    if (rand() < .25)
        return special[1 + int(rand() * pool)]
    if (!is_definite && rand() < .1)
        return "X'7000 0000 0000 0000'"
    return sprintf("%.13fe%d", (rand() - .5) * 4, rand() * 12 - 6)
}

# b is definite, because comparisons need it, and i is an index.
function put_words(kind,    v, i) {
    print kind ":"
    for (v = 1; v <= vectors; v++)
        for (i = 0; i < elements; i++)
            print "        .word   " (vector[v] == "i" ? sprintf("X'%016X'", rand() * elements) \
                  : random_word(kind == "definite" || vector[v] == "b"))
}

# Prints a line for each vector. # becomes the offset of its first word.
function each(line,    v, text) {
    for (v = 1; v <= vectors; v++) {
        text = line
        gsub(/@/, vector[v], text)
        gsub(/#/, 64 * elements * (v - 1), text)
        print text
    }
}

function begin_program(    i) {
    print "        .include \"core.s\"\n        .include \"forms.s\""
    print "        .regs   r10, j, one, count, all_words, round, left, from, word, other"
    print "        .regs   r20, scratch, second, third, bits, more_bits, rest, differing"
    print "        .regs   r30, at, k, l, m, n, o, p"
    print "        .regs   r40, a, b, c, d, e, f, g, h, i, x, y, t"
    print "        scalar_form number_, scratch, second, third"
    print "        vector_form vector_, bits, more_bits, rest\n        .data"
    put_words("mixed")
    put_words("definite")
    print "numbers:"
    for (i = 0; i < 6 * rounds; i++)
        print "        .word   " random_word(1)
    print "by_element: .space " vectors * elements "\nby_vector: .space " vectors * elements
    print "        .bitvector first_bits, " elements
    print "        .bitvector second_bits, " elements
    print "        .bitvector third_bits, " elements
    print "        .code\n        ES      one, 1\n        EX      count, " elements
    print "        EX      all_words, " (vectors - 1) * elements "    ; without t"

    print "        .macro  both operation, words"
    print "        .data\ndiffering.\\operation: .space 1\n        .code"
    print "        ES      differing, 0\n        ES      left, " rounds
    print "        EX      round, numbers\n        EX      at, \\words\nround\\@:"
    for (i = 1; i <= 6; i++)
        print "        LOD     [round], " substr("klmnop", i, 1) "\n        IX      round, 64"
    print "        ES      j, 0\nelement\\@:"
    each("        EX      from, \\words + #\n        LOD     [from, j], @")
    print "        \\operation number"
    each("        EX      from, by_element + #\n        STO     [from, j], @")
    print "        IBXNE   j, one, count, element\\@, j"
    each("        descriptor @, by_vector + #, " elements \
         "\n        descriptor from, \\words + #, " elements "\n        VTOV    [from], [@]")
    print "        descriptor bits, first_bits, " elements
    print "        descriptor more_bits, second_bits, " elements
    print "        descriptor rest, third_bits, " elements "\n        \\operation vector"
    print "        ES      j, 0\n        EX      a, by_element\n        EX      b, by_vector"
    print "word\\@: LOD     [a, j], word\n        LOD     [b, j], other"
    print "        XOR     word, other, word\n        SHIFTI  word, 24, other"
    print "        OR      word, other, word       ; IBXEQ compares 48 bits"
    print "        IBXEQ   word, r0, r0, equal\\@, word"
    print "        ADDX    differing, one, differing"
    print "equal\\@: IBXNE  j, one, all_words, word\\@, j"
    print "        IS      left, -1\n        IBXNE   left, r0, r0, round\\@, left"
    print "        EX      from, differing.\\operation\n        STO     [from], differing"
    print "        .endm"
}

# Returns the lines around an operation, for the longest start of its name.
function lines_around(name,    start, longest) {
    for (start in around)
        if (index(name "_", start "_") == 1 && length(start) > length(longest))
            longest = start
    return longest == "" ? "@" : around[longest]
}

function put_operation(    name, list, count, i, line) {
    name = operation
    sub(/ .*/, "", name)
    listed_names[name]
    if (name == "" || index(covered, " " name " "))
        return
    print "        .macro  test_" name " form"
    line = lines_around(name)
    sub(/@/, operation, line)
    count = split(line, list, ":")
    for (i = 1; i <= count; i++) {
        line = list[i]
        sub(/, case$/, "", line)
        if (line ~ /(label|end|next)$/)
            line = line "\\@"
        sub(/otherwise end,/, "otherwise end\\@,", line)
        print "        \\form\\()_" line
    }
    print "        .endm\n        both    test_" name ", " (definite ? "definite" : "mixed")
    print "; expect: [differing.test_" name "] = 0"
}

/^; Arithmetic, one operation:/ { listed = 1 }
/\.ifndef/ {
    put_operation()
    listed = 0
}
/^        \.macro  .prefix/ {
    name = substr($2, length("\\prefix\\()") + 1)
    if (!(name in listed_names)) {
        printf "%s: %s is not in the list\n", FILENAME, name >"/dev/stderr"
        code = 1
    }
}
listed && /^;       [a-z]/ {
    put_operation()
    operation = substr($0, 9)
    sub(/  .*/, "", operation)
    definite = 0
}
listed && /  \* / { definite = 1 }
END {
    print "        EXIT"
    exit code + 0
}
