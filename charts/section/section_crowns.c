/* section_crowns.c - see section_crowns.h. */
#include "charts/section/section_crowns.h"

#include <math.h>

/* Extent of the cut through the crown, from s[0] to s[1]; false if it is not cut. */
static bool crown_cut(const struct pp_section_cut *cut, const struct pp_tree *tree,
                      double s[2])
{
    double x = tree->foot.x - cut->origin[0], y = tree->foot.y - cut->origin[1];
    double off = x * cut->along[1] - y * cut->along[0];
    double radius = 0.5 * tree->crown_width_m;
    if (!(fabs(off) < radius))
        return false;
    double middle = pp_section_cut_s(cut, tree->foot);
    double half = sqrt(radius * radius - off * off);
    s[0] = middle - half;
    s[1] = middle + half;
    return true;
}

bool pp_section_crowns_are_outside(const struct pp_section_cut *cut,
                                   const struct pp_world *world, bool near)
{
    for (int i = 0; i < world->tree_count; i++) {
        double s[2];
        if (crown_cut(cut, &world->trees[i], s)
            && (near ? s[0] < 0.0 : s[1] > cut->length_m))
            return true;
    }
    return false;
}

void pp_section_crowns_draw(cairo_t *cr, const struct pp_style *style,
                            const struct pp_room_section *section)
{
    const struct pp_world *world = section->world;
    for (int i = 0; i < world->tree_count; i++) {
        const struct pp_tree *tree = &world->trees[i];
        double s[2];
        if (!crown_cut(section->cut, tree, s))
            continue;
        double left = pp_section_frame_x(section, s[0]);
        double top = pp_section_frame_y(section, tree->foot.z + tree->height_m);
        double low = pp_section_frame_y(section, tree->foot.z + tree->crown_base_m);
        cairo_rectangle(cr, left, top, pp_section_frame_x(section, s[1]) - left,
                        low - top);
        pp_style_grey(cr, PP_GREY_FILL);
        cairo_fill_preserve(cr);
        pp_style_line(cr, style->thin, PP_GREY_LINE);
        cairo_stroke(cr);
    }
}
