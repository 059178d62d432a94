/* test_vector_use.c - the counts of elements that control vectors permit are compared
 * with a program whose bits are known. A count of 0 or 2 for an instruction fails. */
#include "tests/unit/saved_machine.h"

#include "rt/trace/vector_use.h"

/* Counts one vector instruction with 150 elements. Its control vector begins in the
 * middle of a word. All its bits are ones, except the first two and the last. The bits
 * around it are also ones. */
static struct vector_use use_of(const char *instruction)
{
    struct vector_use sum = { 0, 0, 0, 0 };
    struct observer observer = vector_use_observer(&sum);
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe-prior", &failure);
    SCOPED(object) *object = good(
        formatted(" .include \"core.s\"\n .data\n"
                  "bits: .word X'FFFFFFFFFF3FFFFF', X'FFFFFFFFFFFFFFFF'\n"
                  " .word X'FFFFFFFFFFFFFFFB', X'FFFFFFFFFFFFFFFF'\n"
                  "v: .space 200\n .code\n"
                  " descriptor r10, v, 150\n"
                  " descriptor r20, bits + 40, 0\n"
                  " %s\n EXIT\n",
                  instruction));
    SCOPED(c205) *machine = machine_with(&object->program, model);
    void *use = observer.begin(observer.context, object, &failure);
    assert_true(c205_listen(machine, observer.listen, use));
    assert_int_equal(c205_run(machine, 100000).trap, C205_TRAP_NONE);
    observer.merge(observer.context, use);
    observer.end(use);
    return sum;
}

static void check(const char *instruction, uint64_t controlled, uint64_t wanted)
{
    struct vector_use use = use_of(instruction);
    assert_int_equal(use.instructions, 1);
    assert_int_equal(use.elements, 150);
    assert_int_equal(use.controlled, controlled);
    assert_int_equal(use.wanted, wanted);
}

TEST(control)
{
    check("ADDNV [r10], [r10], [r10]", 0, 0);
    check("ADDNV [r10], [r10], [r10] ? [r20]", 150, 147);
    check("ADDNV [r10], [r10], [r10] ?! [r20]", 150, 3);
}
