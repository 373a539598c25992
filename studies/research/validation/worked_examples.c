/* worked_examples.c - the rooms and protractors, with their expected values. */
#include "studies/research/validation/worked_examples.h"

#include "methods/protractor/protractor_scale.h"
#include "studies/research/validation/known_room.h"

static enum pp_status check_protractors(struct pp_known_cases *cases,
                                        struct pp_error *err)
{
    static const struct {
        int number;
        double altitude_deg, per_cent;
        int decimals;
        const char *what;
    } list[] = {
        {9, 30.0, 6.6987, 4, "protractor 9, endless strip up to 30 degrees"},
        {10, 30.0, 4.519, 3, "protractor 10, endless strip up to 30 degrees"},
        {9, 60.0, 25.0, 3, "protractor 9, endless strip up to 60 degrees"},
        {10, 60.0, 21.886, 3, "protractor 10, endless strip up to 60 degrees"},
    };
    struct pp_protractor protractor;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        enum pp_status status =
            pp_protractor_scale_published(&protractor, list[i].number, err);
        if (status != PP_OK)
            return status;
        pp_known_case_add_per_cent(
            cases, list[i].what, "protractor",
            pp_protractor_scale_primary(&protractor, list[i].altitude_deg * PP_RAD),
            list[i].per_cent, list[i].decimals);
    }
    return PP_OK;
}

#define SCHOOLROOM                                                                     \
    "<room version='1'><site ground-reflectance='0.1'/>"                               \
    "<plan width='4' depth='6' height='3'/>"                                           \
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/><point x='2' y='3'/>"            \
    "<window wall='south' left='0.2' sill='0.9' width='3.6' height='1.5' "

/* Checks the internally reflected component and the average daylight factor of a room
 * of 4 x 6 x 3 m, and a window read from the BRS table. */
static enum pp_status check_rooms(struct pp_known_cases *cases, struct pp_error *err)
{
    struct pp_known_room room;
    enum pp_status status =
        pp_known_room_evaluate(&room, SCHOOLROOM "/></room>", "bre,split-flux", err);
    if (status != PP_OK)
        return status;
    pp_known_case_add_per_cent(cases, "room 4 x 6 x 3 m, window 3.6 x 1.5 m", "bre",
                               pp_known_room_at_point(&room, PP_IRC, "bre"), 1.3289, 4);
    pp_known_case_add_per_cent(
        cases, "room 4 x 6 x 3 m, window 3.6 x 1.5 m", "split-flux",
        pp_known_room_at_point(&room, PP_IRC, "split-flux"), 1.2610, 4);
    pp_known_room_clear(&room);

    status = pp_known_room_evaluate(
        &room,
        SCHOOLROOM "diffusing='yes' transmittance='0.68' maintenance='0.9'/>"
                   "<skyline wall='south' angle='25'/></room>",
        "average-df", err);
    if (status != PP_OK)
        return status;
    pp_known_case_add_per_cent(
        cases, "the same room, with T = 0.68, M = 0.9 and theta = 65 degrees",
        "average-df", pp_known_room_average(&room, PP_DF, "average-df"), 2.5163, 4);
    pp_known_room_clear(&room);

    status = pp_known_room_evaluate(&room, PP_KNOWN_HALL "</room>", "brs-table", err);
    if (status != PP_OK)
        return status;
    pp_known_case_add_per_cent(cases, "window 3 x 1.8 m at 3 m", "brs-table",
                               pp_known_room_at_point(&room, PP_SC, "brs-table"), 3.35,
                               2);
    pp_known_room_clear(&room);

    status = pp_known_room_evaluate(
        &room, PP_KNOWN_HALL "<skyline wall='south' angle='26.565051177078'/></room>",
        "brs-table", err);
    if (status != PP_OK)
        return status;
    pp_known_case_add_per_cent(
        cases, "the same window, sky component above a skyline of h/d 0.5", "brs-table",
        pp_known_room_at_point(&room, PP_SC, "brs-table"), 2.08, 2);
    pp_known_case_add_per_cent(
        cases, "the same window, externally reflected component of the skyline",
        "brs-table", pp_known_room_at_point(&room, PP_ERC, "brs-table"), 0.254, 3);
    pp_known_room_clear(&room);
    return PP_OK;
}

enum pp_status pp_worked_examples(struct pp_known_cases *cases, struct pp_error *err)
{
    enum pp_status status = check_protractors(cases, err);
    return status == PP_OK ? check_rooms(cases, err) : status;
}
