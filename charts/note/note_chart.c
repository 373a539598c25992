/* note_chart.c - lays out a note: a column of lines, which breaks between steps, and a
 * margin with drawings, on as many sheets as needed. */
#include "charts/note/note_chart.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/note/formula_markup.h"
#include "charts/note/note_drawings.h"
#include "charts/room/room_words.h"
#include "charts/sheet/page.h"
#include "model/base/text.h"
#include "model/results/step_text.h"

enum { OPENINGS_MOST = 64, LINE_BYTES = 4096 };

struct note_drawing {
    struct pp_canvas *canvas;
    cairo_t *cr;
    struct pp_style style;
    const struct pp_note_chart *note;
    struct pp_box lines, margin; /* areas of this sheet */
    double y, margin_y;          /* y of the next line and of the next drawing */
    int sheet;                   /* number of the sheet, from 1 */
    bool shown[OPENINGS_MOST];   /* true for openings already drawn */
    enum pp_status status;
    struct pp_error *err;
};

/* ---- sheets ---- */

/* Draws the title and sets the columns below it, for lines and for drawings. */
static void begin_sheet(struct note_drawing *drawing)
{
    const struct pp_report *report = drawing->note->report;
    struct pp_vec3 point = report->receivers[0].position;
    char subtitle[256], sky[96], foot[1024] = "";
    pp_page_sky(sky, sizeof sky, report->world, &report->light);
    snprintf(subtitle, sizeof subtitle,
             "Note on daylight at x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, %s, "
             "sheet %d",
             point.x, point.y, point.z, sky, ++drawing->sheet);
    if (drawing->sheet == 1)
        pp_page_assumptions(foot, sizeof foot, report->world, &report->light);
    const struct pp_page page = {report->world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(drawing->canvas, &drawing->style, &page);
    double gap = 5.0 * drawing->style.scale, margin = 0.32 * body.width;
    drawing->lines =
        (struct pp_box){body.x, body.y, body.width - margin - gap, body.height};
    drawing->margin =
        (struct pp_box){body.x + body.width - margin, body.y, margin, body.height};
    drawing->y = drawing->margin_y = body.y;
    pp_style_line(drawing->cr, drawing->style.hair, PP_GREY_LINE);
    cairo_move_to(drawing->cr, drawing->margin.x - 0.5 * gap, body.y);
    cairo_line_to(drawing->cr, drawing->margin.x - 0.5 * gap, body.y + body.height);
    cairo_stroke(drawing->cr);
}

/* Begins a new sheet unless `height` (mm) is left on the current sheet, or the current
 * sheet has no lines yet. */
static void need(struct note_drawing *drawing, double height)
{
    double left = drawing->lines.y + drawing->lines.height - drawing->y;
    if (drawing->status != PP_OK || height <= left
        || drawing->y <= drawing->lines.y + 1e-9)
        return;
    if (!pp_canvas_has_sheets(drawing->canvas)) {
        drawing->status = pp_fail(
            drawing->err, PP_BAD_INPUT,
            "the note needs several sheets, but only a PDF can hold several; "
            "expected -o FILE.pdf, fewer methods in --methods, or a larger --paper");
        return;
    }
    drawing->status = pp_canvas_next_sheet(drawing->canvas, drawing->err);
    if (drawing->status == PP_OK)
        begin_sheet(drawing);
}

/* ---- lines ---- */

/* Style and indents of a line. */
struct note_line {
    struct pp_lettering set;
    double in; /* indent from the column's left edge */
    double to; /* space at the right edge of the column, left free for the value */
};

/* Places text at the current height without advancing. If `drawn` is false, only
 * measures. Returns the height of the text. */
static double put_note_words(struct note_drawing *drawing, struct note_line line,
                             const char *words, bool drawn)
{
    line.set.width = drawing->lines.width - line.in - line.to;
    return (drawn ? pp_lettering_draw
                  : pp_lettering_measure)(drawing->cr, &drawing->style, &line.set,
                                          drawing->lines.x + line.in, drawing->y, words)
        .height;
}

static void put_paragraph(struct note_drawing *drawing, struct note_line line,
                          const char *words)
{
    need(drawing, put_note_words(drawing, line, words, false));
    if (drawing->status == PP_OK)
        drawing->y +=
            put_note_words(drawing, line, words, true) + 0.3 * drawing->style.scale;
}

static double step_in(const struct note_drawing *drawing)
{
    return 3.0 * drawing->style.scale;
}

/* Width of the values at the right of the column. */
static double value_width(const struct note_drawing *drawing)
{
    return 20.0 * drawing->style.scale;
}

/* Places a figure at the right edge of the column. */
static void put_figure(struct note_drawing *drawing, const char *figure, bool bold)
{
    const struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = bold, .across = 1.0};
    pp_lettering_draw(drawing->cr, &drawing->style, &set,
                      drawing->lines.x + drawing->lines.width, drawing->y, figure);
}

