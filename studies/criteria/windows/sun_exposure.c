/* sun_exposure.c - exposure to sunlight recommended by [EN17037] (table A.6), for a
 * room of a dwelling, a hospital ward or the playroom of a nursery.
 *
 *   minimum 1.5 h, medium 3 h, high 4 h of sun on a day from 1 February to 21 March
 *
 * The day is 21 March. The sun counts if it reaches the reference point of any opening:
 * at the middle of its width on the inside of its wall, 1.2 m above the floor and at
 * least 0.3 m above the sill (for sloping glass, its centre). The standard ignores the
 * sun below an altitude, which is stated for each country. The standard's table was not
 * available; Germany's 11 degrees and the Czech Republic's 13 are known from secondary
 * sources. For other countries, a level is met if there is enough sun above 20 degrees,
 * and not met if there is not enough sun above 5 degrees. Otherwise the level is
 * undecided, and the altitude at which the verdict changes is stated.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "methods/exact/sunlit_hours.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/windows/exposure_point.h"

#define ABOVE_FLOOR_M 1.2
#define ABOVE_SILL_M 0.3

enum { INTERVALS = 200 }; /* bytes of the intervals as text */

/* Range in which the altitudes of the standard's table are assumed to be. */
static const double lowest_rad = 5.0 * PP_RAD, highest_rad = 20.0 * PP_RAD;

/* Altitude above which the sun counts in a country; 0: not known. */
static double known_altitude_rad(const char *country)
{
    static const struct {
        const char *country;
        double deg;
    } known[] = {{"DE", 11.0}, {"CZ", 13.0}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(country, known[i].country) == 0)
            return known[i].deg * PP_RAD;
    return 0.0;
}

/* The hours of sun above an altitude through any of the openings. words: room for the
 * intervals as text; NULL: not wanted. */
static enum pp_status find_hours(double *hours, const struct pp_inquiry *inquiry,
                                 double above_rad, char *words, struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                    world->longitude_rad};
    struct pp_sunlit_day day = {0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_hidden_view view = {
            pp_exposure_point(opening, ABOVE_FLOOR_M, ABOVE_SILL_M),
            pp_vec_scale(opening->inner.normal, -1.0), opening->face, opening};
        struct pp_hidden_cones cones;
        status = pp_hidden_cones_init(&cones, world, &view, err);
        if (status != PP_OK)
            break;
        status = pp_sunlit_hours_above(&day, &cones, place, 3, 21, above_rad, err);
        pp_hidden_cones_clear(&cones);
    }
    int dropped = pp_sunlit_hours_drop_short(&day, inquiry->shortest_h);
    *hours = pp_sunlit_hours_sum(&day);
    if (words) {
        char times[INTERVALS];
        pp_sunlit_hours_words(times, sizeof times, &day);
        snprintf(words, INTERVALS + 160,
                 "intervals of sun above %.4g degrees on 21 March, in solar time: %s; "
                 "%d shorter than %g minutes left out",
                 above_rad / PP_RAD, times, dropped, 60.0 * inquiry->shortest_h);
    }
    pp_sunlit_hours_clear(&day);
    return status;
}

/* Finds, to 0.01 degrees, the greatest altitude above which the sun shines for the
 * required hours. */
static enum pp_status find_turn(double *turn_rad, const struct pp_inquiry *inquiry,
                                double wanted, struct pp_error *err)
{
    double low = lowest_rad, high = highest_rad;
    enum pp_status status = PP_OK;
    while (high - low > 0.01 * PP_RAD && status == PP_OK) {
        double hours, middle = 0.5 * (low + high);
        status = find_hours(&hours, inquiry, middle, NULL, err);
        if (hours >= wanted)
            low = middle;
        else
            high = middle;
    }
    *turn_rad = 0.5 * (low + high);
    return status;
}

/* Hours with the sun above the upper (least) and above the lower (most) bound of the
 * altitude; the bounds are equal if the altitude is known. */
struct bounded_hours {
    double altitude_rad; /* 0: not known */
    double least, most;
};

static enum pp_status find_bounded(struct bounded_hours *hours, char *words,
                                   const struct pp_inquiry *inquiry,
                                   struct pp_error *err)
{
    hours->altitude_rad = inquiry->least_altitude_rad > 0.0
                              ? inquiry->least_altitude_rad
                              : known_altitude_rad(inquiry->country);
    bool known = hours->altitude_rad > 0.0;
    enum pp_status status =
        find_hours(&hours->least, inquiry, known ? hours->altitude_rad : highest_rad,
                   known ? words : NULL, err);
    hours->most = hours->least;
    return status == PP_OK && !known
               ? find_hours(&hours->most, inquiry, lowest_rad, words, err)
               : status;
}

static enum pp_status judge_level(struct pp_finding *finding, const char *name,
                                  double wanted, const struct bounded_hours *hours,
                                  const struct pp_inquiry *inquiry,
                                  struct pp_error *err)
{
    bool met = hours->least >= wanted, decided = met || hours->most < wanted;
    *finding = pp_finding_of(PP_FIGURE_HOURS, met ? hours->least : hours->most, wanted,
                             false, "%s: %g h on 21 March", name, wanted);
    if (hours->altitude_rad > 0.0) {
        pp_finding_note(finding, "hours with the sun above %.4g degrees",
                        hours->altitude_rad / PP_RAD);
        return PP_OK;
    }
    if (decided) {
        pp_finding_note(finding, "hours with the sun above %g degrees",
                        met ? 20.0 : 5.0);
        return PP_OK;
    }
    double turn_rad;
    enum pp_status status = find_turn(&turn_rad, inquiry, wanted, err);
    finding->verdict = PP_UNDECIDED;
    pp_finding_note(
        finding,
        "hours with the sun above 5 degrees; met if the standard counts the sun from "
        "an altitude of %.1f degrees or lower at this place (--least-altitude)",
        turn_rad / PP_RAD);
    return status;
}

static enum pp_status assess_sun_exposure(const struct pp_inquiry *inquiry,
                                          struct pp_finding_list *findings,
                                          struct pp_error *err)
{
    static const struct {
        const char *name;
        double hours;
    } levels[] = {{"minimum", 1.5}, {"medium", 3.0}, {"high", 4.0}};
    struct bounded_hours hours;
    if (isnan(inquiry->world->latitude_rad)) {
        struct pp_finding finding =
            pp_finding_not_judged("the room file has no latitude (site)", "21 March");
        return pp_finding_list_add(findings, &finding, err);
    }
    char words[INTERVALS + 160];
    enum pp_status status = find_bounded(&hours, words, inquiry, err);
    if (status == PP_OK && inquiry->shortest_h > 0.0)
        pp_finding_list_add_basis(findings, "%s", words);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        struct pp_finding finding;
        status = judge_level(&finding, levels[i].name, levels[i].hours, &hours, inquiry,
                             err);
        finding.level = i + 1; /* 1: minimum */
        finding.is_optional = i > 0;
        if (status == PP_OK)
            status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

const struct pp_criterion pp_criterion_sun_exposure = {
    .name = "sun-exposure",
    .title = "EN 17037 exposure to sunlight",
    .source = "EN17037",
    .summary = "at least 1.5, 3, 4 h of sun on 21 March on the inside of a window",
    .bears_on_use = pp_bearing_is_dwelling,
    .without_trees = true,
    .evaluate = assess_sun_exposure,
};
