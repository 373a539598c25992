/* curve.c - see curve.h. */
#include "model/geometry/curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

void pp_curve_list_clear(struct pp_curve_list *curves)
{
    for (int i = 0; i < curves->count; i++)
        free(curves->list[i].xy);
    free(curves->list);
    *curves = (struct pp_curve_list){0};
}

void pp_curve_add_point(struct pp_curve *curve, const double xy[2])
{
    if (curve->count && memcmp(curve->xy[curve->count - 1], xy, sizeof(double[2])) == 0)
        return;
    memcpy(curve->xy[curve->count++], xy, sizeof(double[2]));
}

enum pp_status pp_curve_list_add(struct pp_curve_list *curves, struct pp_curve curve,
                                 struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&curves->list, curves->count, sizeof *curves->list, err);
    if (status == PP_OK)
        curves->list[curves->count++] = curve;
    else
        free(curve.xy);
    return status;
}

double pp_curve_length(const struct pp_curve *curve)
{
    double length = 0.0;
    for (int i = curve->closed ? 0 : 1; i < curve->count; i++) {
        const double *a = curve->xy[i > 0 ? i - 1 : curve->count - 1];
        const double *b = curve->xy[i];
        length += hypot(b[0] - a[0], b[1] - a[1]);
    }
    return length;
}

double pp_curve_list_area(const struct pp_curve_list *curves)
{
    double twice = 0.0;
    for (int i = 0; i < curves->count; i++)
        for (int k = 0; k < curves->list[i].count; k++) {
            const double *a = curves->list[i].xy[k];
            const double *b = curves->list[i].xy[(k + 1) % curves->list[i].count];
            twice += a[0] * b[1] - b[0] * a[1];
        }
    return 0.5 * twice;
}
