/* section_frame.c - see section_frame.h. */
#include "charts/section/section_frame.h"

#include <math.h>

void pp_section_frame_heights(const struct pp_section_cut *cut, double *low,
                              double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int i = 0; i < cut->count; i++)
        for (int k = 0; k < 2 && cut->list[i].kind == PP_CUT_FACE; k++) {
            *low = fmin(*low, cut->list[i].z[k]);
            *high = fmax(*high, cut->list[i].z[k]);
        }
    if (!(*high > *low)) {
        *low = 0.0;
        *high = cut->height_m + 1.0;
    }
}

double pp_section_frame_x(const struct pp_room_section *section, double s)
{
    return section->x + s * section->mm_per_m;
}

double pp_section_frame_y(const struct pp_room_section *section, double z)
{
    double low, high;
    pp_section_frame_heights(section->cut, &low, &high);
    return section->y + (high - z) * section->mm_per_m;
}

double pp_section_frame_above_mm(const struct pp_room_section *section)
{
    double low, high, top = -INFINITY;
    pp_section_frame_heights(section->cut, &low, &high);
    for (int i = 0; i < section->cut->count; i++)
        if (section->cut->list[i].kind == PP_CUT_GLASS)
            top =
                fmax(top, fmax(section->cut->list[i].z[0], section->cut->list[i].z[1]));
    return fmax(top - high, 0.0) * section->mm_per_m;
}

bool pp_section_frame_is_cut(const struct pp_section_cut *cut, int opening)
{
    for (int k = 0; k < cut->count; k++)
        if (cut->list[k].kind == PP_CUT_OPENING && cut->list[k].of == opening)
            return true;
    return false;
}
