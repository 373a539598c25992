/* read_fitting.c - see read_fitting.h. */
#include "model/room/read/read_fitting.h"

#include <math.h>

#include "model/room/read/element_form.h"

static void add_fitting(struct pp_reader *r, struct pp_room *room,
                        struct pp_fitting_part part, const struct pp_fitting_form *form,
                        int line)
{
    part.reflectance = form->finish.reflectance;
    part.finish = form->finish.finish;
    part.line = line;
    if (!PP_READER_RESERVE(r, room->fittings, room->fitting_count))
        return;
    part.name = pp_reader_copy_text(r, form->name);
    room->fittings[room->fitting_count++] = part;
}

void pp_read_fitting_furniture(struct pp_reader *r, struct pp_room *room,
                               const struct pp_xml_element *e)
{
    struct pp_fitting_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_furniture, e))
        return;
    add_fitting(r, room,
                (struct pp_fitting_part){.kind = PP_FURNITURE,
                                         .corner = pp_vec(form.x, form.y, form.z),
                                         .width_m = form.width_m,
                                         .depth_m = form.depth_m,
                                         .height_m = form.height_m,
                                         .rotate_rad = form.rotate_rad},
                &form, e->line);
}

void pp_read_fitting_column(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e)
{
    struct pp_fitting_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_column, e))
        return;
    bool round = !isnan(form.diameter_m);
    if (round == !isnan(form.width_m) || (round && !isnan(form.depth_m))) {
        pp_mistakes_add(r->mistakes, e->line,
                        "column: has %s; expected a diameter, or a width and a depth "
                        "(for a square column, a width only)",
                        round ? "a diameter, and a width or a depth"
                              : "neither a width nor a diameter");
        return;
    }
    add_fitting(
        r, room,
        (struct pp_fitting_part){.kind = PP_COLUMN,
                                 .corner = pp_vec(form.x, form.y, 0.0),
                                 .is_round = round,
                                 .width_m = round ? form.diameter_m : form.width_m,
                                 .depth_m = round                 ? form.diameter_m
                                            : isnan(form.depth_m) ? form.width_m
                                                                  : form.depth_m,
                                 .height_m = form.height_m,
                                 .rotate_rad = form.rotate_rad},
        &form, e->line);
}

void pp_read_fitting_partition(struct pp_reader *r, struct pp_room *room,
                               const struct pp_xml_element *e)
{
    struct pp_fitting_form form = {0};
    if (!pp_reader_fill_form(r, &form, &pp_rule_partition, e))
        return;
    double dx = form.to[0] - form.from[0], dy = form.to[1] - form.from[1];
    if (!(hypot(dx, dy) > 0.0)) {
        pp_mistakes_add(r->mistakes, e->line,
                        "partition: from and to are the same point");
        return;
    }
    add_fitting(
        r, room,
        (struct pp_fitting_part){.kind = PP_PARTITION,
                                 .corner = pp_vec(form.from[0], form.from[1], 0.0),
                                 .width_m = hypot(dx, dy),
                                 .depth_m = form.thickness_m,
                                 .height_m = form.height_m,
                                 .rotate_rad = atan2(dy, dx)},
        &form, e->line);
}