/* Places a step: formula, inserted values, and the result with its name. For a number
 * that was read from a table or chart, places its symbol, name and value. If `drawn` is
 * false, only measures. Returns the height. */
static double put_step(struct note_drawing *drawing, const struct pp_steps *steps,
                       int index, bool drawn)
{
    const struct pp_calculation_step *step = &steps->list[index];
    double top = drawing->y, symbol = 15.0 * drawing->style.scale;
    double size = drawing->style.text[PP_TEXT_BODY];
    char plain[LINE_BYTES], markup[2 * LINE_BYTES] = "", figure[64];
    struct note_line line = {
        {.size = PP_TEXT_BODY, .markup = true}, step_in(drawing), 0};
    if (step->formula[0]) {
        pp_step_text_formula(plain, sizeof plain, step, true);
        pp_formula_markup(markup, sizeof markup, plain, size);
        drawing->y += put_note_words(drawing, line, markup, drawn);
        pp_step_text_put_in(plain, sizeof plain, steps, index);
        markup[0] = '\0';
        pp_text_append(markup, sizeof markup, "= ");
        pp_formula_markup(markup, sizeof markup, plain, size);
        line.in += 3.0 * drawing->style.scale;
        if (plain[0])
            drawing->y += put_note_words(drawing, line, markup, drawn);
    } else if (step->symbol[0]) {
        plain[0] = '\0';
        pp_step_text_add(plain, sizeof plain, step->symbol, (int)strlen(step->symbol),
                         true);
        pp_formula_markup(markup, sizeof markup, plain, size);
        put_note_words(drawing, line, markup, drawn);
        line.in += symbol;
    }
    const char *unit = pp_step_text_value(figure, sizeof figure - 8, step, true);
    pp_text_append(figure, sizeof figure, "%s", unit);
    line.to = value_width(drawing);
    line.set.markup = false;
    line.set.grey = step->formula[0] ? PP_GREY_TEXT : PP_INK;
    if (drawn)
        put_figure(drawing, figure, step->formula[0]);
    drawing->y += put_note_words(drawing, line, step->what, drawn);
    double height = drawing->y - top + 0.7 * drawing->style.scale;
    drawing->y = top;
    return height;
}

/* ---- headings ---- */

static void put_rule(struct note_drawing *drawing)
{
    pp_style_line(drawing->cr, drawing->style.thin, PP_INK);
    cairo_move_to(drawing->cr, drawing->lines.x, drawing->y);
    cairo_line_to(drawing->cr, drawing->lines.x + drawing->lines.width, drawing->y);
    cairo_stroke(drawing->cr);
    drawing->y += 0.6 * drawing->style.scale;
}

/* Writes a heading. Begins a new sheet if the current sheet has less than `below` mm
 * left below the heading. */
