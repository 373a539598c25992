/* year_classes.c - `classes` and `classes-scaled`: hours sorted into classes of weather,
 * one simulation for each class [HP97].
 *
 * The limits of the original classes were not available. The classes here were chosen
 * for this program: the 8 bins of clearness of Perez, and cells of 15 degrees of
 * altitude and azimuth of the sun. The sky of a class is that of the hour whose sun is
 * nearest to the mean direction of all suns of the class. `classes` calculates one
 * illuminance for the class, from its mean illuminances outside, and assigns it to each
 * hour. `classes-scaled` uses the illuminances outside of each hour.
 */
#include <math.h>
#include <stdlib.h>

#include "studies/year/hand/year_terms.h"

enum { BINS = 8, ALTITUDE_CELLS = 7, AZIMUTH_CELLS = 24 };
enum { CLASSES = BINS * ALTITUDE_CELLS * AZIMUTH_CELLS };
static const double CELL_RAD = 15.0 * PP_RAD;

struct weather_class {
    double hours;
    double diffuse_lx, direct_lx; /* means */
    struct pp_vec3 mean;          /* sum of the sun's directions, weighted by hours */
    int nearest;                  /* hour whose sun is nearest to the mean */
    double cosine;                /* cosine of the angle between that sun and the
                                   * mean */
    int sky, sun;                 /* indices of the reference skies */
};

struct classes_tools {
    struct weather_class list[CLASSES];
};

static const struct pp_formula_quantity of_class[] = {
    {"d_k", PP_UNIT_DAYLIGHT_FACTOR,
     "factor under the representative sky of the class"},
    {"d_n", PP_UNIT_DAYLIGHT_FACTOR, "factor for the sun, normal to its rays"},
    {"E_dk", PP_UNIT_LUX, "mean external diffuse illuminance of the class"},
    {"E_nk", PP_UNIT_LUX,
     "mean illuminance from the sun, normal to its rays, in the hours of the class"},
    {0}};
static const struct pp_formula_quantity of_hour[] = {
    {"d_k", PP_UNIT_DAYLIGHT_FACTOR,
     "factor under the representative sky of the class"},
    {"d_n", PP_UNIT_DAYLIGHT_FACTOR, "factor for the sun, normal to its rays"},
    PP_YEAR_TERMS_E_D,
    PP_YEAR_TERMS_E_N,
    {0}};
static const struct pp_formula by_class = {.symbol = "E",
                                           .sum = "(d_k E_dk + d_n E_nk) / 100",
                                           .unit = PP_UNIT_LUX,
                                           .source = "HP97",
                                           .what = "illuminance",
                                           .quantities = of_class,
                                           .fixed = true};
static const struct pp_formula by_hour = {.symbol = "E",
                                          .sum = "(d_k E_d + d_n E_n) / 100",
                                          .unit = PP_UNIT_LUX,
                                          .source = "HP97",
                                          .what = "illuminance",
                                          .quantities = of_hour,
                                          .fixed = true};
static const struct pp_formula *const formulae_of_class[] = {&by_class, NULL};
static const struct pp_formula *const formulae_of_hour[] = {&by_hour, NULL};

/* Class of an hour. A sun below the horizon is in the lowest cells. */
static int class_of(const struct pp_hand_hour *hour)
{
    int altitude = (int)floor(fmax(hour->altitude_rad, 0.0) / CELL_RAD);
    int azimuth = (int)floor((hour->azimuth_rad + PP_PI) / CELL_RAD);
    azimuth = azimuth < AZIMUTH_CELLS ? azimuth : 0;
    return ((hour->bin - 1) * ALTITUDE_CELLS + altitude) * AZIMUTH_CELLS + azimuth;
}

