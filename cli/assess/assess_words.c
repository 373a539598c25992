/* assess_words.c - see assess_words.h. */
#include "cli/assess/assess_words.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "cli/assess/schedule_file.h"
#include "cli/availability/availability_options.h"
#include "model/base/text.h"
#include "studies/criteria/assessment.h"
#include "studies/criteria/capitals.h"
#include "studies/criteria/rules/rule_table.h"

#define PLACE(member) offsetof(struct pp_assess_words, member)

/* Least length of a boundary line (m). */
#define BOUNDARY_LEAST_M 0.01

static enum pp_status read_boundary(const char *text, void *place, struct pp_error *err)
{
    struct pp_boundary_words *words = place;
    double v[4];
    bool good = pp_options_numbers(text, ',', v, 4) == 4;
    for (int i = 0; i < 4 && good; i++)
        good = fabs(v[i]) <= 1e6;
    if (!good || hypot(v[2] - v[0], v[3] - v[1]) < BOUNDARY_LEAST_M)
        return pp_fail(
            err, PP_BAD_INPUT,
            "two different points X1,Y1,X2,Y2 in metres, such as 0,-7.5,12,-7.5");
    *words = (struct pp_boundary_words){true, {{v[0], v[1]}, {v[2], v[3]}}};
    return PP_OK;
}

