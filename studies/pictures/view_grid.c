/* view_grid.c - projects the points of each line with the camera. A line is interrupted
 * where its points are outside the picture. */
#include "studies/pictures/view_grid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Numbers of points on a full circle and on an edge of an opening, and maximum number
 * of labels in a picture. */
enum { STEPS = 180, EDGE_STEPS = 24, WORDS_MOST = 16 };

/* Labels are within this fraction of the picture's radius, so that all letters are
 * inside. The value was chosen by trial. */
static const double RIM = 0.95;

/* The sheet to which lines are added, and the line being drawn. */
struct tracing {
    struct pp_picture_sheet *sheet;
    const struct pp_camera *camera;
    struct pp_curve curve; /* points of the line so far; `space` is their allocated
                            * number */
    int space;
};

/* Pixel of the picture that shows the point. Returns false if the point is outside the
 * picture. */
static bool project(const struct tracing *tracing, struct pp_vec3 point, double xy[2])
{
    double x, y, distance_m;
    if (!pp_camera_project(tracing->camera, point, &x, &y, &distance_m)
        || hypot(2.0 * x - 1.0, 2.0 * y - 1.0) > 1.0 + 1e-6)
        return false;
    xy[0] = x * tracing->sheet->raster.width;
    xy[1] = y * tracing->sheet->raster.height;
    return true;
}

/* Adds the finished line to the sheet, if it has at least two points. */
static enum pp_status end_line(struct tracing *tracing, struct pp_error *err)
{
    struct pp_curve curve = tracing->curve;
    tracing->curve = (struct pp_curve){0};
    if (curve.count >= 2)
        return pp_curve_list_add(&tracing->sheet->grid, curve, err);
    free(curve.xy);
    return PP_OK;
}

/* Adds the next point to the line. A point outside the picture ends the line. */
static enum pp_status add_point(struct tracing *tracing, struct pp_vec3 point,
                                struct pp_error *err)
{
    double xy[2];
    if (!project(tracing, point, xy))
        return end_line(tracing, err);
    if (!tracing->curve.xy) {
        tracing->curve.xy = malloc((size_t)tracing->space * sizeof *tracing->curve.xy);
        if (!tracing->curve.xy)
            return pp_fail_memory(err);
    }
    pp_curve_add_point(&tracing->curve, xy);
    return PP_OK;
}

/* Point one metre from the eye in the given direction. The bearing is clockwise from
 * north. */
static struct pp_vec3 towards(const struct tracing *tracing, double north_rad,
                              double bearing_rad, double altitude_rad)
{
    double azimuth = bearing_rad - north_rad; /* clockwise from +y */
    struct pp_vec3 u = {sin(azimuth) * cos(altitude_rad),
                        cos(azimuth) * cos(altitude_rad), sin(altitude_rad)};
    return pp_vec_add(tracing->camera->eye, u);
}

/* Adds circles of altitude and lines of azimuth. */
static enum pp_status trace_directions(struct tracing *tracing, double north_rad,
                                       struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int altitude = 0; altitude <= 75 && status == PP_OK; altitude += 15) {
        for (int i = 0; i <= STEPS && status == PP_OK; i++)
            status = add_point(
                tracing,
                towards(tracing, north_rad, 2.0 * PP_PI * i / STEPS, altitude * PP_RAD),
                err);
        if (status == PP_OK)
            status = end_line(tracing, err);
    }
    for (int bearing = 0; bearing < 360 && status == PP_OK; bearing += 30) {
        for (int i = 0; i <= 75 && status == PP_OK; i++)
            status = add_point(
                tracing, towards(tracing, north_rad, bearing * PP_RAD, i * PP_RAD),
                err);
        if (status == PP_OK)
            status = end_line(tracing, err);
    }
    return status;
}

static enum pp_status trace_opening(struct tracing *tracing,
                                    const struct pp_polygon *outline,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < outline->count && status == PP_OK; i++) {
        struct pp_vec3 a = outline->vertices[i];
        struct pp_vec3 side =
            pp_vec_sub(outline->vertices[(i + 1) % outline->count], a);
        for (int k = 0; k <= EDGE_STEPS && status == PP_OK; k++)
            status =
                add_point(tracing, pp_vec_along(a, (double)k / EDGE_STEPS, side), err);
    }
    return status == PP_OK ? end_line(tracing, err) : status;
}

/* Adds a label at a point, moved inwards if it is too near to the edge of the
 * picture. */
static void add_word(struct tracing *tracing, struct pp_vec3 point, const char *words)
{
    struct pp_picture_sheet *sheet = tracing->sheet;
    double xy[2];
    if (sheet->word_count == WORDS_MOST || !project(tracing, point, xy))
        return;
    struct pp_picture_word *word = &sheet->words[sheet->word_count++];
    double x = 0.5 * sheet->raster.width, y = 0.5 * sheet->raster.height;
    double out = hypot(xy[0] / x - 1.0, xy[1] / y - 1.0),
           in = out > RIM ? RIM / out : 1.0;
    word->x = x + in * (xy[0] - x);
    word->y = y + in * (xy[1] - y);
    snprintf(word->words, sizeof word->words, "%s", words);
}

static void add_words(struct tracing *tracing, double north_rad)
{
    static const char *const compass[] = {"N", "E", "S", "W"};
    for (int i = 0; i < 4; i++)
        add_word(tracing, towards(tracing, north_rad, i * PP_PI / 2.0, 4.0 * PP_RAD),
                 compass[i]);
    for (int altitude = 15; altitude <= 75; altitude += 15) {
        char words[16];
        snprintf(words, sizeof words, "%d°", altitude);
        add_word(tracing, towards(tracing, north_rad, 45.0 * PP_RAD, altitude * PP_RAD),
                 words);
    }
}

enum pp_status pp_view_grid(struct pp_picture_sheet *sheet,
                            const struct pp_camera *camera,
                            const struct pp_world *world, struct pp_error *err)
{
    struct tracing tracing = {.sheet = sheet, .camera = camera};
    tracing.space = STEPS + 1;
    for (int i = 0; i < world->opening_count; i++) {
        int points = world->openings[i].inner.count * (EDGE_STEPS + 1);
        tracing.space = points > tracing.space ? points : tracing.space;
    }
    sheet->words = calloc(WORDS_MOST, sizeof *sheet->words);
    if (!sheet->words)
        return pp_fail_memory(err);
    enum pp_status status = trace_directions(&tracing, world->north_rad, err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        status = trace_opening(&tracing, &world->openings[i].inner, err);
    free(tracing.curve.xy);
    if (status == PP_OK)
        add_words(&tracing, world->north_rad);
    return status;
}
