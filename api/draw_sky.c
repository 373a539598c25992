/* draw_sky.c - the luminance of a room's sky from horizon to horizon. */
#include <math.h>

#include "api/chart_kind.h"
#include "charts/sky_chart.h"

/* So far above the horizon the sky's luminance is the horizon's, and not 0. */
#define LEAST_SINE 1e-9

/* Along the great circle through zenith and sun, from the sun's side. */
static void fill(struct pp_sky_sheet *sheet, const struct pp_world *world)
{
    struct pp_vec3 sun = world->sky.sun;
    double level = hypot(sun.x, sun.y);
    struct pp_vec3 towards =
        level > 0.0 ? pp_vec(sun.x / level, sun.y / level, 0.0) : pp_vec(0.0, 1.0, 0.0);
    sheet->world = world;
    for (int i = 0; i <= PP_SKY_SHEET_STEPS; i++) {
        double angle = PP_PI * i / PP_SKY_SHEET_STEPS;
        struct pp_vec3 u = {towards.x * cos(angle), towards.y * cos(angle),
                            fmax(sin(angle), LEAST_SINE)};
        sheet->luminance[i] = PP_PI * pp_sky_luminance(&world->sky, u);
    }
}

static enum pp_status draw(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_wish *wish, bool *finished,
                           struct pp_error *err)
{
    (void)study;
    (void)wish;
    (void)finished;
    struct pp_sky_sheet sheet;
    fill(&sheet, room->world);
    return pp_sky_chart_draw(canvas, &sheet, err);
}

const struct pp_chart_kind pp_draw_sky = {
    .name = "sky",
    .summary = "the sky's luminance from horizon to horizon, through zenith and sun",
    .landscape = true,
    .draw = draw,
};
