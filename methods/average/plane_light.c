/* plane_light.c - see plane_light.h. */
#include "methods/average/plane_light.h"

#include "methods/fast/beam_average.h"
#include "methods/average/point_average.h"
#include "methods/exact/pane_luminance.h"
#include "methods/view/visible.h"

enum pp_status pp_plane_light_average(double mean[2], struct pp_beams *beams,
                                      const struct pp_opening *opening,
                                      const struct pp_plane_light *light,
                                      struct pp_error *err)
{
    return pp_beams_plain(beams)
               ? pp_point_average(mean, pp_beams_world(beams), opening, light, err)
               : pp_beam_average(mean, beams, opening, light, PP_BEAM_AVERAGE_ERROR,
                                 err);
}

enum pp_status pp_plane_light_direct(double mean[2], struct pp_beams *beams,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_glass *glass, struct pp_error *err)
{
    const struct pp_pane_luminance luminance = {
        &light->sky, glass, pp_vec_scale(opening->inner.normal, -1.0)};
    const struct pp_plane_light through = {
        .sky = pp_pane_luminance_sky,
        .exitance = pp_pane_luminance_unity,
        .context = &luminance,
        .of_reflectance = pp_visible_luminance_factor(&light->sky, 1.0),
        .with_outside = true};
    struct pp_kept_beam *kept;
    if (pp_beams_plain(beams))
        return pp_plane_light_average(mean, beams, opening, &through, err);
    enum pp_status status =
        pp_beams_of(&kept, beams, opening, through.with_outside, err);
    if (status != PP_OK || pp_kept_beam_means(mean, kept, glass))
        return status;
    status = pp_plane_light_average(mean, beams, opening, &through, err);
    if (status == PP_OK)
        pp_kept_beam_keep_means(kept, glass, mean);
    return status;
}
