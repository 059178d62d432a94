# mutate.awk - makes faults in the sources of this tree.
#
#     awk -f masked.awk -f mutate.awk -v seed=7 -v count=10 FILE ..
#         draws COUNT different faults: a line "FILE NUMBER LINE KIND" each
#     awk -f masked.awk -f mutate.awk -v number=3 FILE
#         prints the file with this fault
#
# Each line that can have faults has the same probability of being drawn. One of its
# faults is then drawn. C is formatted by clang-format: a binary operator has a blank or
# the end of a line on both sides. Unary operators and declarators have none. A line of
# the assembler is an optional label, the name of an instruction or macro, operands, and
# for a vector instruction "? [z]" or "?! [z]", its control vector.

function pairs(table, text,    word, n, k) {
    n = split(text, word, " ")
    for (k = 1; k < n; k += 2)
        table[word[k]] = word[k + 1]
}

# ---- Sites: another text replaces lines first .. last of the file ----

# Joins the next lines to the current one until its brackets are closed.
function join_until_closed(from,    depth, c, p) {
    for (p = from; ; p++) {
        if (p > length(code) && ++last > lines)
            return 0
        if (p > length(code)) {
            code = code "\n" codes[last]
            text = text "\n" texts[last]
        }
        c = substr(code, p, 1)
        depth += c == "(" || c == "["
        depth -= c == ")" || c == "]"
        if (depth == 0)
            return p
    }
}

function join_line(at) {
    code = codes[at]
    text = texts[at]
    first = last = at
}

function add(kind, at, length_of, by) {
    sites++
    kinds[sites] = kind
    firsts[sites] = first
    lasts[sites] = last
    changed[sites] = substr(text, 1, at - 1) by substr(text, at + length_of)
}

