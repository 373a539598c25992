/* reference_skies.c - the reference skies as an artificial year with one record for
 * each sky. */
#include "studies/year/hand/reference_skies.h"

#include <stdlib.h>

#include "model/base/array.h"

static bool is_same_sky(const struct pp_perez_sky *a, const struct pp_perez_sky *b)
{
    return a->intermediate == b->intermediate && a->gradation == b->gradation
           && a->a == b->a && a->b == b->b && a->c == b->c && a->d == b->d
           && a->e == b->e && a->sun.x == b->sun.x && a->sun.y == b->sun.y
           && a->sun.z == b->sun.z && a->diffuse_lx == b->diffuse_lx
           && a->direct_lx == b->direct_lx;
}

static int enter_sky(struct pp_reference_skies *skies, const struct pp_perez_sky *sky)
{
    for (int i = 0; i < skies->count; i++)
        if (is_same_sky(&skies->list[i], sky))
            return i;
    if (pp_array_reserve(&skies->list, &skies->space, skies->count + 1,
                         sizeof *skies->list, NULL)
        != PP_OK) {
        skies->failed = true;
        return -1;
    }
    skies->list[skies->count] = *sky;
    return skies->count++;
}

int pp_reference_skies_add(struct pp_reference_skies *skies,
                           const struct pp_perez_sky *sky)
{
    struct pp_perez_sky alone = *sky;
    if (!(sky->diffuse_lx > 0.0))
        return -1;
    alone.direct_lx = 0.0;
    pp_perez_sky_set_diffuse(&alone, 1.0);
    return enter_sky(skies, &alone);
}

int pp_reference_skies_add_standard(struct pp_reference_skies *skies,
                                    enum pp_standard_sky kind, struct pp_vec3 sun)
{
    struct pp_vec3 zenith = {0.0, 0.0, 1.0};
    struct pp_perez_sky sky = pp_standard_sky_of(
        kind, kind == PP_STANDARD_OVERCAST || kind == PP_STANDARD_ISO_1 ? zenith : sun);
    return enter_sky(skies, &sky);
}

int pp_reference_skies_add_sun(struct pp_reference_skies *skies, struct pp_vec3 sun)
{
    struct pp_perez_sky sky = {
        .sun = sun, .direct_lx = 1.0, .clearness = 1.0, .bin = 1};
    return sun.z > 0.0 ? enter_sky(skies, &sky) : -1;
}

enum pp_status pp_reference_skies_simulate(struct pp_reference_skies *skies,
                                           const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receivers,
                                           int receiver_count,
                                           const struct pp_annual_options *options,
                                           bool *finished, struct pp_error *err)
{
    if (skies->failed)
        return pp_fail_memory(err);
    struct pp_annual_sheet sheet = {.points = NULL};
    struct pp_annual_options all = *options;
    all.hours = (struct pp_working_hours){0.0, 24.0, PP_ALL_DAYS};
    all.summer = (struct pp_summer_time){{0, 0}, {0, 0}};
    all.illuminance_count = all.lighting_count = 0;
    all.blinds = PP_BLINDS_NEVER;
    all.measure = all.coefficients = all.strict = false;
    struct pp_weather_hour *hours = calloc((size_t)skies->count + 1, sizeof *hours);
    if (!hours)
        return pp_fail_memory(err);
    for (int i = 0; i < skies->count; i++)
        hours[i] = (struct pp_weather_hour){.date = {1, 1},
                                            .weekday = PP_WEEKDAY_UNKNOWN,
                                            .length_h = 1.0,
                                            .known = true,
                                            .lit = true,
                                            .sky = i};
    struct pp_weather_year year = {.words = "reference skies and suns",
                                   .hours = hours,
                                   .skies = skies->list,
                                   .count = skies->count,
                                   .sky_count = skies->count};
    enum pp_status status = pp_annual_of_room(&sheet, world, light, receivers,
                                              receiver_count, false, &year, &all, err);
    *finished = status == PP_OK && sheet.finished;
    if (*finished) {
        skies->factors = sheet.lx;
        sheet.lx = NULL;
    }
    pp_annual_sheet_clear(&sheet);
    free(hours);
    return status;
}

double pp_reference_skies_factor(const struct pp_reference_skies *skies, int receiver,
                                 int sky)
{
    return sky < 0
               ? 0.0
               : (double)skies
                     ->factors[(size_t)receiver * (size_t)skies->count + (size_t)sky];
}

void pp_reference_skies_clear(struct pp_reference_skies *skies)
{
    free(skies->list);
    free(skies->factors);
    *skies = (struct pp_reference_skies){.list = NULL};
}
