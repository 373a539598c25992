/* sky_picture_file.c - see sky_picture_file.h. */
#include "model/pictures/sky_picture_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/read_file.h"
#include "model/base/text.h"
#include "model/pictures/picture_hdr.h"
#include "model/pictures/picture_pfm.h"
#include "model/pictures/quantity.h"
#include "model/pictures/sky_picture_view.h"

/* Limit on the bytes of a file. */
static const size_t BYTES_MOST = (size_t)512 << 20;

/* ---- a file ---- */

struct file {
    struct pp_picture picture;
    struct pp_hdr_notes notes;
};

/* Puts the file's name in front of a message. */
static enum pp_status of_file(const char *path, enum pp_status status,
                              struct pp_error *err)
{
    if (status == PP_OK || !err)
        return status;
    struct pp_error why = *err;
    return strstr(why.message, path)
               ? status
               : pp_fail(err, status, "%s: %s", path, why.message);
}

static enum pp_status read_picture(struct file *file, const char *path,
                                   struct pp_error *err)
{
    char *bytes = NULL;
    size_t length = 0;
    *file = (struct file){.notes = {.exposure = 1.0}};
    enum pp_status status =
        pp_read_file_regular(&bytes, &length, path, BYTES_MOST, err);
    if (status != PP_OK)
        return status;
    const unsigned char *data = (const unsigned char *)bytes;
    if (length > BYTES_MOST)
        status = pp_fail(err, PP_BAD_INPUT, "the picture is larger than %zu bytes",
                         BYTES_MOST);
    else if (length > 2 && data[0] == 'P' && (data[1] == 'F' || data[1] == 'f'))
        status = pp_picture_pfm_read(&file->picture, data, length, err);
    else if (length > 2 && data[0] == '#' && data[1] == '?')
        status = pp_picture_hdr_read(&file->picture, &file->notes, data, length, err);
    else
        status = pp_fail(err, PP_BAD_INPUT,
                         "line 1: expected a Radiance picture (\"#?RADIANCE\") or a "
                         "portable float map (\"PF\")");
    free(bytes);
    if (status == PP_OK && file->notes.quantity[0]
        && strcmp(file->notes.quantity, "luminance") != 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "the pixels hold the quantity \"%s\"; expected luminance",
                         file->notes.quantity);
    return of_file(path, status, err);
}

/* ---- a frame ---- */

static enum pp_status take_pixels(struct pp_sky_frame *frame, const struct file *file,
                                  const struct pp_sky_picture_options *options,
                                  struct pp_error *err)
{
    const struct pp_picture *picture = &file->picture;
    size_t count = (size_t)picture->width * (size_t)picture->height;
    double scale = PP_LUMENS_PER_WATT * options->exposure / file->notes.exposure;
    frame->width = picture->width;
    frame->height = picture->height;
    frame->luminance = malloc(count * sizeof *frame->luminance);
    if (!frame->luminance)
        return pp_fail_memory(err);
    for (size_t i = 0; i < count; i++) {
        const float *at = picture->rgb + 3 * i;
        struct pp_rgb rgb = pp_rgb(at[0], at[1], at[2]);
        double grey = options->srgb ? 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b
                                    : pp_rgb_luminance(rgb);
        frame->luminance[i] = (float)(scale * grey);
    }
    return PP_OK;
}

/* Frame of a second picture that looks in the opposite direction. */
static struct pp_sky_frame opposite(const struct pp_sky_frame *frame)
{
    struct pp_sky_frame other = *frame;
    other.toward = pp_vec_scale(frame->toward, -1.0);
    other.right = pp_vec_scale(frame->right, -1.0);
    other.luminance = other.rgb = NULL;
    return other;
}

