/* sky_picture.c - see sky_picture.h. */
#include "model/light/photographs/sky_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/light/photographs/sky_picture_sun.h"

/* ---- pixels around a position ---- */

/* Mean of the valid pixels around a position, with bilinear weights. */
struct pixel_square {
    double luminance;
    struct pp_rgb colour;
    double q;      /* rim_variable, mean over the pixels */
    double weight; /* total weight of valid pixels: 1 if all four are valid */
};

static bool is_fisheye(const struct pp_sky_frame *frame)
{
    return frame->projection != PP_SKY_LATITUDE_LONGITUDE;
}

/* Distance of a position (pixels) from the centre of the circle, divided by its
 * radius. */
static double radius_of(const struct pp_sky_frame *frame, double x, double y)
{
    return hypot(x - frame->centre[0], y - frame->centre[1]) / frame->radius[0];
}

/* Variable for extrapolation at the rim: the radius, or for a hemispherical picture the
 * cosine of the angle. */
static double rim_variable(const struct pp_sky_frame *frame, double radius)
{
    if (frame->projection != PP_SKY_HEMISPHERICAL)
        return radius;
    double sine = radius * sin(frame->half_angle_rad);
    return sqrt(fmax(0.0, 1.0 - sine * sine));
}

/* True if the pixel is on the side of the horizon given by the sign of `side` (0:
 * any). */
static bool is_on_side(const struct pp_sky_frame *frame, int x, int y, double side)
{
    double place[2] = {(x + 0.5 - frame->centre[0]) / frame->radius[0],
                       (frame->centre[1] - y - 0.5) / frame->radius[1]};
    struct pp_vec3 own;
    if (side == 0.0
        || !pp_sky_projection_direction(frame->projection, frame->half_angle_rad, place,
                                        &own))
        return true;
    return side
               * (own.x * frame->right.z + own.y * frame->up.z
                  + own.z * frame->toward.z)
           > 0.0;
}

/* Criterion for valid pixels: within the circle or picture, and on the side of the
 * horizon given by the sign of `side` (0: any). */
struct counted {
    double side;
    bool colour;
};

static void add_pixel(struct pixel_square *sum, const struct pp_sky_frame *frame, int x,
                      int y, double weight, struct counted counted)
{
    double q = 0.0;
    if (is_fisheye(frame)) {
        double radius = radius_of(frame, x + 0.5, y + 0.5);
        if (radius > 1.0 || x < 0 || y < 0 || x >= frame->width || y >= frame->height)
            return;
        q = rim_variable(frame, radius);
    } else { /* latitude-longitude: periodic in x, ends at the poles */
        x = x < 0 ? x + frame->width : x >= frame->width ? x - frame->width : x;
        y = y < 0 ? 0 : y >= frame->height ? frame->height - 1 : y;
    }
    if (!is_on_side(frame, x, y, counted.side))
        return;
    size_t index = (size_t)y * (size_t)frame->width + (size_t)x;
    sum->luminance += weight * (double)frame->luminance[index];
    sum->q += weight * q;
    sum->weight += weight;
    if (counted.colour && frame->rgb) {
        const float *rgb = frame->rgb + 3 * index;
        sum->colour = pp_rgb_along(sum->colour, weight, pp_rgb(rgb[0], rgb[1], rgb[2]));
    }
}

/* Mean of the valid pixels around the position x, y (pixels). */
static struct pixel_square around(const struct pp_sky_frame *frame, double x, double y,
                                  struct counted counted)
{
    struct pixel_square sum = {0};
    double left = floor(x - 0.5), top = floor(y - 0.5);
    double right = x - 0.5 - left, below = y - 0.5 - top;
    int i = (int)left, k = (int)top;
    add_pixel(&sum, frame, i, k, (1.0 - right) * (1.0 - below), counted);
    add_pixel(&sum, frame, i + 1, k, right * (1.0 - below), counted);
    add_pixel(&sum, frame, i, k + 1, (1.0 - right) * below, counted);
    add_pixel(&sum, frame, i + 1, k + 1, right * below, counted);
    if (sum.weight > 0.0) {
        sum.luminance /= sum.weight;
        sum.q /= sum.weight;
    }
    return sum;
}