static enum pp_status read_altitude(const char *text, void *place, struct pp_error *err)
{
    double deg;
    if (!pp_text_parse_number(text, &deg) || !(deg > 0.0 && deg <= 45.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "an altitude above 0 and up to 45 degrees, such as 11");
    *(double *)place = deg * PP_RAD;
    return PP_OK;
}

static enum pp_status read_shortest(const char *text, void *place, struct pp_error *err)
{
    double minutes;
    if (!pp_text_parse_number(text, &minutes) || !(minutes > 0.0 && minutes <= 240.0))
        return pp_fail(err, PP_BAD_INPUT, "minutes above 0 and up to 240, such as 5");
    *(double *)place = minutes / 60.0;
    return PP_OK;
}

const struct pp_option pp_assess_words_table[] = {
    {"table", 0, NULL,
     "Print one table of all windows and rooms, existing and proposed, instead of a "
     "sheet for each room.",
     NULL, PLACE(table)},
    {"schedule", 0, "FILE",
     "Also write the schedule of windows, existing and proposed, to FILE: .csv, "
     ".xlsx, .html or .pdf.",
     pp_options_read_output, PLACE(schedule)},
    {"rules", 0, NULL,
     "List the rules of countries and schemes for --for, with their numbers, sources "
     "and "
     "certainty; assess nothing.",
     NULL, PLACE(list_rules)},
    {0},
};

const struct pp_option pp_assess_words_choice[] = {
    {"criteria", 'c', "LIST", "Assess only these criteria: names, separated by commas.",
     pp_options_read_text, PLACE(criteria)},
    {"for", 0, "NAME",
     "Assess only the criteria of this profile, which is a kind of report or a use "
     "of the room, or the rules of a country or scheme (--rules).",
     pp_options_read_text, PLACE(profile_name)},
    {"withdrawn", 0, NULL, "Also assess criteria whose standards were withdrawn.", NULL,
     PLACE(withdrawn)},
    {"before", 'b', "FILE",
     "Room file of the site before the development, to assess the loss of visible "
     "sky and of lit area.",
     pp_options_read_input, PLACE(before)},
    {"mirror-image", 0, "X1,Y1,X2,Y2",
     "Also compare visible sky and lit area with those left by a mirror image of "
     "the building beyond this boundary line.",
     read_boundary, PLACE(mirror_image)},
    {"place", 0, "NAME",
     "Use the median illuminance of this capital in the table of EN 17037. The default "
     "is the capital of the site's country, or the nearest one.",
     pp_options_read_text, PLACE(place)},
    {"median-diffuse", 0, "LUX",
     "Median diffuse illuminance at the site, for EN 17037.", pp_options_read_lux,
     PLACE(median_lux)},
    {"weather", 'w', "FILE.epw",
     "Use this EnergyPlus weather file for the median illuminance and the probability "
     "of sunshine.",
     pp_options_read_input, PLACE(weather)},
    {"least-altitude", 0, "DEG",
     "For sun-exposure, count the sun only above this altitude. Default: the value "
     "of EN 17037 for the country (DE 11, CZ 13). For other countries there is a "
     "verdict only if it is the same for all altitudes from 5 to 20 degrees.",
     read_altitude, PLACE(least_altitude_rad)},
    {"shortest", 0, "MIN",
     "For sun-exposure and rules with hours of sun on a day, do not count intervals of "
     "sun shorter than this. sun-exposure lists the others.",
     read_shortest, PLACE(shortest_h)},
    {"room", 0, "NAME", "Assess only the room with this name.", pp_options_read_text,
     PLACE(room.room)},
    {"state", 0, "STATE",
     "Assess only the existing, the proposed or the cumulative state of the site. By "
     "default the proposed state is compared with the others.",
     pp_room_options_read_state, PLACE(room.state)},
    {0},
};

static bool is_profile(const char *name)
{
    const struct pp_profile *profile;
    for (int i = 0; (profile = pp_profile_at(i)) != NULL; i++)
        if (strcmp(profile->name, name) == 0)
            return true;
    return false;
}

void pp_assess_words_help(FILE *out)
{
    fputs("\nCriteria:\n", out);
    const struct pp_criterion *criterion;
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        pp_options_help_word(criterion->name, criterion->summary, out);
    fputs("\nWithdrawn, assessed only if named, or with --withdrawn:\n", out);
    const char *before = "  ";
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (criterion->withdrawn) {
            fprintf(out, "%s%s", before, criterion->name);
            before = ", ";
        }
    fputs("\n\nProfiles for --for:\n", out);
    const struct pp_profile *profile;
    for (int i = 0; (profile = pp_profile_at(i)) != NULL; i++)
        pp_options_help_word(profile->name, profile->summary, out);
    fputs("\nRules of countries and schemes for --for (see --rules):\n ", out);
    const char *name;
    int column = 1;
    for (int i = 0; (name = pp_rule_table_name(i)) != NULL; i++) {
        struct pp_rule_set set;
        if (!pp_rule_set_init(&set, name) || !set.is_judged || is_profile(name))
            continue;
        column += (int)strlen(name) + 1;
        if (column > 78) {
            fputs("\n ", out);
            column = (int)strlen(name) + 2;
        }
        fprintf(out, " %s", name);
    }
    fputs("\n\nAlso:", out);
    for (int i = 0; (criterion = pp_criteria_at(i)) != NULL; i++)
        if (criterion->alias)
            fprintf(out, " %s (%s)", criterion->alias, criterion->name);
    fputc('\n', out);
}

static enum pp_status check_place(const struct pp_assess_words *options,
                                  struct pp_error *err)
{
    const char *names[64];
    int count = 0;
    if (options->weather && (options->place || options->median_lux > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--weather and %s both set the median illuminance; expected "
                       "only one of them",
                       options->place ? "--place" : "--median-diffuse");
    if (!options->place || pp_capitals_find(options->place))
        return options->place && options->median_lux > 0.0
                   ? pp_fail(err, PP_BAD_INPUT,
                             "--place and --median-diffuse both set the median "
                             "illuminance; expected only one of them")
                   : PP_OK;
    for (; count < 64 && count < pp_capitals_count(); count++)
        names[count] = pp_capitals_at(count)->name;
    return pp_text_unknown(err, options->place, names, count, NULL,
                           "--place: \"%.100s\" is not in the table of the standard",
                           options->place);
}

bool pp_assess_words_need_year(const struct pp_assess_words *words)
{
    return words->with_year || (words->has_rules && words->rules.only_year)
           || pp_assessment_needs_year(words->criteria, words->profile, false);
}

bool pp_assess_words_use_year(const struct pp_assess_words *words)
{
    return pp_assess_words_need_year(words)
           || (words->has_rules && words->rules.of_year)
           || pp_assessment_needs_year(words->criteria, words->profile, true);
}

/* Checks that there are both a weather file and a simulation, which a simulated year
 * requires. */
static enum pp_status check_year(const struct pp_assess_words *options,
                                 struct pp_error *err)
{
    const char *by = options->with_year   ? "--year"
                     : options->has_rules ? options->rules.criterion.name
                                          : "LEED";
    if (!options->weather)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s needs weather data for a year; expected --weather FILE.epw",
                       by);
    if (options->room.by_hand)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is always simulated; expected no --by-hand", by);
    return PP_OK;
}

static enum pp_status check_schedule(const struct pp_assess_words *options,
                                     struct pp_error *err)
{
    enum pp_status status = pp_schedule_file_check(options->schedule, err);
    if (status != PP_OK)
        return status;
    return options->room.sweep.axis_count == 0
               ? PP_OK
               : pp_fail(err, PP_BAD_INPUT,
                         "--schedule is for a single run, but --sweep makes many; "
                         "expected only one of them");
}

/* No profile and no rule has this name: the error suggests a similar name, or lists the
 * profiles. */
static enum pp_status refuse_profile(const char *typed, struct pp_error *err)
{
    enum { NAMES_MOST = 128 };
    const char *names[NAMES_MOST], *name;
    char profiles[256], expected[400];
    int count = 0;
    for (int i = 0; pp_profile_at(i) && count < NAMES_MOST; i++)
        names[count++] = pp_profile_at(i)->name;
    snprintf(
        expected, sizeof expected,
        "; expected a profile (%s) or a rule; \"pepperpot assess --rules\" lists the "
        "rules by country",
        pp_text_list_names(profiles, sizeof profiles, names, count));
    for (int i = 0; (name = pp_rule_table_name(i)) != NULL && count < NAMES_MOST; i++) {
        struct pp_rule_set set;
        if (pp_rule_set_init(&set, name) && set.is_judged && !is_profile(name))
            names[count++] = name;
    }
    return pp_text_unknown(err, typed, names, count, expected,
                           "there is no profile and no rule \"%.60s\"", typed);
}

/* Finds the profile or the rules named by --for. Rules replace the room's sky and
 * working plane. */
static enum pp_status find_profile(struct pp_assess_words *options,
                                   struct pp_error *err)
{
    const char *name = options->profile_name;
    if (is_profile(name)) {
        options->profile = pp_profile_find(name, err);
        return PP_OK;
    }
    if (!pp_rule_set_init(&options->rules, name))
        return refuse_profile(name, err);
    if (!options->rules.is_judged)
        return pp_fail(err, PP_BAD_INPUT,
                       "--for: the rules \"%s\" are only listed, as their numbers are "
                       "not established or not calculated; see assess --rules",
                       name);
    options->has_rules = true;
    options->room.study.sky = options->rules.sky;
    options->room.plane_m = options->rules.plane_m > 0.0 ? options->rules.plane_m : 0.0;
    return PP_OK;
}

enum pp_status pp_assess_words_check(void *values, char **files, int file_count,
                                     struct pp_error *err)
{
    (void)files;
    struct pp_assess_words *options = values;
    bool chosen[PP_CRITERIA_MOST];
    if (options->list_rules)
        return PP_OK;
    if (file_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "expected a room file, or - for standard input");
    enum pp_status status = pp_room_options_settle_by_hand(&options->room, err);
    if (status == PP_OK)
        status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK)
        status = check_place(options, err);
    if (status == PP_OK)
        status = pp_assessment_choose(chosen, options->criteria, err);
    if (status == PP_OK && options->profile_name)
        status = find_profile(options, err);
    if (status == PP_OK && pp_assess_words_need_year(options))
        status = check_year(options, err);
    if (status == PP_OK && options->criteria && options->profile_name)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "--criteria and --for both select criteria; expected only one of them");
    if (status == PP_OK && options->mirror_image.given
        && (options->before || options->room.state != PP_STATE_BOTH))
        status = pp_fail(err, PP_BAD_INPUT,
                         "--mirror-image compares the existing and proposed states of "
                         "one file; it cannot be combined with %s",
                         options->before ? "--before" : "--state");
    if (status == PP_OK && options->schedule)
        status = check_schedule(options, err);
    if (status == PP_OK && options->table && options->room.sweep.axis_count > 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "--table is for a single run, but --sweep makes many; "
                         "expected only one of them");
    if (status == PP_OK && options->before && options->room.state != PP_STATE_BOTH)
        status = pp_fail(
            err, PP_BAD_INPUT,
            "--before and --state both select states; expected only one of them");
    return status;
}

void pp_assess_words_init(void *values)
{
    *(struct pp_assess_words *)values = (struct pp_assess_words){
        .room = pp_room_options_none, .light = pp_year_options_default};
}

void pp_assess_words_clear(void *values)
{
    struct pp_assess_words *options = values;
    pp_weather_year_clear(&options->year);
    pp_availability_options_clear(&options->light);
    pp_room_options_clear(&options->room);
}
