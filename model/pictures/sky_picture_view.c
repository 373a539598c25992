/* sky_picture_view.c - see sky_picture_view.h. */
#include "model/pictures/sky_picture_view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"

/* ---- Radiance's VIEW ---- */

/* Values of VIEW in the header; 0 and NAN: not given. */
struct said {
    char type; /* letter after -vt */
    struct pp_vec3 toward, up;
    double across_deg, down_deg;
};

/* Reads the next word of a text and advances the text. Returns false at the end. */
static bool next_word(const char **text, char word[32])
{
    const char *from = *text + strspn(*text, " \t");
    size_t length = strcspn(from, " \t");
    snprintf(word, 32, "%.*s", (int)length, from);
    *text = from + length;
    return length > 0;
}

static bool read_numbers(const char **text, int count, double *numbers)
{
    char word[32];
    for (int i = 0; i < count; i++)
        if (!next_word(text, word) || !pp_text_parse_number(word, &numbers[i]))
            return false;
    return true;
}

static struct said read_view(const char *view)
{
    struct said said = {.toward = {NAN, NAN, NAN},
                        .up = {NAN, NAN, NAN},
                        .across_deg = NAN,
                        .down_deg = NAN};
    char word[32];
    while (next_word(&view, word)) {
        double n[3];
        if (strncmp(word, "-vt", 3) == 0)
            said.type = word[3];
        else if (strcmp(word, "-vd") == 0 && read_numbers(&view, 3, n))
            said.toward = pp_vec(n[0], n[1], n[2]);
        else if (strcmp(word, "-vu") == 0 && read_numbers(&view, 3, n))
            said.up = pp_vec(n[0], n[1], n[2]);
        else if (strcmp(word, "-vh") == 0)
            read_numbers(&view, 1, &said.across_deg);
        else if (strcmp(word, "-vv") == 0)
            read_numbers(&view, 1, &said.down_deg);
    }
    return said;
}

/* ---- projection and circle ---- */

static enum pp_status set_projection(struct pp_sky_frame *frame,
                                     const struct said *said,
                                     const struct pp_sky_picture_options *options,
                                     struct pp_error *err)
{
    bool wide = frame->width == 2 * frame->height;
    if (options->projection >= 0)
        frame->projection = (enum pp_sky_projection)options->projection;
    else if (said->type == 'a')
        frame->projection = PP_SKY_EQUIDISTANT;
    else if (said->type == 'h')
        frame->projection = PP_SKY_HEMISPHERICAL;
    else if (said->type)
        return pp_fail(err, PP_BAD_INPUT,
                       "the picture has a view of type -vt%c; expected -vta or -vth, "
                       "or a projection",
                       said->type);
    else
        frame->projection = wide ? PP_SKY_LATITUDE_LONGITUDE : PP_SKY_EQUIDISTANT;
    if (frame->projection == PP_SKY_LATITUDE_LONGITUDE && !wide)
        return pp_fail(err, PP_BAD_INPUT,
                       "the latitude-longitude picture has %d x %d pixels; expected "
                       "the width to be twice the height",
                       frame->width, frame->height);
    return PP_OK;
}

static enum pp_status set_angle(struct pp_sky_frame *frame, const struct said *said,
                                const struct pp_sky_picture_options *options,
                                struct pp_error *err)
{
    double angle = options->view_angle_rad, most = 2.0;
    bool wide = frame->width > frame->height;
    double own = (wide ? said->down_deg : said->across_deg) * PP_RAD;
    if (isnan(angle))
        angle = isnan(own) ? PP_PI : own;
    most *= pp_sky_projection_widest(frame->projection);
    if (!(angle > 0.0) || !(angle <= most + 1e-9))
        return pp_fail(err, PP_BAD_INPUT,
                       "the view angle is %g degrees; expected more than 0, up to %g",
                       angle / PP_RAD, most / PP_RAD);
    frame->half_angle_rad = fmin(angle, most) / 2.0;
    return PP_OK;
}

