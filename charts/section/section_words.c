/* section_words.c - see section_words.h. */
#include "charts/section/section_words.h"

#include <math.h>

#include "charts/room/plan_names.h"
#include "charts/sheet/lettering.h"

double pp_section_words_mm(const struct pp_style *style)
{
    return 4.6 * style->scale;
}

/* Finds the lowest and highest z of the room's faces at s. Returns false if they are
 * equal, or if there is no face. */
static bool heights_at(const struct pp_section_cut *cut, double s, double *low,
                       double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int i = 0; i < cut->count; i++) {
        const struct pp_cut *one = &cut->list[i];
        double run = one->s[1] - one->s[0], share = (s - one->s[0]) / run;
        if ((one->kind != PP_CUT_FACE && one->kind != PP_CUT_OPENING)
            || fabs(run) < 1e-6 || share < 0.0 || share > 1.0)
            continue;
        double z = one->z[0] + share * (one->z[1] - one->z[0]);
        *low = fmin(*low, z);
        *high = fmax(*high, z);
    }
    return *high > *low + 1e-6;
}

/* Draws the dimension of the room's height where the room is highest, near the far wall
 * if possible. Returns the x of the dimension on paper. */
static double draw_height(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_section *section)
{
    enum { PLACES = 19, FIRST = 17 };
    const struct pp_section_cut *cut = section->cut;
    double best_s = -1.0, best_low = 0.0, best_high = 0.0;
    for (int i = 0; i < PLACES; i++) {
        /* Positions are tried in the order 0.9 L, 0.85 L ... 0.05 L, then 0.95 L. */
        int place = i <= FIRST ? FIRST - i : FIRST + 1;
        double s = cut->length_m * (place + 1) / (PLACES + 1.0), low, high;
        if (heights_at(cut, s, &low, &high)
            && high - low > best_high - best_low + 1e-6) {
            best_s = s;
            best_low = low;
            best_high = high;
        }
    }
    double x = pp_section_frame_x(section, best_s);
    if (best_s >= 0.0)
        pp_plan_names_dimension(cr, style, x, pp_section_frame_y(section, best_low), x,
                                pp_section_frame_y(section, best_high),
                                best_high - best_low, true);
    return x;
}

/* Writes the name of the room in the upper part of the section, in the middle, or left
 * of the height dimension if that is in the middle. */
static void name_room(cairo_t *cr, const struct pp_style *style,
                      const struct pp_room_section *section, double height_x)
{
    const struct pp_world *world = section->world;
    double low, high, length = section->cut->length_m * section->mm_per_m;
    pp_section_frame_heights(section->cut, &low, &high);
    const struct pp_lettering set = {.size = PP_TEXT_BODY, .across = 0.5, .down = 0.5};
    double x = section->x + 0.5 * length,
           y = pp_section_frame_y(section, low + 0.68 * (high - low));
    if (!world->name)
        return;
    double wide = pp_lettering_measure(cr, style, &set, x, y, world->name).width,
           aside = 0.5 * wide + 3.0 * style->scale;
    if (fabs(height_x - x) < aside)
        x = height_x - aside;
    if (wide < 0.65 * length && x - 0.5 * wide > section->x)
        pp_lettering_draw_on_white(cr, style, &set, x, y, world->name);
}

/* Writes the name of a cut opening inside the room, beside the glass. */
static void name_cut(cairo_t *cr, const struct pp_style *style,
                     const struct pp_room_section *section, const struct pp_cut *cut)
{
    const struct pp_opening *opening = &section->world->openings[cut->of];
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .bold = true, .across = 0.5, .down = 0.5};
    struct pp_vec3 normal = opening->inner.normal;
    double in[2] = {normal.x * section->cut->along[0]
                        + normal.y * section->cut->along[1],
                    -normal.z};
    double length = fmax(hypot(in[0], in[1]), 1e-9);
    struct pp_box size = pp_lettering_measure(cr, style, &set, 0, 0, opening->label);
    double off =
        1.2 * style->scale
        + 0.5 * (fabs(in[0]) * size.width + fabs(in[1]) * size.height) / length;
    double x = pp_section_frame_x(section, 0.5 * (cut->s[0] + cut->s[1]));
    double y = pp_section_frame_y(section, 0.5 * (cut->z[0] + cut->z[1]));
    pp_lettering_draw_on_white(cr, style, &set, x + off * in[0] / length,
                               y + off * in[1] / length, opening->label);
}

/* Writes the name of an opening behind the section in its outline, if it fits. */
static void name_behind(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_section *section,
                        const struct pp_opening *opening)
{
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .across = 0.5, .down = 0.5};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < opening->inner.count; i++) {
        double xy[2] = {
            pp_section_frame_x(
                section, pp_section_cut_s(section->cut, opening->inner.vertices[i])),
            pp_section_frame_y(section, opening->inner.vertices[i].z)};
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], xy[k]);
            high[k] = fmax(high[k], xy[k]);
        }
    }
    double x = 0.5 * (low[0] + high[0]), y = 0.5 * (low[1] + high[1]);
    struct pp_box size = pp_lettering_measure(cr, style, &set, x, y, opening->label);
    bool inside =
        x > section->x && x < pp_section_frame_x(section, section->cut->length_m);
    if (inside && size.width < high[0] - low[0] && size.height < high[1] - low[1])
        pp_lettering_draw(cr, style, &set, x, y, opening->label);
}

/* Writes the name of the wall at an end of the section, outside the wall. */
static void name_wall(cairo_t *cr, const struct pp_style *style,
                      const struct pp_room_section *section, bool near, double y)
{
    int face = near ? section->cut->near_face : section->cut->far_face;
    const char *name = face >= 0 ? section->world->surfaces[face].name : NULL;
    char words[PP_PLAN_NAMES_WALL];
    if (!name)
        return;
    pp_plan_names_wall(words, name);
    double x = pp_section_frame_x(section, near ? 0.0 : section->cut->length_m);
    double gap = 2.0 * style->scale;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                     .grey = PP_GREY_TEXT,
                                     .across = near ? 1.0 : 0.0,
                                     .down = 0.5};
    pp_lettering_draw_on_white(cr, style, &set, near ? x - gap : x + gap, y, words);
}

void pp_section_words_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_section *section)
{
    const struct pp_section_cut *cut = section->cut;
    double low, high;
    pp_section_frame_heights(cut, &low, &high);
    double y = pp_section_frame_y(section, low) + 0.65 * pp_section_words_mm(style);
    for (int i = 0; i < section->world->opening_count; i++)
        if (!pp_section_frame_is_cut(cut, i))
            name_behind(cr, style, section, &section->world->openings[i]);
    double height_x = draw_height(cr, style, section);
    name_room(cr, style, section, height_x);
    for (int i = 0; i < cut->count; i++)
        if (cut->list[i].kind == PP_CUT_OPENING)
            name_cut(cr, style, section, &cut->list[i]);
    pp_plan_names_dimension(cr, style, section->x, y,
                            pp_section_frame_x(section, cut->length_m), y,
                            cut->length_m, true);
    name_wall(cr, style, section, true, y);
    name_wall(cr, style, section, false, y);
}
