/* page.c - title, subtitle and notes of a sheet, and sentences that the notes of
 * several charts share. */
#include "charts/sheet/page.h"
#include "charts/sheet/title_block.h"
#include "model/base/text.h"
#include "model/light/photographs/sky_picture.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct pp_style pp_page_style(const struct pp_canvas *canvas)
{
    return pp_style_for(fmin(pp_canvas_width_mm(canvas), pp_canvas_height_mm(canvas)));
}

void pp_page_say(char *text, size_t room, const char *format, ...)
{
    size_t length = strlen(text);
    if (length && text[length - 1] != '\n')
        pp_text_append(text, room, " ");
    va_list arguments;
    va_start(arguments, format);
    pp_text_append_v(text, room, format, arguments);
    va_end(arguments);
}

void pp_page_sky(char *text, size_t room, const struct pp_world *world,
                 const struct pp_outside_light *light)
{
    pp_page_sky_words(text, room, &light->sky, world->north_rad);
}

void pp_page_sky_words(char *text, size_t room, const struct pp_sky *sky,
                       double north_rad)
{
    switch (sky->kind) {
    case PP_SKY_OVERCAST:
        snprintf(text, room, "CIE overcast sky");
        return;
    case PP_SKY_UNIFORM:
        snprintf(text, room, "uniform sky");
        return;
    case PP_SKY_PICTURE:
        snprintf(text, room, "sky of the picture %.60s", sky->picture->title);
        return;
    case PP_SKY_ISO:
        break;
    }
    if (!pp_sky_has_azimuth(sky)) {
        snprintf(text, room, "ISO 15469 sky of type %d", sky->iso);
        return;
    }
    double bearing = north_rad + atan2(sky->sun.x, sky->sun.y);
    bearing = fmod(bearing + 4.0 * PP_PI, 2.0 * PP_PI);
    char type[48] = "Perez sky";
    if (sky->iso > 0)
        snprintf(type, sizeof type, "ISO 15469 sky of type %d", sky->iso);
    snprintf(text, room,
             "%s, sun %.0f\u00b0 high at bearing "
             "%.0f\u00b0",
             type, asin(fmin(sky->sun.z, 1.0)) / PP_RAD, bearing / PP_RAD);
}

/* Writes a number, "0.9", or a range, "0.6 to 0.9", if its ends differ. Returns
 * `text`. */
static const char *range_text(char *text, size_t room, double low, double high)
{
    if (high - low < 5e-4)
        snprintf(text, room, "%.3g", high);
    else
        snprintf(text, room, "%.3g to %.3g", low, high);
    return text;
}

static void say_openings(char *text, size_t room, const struct pp_world *world)
{
    enum { GLASS, FRAME, DIRT, CURTAINS, COUNT };
    double low[COUNT] = {1.0, 1.0, 1.0, 1.0}, high[COUNT] = {0.0, 0.0, 0.0, 0.0};
    bool unglazed = world->opening_count > 0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double values[COUNT] = {opening->glass.normal, opening->frame_factor,
                                opening->maintenance, opening->curtains};
        unglazed = unglazed && opening->glass.panes == 0 && !opening->glass.diffusing;
        for (int k = 0; k < COUNT; k++) {
            low[k] = fmin(low[k], values[k]);
            high[k] = fmax(high[k], values[k]);
        }
    }
    char glass[32], frame[32], dirt[32];
    range_text(frame, sizeof frame, low[FRAME], high[FRAME]);
    range_text(dirt, sizeof dirt, low[DIRT], high[DIRT]);
    if (unglazed)
        pp_page_say(text, room, "Openings without glass, frame factor %s.", frame);
    else if (world->opening_count)
        pp_page_say(
            text, room,
            "Glass with a normal transmittance of %s; frame factor %s, maintenance %s.",
            range_text(glass, sizeof glass, low[GLASS], high[GLASS]), frame, dirt);
    if (low[CURTAINS] < 1.0)
        pp_page_say(text, room, "Curtains transmit %s.",
                    range_text(glass, sizeof glass, low[CURTAINS], high[CURTAINS]));
}

/* Appends a note on the allowance for decorations, if the room has one. */
static void say_decorations(char *text, size_t room, const struct pp_world *world)
{
    if (world->decorations != 1.0)
        pp_page_say(
            text, room,
            "Reflected light is multiplied by %.3g for deterioration of decorations.",
            world->decorations);
}