# Exchanges two parts, unless they are equal or only one of them begins with a bracket.
function exchange(kind, a, a_length, b, b_length,    one, two) {
    one = substr(text, a, a_length)
    two = substr(text, b, b_length)
    if (one != two && (one ~ /^\[/) == (two ~ /^\[/))
        add(kind, a, b + b_length - a, two substr(text, a + a_length, b - a - a_length) one)
}

# Splits the code from .. to at commas outside of brackets. Sets start[] and size[].
function split_at_commas(from, to, start, size,    n, depth, p, c) {
    n = 0
    for (p = from; from <= to + 1; p++) {
        c = substr(code, p, 1)
        depth += c ~ /[[({]/
        depth -= c ~ /[])}]/
        if (p <= to && (c != "," || depth > 0))
            continue
        match(substr(code, from, p - from), /^[ \n]*/)
        start[++n] = from + RLENGTH
        size[n] = p - start[n]
        from = p + 1
        if (p > to)
            break
    }
    return n > 1 || size[1] > 0 ? n : 0
}

# Returns the position of the next number from p on, or 0, with its RLENGTH.
function next_number(p,    at) {
    while (match(substr(code, p), /[0-9]([eEpP][-+][0-9]|[A-Za-z0-9.])*/)) {
        at = p + RSTART - 1
        if (at == 1 || substr(code, at - 1, 1) !~ /[A-Za-z0-9_.\\]/)
            return at
        match(substr(code, at), /^[A-Za-z0-9_.]+/)
        p = at + RLENGTH
    }
    return 0
}

# ---- C ----------------------------------------------------------------------

function is_declaration() {
    return code ~ /^ *[A-Za-z_0-9]+ ([A-Za-z_0-9]|\*[^ ])/ &&
        code !~ /^ *(return|else|case|goto|sizeof) /
}

# Larger arrays and changes of the elements that "{ 0 }" initialises are not faults.
function find_constants_of_c(    p, n, number) {
    for (p = 1; (p = next_number(p)) > 0; p += n) {
        n = RLENGTH
        number = substr(text, p, n)
        if ((substr(code, p - 1, 1) == "[" && is_declaration()) ||
            (p > 2 && substr(code, p - 2, 5) == "{ 0 }"))
            continue
        add("constant", p, n, "(" number " + 1)")
        add("constant", p, n, "(" number " - 1)")
    }
}

function find_operators(    p, n) {
    for (p = 1; match(substr(code, p), /[^ ]+/); p += n) {
        p += RSTART - 1
        n = RLENGTH
        if (substr(code, p, n) in operators)
            add("operator", p, n, operators[substr(code, p, n)])
    }
    for (p = 1; match(substr(code, p), /\+\+|--/); p += 2) {
        p += RSTART - 1
        add("operator", p, 2, substr(code, p, 1) == "+" ? "--" : "++")
    }
}

function find_condition(at,    open, close_at) {
    join_line(at)
    if (!match(code, /(^|[^A-Za-z_0-9])(if|while) \(/))
        return
    open = RSTART + RLENGTH - 1
    close_at = join_until_closed(open)
    if (close_at)
        add("condition", open, close_at - open + 1,
            "(!" substr(text, open, close_at - open + 1) ")")
}

# Removes an assignment, a call or a jump after a statement, block or condition.
function find_statement(at,    start) {
    join_line(at)
    if (before !~ /([;{})]|else) *$/ || is_declaration() ||
        code !~ /^    +[A-Za-z_*(+-]/ ||
        code ~ /^ *(return|for \(|if \(|while \(|else|switch|\(void\)|do )/)
        return
    while (code !~ /[;{}\\]/ && last < lines) {
        code = code "\n" codes[++last]
        text = text "\n" texts[last]
    }
    match(code, /^ +/)
    start = RLENGTH + 1
    match(code, /[;{}\\]/)
    if (substr(code, RSTART, 1) == ";")
        add("statement", start, RSTART - start, "")
}

# Exchanges NAME(column, ..) with the next row of the same name.
function find_row(at,    open, close_at, next_open, next_close, n, m, k) {
    join_line(at)
    if (!match(code, /^[A-Z_]+\(/))
        return
    open = RLENGTH
    close_at = join_until_closed(open)
    n = split_at_commas(open + 1, close_at - 1, start, size)
    for (k = 1; k < n; k++)
        exchange("columns", start[k], size[k], start[k + 1], size[k + 1])
    if (last == lines || substr(codes[last + 1], 1, open) != substr(code, 1, open))
        return
    next_open = length(code) + 1 + open
    code = code "\n" codes[++last]
    text = text "\n" texts[last]
    next_close = join_until_closed(next_open)
    exchange("rows", 1, close_at, next_open - open + 1, next_close - next_open + open)
    m = split_at_commas(next_open + 1, next_close - 1, next_start, next_size)
    for (k = 1; k <= n && k <= m; k++)
        exchange("column of two rows", start[k], size[k], next_start[k], next_size[k])
}

function find_in_c(at) {
    join_line(at)
    find_constants_of_c()
    if (table) {
        find_row(at)
        return
    }
    find_operators()
    find_condition(at)
    find_statement(at)
    if (codes[at] ~ /[^ ]/)
        before = codes[at]
}

# ---- The assembler's texts --------------------------------------------------

# An integer changes by one. Other numbers change in their first digit.
function find_constants(p,    n, number, digit) {
    for (; (p = next_number(p)) > 0; p += n) {
        n = RLENGTH
        number = substr(code, p, n)
        if (number ~ /^[0-9]+$/ && n < 15) {
            add("constant", p, n, number + 1)
            add("constant", p, n, number - 1)
        } else if (match(number, /[1-9]/)) {
            digit = substr(number, RSTART, 1)
            add("constant", p + RSTART - 1, 1, digit == 9 ? 8 : digit + 1)
        }
    }
}

function find_names(name, p,    k, start) {
    for (k in names)
        if (index(name, k) == 1 && name !~ /^ADDLEN/)
            add("instruction", p, length(k), names[k])
    if (match(name, /^(IBX|CFP|CMP|SEL|BH|B)/)) {
        k = substr(name, RLENGTH + 1, 2)
        if (k in opposites)
            add("relation", p + RLENGTH, 2, opposites[k])
    }
}

function can_replace(a, b) {
    return a != b && (a ~ /^[a-z]/ && b ~ /^[a-z]/ || a ~ /^\[/ && b ~ /^\[/ ||
        a ~ /^\\/ && b ~ /^\\/)
}

# An operand is exchanged with the next operand, or an operand of the previous
# instruction replaces it.
function find_operands(name, n,    k, m) {
    for (k = 1; k <= n; k++) {
        if (k < n && (k > 1 || name ~ /^(ANDN|ORN)/ || name !~ commutative))
            exchange("operands", start[k], size[k], start[k + 1], size[k + 1])
        for (m = 1; m <= earlier_count; m++)
            if (can_replace(substr(code, start[k], size[k]), earlier[m])) {
                add("field", start[k], size[k], earlier[m])
                break
            }
    }
    for (k = 1; k <= n; k++)
        earlier[k] = substr(code, start[k], size[k])
    earlier_count = n
}

function find_in_assembly(at,    p, name, end, mark, n) {
    join_line(at)
    sub(/ +$/, "", code)
    match(code, /^[^ ]* */)
    p = RLENGTH + 1
    match(substr(code, p), /^[^ ]*/)
    name = substr(code, p, RLENGTH)
    if (name == "" || (name ~ /^\./ && name !~ /^\.(word|equ|half)/))
        return
    find_constants(p + length(name))
    if (name ~ /^\./)
        return
    add("instruction removed", p, length(code) - p + 1, "")
    find_names(name, p)
    mark = index(code, "?")
    end = mark ? mark - 1 : length(code)
    while (substr(code, end, 1) == " ")
        end--
    n = split_at_commas(p + length(name), end, start, size)
    find_operands(name, n)
    if (!mark)
        return
    n = substr(code, mark + 1, 1) == "!" ? 2 : 1
    add("control vector", mark, n, n == 2 ? "?" : "?!")
    add("no control vector", mark, length(code) - mark + 1, "")
}

# ---- Files ------------------------------------------------------------------

function find_sites(    at) {
    sites = earlier_count = 0
    before = ""
    for (at = 1; at <= lines; at++)
        if (assembly)
            find_in_assembly(at)
        else
            find_in_c(at)
}

# Takes each line of all files: the file, the line, and the faults of the line.
function take_lines(    k) {
    for (k = 1; k <= sites; k++) {
        if (k == 1 || firsts[k] != firsts[k - 1])
            place[++places] = file " " k " " firsts[k] " 0"
        faults[places, ++fault_count[places]] = file " " k " " firsts[k] " " kinds[k]
    }
}

function end_file() {
    if (file == "")
        return
    find_sites()
    if (number == "")
        take_lines()
}

function random(n) {
    state = (state * 16807) % 2147483647
    return 1 + int(state / 2147483647 * n)
}

BEGIN {
    pairs(operators, "< <= <= < > >= >= > == != != == + - - + * / / * % / << >> >> <<" \
        " & | | & ^ | && || || && += -= -= += |= &= &= |= *= /= <<= >>= >>= <<=")
    pairs(names, "ADD SUB SUB ADD MPY DIV DIV MPY MAX MIN MIN MAX FLR CLG ABS RTOR" \
        " ANDB ORB ORB ANDB ANDNB ANDB XOR OR EX IX LOD STO ABSV VTOV")
    pairs(opposites, "EQ NE NE EQ LT GE GE LT LE GT GT LE")
    commutative = "^(ADD[NXUL]|MPY|AND|OR|XOR|NAND|NOR|EQVB|MAX|MIN|CMPEQ|CMPNE|CFPEQ|CFPNE|IBX)"
}

FNR == 1 {
    end_file()
    file = FILENAME
    assembly = file ~ /\.s$/
    table = file ~ /\.def$/
    lines = commented = 0
}

{
    texts[++lines] = $0
    codes[lines] = masked($0)
}

END {
    end_file()
    if (number != "") {
        if (number < 1 || number > sites)
            exit 1
        for (k = 1; k <= lines; k++)
            if (k == firsts[number])
                print changed[number]
            else if (k < firsts[number] || k > lasts[number])
                print texts[k]
        exit 0
    }
    state = (seed * 7919 + 1) % 2147483646 + 1
    for (k = 0; k < 20; k++)
        random(1)
    for (; count > 0 && places > 0; count--) {
        k = random(places)
        print faults[k, random(fault_count[k])]
        for (m = 1; m <= fault_count[places]; m++)
            faults[k, m] = faults[places, m]
        fault_count[k] = fault_count[places--]
    }
}
