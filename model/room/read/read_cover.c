/* read_cover.c - see read_cover.h. */
#include "model/room/read/read_cover.h"

#include "model/room/read/element_form.h"

static void add_cover(struct pp_reader *r, struct pp_room *room,
                      enum pp_cover_kind kind, const struct pp_element_rule *rule,
                      const struct pp_xml_element *e)
{
    struct pp_cover_form form = {0};
    if (!pp_reader_fill_form(r, &form, rule, e)
        || !PP_READER_RESERVE(r, room->covers, room->cover_count))
        return;
    room->covers[room->cover_count++] =
        (struct pp_cover_part){.kind = kind,
                               .name = pp_reader_copy_text(r, form.name),
                               .wall = pp_reader_copy_text(r, form.wall),
                               .left_m = form.left_m,
                               .width_m = form.width_m,
                               .height_m = form.height_m,
                               .reflectance = form.finish.reflectance,
                               .finish = form.finish.finish,
                               .line = e->line};
}

void pp_read_cover_door(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e)
{
    add_cover(r, room, PP_DOOR, &pp_rule_door, e);
}

void pp_read_cover_dado(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e)
{
    add_cover(r, room, PP_DADO, &pp_rule_dado, e);
}
