/* opened.h - a study of a room given as a string, by the public interface only. */
#ifndef PP_TESTS_LIB_OPENED_H
#define PP_TESTS_LIB_OPENED_H

#include "pepperpot.h"
#include "tests/lib/near.h"

/* A study of one room, and the objects it depends on. */
struct pp_test_opened {
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

static inline struct pp_test_opened pp_test_open(const char *xml)
{
    struct pp_test_opened opened = {.mistakes = pp_mistakes_create("test.xml")};
    struct pp_error err = {0};
    assert_non_null(opened.mistakes);
    if (pp_building_parse(&opened.building, xml, strlen(xml), opened.mistakes, &err)
            != PP_OK
        || pp_study_create(&opened.study, opened.building, 0, NULL, opened.mistakes,
                           &err)
               != PP_OK)
        fail_msg("%s", err.message);
    return opened;
}

static inline void pp_test_close(struct pp_test_opened *opened)
{
    pp_study_destroy(opened->study);
    pp_building_destroy(opened->building);
    pp_mistakes_destroy(opened->mistakes);
}

#endif
