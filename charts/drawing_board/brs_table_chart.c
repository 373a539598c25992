/* brs_table_chart.c - draws rules and figures of the table, numbers the places that are
 * read, and lists the readings and their sum below. */
#include "charts/drawing_board/brs_table_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "charts/sheet/page.h"
#include "charts/sheet/labels.h"
#include "model/base/text.h"

/* Maximum number of readings that are numbered and listed. A window has up to four
 * readings, and each obstruction up to four more. */
enum { READINGS_MOST = 36, LIST_COLUMNS = 2, TEXT_BYTES = 4096 };

struct table_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_brs_sheet *sheet;
    struct pp_box box; /* box of the table, including row and column heads */
    double cell[2];    /* width and height of a figure's cell */
    double corner[2];  /* upper left corner of the first figure's cell */
    struct pp_labels *labels;
};

/* ---- the table ---- */

/* Centre of the cell in a column and row, which may be fractional. */
static double middle_x(const struct table_drawing *drawing, double column)
{
    return drawing->corner[0] + (column + 0.5) * drawing->cell[0];
}

static double middle_y(const struct table_drawing *drawing, double row)
{
    return drawing->corner[1] + (row + 0.5) * drawing->cell[1];
}

static void put_table_words(const struct table_drawing *drawing, double x, double y,
                            bool bold, const char *words)
{
    struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .bold = bold, .across = 0.5, .down = 0.5};
    struct pp_style style = drawing->style;
    /* Limits the type size, so that figures of four digits fit into their cells on
     * small paper. */
    style.text[PP_TEXT_SMALL] =
        fmin(style.text[PP_TEXT_SMALL],
             fmin(0.36 * drawing->cell[0], 0.62 * drawing->cell[1]));
    pp_lettering_draw(drawing->cr, &style, &set, x, y, words);
}

static void write_ratio(char text[16], double ratio, int decimals)
{
    if (isinf(ratio))
        snprintf(text, 16, "\u221e");
    else
        snprintf(text, 16, "%.*f", decimals, ratio);
}

static void draw_figures(const struct table_drawing *drawing)
{
    const struct pp_brs_sheet *sheet = drawing->sheet;
    char text[16];
    for (int k = 0; k < PP_BRS_COLUMNS; k++) {
        write_ratio(text, sheet->w_over_d[k], 1);
        put_table_words(drawing, middle_x(drawing, k), middle_y(drawing, -1.0), true,
                        text);
    }
    for (int i = 0; i < PP_BRS_ROWS; i++) {
        write_ratio(text, sheet->h_over_d[i], 1);
        put_table_words(drawing, middle_x(drawing, -1.0), middle_y(drawing, i), true,
                        text);
        for (int k = 0; k < PP_BRS_COLUMNS; k++) {
            double percent = sheet->percent[i][k];
            snprintf(text, sizeof text, "%.*f%s", percent < 1.0 ? 2 : 1, percent,
                     sheet->odd[i][k] ? "*" : "");
            put_table_words(drawing, middle_x(drawing, k), middle_y(drawing, i), false,
                            text);
        }
    }
}

/* Draws a frame, a rule below the column heads, a rule beside the row heads, and a thin
 * rule at every fifth row. */
static void draw_rules(const struct table_drawing *drawing)
{
    cairo_t *cr = drawing->cr;
    const struct pp_box *box = &drawing->box;
    double right = box->x + box->width, bottom = box->y + box->height;
    pp_style_line(cr, drawing->style.hair, PP_GREY_LINE);
    for (int i = 1; i < PP_BRS_ROWS; i++) {
        double y = drawing->corner[1] + i * drawing->cell[1];
        if (i % 5)
            continue;
        cairo_move_to(cr, box->x, y);
        cairo_line_to(cr, right, y);
    }
    cairo_stroke(cr);
    pp_style_line(cr, drawing->style.medium, PP_INK);
    cairo_move_to(cr, box->x, drawing->corner[1]);
    cairo_line_to(cr, right, drawing->corner[1]);
    cairo_move_to(cr, drawing->corner[0], box->y);
    cairo_line_to(cr, drawing->corner[0], bottom);
    cairo_rectangle(cr, box->x, box->y, box->width, box->height);
    cairo_stroke(cr);
}

static void name_heads(const struct table_drawing *drawing)
{
    const struct pp_box *box = &drawing->box;
    put_table_words(drawing,
                    drawing->corner[0] + 0.5 * PP_BRS_COLUMNS * drawing->cell[0],
                    middle_y(drawing, -2.0), false,
                    "w/d: width of the window on one side of the normal, divided by "
                    "the distance to the window");
    put_table_words(drawing, 0.5 * (box->x + drawing->corner[0]),
                    middle_y(drawing, -1.0), true, "h/d");
}

