/* nomogram_sheet_fill.c - adds the marks of the scales, stretch by stretch, and the
 * readings for the openings of a room. Equal readings are added only once. */
#include "methods/nomogram/nomogram_sheet_fill.h"

#include <math.h>
#include <stdlib.h>

#include "methods/method.h"
#include "methods/nomogram/nomogram_position.h"
#include "methods/nomogram/nomogram_reading.h"
#include "methods/nomogram/nomogram_scale.h"
#include "methods/refusals.h"

/* ---- marks ---- */

/* True if the number is a multiple of the step. */
static bool multiple(double number, double step)
{
    return fabs(number / step - rint(number / step)) < 1e-6;
}

/* Adds the marks of the stretch that begins at `number`. *numbered: the y of the last
 * numbered mark. */
static void add_stretch(struct pp_nomogram_scale *scale,
                        const struct pp_nomogram *nomogram, int stem, double number,
                        struct pp_nomogram_spacing spacing, double stretch[2],
                        double *numbered)
{
    double height = spacing.height_mm;
    double unit = pp_nomogram_scale_printed_unit(nomogram->stems[stem].quantity);
    double label = pp_nomogram_scale_division(nomogram, stem, number, height,
                                              spacing.number_mm, stretch);
    double middle = pp_nomogram_scale_division(nomogram, stem, number, height,
                                               3.5 * spacing.fine_mm, stretch);
    double fine = pp_nomogram_scale_division(nomogram, stem, number, height,
                                             spacing.fine_mm, stretch);
    int count = (int)rint((stretch[1] - stretch[0]) / fine);
    for (int i = 0; i <= count; i++) {
        double at = stretch[0] + i * fine;
        bool held =
            pp_nomogram_scale_contains(nomogram, stem, at / unit * (1.0 + 1e-9))
            || pp_nomogram_scale_contains(nomogram, stem, at / unit * (1.0 - 1e-9));
        /* The last mark of a stretch is added as the first of the next. */
        bool next =
            i == count
            && pp_nomogram_scale_contains(nomogram, stem, at / unit * (1.0 + 1e-6));
        if (!held || next)
            continue;
        struct pp_nomogram_mark mark = {
            .y = pp_nomogram_scale_position(nomogram, stem, at / unit), .number = at};
        bool bold = i == 0 || i == count;
        if (multiple(at, middle) || bold)
            mark.rank = PP_MARK_MIDDLE;
        if ((multiple(at, label) || bold)
            && !(fabs(mark.y - *numbered) * height < 0.75 * spacing.number_mm)) {
            mark.rank = PP_MARK_LABELLED;
            *numbered = mark.y;
        }
        scale->marks[scale->count++] = mark;
    }
}

enum { MARKS_MOST = 4000 };

static enum pp_status make_marks(struct pp_nomogram_sheet *sheet,
                                 struct pp_nomogram_spacing spacing,
                                 struct pp_error *err)
{
    const struct pp_nomogram *nomogram = &sheet->nomogram;
    for (int stem = 0; stem < nomogram->stem_count; stem++) {
        struct pp_nomogram_scale *scale = &sheet->scales[stem];
        double unit = pp_nomogram_scale_printed_unit(nomogram->stems[stem].quantity);
        double high = unit * nomogram->stems[stem].high;
        scale->marks = calloc(MARKS_MOST, sizeof *scale->marks);
        if (!scale->marks)
            return pp_fail_memory(err);
        double number = unit * nomogram->stems[stem].low, stretch[2], numbered = NAN;
        while (number < high * (1.0 - 1e-6)) {
            add_stretch(scale, nomogram, stem, number, spacing, stretch, &numbered);
            number = stretch[1];
        }
    }
    return PP_OK;
}

/* Makes the curve of nomogram IV: marks at whole numbers of q, with each interval
 * divided as space allows. */
static enum pp_status make_curve(struct pp_nomogram_sheet *sheet,
                                 struct pp_nomogram_spacing spacing,
                                 struct pp_error *err)
{
    struct pp_nomogram_scale *curve = &sheet->curve;
    curve->marks = calloc(MARKS_MOST, sizeof *curve->marks);
    if (!curve->marks)
        return pp_fail_memory(err);
    for (double from = PP_NOMOGRAM_LEAST_Q; from < PP_NOMOGRAM_MOST_Q; from += 1.0) {
        double step =
            pp_nomogram_position_division(&sheet->nomogram, from, spacing.width_mm,
                                          spacing.height_mm, spacing.fine_mm);
        int count = (int)rint(1.0 / step), last = from + 1.0 >= PP_NOMOGRAM_MOST_Q;
        for (int i = 0; i < count + last; i++) {
            struct pp_nomogram_mark *mark = &curve->marks[curve->count++];
            mark->number = from + i * step;
            mark->rank = i % count == 0   ? PP_MARK_LABELLED
                         : 2 * i == count ? PP_MARK_MIDDLE
                                          : PP_MARK_FINE;
            pp_nomogram_scale_curve(&sheet->nomogram, mark->number, &mark->x, &mark->y);
        }
    }
    return PP_OK;
}

enum pp_status pp_nomogram_sheet_fill_blank(struct pp_nomogram_sheet *sheet,
                                            enum pp_nomogram_kind kind,
                                            struct pp_nomogram_spacing spacing,
                                            struct pp_error *err)
{
    *sheet = (struct pp_nomogram_sheet){.nomogram = pp_nomogram_scale_make(kind),
                                        .blank = true,
                                        .component = NAN,
                                        .further = NAN};
    if (kind == PP_NOMOGRAM_POSITION)
        sheet->formulae = pp_nomogram_position_formulae;
    enum pp_status status = make_marks(sheet, spacing, err);
    return status == PP_OK && kind == PP_NOMOGRAM_POSITION
               ? make_curve(sheet, spacing, err)
               : status;
}

