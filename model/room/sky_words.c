/* sky_words.c - see sky_words.h. */
#include "model/room/sky_words.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/photographs/sky_picture.h"
#include "model/pictures/sky_picture_file.h"

const char *const pp_sky_words[] = {
    "overcast", "uniform", "iso-1",  "iso-2",   "iso-3",  "iso-4",  "iso-5",
    "iso-6",    "iso-7",   "iso-8",  "iso-9",   "iso-10", "iso-11", "iso-12",
    "iso-13",   "iso-14",  "iso-15", "picture", NULL};

enum { ISO_TYPES = 15 };

struct pp_sky_part pp_sky_words_default(void)
{
    return (struct pp_sky_part){
        .kind = PP_SKY_OVERCAST, .sun_altitude_rad = NAN, .sun_bearing_rad = NAN};
}

void pp_sky_words_set_type(struct pp_sky_part *part, int index)
{
    part->kind = index == 0               ? PP_SKY_OVERCAST
                 : index == 1             ? PP_SKY_UNIFORM
                 : index - 1 <= ISO_TYPES ? PP_SKY_ISO
                                          : PP_SKY_PICTURE;
    part->iso = part->kind == PP_SKY_ISO ? index - 1 : 0;
}

struct pp_sky_part pp_sky_words_copy(const struct pp_sky_part *part)
{
    if (part->picture)
        part->picture->holders++;
    return *part;
}

void pp_sky_words_clear(struct pp_sky_part *part)
{
    pp_sky_picture_release(part->picture);
    part->picture = NULL;
}

/* Reads the sun of "TYPE,ALTITUDE,BEARING", after the first comma. */
static bool read_sun(const char *text, double *altitude_deg, double *bearing_deg)
{
    char copy[128];
    size_t length = strlen(text);
    if (length >= sizeof copy)
        return false;
    memcpy(copy, text, length + 1);
    char *comma = strchr(copy, ',');
    if (!comma)
        return false;
    *comma = '\0';
    return pp_text_parse_number(copy, altitude_deg)
           && pp_text_parse_number(comma + 1, bearing_deg) && *altitude_deg >= 0.0
           && *altitude_deg <= 90.0 && fabs(*bearing_deg) <= 360.0;
}

/* Reads "FILE" or "FILE,KEY=VALUE...". */
static enum pp_status read_sky_file(struct pp_sky_picture **picture, const char *words,
                                    struct pp_error *err)
{
    struct pp_sky_picture_options options = pp_sky_picture_options_none();
    size_t length = strcspn(words, ",");
    const char *pairs = words[length] ? words + length + 1 : "";
    char *second = NULL, *path = strndup(words, length);
    enum pp_status status =
        path ? pp_sky_picture_options_parse(&options, &second, pairs, err)
             : pp_fail_memory(err);
    if (status == PP_OK)
        status = pp_sky_picture_file_read(picture, path, second, &options, err);
    free(path);
    free(second);
    return status;
}

enum pp_status pp_sky_words_parse(struct pp_sky_part *part, const char *spec,
                                  struct pp_error *err)
{
    char type[16], shown[64];
    const char *comma = strchr(spec, ',');
    size_t length = comma ? (size_t)(comma - spec) : strlen(spec);
    int index = 0;
    if (length < sizeof type) {
        memcpy(type, spec, length);
        type[length] = '\0';
        while (pp_sky_words[index] && strcmp(pp_sky_words[index], type) != 0)
            index++;
    }
    if (length >= sizeof type || !pp_sky_words[index])
        return pp_fail(err, PP_BAD_INPUT,
                       "there is no sky \"%s\"; expected overcast, uniform, iso-1 to "
                       "iso-15, or picture,FILE",
                       pp_text_excerpt(shown, sizeof shown, spec));

    struct pp_sky_part sky = *part;
    sky.picture = NULL;
    pp_sky_words_set_type(&sky, index);
    if (sky.kind == PP_SKY_PICTURE) {
        if (!comma || !comma[1])
            return pp_fail(err, PP_BAD_INPUT,
                           "the sky \"picture\" needs a file; expected picture,FILE");
        enum pp_status status = read_sky_file(&sky.picture, comma + 1, err);
        if (status == PP_OK) {
            pp_sky_words_clear(part);
            *part = sky;
        }
        return status;
    }
    double altitude_deg, bearing_deg;
    if (comma && !read_sun(comma + 1, &altitude_deg, &bearing_deg))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky \"%s\" has no valid position of the sun; expected "
                       "TYPE,ALTITUDE,BEARING, with 0 to 90 and -360 to 360 degrees",
                       pp_text_excerpt(shown, sizeof shown, spec));
    if (comma) {
        sky.sun_altitude_rad = altitude_deg * PP_RAD;
        sky.sun_bearing_rad = bearing_deg * PP_RAD;
    }
    if (sky.kind == PP_SKY_ISO && pp_sky_iso_has_sun(sky.iso)
        && (isnan(sky.sun_altitude_rad) || isnan(sky.sun_bearing_rad)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky %s needs the position of the sun, which the room file "
                       "does not give; expected %s,ALTITUDE,BEARING in degrees",
                       type, type);
    pp_sky_words_clear(part);
    *part = sky;
    return PP_OK;
}

/* Converts a bearing, clockwise from true north, and an altitude to a direction in the
 * room's axes, whose +y has the bearing north_rad. */
static struct pp_vec3 direction_of(double bearing_rad, double altitude_rad,
                                   double north_rad)
{
    double turn = bearing_rad - north_rad, c = cos(altitude_rad);
    return pp_vec(c * sin(turn), c * cos(turn), sin(altitude_rad));
}

enum pp_status pp_sky_words_sky(struct pp_sky *sky, const struct pp_sky_part *part,
                                double north_rad, struct pp_error *err)
{
    struct pp_vec3 sun = {0.0, 0.0, 1.0};
    switch (part->kind) {
    case PP_SKY_OVERCAST:
        *sky = pp_sky_overcast();
        return PP_OK;
    case PP_SKY_UNIFORM:
        *sky = pp_sky_uniform();
        return PP_OK;
    case PP_SKY_PICTURE:
        *sky = pp_sky_of_picture(part->picture, north_rad);
        return PP_OK;
    case PP_SKY_ISO:
        break;
    }
    if (pp_sky_iso_has_sun(part->iso)) {
        if (isnan(part->sun_altitude_rad) || isnan(part->sun_bearing_rad))
            return pp_fail(err, PP_BAD_INPUT,
                           "iso-%d needs the position of the sun; expected "
                           "sun-altitude and sun-bearing",
                           part->iso);
        sun = direction_of(part->sun_bearing_rad, part->sun_altitude_rad, north_rad);
    }
    return pp_sky_iso(sky, part->iso, sun, err);
}