/* ---- readings ---- */

/* Tints the cells between which a reading is interpolated. */
static void tint_cells(const struct table_drawing *drawing,
                       const struct pp_brs_reading *reading)
{
    double first = fmax(floor(reading->column + 1e-9), 0.0),
           last = fmax(ceil(reading->column - 1e-9), 0.0);
    double top = fmin(floor(reading->row + 1e-9), PP_BRS_ROWS - 1),
           low = fmin(ceil(reading->row - 1e-9), PP_BRS_ROWS - 1);
    cairo_rectangle(drawing->cr, drawing->corner[0] + first * drawing->cell[0],
                    drawing->corner[1] + top * drawing->cell[1],
                    (last - first + 1.0) * drawing->cell[0],
                    (low - top + 1.0) * drawing->cell[1]);
    pp_style_grey(drawing->cr, PP_GREY_FILL);
    cairo_fill(drawing->cr);
}

static void mark(const struct table_drawing *drawing,
                 const struct pp_brs_reading *reading)
{
    double x = middle_x(drawing, reading->column), y = middle_y(drawing, reading->row);
    double arm = 0.9 * drawing->style.scale;
    cairo_move_to(drawing->cr, x - arm, y);
    cairo_line_to(drawing->cr, x + arm, y);
    cairo_move_to(drawing->cr, x, y - arm);
    cairo_line_to(drawing->cr, x, y + arm);
    pp_style_line(drawing->cr, drawing->style.medium, PP_INK);
    cairo_stroke(drawing->cr);
}

/* True if no earlier reading is at the same place. Readings at the same place share a
 * number. */
static bool is_first_there(const struct pp_brs_sheet *sheet, int index)
{
    const struct pp_brs_reading *reading = &sheet->readings[index];
    for (int i = 0; i < index; i++)
        if (fabs(sheet->readings[i].row - reading->row) < 1e-9
            && fabs(sheet->readings[i].column - reading->column) < 1e-9)
            return false;
    return true;
}

static int brs_column_number(const struct pp_brs_sheet *sheet, int index)
{
    int number = 0, at = index;
    const struct pp_brs_reading *reading = &sheet->readings[index];
    for (int i = index; i >= 0; i--)
        if (fabs(sheet->readings[i].row - reading->row) < 1e-9
            && fabs(sheet->readings[i].column - reading->column) < 1e-9)
            at = i;
    for (int i = 0; i <= at; i++)
        number += is_first_there(sheet, i);
    return number;
}

/* Finds a position for a number beside the cross, as near as possible without covering
 * anything. If there is none, the number goes above the cross. */
static struct pp_box find_place(const struct table_drawing *drawing, double x, double y,
                                struct pp_box size)
{
    enum { RADII = 8, ANGLES = 16 };
    double step = 0.35 * drawing->style.text[PP_TEXT_SMALL];
    for (int i = 0; i < RADII * ANGLES; i++) {
        double radius = (i / ANGLES + 2.0) * step;
        double angle = (i % ANGLES + 0.5) * 2.0 * PP_PI / ANGLES;
        struct pp_box box = {x + radius * cos(angle) - 0.5 * size.width,
                             y - radius * sin(angle) - 0.5 * size.height, size.width,
                             size.height};
        if (pp_labels_is_free(drawing->labels, box))
            return box;
    }
    return (struct pp_box){x - 0.5 * size.width, y - 2.0 * step - size.height,
                           size.width, size.height};
}

static void put_number(const struct table_drawing *drawing,
                       const struct pp_brs_reading *reading, int number)
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = true};
    double x = middle_x(drawing, reading->column), y = middle_y(drawing, reading->row);
    char words[8];
    snprintf(words, sizeof words, "%d", number);
    struct pp_box size =
        pp_lettering_measure(drawing->cr, &drawing->style, &set, x, y, words);
    /* Digits have no descenders, so the box needs no space for them. */
    double below = 0.22 * size.height;
    size.height -= below;
    struct pp_box box = find_place(drawing, x, y, size);
    pp_lettering_draw(drawing->cr, &drawing->style, &set, box.x, box.y, words);
    pp_labels_note_box(drawing->labels, box);
}

static int listed(const struct pp_brs_sheet *sheet)
{
    return sheet->reading_count < READINGS_MOST ? sheet->reading_count : READINGS_MOST;
}

