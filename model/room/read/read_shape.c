/* read_shape.c - see read_shape.h. */
#include "model/room/read/read_shape.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/element_form.h"

/* What is wrong with the way a plan's outline is given, or NULL. */
static const char *plan_fault(const struct pp_plan_form *form, int vertices)
{
    bool width = !isnan(form->width_m), depth = !isnan(form->depth_m);
    if (vertices > 0 && (width || depth))
        return "width or depth and vertices are both given; expected width and depth, "
               "or three or more vertices";
    if (vertices > 0)
        return vertices < 3 ? "fewer than three vertices; expected three or more"
                            : NULL;
    if (width && depth)
        return NULL;
    return width   ? "depth is missing; a rectangle needs width and depth"
           : depth ? "width is missing; a rectangle needs width and depth"
                   : "no outline is given; expected width and depth, or three or more "
                     "vertices";
}

void pp_read_shape_plan(struct pp_reader *r, struct pp_room *room,
                        const struct pp_xml_element *e)
{
    struct pp_plan_form form;
    struct pp_plan_part plan = {.line = e->line};
    bool good = pp_reader_fill_form(r, &form, &pp_rule_plan, e);
    good = pp_reader_add_vertices(r, &plan.vertices, &pp_rule_plan_vertex, e) && good;
    if (good) {
        const char *fault = plan_fault(&form, plan.vertices.count);
        if (fault)
            pp_mistakes_add(r->mistakes, e->line, "plan: %s", fault);
        good = !fault;
    }
    if (!good || room->plan.line) {
        pp_room_parts_clear_plan(&plan);
        return;
    }
    plan.rectangle = plan.vertices.count == 0;
    plan.width_m = form.width_m;
    plan.depth_m = form.depth_m;
    plan.height_m = form.height_m;
    room->plan = plan;
}

static bool read_face(struct pp_reader *r, struct pp_plan_part *plan,
                      const struct pp_xml_element *e)
{
    struct pp_face_form form;
    bool good = pp_reader_fill_form(r, &form, &pp_rule_face, e);
    struct pp_face_part face = {.line = e->line};
    good = pp_reader_add_vertices(r, &face.vertices, &pp_rule_vertex, e) && good;
    if (good) {
        face.role = (enum pp_role)form.role;
        face.reflectance = form.finish.reflectance;
        face.finish = form.finish.finish;
        face.name = pp_reader_copy_text(r, form.name);
    }
    if (good && PP_READER_RESERVE(r, plan->faces, plan->face_count)) {
        plan->faces[plan->face_count++] = face;
        return true;
    }
    free(face.name);
    pp_room_parts_clear_vertices(&face.vertices);
    return false;
}

void pp_read_shape_envelope(struct pp_reader *r, struct pp_room *room,
                            const struct pp_xml_element *e)
{
    struct pp_plan_part plan = {.envelope = true,
                                .width_m = NAN,
                                .depth_m = NAN,
                                .height_m = NAN,
                                .line = e->line};
    bool good = pp_reader_fill_form(r, NULL, &pp_rule_envelope, e);
    for (const struct pp_xml_element *c = e->child; c && !pp_reader_should_stop(r);
         c = c->next)
        if (pp_element_form_matches(c, &pp_rule_face))
            good = read_face(r, &plan, c) && good;
    if (!good || room->plan.line)
        pp_room_parts_clear_plan(&plan);
    else
        room->plan = plan;
}

void pp_read_shape_check(struct pp_reader *r, const struct pp_xml_element *e)
{
    const struct pp_xml_element *outline = NULL;
    for (const struct pp_xml_element *c = e->child; c; c = c->next) {
        if (!pp_element_form_matches(c, &pp_rule_plan)
            && !pp_element_form_matches(c, &pp_rule_envelope))
            continue;
        if (outline && strcmp(outline->name, c->name) != 0) {
            pp_mistakes_add(
                r->mistakes, c->line,
                "room: <%s> beside the <%s> of line %d; expected one of them", c->name,
                outline->name, outline->line);
            return;
        }
        outline = outline ? outline : c;
    }
    static const char *const shapes[] = {"plan", "envelope", NULL};
    for (const struct pp_xml_element *c = e->child; c && !outline; c = c->next)
        if (pp_text_nearest(c->name, shapes, -1))
            outline = c; /* misspelt: that has been noted */
    if (!outline && e->ended)
        pp_mistakes_add(r->mistakes, e->line,
                        "room: it has no shape; expected a <plan> or an <envelope>");
}