static enum pp_status add_frame(struct pp_sky_picture *picture, const char *path,
                                const struct pp_sky_picture_options *options,
                                struct pp_error *err)
{
    struct pp_sky_frame *frame = &picture->frames[picture->frame_count];
    struct file file;
    enum pp_status status = read_picture(&file, path, err);
    if (status == PP_OK && picture->frame_count == 1) {
        const struct pp_sky_frame *first = &picture->frames[0];
        *frame = opposite(first);
        if (first->width != file.picture.width || first->height != file.picture.height)
            status = pp_fail(err, PP_BAD_INPUT,
                             "the picture has %d x %d pixels; expected %d x %d, as in "
                             "the first picture",
                             file.picture.width, file.picture.height, first->width,
                             first->height);
    } else if (status == PP_OK) {
        status = pp_sky_picture_view(frame, file.picture.width, file.picture.height,
                                     file.notes.view, options, err);
    }
    if (status == PP_OK)
        status = take_pixels(frame, &file, options, err);
    if (status == PP_OK) {
        frame->rgb = file.picture.rgb;
        file.picture.rgb = NULL;
        picture->frame_count++;
    }
    pp_picture_clear(&file.picture);
    return of_file(path, status, err);
}

/* Largest fraction of the horizontal illuminance that may come from filled directions;
 * more is reported as a mistake. One fifth of the sky is within 12 degrees of the
 * horizon; it contributes 0.04 of the illuminance if the sky is uniform. */
static const double FILLED_MOST = 0.2;

static enum pp_status check_filled(const struct pp_sky_picture *picture,
                                   const struct pp_sky_picture_options *options,
                                   struct pp_error *err)
{
    if (picture->filled <= FILLED_MOST || !isnan(options->fill_cd_m2))
        return PP_OK;
    return pp_fail(
        err, PP_BAD_INPUT,
        "%.0f %% of the light comes from directions that the picture does not show; "
        "expected at most %.0f %%, a second picture, or a luminance for these "
        "directions (fill)",
        100.0 * picture->filled, 100.0 * FILLED_MOST);
}

static enum pp_status take_sun(struct pp_sky_picture *picture,
                               const struct pp_sky_picture_options *options,
                               struct pp_error *err)
{
    if (!(options->sun_lx > 0.0))
        return PP_OK;
    bool altitude = !isnan(options->sun_altitude_rad),
         bearing = !isnan(options->sun_bearing_rad);
    if (!altitude || !bearing)
        return pp_fail(err, PP_BAD_INPUT,
                       "sun-illuminance needs the position of the sun; expected %s",
                       altitude  ? "sun-bearing"
                       : bearing ? "sun-altitude"
                                 : "sun-altitude and sun-bearing");
    picture->sun_lx = options->sun_lx;
    picture->sun =
        pp_vec_at_bearing(options->sun_bearing_rad, options->sun_altitude_rad);
    return PP_OK;
}

enum pp_status pp_sky_picture_file_read(struct pp_sky_picture **result,
                                        const char *path, const char *second,
                                        const struct pp_sky_picture_options *options,
                                        struct pp_error *err)
{
    *result = NULL;
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    if (!picture)
        return pp_fail_memory(err);
    picture->holders = 1;
    picture->horizon_rad = options->horizon_rad;
    picture->fill_cd_m2 = options->fill_cd_m2;
    picture->sampling = options->sampling;
    picture->lamps = options->lamps;
    enum pp_status status = take_sun(picture, options, err);
    if (status == PP_OK)
        status = add_frame(picture, path, options, err);
    if (status == PP_OK && second
        && picture->frames[0].projection == PP_SKY_LATITUDE_LONGITUDE)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s: a latitude-longitude picture shows all directions; "
                         "expected no second picture",
                         second);
    if (status == PP_OK && second)
        status = add_frame(picture, second, options, err);
    if (status == PP_OK)
        status = of_file(
            path, pp_sky_picture_settle(picture, options->illuminance_lx, err), err);
    if (status == PP_OK)
        status = of_file(path, check_filled(picture, options, err), err);
    if (status == PP_OK) {
        const char *slash = strrchr(path, '/');
        picture->title = strdup(slash ? slash + 1 : path);
        if (!picture->title)
            status = pp_fail_memory(err);
    }
    if (status == PP_OK)
        *result = picture;
    else
        pp_sky_picture_release(picture);
    return status;
}
