/* test_file_name_case.c - files that are found by a name in another case. Random
 * spellings of a path are looked up in folders whose names differ only in case, and the
 * results are compared with the files. A file that is missed, or a result with only one
 * of several matching files, fails here. */
#include "base/other_case.h"
#include "tests/unit/draw.h"
#include "tests/unit/temporary_folder.h"

#include <ctype.h>
#include <sys/stat.h>
#include <unistd.h>

/* Only the case of letters may differ. */
TEST(other_case_bytes)
{
    for (int a = 1; a < 128; a++)
        for (int b = 1; b < 128; b++) {
            char one = (char)a, other = (char)b;
            assert_int_equal(other_case_is(&one, &other, 1), tolower(a) == tolower(b));
        }
}

/* Two folders differ in case. All files in them that match a spelling are found. */
TEST(other_case)
{
    static const char *const files[] = { "maps/part.inc", "maps/Part.inc",
                                         "Maps/part.inc", "Maps/only.INC" };
    struct folder found;
    assert_int_equal(chdir(temporary_folder), 0);
    mkdir("maps", 0777);
    mkdir("Maps", 0777);
    for (size_t i = 0; i < 4; i++)
        write_file(files[i], "");
    for (size_t i = 0; i < 200; i++) {
        bool once = i % 2;
        char name[] = "./maps/part.inc", other[] = "./maps/only.inc";
        char *wanted = once ? other : name;
        for (char *at = wanted; *at; at++)
            if (*at >= 'a' && *at <= 'z' && below(2))
                *at = (char)(*at - 'a' + 'A');
        assert_true(other_case_find(&found, in_folder(wanted), strlen(in_folder(""))));
        assert_int_equal(found.count, once ? 1 : 3);
        assert_non_null(
            strstr(found.names[0], once ? "/./Maps/only.INC" : "/./Maps/part.inc"));
        folder_free(&found);
        assert_true(other_case_find(&found, wanted, 0));
        assert_int_equal(found.count, once ? 1 : 3);
        folder_free(&found);
    }
    assert_true(other_case_find(&found, "maps", 0));
    assert_int_equal(found.count, 0);
    folder_free(&found);
    for (size_t i = 0; i < 4; i++)
        remove(files[i]);
    remove("maps");
    remove("Maps");
    assert_int_equal(chdir("/"), 0);
}
