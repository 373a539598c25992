/* room_options.c - the tables of options common to all commands on a room, and their
 * check. */
#include "cli/room_options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/sweep/sweep_options.h"
#include "model/base/text.h"
#include "model/base/array.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/section_line.h"

const struct pp_room_options pp_room_options_none = {.study.seed = 1};

#define PLACE(member) offsetof(struct pp_room_options, member)

/* Reads one point, "X,Y" or "X,Y,Z", from text of `length` bytes. */
static bool read_point(const char *text, size_t length, struct pp_vec3 *point)
{
    char copy[128];
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';

    double xyz[3] = {NAN, NAN, NAN};
    int count = 0;
    for (char *rest = copy, *part; (part = strsep(&rest, ",")) != NULL; count++)
        if (count == 3 || !pp_text_parse_number(part, &xyz[count])
            || fabs(xyz[count]) > 1e6)
            return false;
    *point = pp_vec(xyz[0], xyz[1], xyz[2]);
    return count >= 2;
}

/* Reads points and appends them to the list. */
static enum pp_status read_points(const char *text, void *place, struct pp_error *err)
{
    static const char blanks[] = " \t\n;";
    struct pp_point_list *points = place;
    int before = points->count;
    for (text += strspn(text, blanks); *text; text += strspn(text, blanks)) {
        size_t length = strcspn(text, blanks);
        struct pp_vec3 point;
        if (!read_point(text, length, &point))
            break;
        if (pp_array_append(&points->list, points->count, sizeof *points->list, err)
            != PP_OK)
            return PP_SYSTEM;
        points->list[points->count++] = point;
        text += length;
    }
    if (*text || points->count == before)
        return pp_fail(err, PP_BAD_INPUT,
                       "points X,Y or X,Y,Z in metres, separated by spaces, such as "
                       "\"1.5,0.5 1.5,2\"");
    return PP_OK;
}

enum pp_status pp_room_options_read_state(const char *text, void *place,
                                          struct pp_error *err)
{
    enum pp_site_state *state = place;
    if (strcmp(text, "existing") == 0)
        *state = PP_STATE_EXISTING;
    else if (strcmp(text, "proposed") == 0)
        *state = PP_STATE_PROPOSED;
    else if (strcmp(text, "cumulative") == 0)
        *state = PP_STATE_CUMULATIVE;
    else
        return pp_fail(err, PP_BAD_INPUT, "existing, proposed or cumulative");
    return PP_OK;
}

const struct pp_option pp_room_methods_option[] = {
    {"methods", 'm', "LIST",
     "Methods to use: names, separated by commas, or \"all\", or \"default\".",
     pp_options_read_text, PLACE(study.methods)},
    {0},
};

const struct pp_option pp_room_points_option[] = {
    {"points", 'p', "X,Y[,Z]",
     "Reference points in metres instead of those in the file; separate several by "
     "spaces or repeat the option. Without Z they are on the working plane.",
     read_points, PLACE(study.points)},
    {0},
};

const struct pp_option pp_room_sky_options[] = {
    {"sky", 0, "TYPE",
     "Use a sky other than the file's: overcast, uniform, or iso-1 to iso-15. For "
     "types with a sun, add \",ALTITUDE,BEARING\" in degrees. For a photograph use "
     "\"picture,FILE\"; add \",KEY=VALUE\" for each attribute of <sky>.",
     pp_options_read_text, PLACE(study.sky)},
    {"room", 0, "NAME", "Use only the room with this name.", pp_options_read_text,
     PLACE(room)},
    {"state", 0, "STATE",
     "Use the site as existing, as proposed (default), or cumulative: with other "
     "permitted buildings as well.",
     pp_room_options_read_state, PLACE(state)},
    {0},
};

const struct pp_option pp_room_french_option[] = {
    {"vsc-point-french", 0, "M",
     "Calculate the vertical sky component of full-height windows at this height above "
     "the floor, such as 1.6, instead of at their centre.",
     pp_options_read_metres, 0},
    {0},
};

static enum pp_status read_cut(const char *text, void *place, struct pp_error *err)
{
    return pp_section_place_read(place, text, err);
}

const struct pp_option pp_room_cut_option[] = {
    {"cut", 0, "PLACE",
     "Section: cut along x=M or y=M (in metres, in the axes of the room), or through "
     "the opening with this name. By default, it follows the line of points in the "
     "file, or else passes through the largest opening. A plan marks this section.",
     read_cut, 0},
    {0},
};

#define FACT(member) offsetof(struct pp_project, member)

const struct pp_option pp_room_project_options[] = {
    {"project", 0, "NAME", "Name of the project, in place of the file's <project>.",
     pp_options_read_text, FACT(name)},
    {"client", 0, "NAME", "Client.", pp_options_read_text, FACT(client)},
    {"author", 0, "NAME", "Author.", pp_options_read_text, FACT(author)},
    {"checked", 0, "NAME", "Person who checked the work.", pp_options_read_text,
     FACT(checked)},
    {"date", 0, "DATE", "Date.", pp_options_read_text, FACT(date)},
    {"revision", 0, "TEXT", "Revision.", pp_options_read_text, FACT(revision)},
    {0},
};

