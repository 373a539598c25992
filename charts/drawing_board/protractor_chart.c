/* protractor_chart.c - draws a single protractor as large as the sheet allows. */
#include "charts/drawing_board/protractor_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/drawing_board/board.h"
#include "charts/sheet/page.h"
#include "charts/drawing_board/protractor_disc.h"
#include "charts/drawing_board/protractor_worked.h"

/* Height reserved for notes and ruler (mm). */
static double taken_mm(const struct pp_style *style)
{
    return 50.0 * style->scale;
}

double pp_protractor_chart_radius_mm(const struct pp_canvas *canvas)
{
    struct pp_style style = pp_page_style(canvas);
    double border = 2.0 * (style.margin + pp_protractor_disc_border(&style));
    double most = fmin(pp_canvas_width_mm(canvas) - border,
                       pp_canvas_height_mm(canvas) - border - taken_mm(&style))
                  / 2.0;
    return 5.0 * floor(most / 5.0);
}

double pp_protractor_chart_arc_mm(const struct pp_canvas *canvas, bool worked)
{
    struct pp_style style = pp_page_style(canvas);
    return pp_protractor_disc_arc(&style, worked
                                              ? pp_protractor_worked_radius_mm(canvas)
                                              : pp_protractor_chart_radius_mm(canvas));
}

static void say_protractor_foot(char *foot, size_t room,
                                const struct pp_protractor_scale *scale, double radius)
{
    pp_page_say(foot, room,
                "Radius %.0f\u00a0mm. The protractor measures angles, so it fits "
                "drawings at any scale, such as 1:50 or 1:100.",
                radius);
    pp_page_say(foot, room,
                "On the section, place the centre on the point, with the base line "
                "horizontal. The scale shows, in per cent, the sky component of an "
                "infinitely long opening up to the sight line; the total is %.1f.",
                100.0 * scale->whole);
    if (scale->range_rad > PP_PI / 2.0 + 1e-6)
        pp_page_say(foot, room,
                    "Turn the protractor over for an opening on the other side.");
    if (!scale->turned_down)
        pp_page_say(foot, room,
                    "On the plan, read the correction factor at both jambs, on the "
                    "semicircle of the average altitude.");
    else
        pp_page_say(foot, room,
                    "On the plan in the plane of the average sight line (x and slant "
                    "distance), read the correction factor at both jambs, on the "
                    "semicircle of the average altitude.");
    if (scale->symmetric)
        pp_page_say(
            foot, room,
            "For average altitudes over 90\u00b0, use 180\u00b0 minus the altitude.");
    pp_page_say(
        foot, room,
        "Add the two factors if the jambs are on both sides of the normal; subtract "
        "the smaller if they are on one side. Dirt and frame are not included.");
    pp_page_say(
        foot, room,
        scale->number
            ? "Scales calculated by integration, after BRE Digest 309, 1986."
            : "Scales calculated by integration, following BRE Digest 309, 1986.");
}

static double write_line(cairo_t *cr, const struct pp_style *style,
                         enum pp_text_size size, bool bold, double x, double y,
                         double width, const char *words)
{
    const struct pp_lettering set = {.size = size,
                                     .bold = bold,
                                     .across = 0.5,
                                     .down = 0.0,
                                     .width = width,
                                     .lines = 2};
    return y + pp_lettering_draw(cr, style, &set, x, y, words).height;
}

/* Writes the protractor's name on the disc, since the disc may be cut out. */
static void write_name(cairo_t *cr, const struct pp_style *style,
                       const struct pp_protractor_disc *disc)
{
    const struct pp_protractor_scale *scale = disc->scale;
    double end = scale->range_rad > PP_PI / 2.0 + 1e-6 ? scale->range_rad : PP_PI;
    double x = disc->x - 0.5 * disc->radius * cos(end / 2.0);
    double y = disc->y - 0.58 * disc->radius, width = 0.3 * disc->radius * end;
    char words[64] = "Daylight protractor";
    if (scale->number)
        snprintf(words, sizeof words, "Daylight protractor %d", scale->number);
    y = write_line(cr, style, PP_TEXT_HEAD, true, x, y, width, words);
    y = write_line(cr, style, PP_TEXT_BODY, false, x, y, width, scale->sky);
    y = write_line(cr, style, PP_TEXT_BODY, false, x, y, width, scale->glass);
    write_line(cr, style, PP_TEXT_SMALL, false, x, y + 1.5 * style->scale, width,
               "on the section: sky component, per cent");
}

enum pp_status pp_protractor_chart_draw(struct pp_canvas *canvas,
                                        const struct pp_protractor_sheet *sheet,
                                        struct pp_error *err)
{
    (void)err;
    cairo_t *cr = pp_canvas_cairo(canvas);
    struct pp_style style = pp_page_style(canvas);
    const struct pp_protractor_scale *scale = &sheet->scale;
    double radius = pp_protractor_chart_radius_mm(canvas);
    char foot[1200] = "";
    say_protractor_foot(foot, sizeof foot, scale, radius);
    const struct pp_page page = {.foot = foot}; /* the name is on the disc */
    struct pp_box box = pp_page_draw(canvas, &style, &page);

    double ruler = pp_board_ruler_height(&style);
    pp_board_ruler(cr, &style, box.x, box.y + box.height - ruler);
    box.height -= ruler + 2.0 * style.scale;
    const struct pp_protractor_disc disc = {.scale = scale,
                                            .x = box.x + box.width / 2.0,
                                            .y = box.y + box.height / 2.0,
                                            .radius = radius,
                                            .plan = {0.0, 1.0}};
    pp_protractor_disc_primary(cr, &style, &disc, true);
    pp_protractor_disc_auxiliary(cr, &style, &disc, true);
    write_name(cr, &style, &disc);
    return PP_OK;
}
