/* sky_picture_options.c - parses the options of sky_picture_file.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/photographs/sky_cube.h"
#include "model/pictures/sky_picture_file.h"

struct pp_sky_picture_options pp_sky_picture_options_none(void)
{
    return (struct pp_sky_picture_options){.projection = -1,
                                           .view_angle_rad = NAN,
                                           .top_bearing_rad = NAN,
                                           .view_bearing_rad = NAN,
                                           .view_altitude_rad = NAN,
                                           .circle = {NAN, NAN, NAN},
                                           .fill_cd_m2 = NAN,
                                           .illuminance_lx = NAN,
                                           .exposure = 1.0,
                                           .lamps = 16,
                                           .sun_altitude_rad = NAN,
                                           .sun_bearing_rad = NAN};
}

/* ---- kinds of values ---- */

/* Reads a number within limits, and multiplies it by the unit. */
static bool read_within(const char *value, double least, double most, double unit,
                        double *number)
{
    double read;
    if (!pp_text_parse_number(value, &read) || !(read >= least) || !(read <= most))
        return false;
    *number = read * unit;
    return true;
}

static bool read_lamps(const char *value, int *lamps)
{
    double read;
    if (!pp_text_parse_number(value, &read) || !(read >= PP_SKY_CUBE_LEAST)
        || !(read <= PP_SKY_CUBE_MOST) || fmod(read, 2.0) != 0.0)
        return false;
    *lamps = (int)read;
    return true;
}

static int index_of(const char *value, const char *const *names)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(value, names[i]) == 0)
            return i;
    return -1;
}

static bool read_circle(const char *value, double circle[3])
{
    double read[3];
    for (int i = 0; i < 3; i++) {
        char word[32];
        value += strspn(value, " \t");
        size_t length = strcspn(value, " \t");
        snprintf(word, sizeof word, "%.*s", (int)length, value);
        if (!pp_text_parse_number(word, &read[i]))
            return false;
        value += length;
    }
    memcpy(circle, read, sizeof read);
    return value[strspn(value, " \t")] == '\0';
}

/* ---- the list ---- */

enum key {
    PROJECTION,
    VIEW_ANGLE,
    TOP_BEARING,
    VIEW_BEARING,
    VIEW_ALTITUDE,
    MIRRORED,
    CIRCLE,
    HORIZON,
    FILL,
    ILLUMINANCE,
    EXPOSURE,
    PRIMARIES,
    SAMPLING,
    LAMPS,
    SUN_ILLUMINANCE,
    SUN_ALTITUDE,
    SUN_BEARING,
};

static const char *const keys[] = {
    [PROJECTION] = "projection",
    [VIEW_ANGLE] = "view-angle",
    [TOP_BEARING] = "top-bearing",
    [VIEW_BEARING] = "view-bearing",
    [VIEW_ALTITUDE] = "view-altitude",
    [MIRRORED] = "mirrored",
    [CIRCLE] = "circle",
    [HORIZON] = "horizon",
    [FILL] = "fill",
    [ILLUMINANCE] = "illuminance",
    [EXPOSURE] = "exposure",
    [PRIMARIES] = "primaries",
    [SAMPLING] = "sampling",
    [LAMPS] = "lamps",
    [SUN_ILLUMINANCE] = "sun-illuminance",
    [SUN_ALTITUDE] = "sun-altitude",
    [SUN_BEARING] = "sun-bearing",
    NULL,
};

static const char *const expected[] = {
    [PROJECTION] = "equidistant, equisolid, hemispherical or latitude-longitude",
    [VIEW_ANGLE] = "degrees above 0, up to 360",
    [TOP_BEARING] = "degrees from -360 to 360",
    [VIEW_BEARING] = "degrees from -360 to 360",
    [VIEW_ALTITUDE] = "degrees from -90 to 90",
    [MIRRORED] = "yes or no",
    [CIRCLE] = ("three numbers in pixels: the distances of the centre from the left "
                "and top edges, and the radius"),
    [HORIZON] = "degrees from 0 to 80",
    [FILL] = "nearest, or a luminance in cd/m2 of 0 or more",
    [ILLUMINANCE] = "lux above 0, up to 1e6",
    [EXPOSURE] = "a factor above 0, up to 1e12",
    [PRIMARIES] = "radiance or srgb",
    [SAMPLING] = "bright, lamps or chance",
    [LAMPS] = "an even number of lamps along an edge, from 2 to 64",
    [SUN_ILLUMINANCE] = "lux from 0 to 200000",
    [SUN_ALTITUDE] = "degrees from 0 to 90",
    [SUN_BEARING] = "degrees from -360 to 360",
};

