/* skylight_indicator_fill.c - finds the altitudes of the marks by bisection, and tests
 * which marks are on the sky. */
#include "methods/waldram/skylight_indicator_fill.h"

#include "methods/exact/exterior.h"
#include "methods/waldram/waldram_scale.h"
#include "methods/waldram/waldram_site.h"

/* The altitude that has this Y on the diagram; 60 bisections reach machine
 * precision. */
static double altitude_of(const struct pp_waldram *waldram, double y)
{
    double low = 0.0, high = PP_PI / 2.0;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        *(pp_waldram_scale_y(waldram, middle) < y ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static void place_marks(struct pp_skylight_indicator_sheet *sheet,
                        const struct pp_waldram *waldram)
{
    double top = pp_waldram_scale_y(waldram, PP_PI / 2.0);
    for (int i = 0; i < PP_SKYLIGHT_RINGS; i++) {
        double altitude =
            altitude_of(waldram, (2 * i + 1) * top / (2 * PP_SKYLIGHT_RINGS));
        double r = 1.0 / tan(altitude);
        for (int j = 0; j < PP_SKYLIGHT_RAYS; j++) {
            double x = (2.0 * j + 1.0) / PP_SKYLIGHT_RAYS - 1.0;
            sheet->marks[i * PP_SKYLIGHT_RAYS + j] =
                (struct pp_skylight_mark){.x = r * x, .y = r * sqrt(1.0 - x * x)};
        }
    }
}

/* Extent of the plan, relative to the distance of the lowest marks. */
#define REACH_BEYOND 1.06

static enum pp_status fill_indicator_sheet(struct pp_skylight_indicator_sheet *sheet,
                                           struct pp_waldram *waldram,
                                           const struct pp_sky *sky,
                                           struct pp_vec3 facing, struct pp_error *err)
{
    *sheet = (struct pp_skylight_indicator_sheet){.sky = *sky};
    enum pp_status status = pp_waldram_scale_init_upright(waldram, sky, facing, err);
    if (status != PP_OK)
        return status;
    sheet->whole = pp_waldram_scale_total_area(waldram);
    sheet->worth = sheet->whole / (PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS);
    place_marks(sheet, waldram);
    sheet->reach = REACH_BEYOND * hypot(sheet->marks[0].x, sheet->marks[0].y);
    return PP_OK;
}

enum pp_status pp_skylight_indicator_fill_blank(
    struct pp_skylight_indicator_sheet *sheet, const struct pp_sky *sky,
    struct pp_error *err)
{
    struct pp_waldram waldram;
    enum pp_status status =
        fill_indicator_sheet(sheet, &waldram, sky, pp_vec(0.0, 1.0, 0.0), err);
    sheet->blank = true;
    return status;
}

enum pp_status pp_skylight_indicator_fill_site(
    struct pp_skylight_indicator_sheet *sheet, const struct pp_world *world,
    int opening, struct pp_error *err)
{
    const struct pp_opening *window = &world->openings[opening];
    const struct pp_sky overcast = pp_sky_overcast();
    struct pp_vec3 facing = pp_vec_scale(window->inner.normal, -1.0);
    struct pp_waldram waldram;
    enum pp_status status =
        fill_indicator_sheet(sheet, &waldram, &overcast, facing, err);
    if (status != PP_OK)
        return status;
    sheet->name = world->name;
    sheet->label = window->label;
    sheet->middle = pp_exterior_opening_centroid(window);
    struct pp_waldram_site site;
    status = pp_waldram_site_init_plan(&site, world, sheet->middle, facing,
                                       window->face, sheet->reach, err);
    if (status != PP_OK)
        return status;
    for (int i = 0; i < PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS; i++) {
        struct pp_skylight_mark *mark = &sheet->marks[i];
        mark->counted = pp_region_contains(&site.sky, mark->x, mark->y);
        sheet->counted += mark->counted;
    }
    sheet->sky_component = sheet->counted * sheet->worth;
    sheet->hidden = site.hidden;
    site.hidden = (struct pp_region){0};
    pp_waldram_site_clear(&site);
    return PP_OK;
}
