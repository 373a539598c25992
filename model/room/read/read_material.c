/* read_material.c - see read_material.h. */
#include "model/room/read/read_material.h"

#include <string.h>

#include "model/base/text.h"
#include "model/room/read/element_form.h"

/* Returns false, with a report, for a material with the name of an earlier one, or with
 * slopes that are too steep. */
static bool material_is_possible(struct pp_reader *r,
                                 const struct pp_material_form *form, int line)
{
    const struct pp_rough_finish *other =
        pp_rough_finishes_find(r->materials, form->name);
    char shown[160];
    if (other)
        pp_mistakes_add(r->mistakes, line,
                        "material: the name \"%s\" is taken, by the material on line "
                        "%d; expected another",
                        pp_text_excerpt(shown, sizeof shown, form->name), other->line);
    /* Steeper slopes reflect light to each other many times, which the theory
     * neglects. */
    bool steep = form->roughness_um > form->correlation_um;
    if (steep)
        pp_mistakes_add(r->mistakes, line,
                        "material: roughness is %g, correlation-length %g; expected "
                        "a correlation-length of at least the roughness",
                        form->roughness_um, form->correlation_um);
    return !other && !steep;
}

/* Returns false, with a report, for a material that has some but not all attributes of
 * a rough surface, or is matt without a reflectance. */
static bool material_is_whole(struct pp_reader *r, const struct pp_material_form *form,
                              int line)
{
    bool n = form->n[0] > 0.0, roughness = form->roughness_um > 0.0,
         length = form->correlation_um > 0.0;
    if (n && roughness && length)
        return true;
    if (n || roughness || length || form->k[0] > 0.0 || form->wavelength_um[0] > 0.0) {
        pp_mistakes_add(r->mistakes, line,
                        "material: %s is missing; expected n, roughness and "
                        "correlation-length, or only diffuse for a matt surface",
                        !n           ? "n"
                        : !roughness ? "roughness"
                                     : "correlation-length");
        return false;
    }
    bool black =
        form->diffuse[0] == 0.0 && form->diffuse[1] == 0.0 && form->diffuse[2] == 0.0;
    if (black)
        pp_mistakes_add(r->mistakes, line,
                        "material: n, roughness and correlation-length are missing, "
                        "and diffuse is missing or 0; expected the three of a rough "
                        "surface, or the reflectance diffuse of a matt surface");
    return !black;
}

/* Parses the formula of an attribute; returns false, with a report, if it is not
 * valid. */
static bool read_formula(struct pp_reader *r, struct pp_surface_pattern *formula,
                         const char *attribute, const char *text, int line)
{
    struct pp_expression_mistake mistake;
    char shown[160];
    bool good = pp_surface_pattern_parse(formula, text, &mistake);
    if (!good)
        pp_mistakes_add(r->mistakes, line, "material: %s \"%s\", column %d: %s",
                        attribute, pp_text_excerpt(shown, sizeof shown, text),
                        mistake.column + 1, mistake.what);
    return good;
}

/* The two formulae of a material. */
struct material_formulae {
    struct pp_surface_pattern pattern, height;
    struct pp_rough_formulae given; /* those of the two that the material has */
};

/* Reads the formulae; bumps without a pattern get the pattern 1. Returns false, with a
 * report, if one is not valid. */
static bool read_formulae(struct pp_reader *r, struct material_formulae *formulae,
                          const struct pp_material_form *form, int line)
{
    const char *pattern = form->bump && !form->pattern ? "1" : form->pattern;
    if (form->bump && form->roughness_um > 0.0) {
        pp_mistakes_add(r->mistakes, line,
                        "material: a physically rough material has the attribute bump; "
                        "expected bumps only on a matt material, without n, k, "
                        "roughness and correlation-length");
        return false;
    }
    formulae->given = (struct pp_rough_formulae){pattern ? &formulae->pattern : NULL,
                                                 form->bump ? &formulae->height : NULL};
    return (!pattern || read_formula(r, &formulae->pattern, "pattern", pattern, line))
           && (!form->bump
               || read_formula(r, &formulae->height, "bump", form->bump, line));
}

/* Wavelengths of red, green and blue if a material gives none. */
static const double usual_um[3] = {0.65, 0.55, 0.45};

/* Adds a stand-in for a material with mistakes under its name, so that the surfaces made
 * of it are not reported as well. */
static void add_stand_in(struct pp_reader *r, const struct pp_xml_element *e)
{
    static const struct pp_rough_optics glassy = {.n = {1.5, 1.5, 1.5},
                                                  .wavelength = {0.65, 0.55, 0.45},
                                                  .roughness = 0.1,
                                                  .correlation = 1.0};
    for (int i = 0; i < e->attribute_count; i++) {
        const struct pp_xml_attribute *a = &e->attributes[i];
        if (strcmp(a->name, "name") == 0 && a->value[0]
            && !pp_rough_finishes_find(r->materials, a->value)
            && pp_rough_finishes_add(&r->materials, a->value, &glassy,
                                     (struct pp_rough_formulae){.pattern = NULL},
                                     e->line, NULL)
                   != PP_OK)
            r->out_of_memory = true;
    }
}

static void read_material(struct pp_reader *r, const struct pp_xml_element *e)
{
    struct pp_material_form form;
    struct material_formulae formulae;
    if (pp_rough_finishes_count(r->materials) >= PP_ROOM_MATERIALS_MOST) {
        pp_mistakes_add(r->mistakes, e->line,
                        "material: the file has more than %d materials; expected at "
                        "most %d",
                        PP_ROOM_MATERIALS_MOST, PP_ROOM_MATERIALS_MOST);
        return;
    }
    if (!pp_reader_fill_form(r, &form, &pp_rule_material, e)
        || !material_is_whole(r, &form, e->line)
        || !material_is_possible(r, &form, e->line)
        || !read_formulae(r, &formulae, &form, e->line)) {
        add_stand_in(r, e);
        return;
    }
    struct pp_rough_optics optics = {
        .roughness = form.roughness_um,
        .correlation = form.correlation_um,
        .diffuse = pp_rgb(form.diffuse[0], form.diffuse[1], form.diffuse[2])};
    for (int c = 0; c < 3; c++) {
        optics.n[c] = form.n[c];
        optics.k[c] = form.k[c];
        optics.wavelength[c] =
            form.wavelength_um[c] > 0.0 ? form.wavelength_um[c] : usual_um[c];
    }
    if (pp_rough_finishes_add(&r->materials, form.name, &optics, formulae.given,
                              e->line, NULL)
        != PP_OK)
        r->out_of_memory = true;
}

void pp_read_materials(struct pp_reader *r, const struct pp_xml_element *root)
{
    for (const struct pp_xml_element *e = root->child; e && !pp_reader_should_stop(r);
         e = e->next)
        if (pp_element_form_matches(e, &pp_rule_material))
            read_material(r, e);
        else if (pp_element_form_matches(e, &pp_rule_building_room))
            pp_read_materials(r, e);
}