/* Mean at a position that is `in` pixels nearer to the centre than `place`, whose
 * distance from the centre is `radius`. */
static struct pixel_square inside(const struct pp_sky_frame *frame,
                                  const double place[2], double radius, double in)
{
    double scale = fmax(0.0, frame->radius[0] - in / radius);
    return around(frame, frame->centre[0] + scale * place[0],
                  frame->centre[1] - scale * place[1], (struct counted){0});
}

/* Value at q of the parabola through three points. */
static double parabola(const double at[3], const double value[3], double q)
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        double a = at[(i + 1) % 3], b = at[(i + 2) % 3];
        sum += value[i] * (q - a) * (q - b) / ((at[i] - a) * (at[i] - b));
    }
    return sum;
}

/* Luminance within two pixels of the rim, from the parabola through the outermost valid
 * pixels and two positions further inwards. */
static double rim_luminance(const struct pp_sky_frame *frame, const double place[2],
                            double radius)
{
    static const double steps[] = {1.25, 3.0};
    struct pixel_square outer = {0};
    double in = 0.0;
    for (; in < 4.0 && !(outer.weight > 0.25); in += 0.25)
        outer = inside(frame, place, radius, in);
    if (!(outer.weight > 0.0))
        return 0.0;
    double at[3] = {outer.q};
    double value[3] = {outer.luminance};
    for (int i = 0; i < 2; i++) {
        struct pixel_square inner = inside(frame, place, radius, in + steps[i]);
        if (!(inner.weight > 0.0))
            return outer.luminance;
        at[i + 1] = inner.q;
        value[i + 1] = inner.luminance;
    }
    double low = fmin(at[0], at[1]), high = fmax(at[0], at[1]);
    if (!(high > low) || !(fabs(at[2] - at[0]) > high - low))
        return outer.luminance;
    double change = parabola(at, value, rim_variable(frame, radius)) - outer.luminance;
    double most = 0.5 * outer.luminance;
    return outer.luminance + fmax(-most, fmin(most, change));
}

/* ---- a picture ---- */

/* Position of a direction in a frame, moved to the rim if it is outside; sets *outside.
 * Returns its radius. */
static double place_in(const struct pp_sky_frame *frame, struct pp_vec3 u,
                       double place[2], bool *outside)
{
    struct pp_vec3 own = pp_vec(pp_vec_dot(u, frame->right), pp_vec_dot(u, frame->up),
                                pp_vec_dot(u, frame->toward));
    pp_sky_projection_place(frame->projection, frame->half_angle_rad, own, place);
    double radius = is_fisheye(frame) ? hypot(place[0], place[1]) : 0.0;
    *outside = radius > 1.0 + 1e-9
               || (frame->projection == PP_SKY_HEMISPHERICAL && own.z < -1e-9);
    if (radius > 1.0) {
        place[0] /= radius;
        place[1] /= radius;
        radius = 1.0;
    }
    return radius;
}

/* Bilinear luminance; x and y in pixels. Returns false unless all four neighbours are
 * in the picture. */
static bool bilinear(const struct pp_sky_frame *frame, double x, double y,
                     double *luminance)
{
    double left = floor(x - 0.5), top = floor(y - 0.5);
    if (!(left >= 0.0) || !(top >= 0.0) || !(left < frame->width - 1)
        || !(top < frame->height - 1))
        return false;
    const float *at =
        frame->luminance + (size_t)top * (size_t)frame->width + (size_t)left;
    const float *below = at + frame->width;
    double right = x - 0.5 - left, down = y - 0.5 - top;
    double upper = (double)at[0] + right * ((double)at[1] - (double)at[0]);
    double lower = (double)below[0] + right * ((double)below[1] - (double)below[0]);
    *luminance = upper + down * (lower - upper);
    return true;
}