static void put_heading(struct note_drawing *drawing, const char *words, double below)
{
    const struct note_line line = {{.size = PP_TEXT_HEAD, .bold = true}, 0.0, 0.0};
    double gap = drawing->y > drawing->lines.y ? 2.5 * drawing->style.scale : 0.0;
    need(drawing, gap + put_note_words(drawing, line, words, false) + below
                      + 2.0 * drawing->style.scale);
    if (drawing->status != PP_OK)
        return;
    drawing->y += drawing->y > drawing->lines.y ? gap : 0.0;
    put_rule(drawing);
    drawing->y +=
        put_note_words(drawing, line, words, true) + 0.5 * drawing->style.scale;
}

/* Draws the wall of an opening in the margin, once for each opening, if there is space
 * beside the lines about the opening. */
static void show_opening(struct note_drawing *drawing, int line)
{
    const struct pp_report *report = drawing->note->report;
    for (int i = 0; i < report->world->opening_count && i < OPENINGS_MOST; i++) {
        if (report->world->openings[i].line != line || drawing->shown[i])
            continue;
        double top = fmax(drawing->margin_y, drawing->y);
        struct pp_box box = {drawing->margin.x, top, drawing->margin.width,
                             drawing->margin.width};
        double height = pp_note_drawings_opening(drawing->cr, &drawing->style, report,
                                                 i, box, false);
        if (top + height > drawing->margin.y + drawing->margin.height)
            continue;
        pp_note_drawings_opening(drawing->cr, &drawing->style, report, i, box, true);
        drawing->margin_y = top + height + 4.0 * drawing->style.scale;
        drawing->shown[i] = true;
    }
}

static void put_opening(struct note_drawing *drawing, int line, double below)
{
    const struct note_line set = {{.size = PP_TEXT_BODY, .italic = true}, 0.0, 0.0};
    char words[64];
    const char *label = pp_world_label(drawing->note->report->world, line);
    snprintf(words, sizeof words, line ? "Window %s" : "All windows", label);
    need(drawing, put_note_words(drawing, set, words, false) + below);
    if (drawing->status != PP_OK)
        return;
    if (line)
        show_opening(drawing, line);
    drawing->y +=
        put_note_words(drawing, set, words, true) + 0.5 * drawing->style.scale;
}

/* ---- parts ---- */

static const char *const components[PP_COMPONENT_COUNT] = {
    [PP_SC] = "Direct component",
    [PP_ERC] = "Externally reflected component",
    [PP_IRC] = "Internally reflected component",
    [PP_DF] = "Daylight factor",
};

static const struct pp_reading *note_reading(const struct pp_column *column)
{
    return column->points ? column->points : &column->average;
}

static void put_part(struct note_drawing *drawing, int index)
{
    const struct pp_column *column = &drawing->note->report->columns[index];
    const struct pp_steps *steps = note_reading(column)->steps;
    const struct note_line small = {
        {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT}, 0, 0};
    char words[160];
    if (!steps || steps->count == 0)
        return;
    double first = put_step(drawing, steps, 0, false);
    snprintf(words, sizeof words, "%s by %.48s%s", components[column->component],
             column->name, column->points ? "" : ", of the room");
    put_heading(drawing, words, first + 6.0 * drawing->style.text[PP_TEXT_BODY]);
    if (drawing->note->contents[index][0])
        put_paragraph(drawing, small, drawing->note->contents[index]);
    int line = 0;
    for (int i = 0; i < steps->count && drawing->status == PP_OK; i++) {
        double height = put_step(drawing, steps, i, false);
        if (steps->list[i].line != line)
            put_opening(drawing, steps->list[i].line, height);
        line = steps->list[i].line;
        need(drawing, height);
        if (drawing->status == PP_OK)
            drawing->y += put_step(drawing, steps, i, true);
    }
}

