/* picture_words.c - writes the sentences below a picture, and chooses levels of its
 * false colours. */
#include "cli/render/picture_words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "model/pictures/iso_lines.h"

/* For lines: the smoothing and the shortest line, as shares of the picture's longer
 * side. */
static const double smooth_share = 1.0 / 250.0, shortest_share = 1.0 / 25.0;

/* Lengths and north, of a parallel view. */
static void lay_lengths(struct pp_picture_sheet *sheet,
                        const struct pp_shown_picture *shown)
{
    const struct pp_camera *camera = &shown->camera;
    if (camera->kind != PP_VIEW_PARALLEL)
        return;
    double n = shown->world->north_rad;
    struct pp_vec3 north = {-sin(n), cos(n), 0.0};
    sheet->pixels_per_m = shown->picture.width / camera->across;
    sheet->upright = hypot(camera->toward.x, camera->toward.y) > 1e-6;
    sheet->north_rad =
        -atan2(pp_vec_dot(north, camera->right), pp_vec_dot(north, camera->up));
}

/* Daylight factors and illuminances allow for decorations, luminances don't. */
static void note_decorations(struct pp_picture_sheet *sheet,
                             const struct pp_shown_picture *shown)
{
    size_t room = sizeof sheet->foot;
    if (shown->world->decorations == 1.0)
        return;
    if (shown->quantity == PP_LUMINANCE)
        pp_page_say(sheet->foot, room, "Decorations as new: without their %.3g.",
                    shown->world->decorations);
    else
        pp_page_say(sheet->foot, room, "Decorations leave %.3g of what is reflected.",
                    shown->world->decorations);
}

void pp_picture_words(struct pp_picture_sheet *sheet,
                      const struct pp_shown_picture *shown,
                      const struct pp_render_choice *choice)
{
    struct pp_quantity_words words = pp_quantity_words(shown->quantity);
    size_t room = sizeof sheet->subtitle, notes = sizeof sheet->foot;
    pp_page_say(sheet->subtitle, room, "%s", words.heading);
    if (shown->quantity != PP_LUMINANCE)
        pp_page_say(sheet->subtitle, room, "on the surfaces seen");
    if (!shown->world) {
        sheet->title = choice->from_picture;
        if (shown->view[0])
            pp_page_say(sheet->foot, notes, "View: %s.", shown->view);
        return;
    }
    char sky[128];
    lay_lengths(sheet, shown);
    sheet->title = shown->world->name;
    pp_page_sky(sky, sizeof sky, shown->world, shown->light);
    pp_page_say(sheet->subtitle, room, "under %s %s%s", sky[0] == 'I' ? "an" : "a", sky,
                shown->quantity == PP_DAYLIGHT_FACTOR ? "" : ",");
    if (shown->quantity != PP_DAYLIGHT_FACTOR)
        pp_page_say(sheet->subtitle, room, "%.0f lx outside", shown->external_lux);
    pp_page_say(sheet->foot, notes, "%s.", shown->words);
    if (shown->quantity != PP_LUMINANCE)
        pp_page_say(sheet->foot, notes, "Glass and sky have no %s and are left white.",
                    shown->quantity == PP_ILLUMINANCE ? "illuminance"
                                                      : "daylight factor");
    note_decorations(sheet, shown);
}

/* Are there pixels beyond the ends of the scale? */
static void look_beyond(struct pp_picture_sheet *sheet,
                        const struct pp_picture *picture, double unit)
{
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = unit * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            sheet->off_scale[0] |= value < sheet->scale.low * 0.999;
            sheet->off_scale[1] |= value > sheet->scale.high * 1.001;
        }
}

static void choose_levels(struct pp_picture_sheet *sheet,
                          const struct pp_render_choice *choice)
{
    if (choice->no_contours)
        return;
    if (choice->levels.count) {
        sheet->level_count = choice->levels.count;
        memcpy(sheet->levels, choice->levels.list, sizeof choice->levels.list);
        return;
    }
    /* Levels within the scale. */
    double all[PP_FALSE_COLOUR_LEVELS_MOST];
    int count = pp_false_colour_scale_levels(&sheet->scale, all);
    for (int i = 0; i < count; i++)
        if (all[i] > sheet->scale.low && all[i] < sheet->scale.high)
            sheet->levels[sheet->level_count++] = all[i];
}

enum pp_status pp_picture_words_false_colour(struct pp_picture_sheet *sheet,
                                             const struct pp_shown_picture *shown,
                                             const struct pp_render_choice *choice,
                                             struct pp_error *err)
{
    const struct pp_picture *picture = &shown->picture;
    struct pp_quantity_words words = pp_quantity_words(shown->quantity);
    sheet->scaled = true;
    sheet->unit = words.unit;
    enum pp_status status = pp_false_colour_scale_fit(
        &sheet->scale, picture, words.scale, !choice->linear, err);
    if (status != PP_OK)
        return status;
    if (choice->range.count)
        sheet->scale = (struct pp_false_colour_scale){
            choice->range.list[0], choice->range.list[1], !choice->linear};
    look_beyond(sheet, picture, words.scale);
    choose_levels(sheet, choice);
    double side = fmax(picture->width, picture->height);
    status = pp_false_colour_raster(&sheet->raster, picture, words.scale, &sheet->scale,
                                    err);
    if (status == PP_OK)
        status = pp_iso_lines(&sheet->lines, picture, shown->tags, words.scale,
                              sheet->levels, sheet->level_count, smooth_share * side,
                              shortest_share * side, err);
    return status;
}
