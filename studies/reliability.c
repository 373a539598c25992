/* reliability.c - compares properties of a room and its report with the thresholds of
 * reliability.h. */
#include "studies/reliability.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "methods/method.h"
#include "model/base/text.h"

static const struct pp_reliability_band bands[] = {
#include "tables/reliability.inc"
};

const char *const pp_reliability_names[PP_RELIABILITY_KINDS] = {
    [PP_RELIABILITY_OUTSIDE] = "outside",
    [PP_RELIABILITY_INSIDE] = "inside",
    [PP_RELIABILITY_PROPORTIONS] = "proportions",
    [PP_RELIABILITY_GROUND] = "ground",
};

/* Thresholds of reliability.h. In 29 of the example and trial rooms, simulation changes
 * the verdict. All but one of these rooms exceed a threshold; the exception is an
 * average by average-df, noted in studies/criteria/averages.c. In rooms below the
 * thresholds, values by hand were 0.76 to 1.14 times the simulated values. */
static const double outside_share = 0.3, inside_share = 0.65;
static const double deep = 2.0, ground_off = 0.3;

const struct pp_reliability_band *pp_reliability_band(enum pp_reliability_kind kind)
{
    for (size_t i = 0; i < sizeof bands / sizeof *bands; i++)
        if (strcmp(bands[i].kind, pp_reliability_names[kind]) == 0)
            return &bands[i];
    return NULL;
}

/* Columns of a pair A+B and of its components. */
struct pair {
    const struct pp_column *sc, *erc, *irc, *df;
};

/* Finds the first pair in the report that has an average. Returns false if there is
 * none. */
static bool find_pair(struct pair *pair, const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *df = &report->columns[i];
        const char *plus = strchr(df->name, '+');
        if (df->component != PP_DF || !plus || !isfinite(df->average.value))
            continue;
        char direct[sizeof df->name];
        snprintf(direct, sizeof direct, "%.*s", (int)(plus - df->name), df->name);
        *pair = (struct pair){pp_report_find(report, PP_SC, direct),
                              pp_report_find(report, PP_ERC, direct),
                              pp_report_find(report, PP_IRC, plus + 1), df};
        if (pair->sc && pair->erc && pair->irc)
            return true;
    }
    return false;
}

static void set(struct pp_reliability *found, enum pp_reliability_kind kind,
                double share, bool is)
{
    found->share[kind] = share;
    found->is[kind] = is;
    found->any |= is;
}

/* Fraction of internally reflected light at the darkest point with a value above 0; 1
 * if no sky is visible from that point. NAN: there is no such point. */
static double share_inside(const struct pair *pair, int count)
{
    int darkest = -1;
    for (int i = 0; i < count; i++) {
        double value = pair->df->points[i].value;
        if (value > 0.0 && (darkest < 0 || value < pair->df->points[darkest].value))
            darkest = i;
    }
    if (darkest < 0)
        return NAN;
    if (!(pair->sc->points[darkest].value > 1e-9))
        return 1.0;
    return pair->irc->points[darkest].value / pair->df->points[darkest].value;
}

/* Depth divided by width of the room, with the depth measured from the largest vertical
 * opening; NAN: there is no such opening. */
static double depth_over_width(const struct pp_world *world)
{
    const struct pp_opening *largest = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        bool upright = fabs(opening->slope_rad - PP_PI / 2.0) < 1e-3;
        if (upright && (!largest || opening->inner.area_m2 > largest->inner.area_m2))
            largest = opening;
    }
    if (!largest)
        return NAN;
    struct pp_vec3 in = largest->inner.normal, across = pp_vec(-in.y, in.x, 0.0);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            struct pp_vec3 corner = world->surfaces[i].outline.vertices[k];
            double along[2] = {pp_vec_dot(corner, in), pp_vec_dot(corner, across)};
            for (int a = 0; a < 2; a++) {
                low[a] = fmin(low[a], along[a]);
                high[a] = fmax(high[a], along[a]);
            }
        }
    return (high[0] - low[0]) / (high[1] - low[1]);
}

/* True if the method has a value for the room or for any of its points. */
static bool has_figure(const struct pp_report *report, const char *name)
{
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (strcmp(column->name, name) != 0)
            continue;
        if (isfinite(column->average.value))
            return true;
        for (int k = 0; column->points && k < report->receiver_count; k++)
            if (isfinite(column->points[k].value))
                return true;
    }
    return false;
}