static double frame_luminance(const struct pp_sky_frame *frame, struct pp_vec3 u,
                              bool *outside)
{
    double place[2], luminance, radius = place_in(frame, u, place, outside);
    if (is_fisheye(frame) && frame->radius[0] * (1.0 - radius) < 2.0)
        return rim_luminance(frame, place, radius);
    double x = frame->centre[0] + frame->radius[0] * place[0];
    double y = frame->centre[1] - frame->radius[1] * place[1];
    /* Ground and sky pixels must not mix at the horizon. */
    double step = PP_PI / 2.0 / frame->radius[1];
    bool edge =
        fabs(u.z) < 1.5 * step * fmax(1.0, frame->half_angle_rad / (PP_PI / 2.0));
    if (!edge && bilinear(frame, x, y, &luminance))
        return luminance;
    struct counted counted = {.side = edge ? u.z : 0.0};
    struct pixel_square those = around(frame, x, y, counted);
    if (!(those.weight > 0.0))
        those = around(frame, x, y, (struct counted){0});
    return those.luminance;
}

/* Weight of the first of two opposite pictures in direction u: 1 where only that one
 * shows it, decreasing to 0 over the overlap. */
static double share_of_first(const struct pp_sky_picture *picture, struct pp_vec3 u)
{
    if (picture->frame_count == 1)
        return 1.0;
    double t = acos(fmax(-1.0, fmin(1.0, pp_vec_dot(u, picture->frames[0].toward))));
    double least = PP_PI - picture->frames[1].half_angle_rad;
    double most = picture->frames[0].half_angle_rad;
    if (most <= least)
        return t <= 0.5 * (least + most) ? 1.0 : 0.0;
    return fmax(0.0, fmin(1.0, (most - t) / (most - least)));
}

/* Returns the direction, raised to the horizon of the picture if it is below that
 * horizon; sets *below. */
static struct pp_vec3 above_horizon(const struct pp_sky_picture *picture,
                                    struct pp_vec3 u, bool *below)
{
    double sine = sin(picture->horizon_rad), level = hypot(u.x, u.y);
    *below = picture->horizon_rad > 0.0 && u.z < sine;
    if (!*below || !(level > 0.0))
        return u;
    double scale = cos(picture->horizon_rad) / level;
    return pp_vec(scale * u.x, scale * u.y, sine);
}

double pp_sky_picture_luminance(const struct pp_sky_picture *picture, struct pp_vec3 u,
                                bool *filled)
{
    bool below, outside[2] = {false, false};
    u = above_horizon(picture, u, &below);
    double first = share_of_first(picture, u), sum = 0.0;
    for (int i = 0; i < picture->frame_count; i++) {
        double share = i == 0 ? first : 1.0 - first;
        if (share > 0.0)
            sum += share * frame_luminance(&picture->frames[i], u, &outside[i]);
    }
    bool fill = below || outside[0] || outside[1];
    if (filled)
        *filled = fill;
    return fill && !isnan(picture->fill_cd_m2) ? picture->fill_cd_m2 : sum;
}

struct pp_rgb pp_sky_picture_colour(const struct pp_sky_picture *picture,
                                    struct pp_vec3 u)
{
    bool below, outside;
    u = above_horizon(picture, u, &below);
    const struct pp_sky_frame *frame =
        &picture->frames[share_of_first(picture, u) >= 0.5 ? 0 : 1];
    double place[2];
    place_in(frame, u, place, &outside);
    struct pp_rgb colour = around(frame, frame->centre[0] + frame->radius[0] * place[0],
                                  frame->centre[1] - frame->radius[1] * place[1],
                                  (struct counted){.colour = true})
                               .colour;
    double luminance = pp_rgb_luminance(colour);
    return luminance > 0.0 ? pp_rgb_scale(colour, 1.0 / luminance) : pp_rgb_grey(1.0);
}

/* ---- the table ---- */

/* Mean of a cell, sampled at the resolution of the pixels, at most 16 by 16 times.
 * *filled: share of the mean that is not from the pictures. */
static double cell_mean(const struct pp_sky_picture *picture, int row, int column,
                        double *filled)
{
    double cosine = cos((row + 0.5) * PP_SKY_PICTURE_ROW_RAD);
    int up = (int)fmin(16.0, ceil(PP_SKY_PICTURE_ROW_RAD / picture->step_rad));
    int along =
        (int)fmin(16.0, ceil(PP_SKY_PICTURE_COLUMN_RAD * cosine / picture->step_rad));
    double sum = 0.0, of_fill = 0.0;
    for (int i = 0; i < up; i++)
        for (int k = 0; k < along; k++) {
            double a = (row + (i + 0.5) / up) * PP_SKY_PICTURE_ROW_RAD;
            double b = (column + (k + 0.5) / along) * PP_SKY_PICTURE_COLUMN_RAD;
            struct pp_vec3 u = pp_vec(cos(a) * sin(b), cos(a) * cos(b), sin(a));
            bool fill;
            double value = pp_sky_picture_luminance(picture, u, &fill);
            sum += value;
            of_fill += fill ? value : 0.0;
        }
    *filled = sum > 0.0 ? of_fill / sum : 0.0;
    return sum / (up * along);
}