/* Marks the figures around a reading as occupied, so that no number covers them. */
static void note_figures(const struct table_drawing *drawing,
                         const struct pp_brs_reading *reading)
{
    double wide = 0.5 * drawing->cell[0], high = 0.36 * drawing->cell[1];
    int row = (int)floor(reading->row), column = (int)floor(reading->column);
    for (int i = row; i <= row + 1; i++)
        for (int k = column; k <= column + 1; k++)
            pp_labels_note_box(drawing->labels,
                               (struct pp_box){middle_x(drawing, k) - 0.5 * wide,
                                               middle_y(drawing, i) - 0.5 * high, wide,
                                               high});
}

static void mark_readings(const struct table_drawing *drawing)
{
    const struct pp_brs_sheet *sheet = drawing->sheet;
    for (int i = 0; i < listed(sheet); i++)
        if (is_first_there(sheet, i)) {
            double x = middle_x(drawing, sheet->readings[i].column);
            double y = middle_y(drawing, sheet->readings[i].row);
            mark(drawing, &sheet->readings[i]);
            pp_labels_note(drawing->labels, -1, x, y, x, y);
            note_figures(drawing, &sheet->readings[i]);
        }
    for (int i = 0; i < listed(sheet); i++)
        if (is_first_there(sheet, i))
            put_number(drawing, &sheet->readings[i], brs_column_number(sheet, i));
}

/* ---- words ---- */

/* Writes a reading, such as "1 W1, sky, head left: h/d 0.840, w/d 0.142: + 0.64 %". */
static void say_reading(char *text, size_t room, const struct pp_brs_sheet *sheet,
                        int index)
{
    const struct pp_brs_reading *reading = &sheet->readings[index];
    snprintf(text, room, "%d  %s, %s, %s %s: h/d %.3f, w/d %.3f: %s\u00a0%.2f\u00a0%%",
             brs_column_number(sheet, index), sheet->windows[reading->window].label,
             reading->hidden ? "obstruction" : "sky", reading->lower ? "foot" : "head",
             reading->left ? "left" : "right", reading->h_over_d, reading->w_over_d,
             reading->sign > 0 ? "+" : "\u2212", 100.0 * reading->value);
}

static void say_sums(char *text, size_t room, const struct pp_brs_sheet *sheet)
{
    enum { WINDOWS_MOST = 6 };
    *text = '\0';
    for (int i = 0; i < sheet->window_count && i < WINDOWS_MOST; i++) {
        const struct pp_brs_window *window = &sheet->windows[i];
        if (!(window->distance_m > 0.0)) {
            pp_page_say(text, room,
                        "%s: the point is behind the window or in its plane.",
                        window->label);
            continue;
        }
        pp_page_say(
            text, room,
            "%s, %.2f\u00a0m away: with glass, frame and dirt (\u00d7 %.3f), sky "
            "component %.2f\u00a0%%, externally reflected component %.2f\u00a0%%.",
            window->label, window->distance_m, window->allowance, 100.0 * window->sky,
            100.0 * window->external);
    }
    if (sheet->window_count > WINDOWS_MOST)
        pp_page_say(text, room, "Further windows, not listed: %d.",
                    sheet->window_count - WINDOWS_MOST);
    pp_page_say(text, room,
                "All windows together: sky component %.2f\u00a0%%, externally "
                "reflected component %.2f\u00a0%%.",
                100.0 * sheet->sky_component, 100.0 * sheet->external);
}

/* Draws the readings in columns, then the sums. If `drawn` is false, only measures.
 * Returns the height. */
static double draw_readings(const struct table_drawing *drawing, struct pp_box room,
                            bool drawn)
{
    const struct pp_brs_sheet *sheet = drawing->sheet;
    double line = 1.3 * drawing->style.text[PP_TEXT_SMALL];
    int count = listed(sheet), rows = (count + LIST_COLUMNS - 1) / LIST_COLUMNS;
    double wide = room.width / LIST_COLUMNS, height = rows * line;
    char text[TEXT_BYTES];
    for (int i = 0; i < count && drawn; i++) {
        const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                         .width = wide - 3.0 * drawing->style.scale,
                                         .lines = 1};
        say_reading(text, sizeof text, sheet, i);
        pp_lettering_draw(drawing->cr, &drawing->style, &set,
                          room.x + (i / rows) * wide, room.y + (i % rows) * line, text);
    }
    say_sums(text, sizeof text, sheet);
    if (count < sheet->reading_count)
        pp_page_say(text, sizeof text,
                    "The first %d readings are shown; the sums include %d more.", count,
                    sheet->reading_count - count);
    const struct pp_lettering set = {.size = PP_TEXT_BODY, .width = room.width};
    height += drawing->style.scale;
    return height
           + (drawn ? pp_lettering_draw : pp_lettering_measure)(
                 drawing->cr, &drawing->style, &set, room.x, room.y + height, text)
                 .height;
}

