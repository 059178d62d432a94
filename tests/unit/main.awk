# main.awk - prints a file with TEST(name) lines (unit.h), followed by a main that runs
# the tests. A file without such lines has its own main.

{
    macro = $0
    sub(/\(.*/, "", macro)
    name = $0
    sub(/^[A-Z_]*\(/, "", name)
    sub(/[,)].*/, "", name)
}
macro == "TEST" || macro == "TEST_CALL" {
    rows = rows "    { \"" name "\", test_" name ", NULL, NULL, NULL },\n"
}
macro == "TEST_WITH" {
    rows = rows "    { \"" name "\", test_" name \
        ", before_" name ", after_" name ", NULL },\n"
}
macro == "GROUP" {
    group = "before_all, after_all"
}
macro == "ARGUMENTS" || macro == "COUNT_AND_SEED" {
    reads = "    read_arguments(argc, argv);\n"
}
macro == "int main" {
    own = 1
}
END {
    if (own == (rows != "")) {
        print FILENAME ": needs either tests or a main" >"/dev/stderr"
        exit 1
    }
    print "#include \"" FILENAME "\""
    if (own)
        exit
    printf "static const struct CMUnitTest tests[] = {\n%s};\n", rows
    print "int main(int argc, char **argv)\n{"
    printf "%s", reads ? reads : "    (void)argc, (void)argv;\n"
    title = FILENAME
    gsub(/.*\/test_|\.c$/, "", title)
    print "    return RUN_TESTS(\"" title "\", tests, " \
        (group ? group : "FILE_FIXTURES") ");\n}"
}