static enum pp_status fill_cells(struct pp_sky_picture *picture, struct pp_error *err)
{
    picture->cells = malloc(PP_SKY_PICTURE_CELLS * sizeof *picture->cells);
    if (!picture->cells)
        return pp_fail_memory(err);
    double sum = 0.0, of_fill = 0.0;
    for (int row = 0; row < PP_SKY_PICTURE_ROWS; row++) {
        double low = sin(row * PP_SKY_PICTURE_ROW_RAD),
               high = sin((row + 1) * PP_SKY_PICTURE_ROW_RAD);
        double weight = 0.5 * (high * high - low * low) * PP_SKY_PICTURE_COLUMN_RAD;
        for (int column = 0; column < PP_SKY_PICTURE_COLUMNS; column++) {
            double filled, mean = cell_mean(picture, row, column, &filled);
            picture->cells[row * PP_SKY_PICTURE_COLUMNS + column] = (float)mean;
            sum += weight * mean;
            of_fill += weight * mean * filled;
        }
    }
    if (!(sum > 0.0) || !isfinite(sum))
        return pp_fail(err, PP_BAD_INPUT,
                       "the sky in the picture gives no light; expected pixels with "
                       "values above 0 in the part above the horizon");
    picture->horizontal_lx = sum;
    picture->filled = of_fill / sum;
    return PP_OK;
}

double pp_sky_picture_on_plane(const struct pp_sky_picture *picture, struct pp_vec3 n)
{
    double sum = 0.0;
    for (int row = 0; row < PP_SKY_PICTURE_ROWS; row++) {
        double a = (row + 0.5) * PP_SKY_PICTURE_ROW_RAD, sine = sin(a), cosine = cos(a),
               total = 0.0;
        double omega = pp_sky_picture_solid_angle(row * PP_SKY_PICTURE_COLUMNS);
        for (int column = 0; column < PP_SKY_PICTURE_COLUMNS; column++) {
            double b = (column + 0.5) * PP_SKY_PICTURE_COLUMN_RAD;
            double facing = n.z * sine + cosine * (n.x * sin(b) + n.y * cos(b));
            if (facing > 0.0)
                total +=
                    facing
                    * (double)picture->cells[row * PP_SKY_PICTURE_COLUMNS + column];
        }
        sum += omega * total;
    }
    return sum;
}

/* ---- other quantities ---- */

static void scale_luminance(struct pp_sky_picture *picture, double factor)
{
    for (int i = 0; i < picture->frame_count; i++) {
        struct pp_sky_frame *frame = &picture->frames[i];
        size_t count = (size_t)frame->width * (size_t)frame->height;
        for (size_t k = 0; k < count; k++)
            frame->luminance[k] = (float)(factor * (double)frame->luminance[k]);
    }
    for (size_t k = 0; k < PP_SKY_PICTURE_CELLS; k++)
        picture->cells[k] = (float)(factor * (double)picture->cells[k]);
    picture->horizontal_lx *= factor;
    picture->peak_cd_m2 *= factor;
    picture->fill_cd_m2 *= factor;
}

static bool is_within_lens(const struct pp_sky_frame *frame, int x, int y)
{
    return !is_fisheye(frame) || radius_of(frame, x + 0.5, y + 0.5) <= 1.0;
}

static enum pp_status check_pixels(struct pp_sky_picture *picture, struct pp_error *err)
{
    for (int i = 0; i < picture->frame_count; i++) {
        const struct pp_sky_frame *frame = &picture->frames[i];
        for (int y = 0; y < frame->height; y++)
            for (int x = 0; x < frame->width; x++) {
                double value =
                    (double)
                        frame->luminance[(size_t)y * (size_t)frame->width + (size_t)x];
                if (!is_within_lens(frame, x, y))
                    continue;
                if (!(value >= 0.0) || !isfinite(value))
                    return pp_fail(err, PP_BAD_INPUT,
                                   "row %d, pixel %d: the luminance is %g; expected 0 "
                                   "or more",
                                   y + 1, x + 1, value);
                picture->peak_cd_m2 = fmax(picture->peak_cd_m2, value);
            }
    }
    return PP_OK;
}