/* Reads a grid spacing: "S", "S,MARGIN" or "largest". */
static enum pp_status read_spacing(const char *text, void *place, struct pp_error *err)
{
    struct pp_grid_choice *choice = place;
    double v[2] = {0.0, PP_PLANE_GRID_MARGIN_M};
    *choice = (struct pp_grid_choice){.largest = strcmp(text, "largest") == 0};
    if (choice->largest)
        return PP_OK;
    if (pp_options_numbers(text, ',', v, 2) < 1 || !(v[0] >= 0.01 && v[0] <= 10.0)
        || !(v[1] >= 0.0 && v[1] <= 10.0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "a spacing from 0.01 to 10 m, with or without a comma and a margin from "
            "0 to 10 m, such as 0.25 or 0.25,0.5; or largest");
    choice->spacing_m = v[0];
    choice->margin_m = v[1];
    return PP_OK;
}

const struct pp_option pp_room_spacing_option[] = {
    {"spacing", 0, "S[,MARGIN]",
     "Assess the working plane on a grid with spacing S, at a distance MARGIN from the "
     "walls (default 0.5 m). Without the option, the spacing is that of the grid in "
     "the file, or else 0.3 m, halved until the verdicts no longer depend on it. "
     "\"largest\" is the coarsest grid that EN 17037 permits.",
     read_spacing, 0},
    {0},
};

const struct pp_option pp_room_external_option[] = {
    {"external", 0, "LUX",
     "Also show illuminances in lux for this external illuminance (5000 is common).",
     pp_options_read_lux, PLACE(study.external_lux)},
    {0},
};

const struct pp_option pp_room_simulate_option[] = {
    {"simulate", 's', NULL, "Also simulate, and compare the result with the methods.",
     NULL, PLACE(study.simulate)},
    {0},
};

const struct pp_option pp_room_by_hand_options[] = {
    {"by-hand", 0, NULL, "Leave out the simulation.", NULL, PLACE(by_hand)},
    {"simulate", 's', NULL, "Simulate (default).", NULL, PLACE(study.simulate)},
    {0},
};

const struct pp_option pp_room_stop_options[] = {
    {"error", 0, "E%",
     "Stop when the standard error at every point is below this share of the "
     "daylight factor, or below 0.002 percentage points. Default 1%, at most 100%. "
     "Above 5 to 10% the result is more accurate than requested, because a minimum "
     "number of paths is used.",
     pp_options_read_per_cent, PLACE(study.error)},
    {"samples", 0, "N",
     "Stop after N paths per point in each randomisation, instead of at a standard "
     "error.",
     pp_options_read_count, PLACE(study.samples)},
    {"time", 0, "TIME",
     "Stop after this time per room: 10s, 500ms, 2m, 1h. The result then depends on "
     "the computer.",
     pp_options_read_seconds, PLACE(study.seconds)},
    {0},
};

const struct pp_option pp_room_plain_option[] = {
    {"plain", 0, NULL,
     "Use only the plain code, without the fast alternatives, as a check. It gives the "
     "same figures more slowly.",
     NULL, PLACE(study.method_options.plain)},
    {0},
};

const struct pp_option pp_room_seed_options[] = {
    {"seed", 0, "N",
     "Seed of the random numbers (default 1). The same seed gives the same result.",
     pp_options_read_seed, PLACE(study.seed)},
    {"threads", 'j', "N",
     "Number of threads (default: one per processor). The result does not depend on "
     "it.",
     pp_options_read_threads, PLACE(study.threads)},
    {0},
};

const struct pp_option pp_room_output_options[] = {
    {"output", 'o', "FILE",
     "Write to FILE instead of standard output. FILE is written completely or not at "
     "all; - is standard output.",
     pp_options_read_output, PLACE(output)},
    {"quiet", 'q', NULL, "Show no progress bar.", NULL, PLACE(quiet)},
    {"strict", 0, NULL, "Treat doubtful input as an error instead of a warning.", NULL,
     PLACE(study.strict)},
    {0},
};

/* First option given that determines when a simulation ends; NULL: none. */
static const char *stop_option(const struct pp_study_options *study)
{
    return study->error > 0.0     ? "--error"
           : study->samples > 0   ? "--samples"
           : study->seconds > 0.0 ? "--time"
                                  : NULL;
}

enum pp_status pp_room_options_settle_by_hand(struct pp_room_options *options,
                                              struct pp_error *err)
{
    const char *of_simulation =
        options->study.simulate ? "--simulate" : stop_option(&options->study);
    if (options->by_hand && of_simulation)
        return pp_fail(err, PP_BAD_INPUT,
                       "--by-hand leaves out the simulation, but %s controls it; "
                       "expected only one of them",
                       of_simulation);
    options->study.simulate = !options->by_hand;
    return PP_OK;
}

enum pp_status pp_room_options_settle(struct pp_room_options *options,
                                      struct pp_error *err)
{
    const char *needs_simulate = stop_option(&options->study);
    enum pp_status status = pp_sweep_options_check(&options->sweep, err);
    if (status == PP_OK)
        status = pp_sweep_choose(&options->sweep, 0, err);
    if (status != PP_OK)
        return status;
    if (needs_simulate && !options->study.simulate)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s controls when the simulation stops; expected --simulate as well",
            needs_simulate);
    if (options->study.error > 0.0 && options->study.samples > 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--error and --samples both determine when the simulation "
                       "stops; expected only one of them");
    bool has_end = options->study.error > 0.0 || options->study.samples > 0
                   || options->study.seconds > 0.0;
    if (options->study.simulate && !has_end)
        options->study.error = 0.01;
    return PP_OK;
}

void pp_room_options_clear(struct pp_room_options *options)
{
    free(options->study.points.list);
    options->study.points = (struct pp_point_list){0};
    pp_sweep_clear(&options->sweep);
}
