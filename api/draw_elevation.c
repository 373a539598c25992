/* draw_elevation.c - charts of all rooms of a site: the plan, and elevations of the
 * outer walls. */
#include "api/chart_kind.h"
#include "charts/site/elevation_chart.h"
#include "charts/site/site_chart.h"
#include "studies/site/elevation_study.h"

/* Returns the rooms of the site; if there is no site, the single room. */
static struct pp_site_rooms rooms_of(const struct pp_chart_choice *choice,
                                     struct pp_study_room *room,
                                     const struct pp_study_room *const *none)
{
    if (choice->site.count > 0)
        return (struct pp_site_rooms){choice->site.rooms, choice->site.before,
                                      choice->site.count, choice->site.french_m};
    return (struct pp_site_rooms){room, none, 1, choice->site.french_m};
}

static enum pp_status draw_site(struct pp_canvas *canvas, struct pp_study_room *room,
                                const struct pp_study_options *study,
                                const struct pp_chart_choice *choice, bool *finished,
                                struct pp_error *err)
{
    (void)study, (void)finished;
    const struct pp_study_room *none = NULL;
    const struct pp_site_rooms rooms = rooms_of(choice, room, &none);
    struct pp_site_sheet sheet;
    enum pp_status status = pp_site_study_make(&sheet, &rooms, err);
    if (status == PP_OK)
        status = pp_site_chart_draw(canvas, &sheet, err);
    pp_site_sheet_clear(&sheet);
    return status;
}

static enum pp_status draw_elevation(struct pp_canvas *canvas,
                                     struct pp_study_room *room,
                                     const struct pp_study_options *study,
                                     const struct pp_chart_choice *choice,
                                     bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    const struct pp_study_room *none = NULL;
    const struct pp_site_rooms rooms = rooms_of(choice, room, &none);
    struct pp_elevation_sheet sheet;
    enum pp_status status = pp_elevation_study_make(&sheet, &rooms, err);
    if (status == PP_OK)
        status = pp_elevation_chart_draw(canvas, &sheet, err);
    pp_site_sheet_clear_elevations(&sheet);
    return status;
}

const struct pp_chart_kind pp_draw_site_plan = {
    .name = "site",
    .summary = "site plan, with the vertical sky component of windows",
    .compares = true,
    .of_site = true,
    .landscape = true,
    .draw = draw_site,
};

const struct pp_chart_kind pp_draw_elevation = {
    .name = "elevation",
    .summary = "elevations of external walls, with the vertical sky component",
    .compares = true,
    .of_site = true,
    .landscape = true,
    .draw = draw_elevation,
};
