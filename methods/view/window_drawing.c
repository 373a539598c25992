/* window_drawing.c - scales the patches of a view to unit distance and clips them to
 * their half-spaces. */
#include "methods/view/window_drawing.h"

#include <stdlib.h>

/* h.u for the direction u = (x, y, 1): positive within the half-space. */
static double depth_in(const double *xy, struct pp_vec3 h)
{
    return h.x * xy[0] + h.y * xy[1] + h.z;
}

/* Clips a ring in place to a half-space [SH74]; spare has space for twice its points. A
 * non-convex ring may run twice along the cut, which changes neither its area nor the
 * points inside. Returns the number of points that remain. */
static int cut_ring(double (*xy)[2], int count, struct pp_vec3 h, double (*spare)[2])
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *p = xy[i], *q = xy[(i + 1) % count];
        double from = depth_in(p, h), to = depth_in(q, h);
        if (from >= 0.0) {
            spare[kept][0] = p[0];
            spare[kept++][1] = p[1];
        }
        if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
            double t = from / (from - to);
            spare[kept][0] = p[0] + t * (q[0] - p[0]);
            spare[kept++][1] = p[1] + t * (q[1] - p[1]);
        }
    }
    for (int i = 0; i < kept; i++) {
        xy[i][0] = spare[i][0];
        xy[i][1] = spare[i][1];
    }
    return kept;
}

/* Draws a ring of a patch, at unit distance and within the patch's half-spaces. */
static enum pp_status draw_ring(struct pp_ring *drawn, const struct pp_ring *ring,
                                const struct pp_visible *visible,
                                const struct pp_visible_patch *patch,
                                struct pp_error *err)
{
    /* Each half-space can at most double the points. */
    size_t most = (size_t)ring->count << patch->half_space_count;
    double(*spare)[2] = malloc((most + 1) * sizeof *spare);
    drawn->xy = malloc((most + 1) * sizeof *drawn->xy);
    if (!spare || !drawn->xy) {
        free(spare);
        return pp_fail_memory(err);
    }
    for (int i = 0; i < ring->count; i++)
        for (int axis = 0; axis < 2; axis++)
            drawn->xy[i][axis] = ring->xy[i][axis] / visible->view.distance_m;
    drawn->count = ring->count;
    for (int i = 0; i < patch->half_space_count; i++)
        drawn->count = cut_ring(
            drawn->xy, drawn->count,
            pp_projection_direction(&visible->view, patch->half_spaces[i]), spare);
    free(spare);
    return PP_OK;
}

static enum pp_status draw_patch(struct pp_drawn_part *part,
                                 const struct pp_visible *visible,
                                 const struct pp_visible_patch *patch,
                                 const struct pp_sky *sky, struct pp_error *err)
{
    part->hidden = patch->hidden;
    part->factor =
        patch->hidden ? pp_visible_luminance_factor(sky, patch->reflectance) : 1.0;
    part->region.rings = calloc(patch->region.count + 1, sizeof *part->region.rings);
    if (!part->region.rings)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < patch->region.count && status == PP_OK; i++) {
        struct pp_ring *drawn = &part->region.rings[part->region.count];
        status = draw_ring(drawn, &patch->region.rings[i], visible, patch, err);
        if (status == PP_OK && drawn->count < 3)
            free(drawn->xy);
        else
            part->region.count++;
    }
    return status;
}

enum pp_status pp_window_drawing_of_view(struct pp_window_drawing *drawing,
                                         const struct pp_visible *visible,
                                         const struct pp_sky *sky, struct pp_error *err)
{
    const struct pp_projection *view = &visible->view;
    *drawing = (struct pp_window_drawing){.axes = {view->along, view->up, view->toward},
                                          .distance_m = view->distance_m,
                                          .count = visible->patch_count};
    drawing->parts = calloc(visible->patch_count + 1, sizeof *drawing->parts);
    if (!drawing->parts) {
        drawing->count = 0;
        return pp_fail_memory(err);
    }
    enum pp_status status = PP_OK;
    for (int i = 0; i < drawing->count && status == PP_OK; i++)
        status =
            draw_patch(&drawing->parts[i], visible, &visible->patches[i], sky, err);
    if (status != PP_OK)
        pp_window_drawing_clear(drawing);
    return status;
}

enum pp_status pp_window_drawing_init(struct pp_window_drawing *drawing,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      struct pp_vec3 point, struct pp_error *err)
{
    *drawing = (struct pp_window_drawing){0};
    struct pp_visible visible;
    enum pp_status status = pp_visible_through(&visible, world, opening, point, err);
    if (status != PP_OK)
        return status;
    status = pp_window_drawing_of_view(drawing, &visible, &light->sky, err);
    pp_visible_clear(&visible);
    return status;
}

void pp_window_drawing_clear(struct pp_window_drawing *drawing)
{
    for (int i = 0; i < drawing->count; i++)
        pp_region_clear(&drawing->parts[i].region);
    free(drawing->parts);
    drawing->parts = NULL;
    drawing->count = 0;
}

static const struct pp_formula_quantity quantities[] = {
    {"n", PP_UNIT_COUNT, "squares or dots counted"},
    {"w", PP_UNIT_DAYLIGHT_FACTOR, "value of one square or dot"},
    {0},
};
static const struct pp_formula_quantity of_hidden[] = {
    {"n", PP_UNIT_COUNT, "squares or dots counted"},
    {"w", PP_UNIT_DAYLIGHT_FACTOR, "value of one square or dot"},
    {"f", PP_UNIT_NUMBER, "luminance factor of the obstruction"},
    {0},
};

/* These formulae have no variants, since an average is an integral and not the mean of
 * many counts. */
const struct pp_formula pp_window_drawing_sc = {.symbol = "sc",
                                                .sum = "n w",
                                                .unit = PP_UNIT_DAYLIGHT_FACTOR,
                                                .what = "sky component",
                                                .quantities = quantities,
                                                .fixed = true};
const struct pp_formula pp_window_drawing_erc = {.symbol = "erc",
                                                 .sum = "f n w",
                                                 .unit = PP_UNIT_DAYLIGHT_FACTOR,
                                                 .what =
                                                     "externally reflected component",
                                                 .quantities = of_hidden,
                                                 .fixed = true};

const struct pp_formula *const pp_window_drawing_formulae[] = {
    &pp_window_drawing_sc, &pp_window_drawing_erc, NULL};

double pp_window_drawing_work(struct pp_part_steps *terms,
                              const struct pp_drawn_part *part, double count,
                              const char *things)
{
    pp_part_steps_next(terms);
    pp_worksheet_put(terms->sheet, PP_UNIT_COUNT, count, "n", "%s on %s", things,
                     part->hidden ? "an obstruction" : "the sky");
    if (!part->hidden)
        return pp_part_steps_work(terms, false, &pp_window_drawing_sc, "sky component");
    pp_worksheet_put(terms->sheet, PP_UNIT_NUMBER, part->factor, "f",
                     "luminance factor of the obstruction");
    return pp_part_steps_work(terms, true, &pp_window_drawing_erc,
                              "externally reflected component");
}