/* Lists the methods whose built-in ground reflectance differs from that of the room.
 * Returns the largest difference. */
static double compare_grounds(struct pp_reliability *found,
                              const struct pp_report *report)
{
    double ground = report->light.ground_reflectance, most = 0.0, own = 0.0;
    char names[160] = "";
    const struct pp_method *method;
    for (int i = 0; (method = pp_method_at(i)) != NULL; i++) {
        if (method->own_ground == 0.0 || !has_figure(report, method->name)
            || fabs(method->own_ground - ground) < 1e-6)
            continue;
        own = method->own_ground;
        most = fmax(most, fabs(own - ground));
        pp_text_append(names, sizeof names, "%s%s", names[0] ? ", " : "", method->name);
    }
    if (names[0])
        snprintf(found->grounds, sizeof found->grounds,
                 "%s: assumed ground reflectance %g instead of the room's %g", names,
                 own, ground);
    return most;
}

struct pp_reliability pp_reliability_of(const struct pp_report *report)
{
    struct pp_reliability found = {0};
    struct pair pair;
    double ground = report->light.ground_reflectance;
    double off = compare_grounds(&found, report);
    set(&found, PP_RELIABILITY_GROUND, ground, off >= ground_off - 1e-9);
    if (find_pair(&pair, report)) {
        double outside = pair.erc->average.value / pair.df->average.value;
        double inside = share_inside(&pair, report->receiver_count);
        set(&found, PP_RELIABILITY_OUTSIDE, outside, outside >= outside_share);
        set(&found, PP_RELIABILITY_INSIDE, inside, inside >= inside_share);
    }
    double depth = depth_over_width(report->world);
    set(&found, PP_RELIABILITY_PROPORTIONS, depth,
        depth > deep * (1.0 + 1e-9) && has_figure(report, "bre-min"));
    return found;
}

void pp_reliability_sentence(const struct pp_reliability *reliability, char *text,
                             size_t size)
{
    static const char *const reasons[PP_RELIABILITY_KINDS] = {
        [PP_RELIABILITY_OUTSIDE] = "%.0f %% of the average daylight factor is light "
                                   "reflected by obstructions and the ground",
        [PP_RELIABILITY_INSIDE] = ("%.0f %% of the light at the darkest point is the "
                                   "room's average internally reflected component"),
        [PP_RELIABILITY_PROPORTIONS] =
            "the room's depth is %.3g times its width, which the table of bre-min does "
            "not cover",
        [PP_RELIABILITY_GROUND] = "the ground reflectance is %.3g",
    };
    bool all_points = reliability->is[PP_RELIABILITY_OUTSIDE]
                      || reliability->is[PP_RELIABILITY_PROPORTIONS]
                      || reliability->is[PP_RELIABILITY_GROUND];
    text[0] = '\0';
    for (int kind = 0; kind < PP_RELIABILITY_KINDS; kind++) {
        if (!reliability->is[kind])
            continue;
        const struct pp_reliability_band *band = pp_reliability_band(kind);
        double share = reliability->share[kind];
        bool in_per_cent =
            kind == PP_RELIABILITY_OUTSIDE || kind == PP_RELIABILITY_INSIDE;
        pp_text_append(text, size, "%s",
                       text[0] ? "; "
                       : all_points
                           ? "Do not rely on hand figures here: "
                           : "Do not rely on hand figures at the darkest point: ");
        if (kind == PP_RELIABILITY_INSIDE && share >= 1.0)
            pp_text_append(text, size, "the darkest point has no view of the sky");
        else
            pp_text_append(text, size, reasons[kind],
                           in_per_cent ? 100.0 * share : share);
        pp_text_append(
            text, size,
            " (in similar rooms %s was %.2g to %.2g times the simulated value)",
            band->of, band->low, band->high);
    }
}

void pp_reliability_note(const struct pp_report *report, char *text, size_t size)
{
    struct pp_reliability found = pp_reliability_of(report);
    pp_reliability_sentence(&found, text, size);
    if (text[0])
        pp_text_append(text, size, ".");
}