/* ---- a room ---- */

/* True if both readings draw the same lines on the sheet. */
static bool same_lines(const struct pp_nomogram_window *a,
                       const struct pp_nomogram_window *b)
{
    bool same = a->allowance == b->allowance && a->read.tens == b->read.tens;
    for (int i = 0; i < PP_NOMOGRAM_STEMS && same; i++)
        same = a->read.value[i] == b->read.value[i]
               || (isnan(a->read.value[i]) && isnan(b->read.value[i]));
    for (int i = 0; i < 2 && same; i++)
        same = a->read.places[i].q == b->read.places[i].q
               && a->read.places[i].share == b->read.places[i].share;
    return same;
}

/* A room, and the nomogram with which it is read. */
struct room_on_sheet {
    struct pp_nomogram_sheet *sheet;
    const struct pp_method *method; /* `irc-atlas` for nomogram IV, `nomogram` for the
                                     * others: its scope and allowances apply */
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_receiver *receiver;
    void *tools; /* tools of the method for nomogram IV; else NULL */
};

static enum pp_status read_window(struct pp_nomogram_reading *reading,
                                  const struct room_on_sheet *room,
                                  const struct pp_opening *opening,
                                  struct pp_error *err)
{
    const struct pp_nomogram *nomogram = &room->sheet->nomogram;
    if (nomogram->kind != PP_NOMOGRAM_POSITION)
        return pp_nomogram_reading_of_opening(reading, nomogram, room->world,
                                              room->light, opening, err);
    const char *why = pp_method_refuses_opening(room->method, room->world, room->light,
                                                opening, room->receiver);
    enum pp_status status = PP_OK;
    if (!why)
        status =
            pp_nomogram_position_read(reading, &why, nomogram, room->world, room->light,
                                      opening, room->receiver, room->tools, err);
    return why ? pp_fail(err, PP_BAD_INPUT, "the nomogram does not apply: %s %s %s",
                         pp_world_kind(room->world, opening->line), opening->label, why)
               : status;
}

static enum pp_status add_window(const struct room_on_sheet *room,
                                 const struct pp_opening *opening, struct pp_error *err)
{
    struct pp_nomogram_sheet *sheet = room->sheet;
    struct pp_nomogram_window window = {
        .label = opening->label,
        .alike = 1,
        .allowance = pp_allowance_factor(room->method->allowances, opening)};
    enum pp_status status = read_window(&window.read, room, opening, err);
    if (status != PP_OK)
        return status;
    double allowance = pp_allowance_of(room->method, room->world, opening);
    sheet->component += allowance * window.read.component;
    sheet->further += allowance * window.read.further;
    for (int i = 0; i < sheet->window_count; i++)
        if (same_lines(&sheet->windows[i], &window)) {
            sheet->windows[i].alike++;
            return PP_OK;
        }
    for (int i = 0; i < sheet->nomogram.stem_count; i++)
        window.y[i] =
            pp_nomogram_scale_position(&sheet->nomogram, i, window.read.value[i]);
    sheet->windows[sheet->window_count++] = window;
    return PP_OK;
}

/* Adds the room's openings that this nomogram covers; PP_BAD_INPUT if there are
 * none. */
static enum pp_status add_nomogram_windows(struct room_on_sheet *room,
                                           struct pp_error *err)
{
    struct pp_nomogram_sheet *sheet = room->sheet;
    const struct pp_world *world = room->world;
    const bool top = sheet->nomogram.kind == PP_NOMOGRAM_ROOFLIGHT;
    enum pp_status status = PP_OK;
    if (sheet->nomogram.kind == PP_NOMOGRAM_POSITION)
        status = room->method->prepare(&room->tools, world, room->light, err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        bool upright = pp_refusals_unless_vertical(opening) == NULL;
        if (upright != top)
            status = add_window(room, opening, err);
        else
            sheet->left_out++;
    }
    if (room->tools)
        room->method->destroy_tools(room->tools);
    if (status == PP_OK && sheet->window_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       top ? "the room has no rooflight; for windows, use --which "
                             "average or --which minimum"
                       : room->tools ? "the room has no vertical window"
                                     : "the room has no vertical window; for "
                                       "rooflights, use --which rooflight");
    return status;
}

enum pp_status pp_nomogram_sheet_fill_room(struct pp_nomogram_sheet *sheet,
                                           enum pp_nomogram_kind kind,
                                           const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_receiver *receiver,
                                           struct pp_nomogram_spacing spacing,
                                           struct pp_error *err)
{
    const bool position = kind == PP_NOMOGRAM_POSITION;
    enum pp_status status = pp_nomogram_sheet_fill_blank(sheet, kind, spacing, err);
    sheet->blank = false;
    sheet->name = world->name;
    sheet->decorations = pp_allowance_decorations(&pp_method_nomogram, world);
    sheet->component = 0.0;
    sheet->further = kind == PP_NOMOGRAM_MINIMUM || position ? 0.0 : NAN;
    if (status != PP_OK)
        return status;
    struct room_on_sheet room = {.sheet = sheet,
                                 .method = position ? &pp_method_irc_atlas
                                                    : &pp_method_nomogram,
                                 .world = world,
                                 .light = light,
                                 .receiver = receiver};
    const char *why = pp_method_refuses_room(room.method, world, light, receiver);
    if (!why && position)
        why = pp_nomogram_reading_refuses_room(world);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "no nomogram applies: %s", why);
    sheet->windows = calloc((size_t)world->opening_count + 1, sizeof *sheet->windows);
    return sheet->windows ? add_nomogram_windows(&room, err) : pp_fail_memory(err);
}
