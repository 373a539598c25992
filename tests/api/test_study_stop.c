/* test_study_stop.c - hand methods and contours stop when the condition of the program
 * holds, in every thread that works on them. */
#include "tests/lib/near.h"

#include <stdatomic.h>
#include <string.h>

#include "pepperpot.h"

static const char room_text[] =
    "<room version='1'><plan width='6.0' depth='9.0' height='2.7'/>\n"
    "<window wall='south' left='0.4' sill='0.9' width='1.1' height='1.3'/>\n"
    "<grid spacing='0.5'/></room>";

/* A condition that holds from a certain call on. */
struct patience {
    atomic_int calls;
    int most;
};

static bool is_exhausted(void *data)
{
    struct patience *patience = data;
    return atomic_fetch_add(&patience->calls, 1) >= patience->most;
}

/* Runs hand methods (or makes contours) until the given call of the condition. */
static enum pp_status run_until(struct patience *patience, bool contours)
{
    struct pp_mistakes *mistakes = pp_mistakes_create("test.xml");
    struct pp_building *building = NULL;
    struct pp_study *study = NULL;
    struct pp_error err = {0};
    char *bytes = NULL;
    size_t length;
    if (pp_building_parse(&building, room_text, strlen(room_text), mistakes, &err)
            != PP_OK
        || pp_study_create(&study, building, 0, NULL, mistakes, &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_study_stop_when(study, is_exhausted, patience);
    enum pp_status status =
        contours ? pp_study_plan(study, "exact+bre", 0.01, &bytes, &length, &err)
                 : pp_study_methods(study, "exact+bre,protractor+bre", false, &err);
    pp_free(bytes);
    pp_study_destroy(study);
    pp_building_destroy(building);
    pp_mistakes_destroy(mistakes);
    return status;
}

static void work_stops_when_its_condition_holds(void **state)
{
    (void)state;
    for (int contours = 0; contours < 2; contours++) {
        struct patience endless = {.most = 1 << 30};
        assert_int_equal(run_until(&endless, contours), PP_OK);
        int all = atomic_load(&endless.calls);
        assert_true(all > 4000);
        for (int share = 0; share < 8; share++) {
            struct patience patience = {.most = all * share / 8};
            assert_int_equal(run_until(&patience, contours), PP_INTERRUPTED);
            /* A batch of 16 points may be under way in each of a few threads. */
            assert_true(atomic_load(&patience.calls) < patience.most + 500);
        }
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(work_stops_when_its_condition_holds),
    };
    add_tests(tests, NULL, NULL);
}
