/* read_opening.c - see read_opening.h. */
#include "model/room/read/read_opening.h"

#include <stdlib.h>
#include <string.h>

#include "model/light/bsdf/bsdf_file.h"
#include "model/light/glazings.h"
#include "model/room/read/element_form.h"
#include "model/room/read/read_device.h"

static struct pp_glass named_glass(struct pp_reader *r, const char *name)
{
    const struct pp_glazing *glazing = pp_glazings_find(name);
    if (!glazing)
        return pp_glass_none(); /* "none", the only other name that the form accepts */
    size_t index = (size_t)(glazing - pp_glazings_at(0));
    if (index >= PP_READER_GLASSES)
        return pp_glazings_glass(glazing);
    if (r->glasses[index].panes == 0)
        r->glasses[index] = pp_glazings_glass(glazing);
    return r->glasses[index];
}

static bool has(const struct pp_xml_element *e, const char *name)
{
    for (int i = 0; i < e->attribute_count; i++)
        if (strcmp(e->attributes[i].name, name) == 0)
            return true;
    return false;
}

/* False, with a report, if the attributes specify the glass in two ways, or if
 * glazing-peak is given without glazing-file. */
static bool said_once(struct pp_reader *r, const struct pp_xml_element *e)
{
    static const char *const pairs[][2] = {{"glazing", "transmittance"},
                                           {"glazing", "glazing-file"},
                                           {"transmittance", "glazing-file"},
                                           {"diffusing", "glazing-file"},
                                           {"absorbing", "glazing-file"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (has(e, pairs[i][0]) && has(e, pairs[i][1])) {
            pp_mistakes_add(r->mistakes, e->line,
                            "%s: %s and %s are both given; expected only one of them",
                            e->name, pairs[i][0], pairs[i][1]);
            return false;
        }
    if (!has(e, "glazing-peak") || has(e, "glazing-file"))
        return true;
    pp_mistakes_add(r->mistakes, e->line,
                    "%s: glazing-peak is given without glazing-file; expected both",
                    e->name);
    return false;
}

/* Reads a measured pane; NULL after a mistake. */
static struct pp_measured_pane *read_pane_file(struct pp_reader *r, const char *file,
                                               bool split,
                                               const struct pp_xml_element *e)
{
    struct pp_measured_pane *pane = NULL;
    struct pp_error fault = {0};
    struct pp_bsdf bsdf;
    char *path = pp_reader_path(r, file);
    enum pp_status status = path ? pp_bsdf_file_read(&bsdf, path, &fault) : PP_SYSTEM;
    if (status == PP_OK) {
        status = pp_measured_pane_create(&pane, &bsdf, split, &fault);
        pp_bsdf_clear(&bsdf);
        if (status == PP_OK)
            pane->file = pp_reader_copy_text(r, file);
        else if (fault.message[0])
            pp_mistakes_add(r->mistakes, e->line, "%s: \"%.200s\": %s", e->name, file,
                            fault.message);
    } else if (fault.message[0]) {
        pp_mistakes_add(r->mistakes, e->line, "%s: %s", e->name, fault.message);
    } else {
        r->out_of_memory = true;
    }
    free(path);
    return pane;
}

/* Measured pane of a file: shared with another opening of the room, or new; NULL after
 * a mistake. */
static struct pp_measured_pane *measured_pane(struct pp_reader *r,
                                              const struct pp_room *room,
                                              const struct pp_opening_form *form,
                                              const struct pp_xml_element *e)
{
    bool split = form->peak == 0;
    for (int i = 0; i < room->opening_count; i++) {
        struct pp_measured_pane *other = room->openings[i].glazing.measured;
        if (other && other->file && other->is_split == split
            && strcmp(other->file, form->glazing_file) == 0)
            return pp_measured_pane_hold(other);
    }
    if (r->folder)
        return read_pane_file(r, form->glazing_file, split, e);
    pp_mistakes_add(r->mistakes, e->line,
                    "%s: the room was not read from a file, so its glazing-file cannot "
                    "be located; expected a room read from a file",
                    e->name);
    return NULL;
}

/* Glass that represents a measured pane in hand methods. */
static struct pp_glass glass_for(const struct pp_measured_pane *pane)
{
    return pane->kind == PP_MEASURED_DIFFUSING
               ? pp_glass_diffusing(fmin(1.0, pane->diffuse))
               : pp_glass_measured(pane->normal, pane->diffuse);
}

/* Makes glass tinted in its mass; false, with a report, if the attributes do not allow
 * it. */
static bool absorbing_glass(struct pp_reader *r, struct pp_glass *glass,
                            const struct pp_opening_form *form,
                            const struct pp_xml_element *e)
{
    if (form->diffusing != 1 && form->transmittance <= PP_GLASS_ABSORBING_MOST) {
        *glass = pp_glass_absorbing(form->transmittance);
        return true;
    }
    if (form->diffusing == 1)
        pp_mistakes_add(r->mistakes, e->line,
                        "%s: absorbing and diffusing are both \"yes\"; expected only "
                        "one of them",
                        e->name);
    else
        pp_mistakes_add(r->mistakes, e->line,
                        "%s: absorbing is \"yes\"; expected a transmittance of at most "
                        "%g, which a pane without absorption has",
                        e->name, PP_GLASS_ABSORBING_MOST);
    return false;
}

/* Glass that the attributes describe; false, with a report, if they contradict each
 * other. */
static bool glass_of(struct pp_reader *r, struct pp_glass *glass,
                     const struct pp_opening_form *form, const struct pp_xml_element *e)
{
    if (form->absorbing == 1)
        return absorbing_glass(r, glass, form, e);
    if (!isnan(form->transmittance)) {
        *glass = form->diffusing == 1 ? pp_glass_diffusing(form->transmittance)
                                      : pp_glass_scaled(named_glass(r, "clear-single"),
                                                        form->transmittance);
        return true;
    }
    const char *name = form->glazing ? form->glazing : "clear-single";
    *glass = named_glass(r, name);
    if (form->diffusing < 0 || form->diffusing == (int)glass->diffusing)
        return true;
    pp_mistakes_add(r->mistakes, e->line,
                    glass->diffusing
                        ? "%s: diffusing is \"no\", but the glazing \"%s\" is "
                          "diffusing; expected a clear glazing, or a transmittance"
                        : "%s: diffusing is \"yes\", but the glazing \"%s\" is clear; "
                          "expected a diffusing glazing, or a transmittance",
                    e->name, name);
    return false;
}

/* Reads a shade of the window; a shade with a mistake is left out. */
static void read_shade(struct pp_reader *r, struct pp_opening_part *part,
                       const struct pp_xml_element *e, enum pp_shade_kind kind,
                       const struct pp_element_rule *rule)
{
    struct pp_shade_form form = {0};
    if (!pp_reader_fill_form(r, &form, rule, e)
        || !PP_READER_RESERVE(r, part->shades, part->shade_count))
        return;
    part->shades[part->shade_count++] =
        (struct pp_shade_part){.kind = kind,
                               .depth_m = form.depth_m,
                               .inside_m = form.inside_m,
                               .above_m = form.above_m,
                               .below_m = form.below_m,
                               .left_m = form.left_m,
                               .right_m = kind == PP_FIN ? form.left_m : form.right_m,
                               .is_left = form.side != 2,
                               .is_right = form.side != 1,
                               .height_m = form.height_m,
                               .parapet_m = form.parapet_m,
                               .reflectance = form.finish.reflectance,
                               .finish = form.finish.finish,
                               .line = e->line};
}

static void read_shades(struct pp_reader *r, struct pp_opening_part *part,
                        const struct pp_xml_element *e)
{
    static const struct pp_element_rule *const rules[] = {
        [PP_OVERHANG] = &pp_rule_overhang,
        [PP_FIN] = &pp_rule_fin,
        [PP_BALCONY] = &pp_rule_balcony,
        [PP_SHELF] = &pp_rule_shelf};
    for (const struct pp_xml_element *c = e->child; c && !pp_reader_should_stop(r);
         c = c->next)
        for (int kind = 0; kind <= PP_SHELF; kind++)
            if (pp_element_form_matches(c, rules[kind]))
                read_shade(r, part, c, (enum pp_shade_kind)kind, rules[kind]);
}

void pp_read_opening(struct pp_reader *r, struct pp_room *room,
                     const struct pp_xml_element *e, enum pp_opening_kind kind,
                     const struct pp_element_rule *rule)
{
    /* Attributes that this kind of opening does not have stay "not given". */
    struct pp_opening_form form = {.left_m = NAN,
                                   .sill_m = NAN,
                                   .width_m = NAN,
                                   .height_m = NAN,
                                   .x = NAN,
                                   .y = NAN,
                                   .depth_m = NAN};
    struct pp_opening_part part = {.kind = kind, .line = e->line};
    bool good = pp_reader_fill_form(r, &form, rule, e);
    good = said_once(r, e) && good;
    if (kind == PP_OPENING)
        good = pp_reader_add_vertices(r, &part.vertices, &pp_rule_vertex, e) && good;
    if (good && form.glazing_file) {
        part.glazing.measured = measured_pane(r, room, &form, e);
        good = part.glazing.measured != NULL;
        if (good)
            part.glazing.glass = glass_for(part.glazing.measured);
    } else {
        good = good && glass_of(r, &part.glazing.glass, &form, e);
    }
    good = pp_read_device(r, &part.device, e) && good;
    if (good && form.glazing_file && part.device.kind != PP_DEVICE_NONE) {
        pp_mistakes_add(r->mistakes, part.device.line,
                        "%s: the window has a glazing-file; expected a %s in a window "
                        "without measured glazing",
                        pp_window_device_word(part.device.kind),
                        pp_window_device_word(part.device.kind));
        good = false;
    }
    if (kind == PP_WINDOW)
        read_shades(r, &part, e);
    if (!good || !PP_READER_RESERVE(r, room->openings, room->opening_count)) {
        pp_room_parts_clear_vertices(&part.vertices);
        free(part.shades);
        pp_measured_pane_release(part.glazing.measured);
        return;
    }
    part.glazing.frame_factor = form.frame_factor;
    part.glazing.maintenance = form.maintenance;
    part.glazing.curtains = form.curtains;
    part.glazing.reveal_m = form.reveal_m;
    part.left_m = form.left_m;
    part.sill_m = form.sill_m;
    part.width_m = form.width_m;
    part.height_m = form.height_m;
    part.x = form.x;
    part.y = form.y;
    part.depth_m = form.depth_m;
    part.wall = pp_reader_copy_text(r, form.wall);
    part.name = pp_reader_copy_text(r, form.name);
    room->openings[room->opening_count++] = part;
}
