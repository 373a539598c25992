/* annual_methods.c - see annual_methods.h. */
#include "cli/annual/annual_methods.h"

#include <string.h>

#include "methods/selection.h"

#define PLACE(member) offsetof(struct pp_annual_methods, member)

const struct pp_option pp_annual_methods_options[] = {
    {"methods", 'm', "all|LIST",
     "Also estimate the year by hand methods, beside the simulated figures: all, or "
     "names from the list below, separated by commas.",
     pp_options_read_text, PLACE(methods)},
    {"df", 0, "simulated|iso-1|METHOD",
     "Daylight factors for the hand methods. simulated (default) is for the CIE "
     "overcast sky of Moon and Spencer, iso-1 for type 1 of ISO 15469. METHOD is a "
     "hand "
     "method of df, such as exact+bre.",
     pp_options_read_text, PLACE(df)},
    {"explain", 'e', NULL,
     "Show the calculation of each hand method for the year, and for the hour of "
     "--when. For one point only.",
     NULL, PLACE(explain)},
    {"when", 0, "'YYYY-MM-DD HH:MM'",
     "With --explain: also show the calculation for the record of the weather file "
     "that "
     "contains this standard time; the year is ignored.",
     pp_moment_choice_read_when, PLACE(moment)},
    {0},
};

enum pp_status pp_annual_methods_settle(struct pp_annual_methods *methods, bool csv,
                                        struct pp_error *err)
{
    struct pp_hand_year_options *options = &methods->options;
    const char *alone = methods->df            ? "--df"
                        : methods->explain     ? "--explain"
                        : methods->moment.when ? "--when"
                                               : NULL;
    if (!methods->methods)
        return alone ? pp_fail(err, PP_BAD_INPUT,
                               "%s is for hand methods; expected --methods as well",
                               alone)
                     : PP_OK;
    if (methods->moment.when && !methods->explain)
        return pp_fail(err, PP_BAD_INPUT,
                       "--when selects the hour of an explanation; expected --explain "
                       "as well");
    if (methods->explain && csv)
        return pp_fail(err, PP_BAD_INPUT,
                       "--explain cannot write CSV; expected --format text or json");
    enum pp_status status =
        pp_year_method_choose(&options->methods, methods->methods, err);
    options->explain = methods->explain;
    options->date = methods->moment.of.date;
    options->clock_h = methods->moment.of.clock_h;
    if (methods->df && strcmp(methods->df, "iso-1") == 0) {
        options->overcast = PP_STANDARD_ISO_1;
    } else if (methods->df && strcmp(methods->df, "simulated") != 0) {
        options->df = methods->df;
        if (status == PP_OK)
            status = pp_selection_check(methods->df, err);
    }
    return status;
}

enum pp_status pp_annual_methods_check_rooms(const struct pp_annual_methods *methods,
                                             const struct pp_rooms *rooms,
                                             struct pp_error *err)
{
    for (int i = 0; methods->explain && i < rooms->count; i++)
        if (rooms->list[i].receiver_count != 1)
            return pp_fail(err, PP_BAD_INPUT,
                           "--explain shows the calculation for one point only, but "
                           "there are %d; expected one point, such as --points X,Y",
                           rooms->list[i].receiver_count);
    return PP_OK;
}

void pp_annual_methods_help(FILE *out)
{
    fputs("\nHand methods for the year (--methods):\n", out);
    for (int i = 0; pp_year_methods[i]; i++)
        pp_options_help_word(pp_year_methods[i]->name, pp_year_methods[i]->summary,
                             out);
}