static void say_how(char *foot, size_t room, const struct pp_brs_sheet *sheet)
{
    pp_page_say(foot, room,
                "The table is for vertical windows with clear single glass, a CIE "
                "overcast sky and a horizontal plane at sill level. Dirt, frame and "
                "glazing bars are not included.");
    pp_page_say(foot, room,
                "h: head above the plane. d: distance from the point to the window. "
                "w: width on one side of the normal through the point. If the jambs "
                "are on both sides, add both readings. If both are on one side, "
                "subtract the smaller reading from the larger. For a sill above the "
                "plane, subtract the reading for the sill. For an obstruction, "
                "subtract the reading for its top. The externally reflected "
                "component is the hidden sky component times the luminance factor of "
                "the obstruction (0.2).");
    pp_page_say(foot, room,
                "Interpolate linearly between cells. Beyond the last finite row or "
                "column, scale in proportion to d/h or d/w. For values below 0.1, "
                "scale linearly to zero.");
    pp_page_say(
        foot, room,
        "Hopkinson, Longmore and Graham, Simplified daylight tables, HMSO, London, "
        "1958 [HLG58], as printed. Cells marked * are irregular in the original.");
    if (!sheet->blank)
        pp_page_say(foot, room, "Crosses in tinted cells mark the readings.");
}

static void brs_table_titles(const struct pp_brs_sheet *sheet, char *title,
                             char *subtitle, size_t room)
{
    snprintf(title, room, "%s",
             sheet->name ? sheet->name : "BRS simplified daylight table");
    if (sheet->blank)
        snprintf(subtitle, room, "Sky component (%%) of a window, CIE overcast sky");
    else
        snprintf(subtitle, room,
                 "BRS simplified daylight table with the readings for x\u00a0%.2f, "
                 "y\u00a0%.2f, z\u00a0%.2f\u00a0m, CIE overcast sky",
                 sheet->point.x, sheet->point.y, sheet->point.z);
}

/* Fits the table into the box. Besides the figures, the table has a row and a column of
 * heads. The name of the column heads is on a line above the table, that of the row
 * heads in the corner cell. */
static void lay_table(struct table_drawing *drawing, struct pp_box box)
{
    double name = 1.0, heads = 1.0;
    drawing->cell[0] = box.width / (PP_BRS_COLUMNS + heads);
    drawing->cell[1] =
        fmin(box.height / (PP_BRS_ROWS + heads + name), 0.95 * drawing->cell[0]);
    drawing->corner[0] = box.x + drawing->cell[0];
    drawing->corner[1] = box.y + 2.0 * drawing->cell[1];
    drawing->box = (struct pp_box){box.x, box.y + drawing->cell[1], box.width,
                                   (PP_BRS_ROWS + heads) * drawing->cell[1]};
}

enum pp_status pp_brs_table_chart_draw(struct pp_canvas *canvas,
                                       const struct pp_brs_sheet *sheet,
                                       struct pp_error *err)
{
    struct pp_labels *labels = calloc(1, sizeof *labels);
    if (!labels)
        return pp_fail_memory(err);
    struct table_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                    .style = pp_page_style(canvas),
                                    .sheet = sheet,
                                    .labels = labels};
    char title[512], subtitle[512], foot[2048] = "";
    brs_table_titles(sheet, title, subtitle, sizeof title);
    say_how(foot, sizeof foot, sheet);
    const struct pp_page page = {title, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing.style, &page);
    double below =
        sheet->blank ? 0.0
                     : draw_readings(&drawing, body, false) + 3.0 * drawing.style.scale;
    struct pp_box room = body;
    room.height -= below;
    lay_table(&drawing, room);
    labels->field = drawing.box;
    for (int i = 0; i < listed(sheet); i++)
        tint_cells(&drawing, &sheet->readings[i]);
    draw_rules(&drawing);
    draw_figures(&drawing);
    name_heads(&drawing);
    mark_readings(&drawing);
    body.y = drawing.box.y + drawing.box.height + 3.0 * drawing.style.scale;
    if (!sheet->blank)
        draw_readings(&drawing, body, true);
    free(labels);
    return PP_OK;
}