static void put_given(struct note_drawing *drawing)
{
    const struct pp_report *report = drawing->note->report;
    const struct pp_world *world = report->world;
    const struct note_line line = {{.size = PP_TEXT_BODY}, step_in(drawing), 0.0};
    struct pp_vec3 point = report->receivers[0].position;
    char words[2048] = "Room:";
    put_heading(drawing, "Given", 8.0 * drawing->style.text[PP_TEXT_BODY]);
    pp_room_words_size(words, sizeof words, world);
    put_paragraph(drawing, line, words);
    for (int i = 0; i < world->opening_count && drawing->status == PP_OK; i++) {
        snprintf(words, sizeof words, "Window %s:", world->openings[i].label);
        pp_room_words_opening(words, sizeof words, world, i);
        put_paragraph(drawing, line, words);
    }
    words[0] = '\0';
    pp_room_words_outside(words, sizeof words, world);
    if (words[0])
        put_paragraph(drawing, line, words);
    snprintf(words, sizeof words,
             "Calculated: the daylight factor at x\u00a0%.2f, y\u00a0%.2f, "
             "z\u00a0%.2f\u00a0m.",
             point.x, point.y, point.z);
    put_paragraph(drawing, line, words);
}

/* Places the value of each column, or the reason why there is none. */
static void put_results(struct note_drawing *drawing)
{
    static const char *const names[PP_COMPONENT_COUNT] = {
        [PP_SC] = "Sky component",
        [PP_ERC] = "Externally reflected component",
        [PP_IRC] = "Internally reflected component",
        [PP_DF] = "Daylight factor",
    };
    const struct pp_report *report = drawing->note->report;
    const struct note_line line = {
        {.size = PP_TEXT_BODY}, step_in(drawing), value_width(drawing)};
    put_heading(drawing, "Result", 3.0 * drawing->style.text[PP_TEXT_BODY]);
    for (int i = 0; i < report->column_count && drawing->status == PP_OK; i++) {
        const struct pp_column *column = &report->columns[i];
        const struct pp_reading *reading = note_reading(column);
        char words[512], figure[32] = "\u2013";
        snprintf(words, sizeof words, "%s by %.48s%s%s%.200s", names[column->component],
                 column->name, column->points ? "" : ", of the room",
                 reading->why ? ": " : "", reading->why ? reading->why : "");
        if (isfinite(reading->value))
            snprintf(figure, sizeof figure, "%.2f\u00a0%%",
                     100.0 * reading->value + 0.0);
        double height = put_note_words(drawing, line, words, false);
        need(drawing, height);
        if (drawing->status != PP_OK)
            return;
        put_figure(drawing, figure, column->component == PP_DF);
        put_note_words(drawing, line, words, true);
        drawing->y += height + 0.3 * drawing->style.scale;
    }
}

static void put_list(struct note_drawing *drawing, const char *heading,
                     const char *const *list, int count)
{
    const struct note_line line = {
        {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT}, step_in(drawing), 0.0};
    if (count == 0)
        return;
    put_heading(drawing, heading, 3.0 * drawing->style.text[PP_TEXT_BODY]);
    for (int i = 0; i < count && drawing->status == PP_OK; i++)
        put_paragraph(drawing, line, list[i]);
}

enum pp_status pp_note_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_note_chart *note,
                                  struct pp_error *err)
{
    struct note_drawing drawing = {.canvas = canvas,
                                   .cr = pp_canvas_cairo(canvas),
                                   .style = pp_page_style(canvas),
                                   .note = note,
                                   .err = err};
    double used;
    begin_sheet(&drawing);
    drawing.status = pp_note_drawings_room(&used, drawing.cr, &drawing.style,
                                           note->report, drawing.margin, err);
    if (drawing.status != PP_OK)
        return drawing.status;
    drawing.margin_y += used;
    put_given(&drawing);
    for (int i = 0; i < note->report->column_count && drawing.status == PP_OK; i++)
        put_part(&drawing, i);
    if (drawing.status == PP_OK)
        put_results(&drawing);
    if (drawing.status == PP_OK)
        put_list(&drawing, "Notes", note->notes, note->note_count);
    if (drawing.status == PP_OK)
        put_list(&drawing, "Sources", note->sources, note->source_count);
    return drawing.status;
}