void pp_page_assumptions(char *text, size_t room, const struct pp_world *world,
                         const struct pp_outside_light *light)
{
    static const char *const parts[] = {
        [PP_FLOOR] = "floor", [PP_WALL] = "walls", [PP_CEILING] = "ceiling"};
    say_openings(text, room, world);
    char sentence[160] = "Reflectances:";
    for (enum pp_role role = PP_FLOOR; role <= PP_CEILING; role++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < world->face_count; i++)
            if (world->surfaces[i].role == role) {
                low = fmin(low, world->surfaces[i].front);
                high = fmax(high, world->surfaces[i].front);
            }
        char range[32];
        if (high >= low)
            pp_page_say(sentence, sizeof sentence, "%s %s,", parts[role],
                        range_text(range, sizeof range, low, high));
    }
    pp_page_say(text, room, "%s ground %.3g.", sentence, light->ground_reflectance);
    say_decorations(text, room, world);
}

static struct pp_box lay_page(struct pp_canvas *canvas, const struct pp_style *style,
                              const struct pp_page *page, bool drawn)
{
    struct pp_box (*put)(cairo_t *, const struct pp_style *,
                         const struct pp_lettering *, double, double, const char *) =
        drawn ? pp_lettering_draw : pp_lettering_measure;
    cairo_t *cr = pp_canvas_cairo(canvas);
    double margin = style->margin;
    double width = pp_canvas_width_mm(canvas) - 2.0 * margin;
    double top = margin, bottom = pp_canvas_height_mm(canvas) - margin;
    const char *imprint = pp_canvas_imprint(canvas);
    if (*imprint && drawn) {
        struct pp_lettering small = {.size = PP_TEXT_SMALL,
                                     .grey = PP_GREY_LINE,
                                     .across = 1.0,
                                     .width = width,
                                     .lines = 1};
        pp_lettering_draw(cr, style, &small, margin + width,
                          bottom + 0.5 * style->text[PP_TEXT_SMALL], imprint);
    }

    double block = pp_title_block_draw(cr, style, pp_canvas_project(canvas), margin,
                                       bottom - 0.5 * style->scale, width, drawn);
    bottom -= block > 0.0 ? block + 2.0 * style->scale : 0.0;

    if (page->title) {
        /* A long name is set in smaller type, on up to four lines. */
        struct pp_lettering title = {
            .size = PP_TEXT_TITLE, .bold = true, .width = width};
        if (pp_lettering_measure(cr, style, &title, 0, 0, page->title).height
            > 2.7 * style->text[PP_TEXT_TITLE]) {
            title.size = PP_TEXT_HEAD;
            title.lines = 4;
        }
        top += put(cr, style, &title, margin, top, page->title).height;
        top += 0.6 * style->scale;
    }
    if (page->subtitle) {
        struct pp_lettering subtitle = {
            .size = PP_TEXT_HEAD, .grey = PP_GREY_TEXT, .width = width, .lines = 3};
        top += put(cr, style, &subtitle, margin, top, page->subtitle).height;
    }
    if (page->foot && *page->foot) {
        int lines = (int)(0.22 * pp_canvas_height_mm(canvas)
                          / (1.25 * style->text[PP_TEXT_SMALL]));
        struct pp_lettering foot = {.size = PP_TEXT_SMALL,
                                    .grey = PP_GREY_TEXT,
                                    .down = 1.0,
                                    .width = width,
                                    .lines = lines};
        bottom -= put(cr, style, &foot, margin, bottom, page->foot).height;
        bottom -= 1.2 * style->scale;
        pp_style_line(cr, style->hair, PP_GREY_LINE);
        cairo_move_to(cr, margin, bottom);
        cairo_line_to(cr, margin + width, bottom);
        if (drawn)
            cairo_stroke(cr);
        else
            cairo_new_path(cr);
    }
    double gap = 4.0 * style->scale;
    return (struct pp_box){margin, top + gap, width, bottom - top - 2.0 * gap};
}

struct pp_box pp_page_draw(struct pp_canvas *canvas, const struct pp_style *style,
                           const struct pp_page *page)
{
    return lay_page(canvas, style, page, true);
}

struct pp_box pp_page_measure(struct pp_canvas *canvas, const struct pp_style *style,
                              const struct pp_page *page)
{
    return lay_page(canvas, style, page, false);
}
