/* test_array.c - lists keep their contents when they grow. */
#include "tests/lib/near.h"

#include <limits.h>
#include <stdlib.h>

#include "model/base/array.h"

static void items_stay_while_a_list_grows(void **state)
{
    (void)state;
    double *list = NULL;
    int capacity = 0;
    for (int i = 0; i < 1000; i++) {
        assert_int_equal(pp_array_reserve(&list, &capacity, i + 1, sizeof *list, NULL),
                         PP_OK);
        list[i] = 1.5 * i;
    }
    assert_int_equal(capacity, 1024);
    for (int i = 0; i < 1000; i++)
        assert_true(list[i] == 1.5 * i);
    free(list);
}

static void items_stay_where_no_capacity_is_kept(void **state)
{
    (void)state;
    char *list = NULL;
    for (int i = 0; i < 777; i++) {
        assert_int_equal(pp_array_append(&list, i, sizeof *list, NULL), PP_OK);
        list[i] = (char)(i % 101);
    }
    for (int i = 0; i < 777; i++)
        assert_int_equal(list[i], i % 101);
    free(list);
}

static void more_than_there_can_be_is_refused_and_the_list_stays(void **state)
{
    (void)state;
    struct {
        char bytes[1 << 30];
    } *list = NULL;
    int capacity = 0;
    struct pp_error err;
    void *before = list;
    assert_int_equal(pp_array_reserve(&list, &capacity, INT_MAX, (size_t)1 << 62, &err),
                     PP_SYSTEM);
    assert_int_equal(capacity, 0);
    assert_ptr_equal(list, before);
    assert_int_equal(pp_array_append(&list, INT_MAX, 1, &err), PP_SYSTEM);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(items_stay_while_a_list_grows),
        cmocka_unit_test(items_stay_where_no_capacity_is_kept),
        cmocka_unit_test(more_than_there_can_be_is_refused_and_the_list_stays),
    };
    add_tests(tests, NULL, NULL);
}