static bool set(struct pp_sky_picture_options *o, enum key key, const char *value)
{
    static const char *const yes_no[] = {"no", "yes", NULL};
    static const char *const primaries[] = {"radiance", "srgb", NULL};
    static const char *const samplings[] = {"bright", "lamps", "chance", NULL};
    const double tiny = 1e-12;
    int index;
    switch (key) {
    case PROJECTION:
        o->projection = index_of(value, pp_sky_projection_names);
        return o->projection >= 0;
    case VIEW_ANGLE:
        return read_within(value, tiny, 360.0, PP_RAD, &o->view_angle_rad);
    case TOP_BEARING:
        return read_within(value, -360.0, 360.0, PP_RAD, &o->top_bearing_rad);
    case VIEW_BEARING:
        return read_within(value, -360.0, 360.0, PP_RAD, &o->view_bearing_rad);
    case VIEW_ALTITUDE:
        return read_within(value, -90.0, 90.0, PP_RAD, &o->view_altitude_rad);
    case MIRRORED:
        index = index_of(value, yes_no);
        o->mirrored = index == 1;
        return index >= 0;
    case CIRCLE:
        return read_circle(value, o->circle);
    case HORIZON:
        return read_within(value, 0.0, 80.0, PP_RAD, &o->horizon_rad);
    case FILL:
        o->fill_cd_m2 = NAN;
        return strcmp(value, "nearest") == 0
               || read_within(value, 0.0, 1e12, 1.0, &o->fill_cd_m2);
    case ILLUMINANCE:
        return read_within(value, tiny, 1e6, 1.0, &o->illuminance_lx);
    case EXPOSURE:
        return read_within(value, tiny, 1e12, 1.0, &o->exposure);
    case PRIMARIES:
        index = index_of(value, primaries);
        o->srgb = index == 1;
        return index >= 0;
    case SAMPLING:
        index = index_of(value, samplings);
        o->sampling = (enum pp_sky_sampling)index;
        return index >= 0;
    case LAMPS:
        return read_lamps(value, &o->lamps);
    case SUN_ILLUMINANCE:
        return read_within(value, 0.0, 2e5, 1.0, &o->sun_lx);
    case SUN_ALTITUDE:
        return read_within(value, 0.0, 90.0, PP_RAD, &o->sun_altitude_rad);
    case SUN_BEARING:
        return read_within(value, -360.0, 360.0, PP_RAD, &o->sun_bearing_rad);
    }
    return false;
}

enum pp_status pp_sky_picture_options_set(struct pp_sky_picture_options *options,
                                          const char *key, const char *value,
                                          struct pp_error *err)
{
    char shown[64], shown_key[64];
    int index = index_of(key, keys);
    if (index < 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "a photographed sky has no attribute \"%s\"; expected projection, "
            "view-angle, top-bearing, view-bearing, view-altitude, mirrored, circle, "
            "horizon, fill, illuminance, exposure, primaries, sampling, lamps, "
            "sun-illuminance, sun-altitude, sun-bearing or second",
            pp_text_excerpt(shown_key, sizeof shown_key, key));
    if (!set(options, (enum key)index, value))
        return pp_fail(err, PP_BAD_INPUT, "%s is \"%s\"; expected %s", key,
                       pp_text_excerpt(shown, sizeof shown, value), expected[index]);
    return PP_OK;
}

enum pp_status pp_sky_picture_options_parse(struct pp_sky_picture_options *options,
                                            char **second, const char *pairs,
                                            struct pp_error *err)
{
    enum pp_status status = PP_OK;
    *second = NULL;
    char *copy = strdup(pairs), *next = copy;
    if (!copy)
        return pp_fail_memory(err);
    while (status == PP_OK && next && *next) {
        char *pair = next, *comma = strchr(pair, ',');
        next = comma ? comma + 1 : NULL;
        if (comma)
            *comma = '\0';
        char *value = strchr(pair, '=');
        if (value)
            *value++ = '\0';
        if (!value) {
            char shown[64];
            status =
                pp_fail(err, PP_BAD_INPUT, "\"%s\" has no value; expected KEY=VALUE",
                        pp_text_excerpt(shown, sizeof shown, pair));
        } else if (strcmp(pair, "second") == 0) {
            free(*second);
            *second = strdup(value);
            status = *second ? PP_OK : pp_fail_memory(err);
        } else {
            status = pp_sky_picture_options_set(options, pair, value, err);
        }
    }
    free(copy);
    if (status != PP_OK) {
        free(*second);
        *second = NULL;
    }
    return status;
}
