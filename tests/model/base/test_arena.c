/* test_arena.c - blocks of memory that are freed together. */
#include <stdint.h>

#include "model/base/arena.h"
#include "tests/lib/near.h"

/* Small blocks, blocks that fill a chunk exactly, and blocks larger than any chunk. */
static void pieces_lie_apart_and_fit_any_type(void **state)
{
    (void)state;
    static const size_t sizes[] = {1, 0, 17, 65535, 65536, 8, 200000, 3, 65520, 16, 1};
    enum { COUNT = sizeof sizes / sizeof *sizes };
    struct pp_arena arena = {0};
    unsigned char *pieces[COUNT];
    for (int i = 0; i < COUNT; i++) {
        pieces[i] = pp_arena_take(&arena, sizes[i]);
        assert_non_null(pieces[i]);
        assert_int_equal((uintptr_t)pieces[i] % _Alignof(max_align_t), 0);
        memset(pieces[i], i + 1, sizes[i]);
    }
    for (int i = 0; i < COUNT; i++)
        for (size_t k = 0; k < sizes[i]; k++)
            if (pieces[i][k] != i + 1)
                fail_msg("byte %zu of piece %d was written by another", k, i);
    pp_arena_clear(&arena);
    assert_null(arena.blocks);
    pp_arena_clear(&arena);
}

static void texts_are_copies_with_an_end(void **state)
{
    (void)state;
    struct pp_arena arena = {0};
    char text[] = "daylight";
    const char *day = pp_arena_take_text(&arena, text, 3);
    const char *none = pp_arena_take_text(&arena, text, 0);
    text[0] = 'x';
    assert_string_equal(day, "day");
    assert_string_equal(none, "");
    pp_arena_clear(&arena);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_lie_apart_and_fit_any_type),
        cmocka_unit_test(texts_are_copies_with_an_end),
    };
    add_tests(tests, NULL, NULL);
}