static enum pp_status prepare_classes(void **tools, struct pp_hand_case *of,
                                      struct pp_error *err)
{
    struct classes_tools *t = calloc(1, sizeof *t);
    if (!t)
        return pp_fail_memory(err);
    for (int i = 0; i < of->hour_count; i++) {
        const struct pp_hand_hour *hour = &of->hours[i];
        struct weather_class *k = &t->list[class_of(hour)];
        k->hours += hour->length_h;
        k->diffuse_lx += hour->length_h * hour->diffuse_lx;
        k->direct_lx += hour->length_h * hour->direct_lx;
        k->mean = pp_vec_add(k->mean, pp_vec_scale(hour->sun, hour->length_h));
        k->cosine = -2.0;
    }
    for (int i = 0; i < of->hour_count; i++) {
        struct weather_class *k = &t->list[class_of(&of->hours[i])];
        double cosine = pp_vec_dot(of->hours[i].sun, k->mean) / pp_vec_length(k->mean);
        if (cosine > k->cosine && of->hours[i].diffuse_lx > 0.0) {
            k->cosine = cosine;
            k->nearest = i;
        }
    }
    for (int i = 0; i < CLASSES; i++) {
        struct weather_class *k = &t->list[i];
        if (!(k->hours > 0.0))
            continue;
        k->diffuse_lx /= k->hours;
        k->direct_lx /= k->hours;
        k->sky = k->cosine > -2.0
                     ? pp_reference_skies_add(&of->skies, &of->year->skies[k->nearest])
                     : -1;
        k->sun = pp_reference_skies_add_sun(&of->skies, pp_vec_unit(k->mean));
    }
    *tools = t;
    return PP_OK;
}

static const struct weather_class *put_class(const struct pp_hand_case *of,
                                             const struct classes_tools *t, int point,
                                             const struct pp_hand_hour *hour,
                                             struct pp_worksheet *sheet)
{
    const struct weather_class *k = &t->list[class_of(hour)];
    pp_worksheet_put(
        sheet, PP_UNIT_DAYLIGHT_FACTOR,
        pp_reference_skies_factor(&of->skies, point, k->sky), "d_k",
        "factor under the representative sky of the class, bin %d of clearness",
        hour->bin);
    pp_year_terms_put_factor(sheet, of, point, k->sun, "d_n",
                             "factor for the sun, normal to its rays");
    return k;
}

static void evaluate_classes(const struct pp_hand_case *of, const void *tools,
                             int point, const struct pp_hand_hour *hour,
                             struct pp_worksheet *sheet, struct pp_year_states *states)
{
    const struct weather_class *k = put_class(of, tools, point, hour, sheet);
    pp_worksheet_put(sheet, PP_UNIT_LUX, k->diffuse_lx, "E_dk",
                     "mean external diffuse illuminance of the class, %.4g h",
                     k->hours);
    pp_worksheet_put(
        sheet, PP_UNIT_LUX, k->direct_lx, "E_nk",
        "mean illuminance from the sun, normal to its rays, in the hours of "
        "the class");
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &by_class, "illuminance"));
}

static void evaluate_classes_scaled(const struct pp_hand_case *of, const void *tools,
                                    int point, const struct pp_hand_hour *hour,
                                    struct pp_worksheet *sheet,
                                    struct pp_year_states *states)
{
    put_class(of, tools, point, hour, sheet);
    pp_year_terms_put_sky(sheet, hour);
    pp_worksheet_put(sheet, PP_UNIT_LUX, hour->direct_lx, "E_n",
                     "illuminance from the sun, normal to its rays");
    *states = pp_year_terms_state(pp_worksheet_work(sheet, &by_hour, "illuminance"));
}

#define OWN                                                                            \
    "classes of this program, since the original limits were not available: 8 bins "   \
    "of clearness, cells of 15 degrees of altitude and azimuth of the sun. The sky "   \
    "of a class is that of the hour whose sun is nearest to the mean position of the " \
    "sun in the class"

const struct pp_year_method pp_year_method_classes = {
    .name = "classes",
    .summary = "hours in classes of clearness and position of the sun, one illuminance "
               "for each class",
    .source = "HP97",
    .assumptions = OWN,
    .formulae = formulae_of_class,
    .prepare = prepare_classes,
    .evaluate = evaluate_classes,
};

const struct pp_year_method pp_year_method_classes_scaled = {
    .name = "classes-scaled",
    .summary = "the same classes, with the external illuminances of each hour",
    .source = "HP97",
    .assumptions = OWN,
    .formulae = formulae_of_hour,
    .prepare = prepare_classes,
    .evaluate = evaluate_classes_scaled,
};