static enum pp_status set_circle(struct pp_sky_frame *frame,
                                 const struct pp_sky_picture_options *options,
                                 struct pp_error *err)
{
    double width = frame->width, height = frame->height;
    bool sphere = frame->projection == PP_SKY_LATITUDE_LONGITUDE;
    frame->centre[0] = 0.5 * width;
    frame->centre[1] = 0.5 * height;
    frame->radius[0] = sphere ? 0.5 * width : 0.5 * fmin(width, height);
    frame->radius[1] = sphere ? 0.5 * height : frame->radius[0];
    if (isnan(options->circle[0]))
        return PP_OK;
    const double *circle = options->circle;
    if (sphere || !(circle[2] >= 4.0) || !(circle[0] >= 0.0) || !(circle[0] <= width)
        || !(circle[1] >= 0.0) || !(circle[1] <= height)
        || !(circle[2] <= width + height))
        return pp_fail(err, PP_BAD_INPUT,
                       "the circle is \"%g %g %g\"; expected a circle of at least 4 "
                       "pixels in radius, centred within the %d x %d pixels of a "
                       "fisheye picture",
                       circle[0], circle[1], circle[2], frame->width, frame->height);
    frame->centre[0] = circle[0];
    frame->centre[1] = circle[1];
    frame->radius[0] = frame->radius[1] = circle[2];
    return PP_OK;
}

/* ---- axes ---- */

static double or_else(double given, double fallback)
{
    return isnan(given) ? fallback : given;
}

/* Finds the direction of view, and a direction towards the top of the picture. */
static void find_view(const struct pp_sky_frame *frame, const struct said *said,
                      const struct pp_sky_picture_options *options,
                      struct pp_vec3 *toward, struct pp_vec3 *top)
{
    bool sphere = frame->projection == PP_SKY_LATITUDE_LONGITUDE;
    bool given = !isnan(options->view_altitude_rad) || !isnan(options->view_bearing_rad)
                 || !isnan(options->top_bearing_rad);
    if (!given && !isnan(said->toward.x) && !isnan(said->up.x)) {
        *toward = said->toward;
        *top = said->up;
        return;
    }
    double level = isnan(options->view_bearing_rad) ? PP_PI / 2.0 : 0.0;
    double altitude = sphere ? 0.0 : or_else(options->view_altitude_rad, level);
    *toward = pp_vec_at_bearing(or_else(options->view_bearing_rad, 0.0), altitude);
    *top = pp_vec(0.0, 0.0, 1.0);
    if (fabs(toward->z) > 1.0 - 1e-9) {
        *toward = pp_vec(0.0, 0.0, toward->z > 0.0 ? 1.0 : -1.0);
        *top = pp_vec_at_bearing(or_else(options->top_bearing_rad, 0.0), 0.0);
    }
}

static enum pp_status set_axes(struct pp_sky_frame *frame, const struct said *said,
                               const struct pp_sky_picture_options *options,
                               struct pp_error *err)
{
    struct pp_vec3 toward, top;
    find_view(frame, said, options, &toward, &top);
    struct pp_vec3 right = pp_vec_cross(toward, top);
    if (!(pp_vec_length(right) > 1e-9 * pp_vec_length(toward) * pp_vec_length(top)))
        return pp_fail(err, PP_BAD_INPUT,
                       "the direction to the top of the picture is the same as its "
                       "direction of view");
    frame->toward = pp_vec_unit(toward);
    frame->right = pp_vec_unit(right);
    frame->up = pp_vec_cross(frame->right, frame->toward);
    if (options->mirrored)
        frame->right = pp_vec_scale(frame->right, -1.0);
    return PP_OK;
}

enum pp_status pp_sky_picture_view(struct pp_sky_frame *frame, int width, int height,
                                   const char *view,
                                   const struct pp_sky_picture_options *options,
                                   struct pp_error *err)
{
    struct said said = read_view(view);
    frame->width = width;
    frame->height = height;
    enum pp_status status = set_projection(frame, &said, options, err);
    if (status == PP_OK)
        status = set_angle(frame, &said, options, err);
    if (status == PP_OK)
        status = set_circle(frame, options, err);
    return status == PP_OK ? set_axes(frame, &said, options, err) : status;
}
