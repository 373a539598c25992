/* elevation_cover.c - see elevation_cover.h. */
#include "methods/view/elevation_cover.h"

#include <math.h>

/* Jambs this close to the edge of a column (in columns) are rounded to the side that
 * hides less. */
static const double grain = 1e-9;

void pp_elevation_cover_init(struct pp_elevation_cover *cover,
                             const struct pp_elevation_part *seen)
{
    cover->left = seen->left;
    cover->width = (seen->right - seen->left) / PP_ELEVATION_COLUMNS;
    cover->alike = true;
    cover->high[0] = seen->low;
    cover->distance_m[0] = 0.0;
}

/* Gives each column its own copy of the values that were common to all. */
static void part_columns(struct pp_elevation_cover *cover)
{
    for (int i = 1; i < PP_ELEVATION_COLUMNS; i++) {
        cover->high[i] = cover->high[0];
        cover->distance_m[i] = cover->distance_m[0];
    }
    cover->alike = false;
}

/* Position of a jamb in columns from the first, clamped to the columns. */
static double cover_column(const struct pp_elevation_cover *cover, double x)
{
    double at = (x - cover->left) / cover->width;
    return fmin(fmax(at, 0.0), PP_ELEVATION_COLUMNS);
}

void pp_elevation_cover_add(struct pp_elevation_cover *cover,
                            const struct pp_elevation_part *outline, double distance_m)
{
    int first = (int)ceil(cover_column(cover, outline->left) + grain);
    int end = (int)floor(cover_column(cover, outline->right) - grain);
    if (outline->left <= cover->left)
        first = 0;
    if (outline->right >= cover->left + PP_ELEVATION_COLUMNS * cover->width)
        end = PP_ELEVATION_COLUMNS;
    if (cover->alike && first < end && end - first < PP_ELEVATION_COLUMNS)
        part_columns(cover);
    if (cover->alike && first < end)
        end = 1;
    for (int i = first; i < end; i++)
        if (outline->low <= cover->high[i] && outline->high > cover->high[i]) {
            cover->high[i] = outline->high;
            cover->distance_m[i] = fmax(cover->distance_m[i], distance_m);
        }
}

bool pp_elevation_cover_hides(const struct pp_elevation_cover *cover, double left,
                              double right, double high, double distance_m)
{
    int first = (int)floor(cover_column(cover, left) - grain);
    int end = (int)ceil(cover_column(cover, right) + grain);
    first = first < 0 ? 0 : first;
    end = end > PP_ELEVATION_COLUMNS ? PP_ELEVATION_COLUMNS : end;
    if (cover->alike && first < end) {
        first = 0;
        end = 1;
    }
    for (int i = first; i < end; i++)
        if (!(high <= cover->high[i] && distance_m > cover->distance_m[i]))
            return false;
    return end > first;
}