/* Counts the pixels of a sun beyond the camera's range. The sun is assumed to be beyond
 * this range if several pixels share the largest value, within the resolution of the
 * format, and that value is more than SUN times the mean of the sky. */
static void count_saturated(struct pp_sky_picture *picture)
{
    enum { SEVERAL = 4 };
    const double SUN = 20.0, same = 0.99 * picture->peak_cd_m2;
    int count = 0;
    for (int i = 0; i < picture->frame_count; i++) {
        const struct pp_sky_frame *frame = &picture->frames[i];
        for (int y = 0; y < frame->height; y++)
            for (int x = 0; x < frame->width; x++)
                count +=
                    (double)frame
                            ->luminance[(size_t)y * (size_t)frame->width + (size_t)x]
                        >= same
                    && is_within_lens(frame, x, y);
    }
    bool bright = picture->peak_cd_m2 > SUN * picture->horizontal_lx / PP_PI;
    picture->saturated = bright && count >= SEVERAL ? count : 0;
}

static uint64_t stir(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *at = bytes;
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ at[i]) * 1099511628211u; /* FNV-1a */
    return hash;
}

static uint64_t hash_of(const struct pp_sky_picture *picture)
{
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < picture->frame_count; i++) {
        const struct pp_sky_frame *f = &picture->frames[i];
        const double numbers[] = {
            f->projection, f->half_angle_rad, f->centre[0], f->centre[1], f->radius[0],
            f->radius[1],  f->right.x,        f->right.y,   f->right.z,   f->up.x,
            f->up.y,       f->up.z,           f->width,     f->height};
        hash = stir(hash, numbers, sizeof numbers);
        hash = stir(hash, f->luminance,
                    sizeof *f->luminance * (size_t)f->width * (size_t)f->height);
    }
    const double rest[] = {picture->horizon_rad,
                           isnan(picture->fill_cd_m2) ? -1.0 : picture->fill_cd_m2};
    return stir(hash, rest, sizeof rest);
}

/* Smallest angle of a pixel at the centre of the pictures. */
static double pixel_angle(const struct pp_sky_picture *picture)
{
    double least = PP_PI;
    for (int i = 0; i < picture->frame_count; i++) {
        const struct pp_sky_frame *frame = &picture->frames[i];
        double angle = frame->projection == PP_SKY_LATITUDE_LONGITUDE
                           ? PP_PI
                           : frame->half_angle_rad;
        least = fmin(least, angle / frame->radius[0]);
    }
    return least;
}

enum pp_status pp_sky_picture_settle(struct pp_sky_picture *picture, double measured_lx,
                                     struct pp_error *err)
{
    picture->holders = 1;
    picture->peak_cd_m2 = 0.0;
    picture->step_rad = pixel_angle(picture);
    enum pp_status status = check_pixels(picture, err);
    if (status == PP_OK)
        status = fill_cells(picture, err);
    if (status != PP_OK)
        return status;
    double of_sun = picture->sun_lx * picture->sun.z;
    if (measured_lx <= of_sun)
        return pp_fail(err, PP_BAD_INPUT,
                       "the sun alone gives %.0f lx on a horizontal plane; expected an "
                       "illuminance above that, or a lower sun-illuminance",
                       of_sun);
    if (!isnan(measured_lx))
        scale_luminance(picture, (measured_lx - of_sun) / picture->horizontal_lx);
    if (picture->sun_lx > 0.0)
        status = pp_sky_picture_sun_add(picture, err);
    else
        count_saturated(picture);
    picture->hash = hash_of(picture);
    return status;
}

void pp_sky_picture_release(struct pp_sky_picture *picture)
{
    if (!picture || --picture->holders > 0)
        return;
    for (int i = 0; i < picture->frame_count; i++) {
        free(picture->frames[i].luminance);
        free(picture->frames[i].rgb);
    }
    free(picture->cells);
    free(picture->title);
    free(picture);
}
