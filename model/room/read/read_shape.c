/* read_shape.c - see read_shape.h. */
#include "model/room/read/read_shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/room/read/element_form.h"
#include "model/room/read/plan_roof.h"

/* Message about the outline of a plan; NULL if the outline is valid. */
static const char *plan_fault(const struct pp_plan_form *form, int vertices)
{
    bool width = !isnan(form->width_m), depth = !isnan(form->depth_m);
    if (vertices > 0 && (width || depth))
        return "width or depth is given as well as vertices; expected either width and "
               "depth, or three or more vertices";
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

/* Message about the roof of a plan; NULL if the roof is valid. */
static const char *roof_fault(const struct pp_plan_form *form, int vertices)
{
    bool is_flat = form->roof == PP_ROOF_FLAT;
    if (is_flat && !isnan(form->pitch_rad))
        return "has a pitch, but its roof is flat; expected a \"mono\", \"gable\", "
               "\"hip\" or \"saw-tooth\" roof";
    if (is_flat)
        return NULL;
    if (vertices > 0)
        return "has a roof and vertices; expected width and depth, because only "
               "rectangular plans can have a roof";
    if (isnan(form->pitch_rad))
        return "pitch is missing; expected a number of degrees above 0, up to 85";
    return form->teeth && form->roof != PP_ROOF_SAW_TOOTH
               ? "has teeth, which only a \"saw-tooth\" roof can have"
               : NULL;
}

/* Adds the roof. If the number of teeth is not given, there are as many as fit with a
 * width of at least 4 m each. */
static void raise_roof(struct pp_reader *r, struct pp_plan_part *plan,
                       const struct pp_plan_form *form, int line)
{
    bool turned = form->ridge == PP_RIDGE_DEPTH
                  || (form->ridge == PP_RIDGE_LONGER && form->depth_m > form->width_m);
    double across = turned ? form->width_m : form->depth_m;
    int usual = (int)fmin(fmax(floor(across / 4.0), 1.0), PP_PLAN_ROOF_TEETH_MOST);
    pp_plan_roof_add(r, plan,
                     &(struct pp_plan_roof){.width_m = form->width_m,
                                            .depth_m = form->depth_m,
                                            .height_m = form->height_m,
                                            .pitch_rad = form->pitch_rad,
                                            .roof = (enum pp_roof)form->roof,
                                            .ridge = (enum pp_ridge)form->ridge,
                                            .teeth = form->teeth ? form->teeth : usual,
                                            .line = line});
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
        if (!fault)
            fault = roof_fault(&form, plan.vertices.count);
        if (fault)
            pp_mistakes_add(r->mistakes, e->line, "plan: %s", fault);
        good = !fault;
    }
    if (!good || room->plan.line) {
        pp_room_parts_clear_plan(&plan);
        return;
    }
    if (form.roof != PP_ROOF_FLAT) {
        raise_roof(r, &plan, &form, e->line);
        room->plan = plan;
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
            pp_mistakes_add(r->mistakes, c->line,
                            "room: has both <%s> and the <%s> on line %d; expected "
                            "only one of them",
                            c->name, outline->name, outline->line);
            return;
        }
        outline = outline ? outline : c;
    }
    static const char *const shapes[] = {"plan", "envelope", NULL};
    for (const struct pp_xml_element *c = e->child; c && !outline; c = c->next)
        if (pp_text_nearest(c->name, shapes, -1))
            outline = c; /* misspelt, and reported as such */
    if (!outline && e->ended)
        pp_mistakes_add(r->mistakes, e->line,
                        "room: has no shape; expected a <plan> or an <envelope>");
}
